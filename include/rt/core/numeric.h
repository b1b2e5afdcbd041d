// Every tolerance of the renderer, each derived from the rounding of the magnitudes at hand.
// Nothing outside this file may hold a tolerance of its own.
#pragma once

#include <cmath>
#include <limits>

#ifdef __FAST_MATH__
#error "the error bounds of this program do not hold under -ffast-math"
#endif

namespace rt {

/// Unit roundoff of double: the relative error of one correctly rounded operation.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// Bound on the relative error of n successive roundings, n u / (1 - n u)
/// (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 3.1).
constexpr double gamma(int n) {
    return n * kUnitRoundoff / (1.0 - n * kUnitRoundoff);
}

/// Surfaces closer than so many roundings of the coordinates are one surface: a face that two
/// solids share is computed through two transforms, each off by some tens of roundings, and is seen
/// as close to edge on as 1 : 100. Secondary rays start this far off their surface.
inline constexpr double kCoincidence = 4096 * kUnitRoundoff;

/// Bound on the error of the dot product of two vectors that were normalised in double: each is off
/// by at most 4 roundings (three of a length, one of the division), the product itself by 3.
inline constexpr double kUnitDotError = gamma(11);

/// Sine of an angle between two sides of a triangle below which it has no certain area: the sides,
/// as rounded differences of the corners, turn by up to 2 roundings each, and their cross product
/// is off by 3 more.
inline constexpr double kNoAreaSine = gamma(7);

/// Beyond so many roundings of its two products, a plain 2 x 2 determinant of rounded differences
/// has the right sign (Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997: 3 + 16 u).
inline constexpr double kPlainOrientationError = gamma(4);

/// a b - c d with an error of at most 1.5 roundings of the result, without cancellation
/// (Kahan's difference of products; Jeannerod, Louvet, Muller, Math. Comp. 82, 2013).
inline double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    const double error = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + error;
}

/// The rounded result of an operation, and what its rounding left out: value + error is exact.
struct TwoTerms {
    double value;
    double error;
};

/// a + b (Knuth, The Art of Computer Programming 2, 1969, section 4.2.2, theorem C).
inline TwoTerms exactSum(double a, double b) {
    const double sum = a + b;
    const double b2 = sum - a;
    return {sum, (a - (sum - b2)) + (b - b2)};
}

inline TwoTerms exactDifference(double a, double b) {
    return exactSum(a, -b);
}

/// a b, while nothing underflows.
inline TwoTerms exactProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// Between 1 / kOrdinaryLength and kOrdinaryLength, a product of eight lengths neither overflows
/// nor loses digits to underflow (2^800 < 2^1022); solids and directions outside are rescaled
/// first.
inline constexpr double kOrdinaryLength = 0x1p100;

/// A direction whose part across an axis is below this fraction of its length moves less than a
/// rounding sideways along any solid that is not 2^200 times as long as wide: it is parallel.
inline constexpr double kParallelSine = 0x1p-260;

/// The stretch of a line in which a torus is looked for is this much wider than R + r (that it is
/// thousands of roundings is what lets the signs at its ends be known without looking).
inline constexpr double kTorusSlack = 0x1p-40;

/// Halley's iteration cubes the relative error: a step below this leaves less than a rounding.
inline constexpr double kTorusHandover = 0x1p-18;

/// In units of r (R + r): a point of a line is off by 1 rounding of at most R + r and its rho by 2
/// more, to which f near the surface is 2 r times as sensitive; its own sum adds 4 of r^2.
inline constexpr double kTorusBlur = 16 * kUnitRoundoff;

/// Relative to t: 1 rounding made it from the foot's t and a root, 1 more parts them again.
inline constexpr double kTorusSway = 4 * kUnitRoundoff;

/// In the same units: half a rounding of R + r, below which a root is as good as its line.
inline constexpr double kTorusFloor = kUnitRoundoff;

/// Least square of a direction's length whose third power is still far from underflow.
inline constexpr double kTorusLeastSpeed = 0x1p-250;

/// How often Halley's iteration is let run unguarded: from a parabola, it takes one to three steps.
inline constexpr int kTorusGlances = 4;

/// After so many steps bisection takes over, and runs out of doubles within 64 more.
inline constexpr int kTorusPatience = 16;
inline constexpr int kTorusMaxSteps = kTorusPatience + 64;

/// Added to rho^2, so that a quotient by rho is finite on the axis; far below any rounding.
inline constexpr double kTorusAxisGuard = 0x1p-400;

/// Below this the line meets the axis as far as doubles can tell, and cubes would underflow.
inline constexpr double kTorusSmallestMoment = 0x1p-900;

// --- single-precision boxes (accel) ---

/// Bound on the relative error of rounding a double to float, outwards.
inline constexpr double kFloatRounding = 0x1p-23;

/// Distances between positions that are kept in single precision relative to the eye, and products
/// with unit normals in it, are off by eight of its roundings of the positions' length.
inline constexpr float kProbePositionError = 0x1p-20F;

/// How far the planes of boxes are moved outwards, in units of half the extent of their tree.
/// A slab test there (origin within 4 of the centre, parameter below 6, slopes below 2) is off by
/// at most 30 roundings to float, 2^-24 each: 4 for the origin, 12 for the slope, 5 for its
/// reciprocal, 4 for the product with the origin, 5 for the result; twice that.
inline constexpr double kBoxPad = 0x1p-18;

/// Slopes below this count as this: the ray moves by less than 2^-37 within the tree, and reaches a
/// plane that is kBoxPad away at a parameter beyond any within the tree.
inline constexpr double kLeastSlope = 0x1p-40;

/// Rounding in double of a ray's origin, relative to its distance: 2^7 roundings, more than any
/// primitive's test makes before its hits lie on the ray again.
inline constexpr double kOriginRounding = 0x1p-46;

// --- double-precision boxes (accel) ---

/// Directions are tested against boxes in double precision while their longest part lies between
/// this and its inverse: far from where a reciprocal overflows or loses digits.
inline constexpr double kLongestSlope = 0x1p500;

/// Shapes whose Transform::condition() is above this have no box in double precision: origin and
/// direction are off by 3 roundings each, times that, and with the 2^6 that a hit may lie outside
/// of its Bounds it is still below the pad of 2^7.
inline constexpr double kBoxedCondition = 8.0;

/// Parts of a direction below this fraction of the longest count as this. Until a ray has left a
/// box at p, it has gone |origin| + |p| along its longest axis, and so less than 2^-59 of that
/// sideways by the difference: the pad is 2^-46 of it.
inline constexpr double kLeastSlopeShare = 0x1p-60;

/// Patterns are read this far below a surface, in their sizes: more than the rounding of points up
/// to 2^20 sizes from the origin, and no more than an eye can see.
inline constexpr double kPatternDepth = 0x1p-24;

/// A plane ends here: the square of such a length still is a float.
inline constexpr double kFarthestOfPlane = 0x1p60;

/// In surface() of a torus: rho is off by 2 roundings of at most R + r, rho - R by one more, the
/// distance to the circle by 3 and its difference with r by 1, each of r; relative to R + r.
inline constexpr double kTorusPointError = gamma(7);

/// Linear maps of larger condition |inverse| |map| (largest row sum) count as singular: the entries
/// of composed maps are off by some 16 roundings, and that much could make such a map singular
/// (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 7.2).
inline constexpr double kLargestCondition = 1.0 / (16 * kUnitRoundoff);

/// A map keeps angles if the products of its columns are alike to this: chains of rotations and
/// even scales are off by some tens of roundings, and no uneven scale that matters is so small.
inline constexpr double kSimilarityError = 4096 * kUnitRoundoff;

/// A Newton step on a surface that is met at an angle mends thousands of roundings of the size at
/// most; longer ones come from grazing rays, which they would not mend.
inline constexpr double kNewtonReach = 8192 * kUnitRoundoff;

/// Curvatures below this share of a quadric's largest are none when its middle is looked for: the
/// square of it, which the normal equations see, still stands clear of their roundings.
inline constexpr double kLeastBend = 0x1p-20;

}  // namespace rt
