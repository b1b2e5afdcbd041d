// What the solids share: rays seen from a point on them near the solid, and refusals.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/numeric.h"
#include "rt/geometry/hit.h"

#include <algorithm>
#include <cmath>

namespace rt {

/// The ray o + t d as foot + s d, relative to an anchor: t = tFoot + s. The foot lies on the exact
/// ray to a rounding of its own size, however far away the origin is.
struct FootRay {
    Vec3 foot;
    const Vec3& direction;
    double tFoot;
    double inverseSquare;  ///< 1 / (d . d)
};

inline double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Seen from `anchor`, the foot being the point of the ray nearest to anchor + `middle`. tFoot, as
/// rounded, defines the foot: what is rounded there moves the foot along the ray, never off it.
/// o - c is exact in two terms, and fma rounds t d + (o - c) once (after Wald, Improving Numerical
/// Precision in Intersection Programs, Ray Tracing Gems II, 2021, ch. 34).
inline FootRay footRay(const Ray& ray, const Vec3& anchor, const Vec3& middle) {
    const Vec3& d = ray.direction;
    const TwoTerms x = exactDifference(ray.origin.x, anchor.x);
    const TwoTerms y = exactDifference(ray.origin.y, anchor.y);
    const TwoTerms z = exactDifference(ray.origin.z, anchor.z);
    const double inverseSquare = 1.0 / dot(d, d);
    const Vec3 fromMiddle(x.value - middle.x, y.value - middle.y, z.value - middle.z);
    const double tFoot = -dot(fromMiddle, d) * inverseSquare;
    return {Vec3(std::fma(tFoot, d.x, x.value) + x.error, std::fma(tFoot, d.y, y.value) + y.error,
                 std::fma(tFoot, d.z, z.value) + z.error),
            d, tFoot, inverseSquare};
}

inline Vec3 along(const FootRay& ray, double s) {
    return Vec3(std::fma(s, ray.direction.x, ray.foot.x), std::fma(s, ray.direction.y, ray.foot.y),
                std::fma(s, ray.direction.z, ray.foot.z));
}

/// One end of the part of a ray that lies inside a convex solid.
struct Crossing {
    double s;
    Index part;
};

/// The part of a ray inside a convex solid, cut down by one half-space after another. A NaN cuts
/// nothing, which is right for a ray within a bounding plane.
struct InsideSpan {
    Crossing entry;
    Crossing exit;

    void enterAt(double s, Index part) {
        if (s > entry.s) entry = {s, part};
    }
    void leaveAt(double s, Index part) {
        if (s < exit.s) exit = {s, part};
    }
    bool isEmpty() const { return !(entry.s <= exit.s); }
};

constexpr bool isOrdinarySquare(double square) {
    constexpr double kLimit = kOrdinaryLength * kOrdinaryLength;
    return square > 1.0 / kLimit && square < kLimit;
}

inline bool isOrdinary(double size, const Vec3& direction) {
    return isOrdinarySquare(dot(direction, direction)) && size > 1.0 / kOrdinaryLength &&
           size < kOrdinaryLength;
}

inline Vec3 scaleByPowerOfTwo(const Vec3& v, int exponent) {
    return Vec3(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
}

inline double largestComponent(const Vec3& v) {
    return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

/// Intersects where a square of the size or of the direction's length could leave the range of
/// double: powers of two bring both near 1. `intersect(exponent, ray, range, hit)` does the work
/// on the solid times 2^exponent.
template <class Intersect>
[[gnu::noinline, gnu::cold]] bool intersectRescaled(double size, const Ray& ray, Interval range,
                                                    PrimitiveHit& hit, const Intersect& intersect) {
    const double speed = largestComponent(ray.direction);
    const bool isNumber = dot(ray.direction, ray.direction) >= 0.0;
    if (!(isNumber && speed > 0.0 && speed < kInfinity)) return false;
    const int sizeExponent = std::ilogb(size);
    const int speedExponent = std::ilogb(speed);
    const int timeExponent = sizeExponent - speedExponent;
    const Ray scaled{scaleByPowerOfTwo(ray.origin, -sizeExponent),
                     scaleByPowerOfTwo(ray.direction, -speedExponent)};
    PrimitiveHit found;
    if (!intersect(
            -sizeExponent, scaled,
            Interval{std::ldexp(range.min, -timeExponent), std::ldexp(range.max, -timeExponent)},
            found)) {
        return false;
    }
    found.t = std::ldexp(found.t, timeExponent);
    if (!range.contains(found.t)) return false;
    found.local = scaleByPowerOfTwo(found.local, sizeExponent);
    hit = found;
    return true;
}

/// (x, z) as a unit vector and a length; a vector of zero points along +z.
struct Radial {
    double x;
    double z;
    double length;
};

/// The two below where a square would leave the range of double.
Vec3 extremeUnitVector(const Vec3& v);
Radial extremeRadial(double x, double z);

/// v at length 1; v is not zero.
inline Vec3 unitVector(const Vec3& v) {
    const double square = dot(v, v);
    if (!isOrdinarySquare(square)) [[unlikely]]
        return extremeUnitVector(v);
    const double inverse = 1.0 / std::sqrt(square);
    return Vec3(v.x * inverse, v.y * inverse, v.z * inverse);
}

inline Radial radial(double x, double z) {
    const double square = x * x + z * z;
    if (!isOrdinarySquare(square)) [[unlikely]]
        return extremeRadial(x, z);
    const double length = std::sqrt(square);
    const double inverse = 1.0 / length;
    return {x * inverse, z * inverse, length};
}

/// a + b rounded down (up): at most one step from the rounded sum.
inline double sumBelow(double a, double b) {
    const TwoTerms sum = exactSum(a, b);
    return sum.error >= 0.0 ? sum.value : std::nextafter(sum.value, -kInfinity);
}

inline double sumAbove(double a, double b) {
    const TwoTerms sum = exactSum(a, b);
    return sum.error <= 0.0 ? sum.value : std::nextafter(sum.value, kInfinity);
}

/// std::invalid_argument "sphere: radius must be > 0 and finite, got -1".
void requirePositive(const char* solid, const char* what, double value);
/// std::invalid_argument "sphere: centre must be finite, got (nan, 0, 0)".
void requireFinite(const char* solid, const char* what, const Vec3& value);

}  // namespace rt
