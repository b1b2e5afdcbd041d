#include <utility>

#include "portable_kernel.h"
#include "portable_tables.h"
#include "rt/math/portable.h"

namespace rt::portable {
namespace {

using namespace tables;

/// Below this, asin's x^3/6 is less than a quarter of an ulp of x.
constexpr double kTiny = 0x1p-27;
/// Below this ratio the angle of a point is y/x to less than a quarter of an ulp.
constexpr double kFlatRatio = 0x1p-54;

/// asin(s) - s for s = sqrt(z) <= 1/2.
RT_KERNEL double asinTail(double s, double z) {
    return s * (z * polynomial(kAsin, z));
}

/// asin(sqrt((1 - a)/2)) for 1/2 < a <= 1, half of acos(a).
RT_KERNEL DoubleDouble halfAcos(double a) {
    const double z = (1.0 - a) * 0.5;
    const double s = std::sqrt(z);
    const double rest = s > 0.0 ? std::fma(-s, s, z) / (2.0 * s) : 0.0;
    return {s, rest + asinTail(s, z)};
}

/// (hi + lo) - 2 angle, for hi >= 2 angle >= 0.
RT_KERNEL double minusTwice(double hi, double lo, DoubleDouble angle) {
    const DoubleDouble head = fastTwoSum(hi, -2.0 * angle.hi);
    return head.hi + (head.lo + (lo - 2.0 * angle.lo));
}

struct Asin {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (!(a <= 1.0)) return (x - x) / (x - x);
        if (a < kTiny) return x;
        if (a <= 0.5) return x + asinTail(x, x * x);
        return std::copysign(minusTwice(kHalfPiHi, kHalfPiLo, halfAcos(a)), x);
    }
};

struct Acos {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (!(a <= 1.0)) return (x - x) / (x - x);
        if (a <= 0.5) {
            const DoubleDouble head = fastTwoSum(kHalfPiHi, -x);
            return head.hi + (head.lo + (kHalfPiLo - asinTail(x, x * x)));
        }
        const DoubleDouble half = halfAcos(a);
        if (x > 0.0) return 2.0 * (half.hi + half.lo);
        return minusTwice(kPiHi, kPiLo, half);
    }
};

/// atan(a / b) for 0 <= a <= b, both far from overflow and underflow:
/// atan(c) + atan((a - c b) / (b + c a)) with c the nearest multiple of 1/64.
RT_KERNEL DoubleDouble ratioAngle(double a, double b) {
    const double shifted = a / b * 64.0 + kRoundingShift;
    const std::uint64_t cell = bitsOf(shifted) & 0x7f;
    const double c = (shifted - kRoundingShift) * (1.0 / 64.0);
    const DoubleDouble product = twoProduct(c, b);
    const double numerator = a - product.hi;
    const double denominator = std::fma(c, a, b);
    const double denominatorRest = std::fma(c, a, b - denominator);
    const double reciprocal = 1.0 / denominator;
    const double t = numerator * reciprocal;
    const double rest = (std::fma(-t, denominator, numerator) - product.lo) - t * denominatorRest;
    const double z = t * t;
    const double tail = std::fma(t * z, polynomial(kAtan, z), rest * reciprocal);
    const DoubleDouble head = fastTwoSum(kAtanHi[cell], t);
    return {head.hi, head.lo + (kAtanLo[cell] + tail)};
}

/// base - angle for base >= angle.
RT_KERNEL DoubleDouble complement(DoubleDouble base, DoubleDouble angle) {
    const DoubleDouble head = fastTwoSum(base.hi, -angle.hi);
    return {head.hi, head.lo + (base.lo - angle.lo)};
}

/// The angle of (x, y), x and y >= 0, turned into the half plane of a negative abscissa if asked.
RT_KERNEL double placed(double x, double y, bool left, DoubleDouble angle) {
    if (y > x) angle = complement({kHalfPiHi, kHalfPiLo}, angle);
    if (left) angle = complement({kPiHi, kPiLo}, angle);
    return angle.hi + angle.lo;
}

/// Zeros, infinities, ratios beyond 2^54 and magnitudes that the fast path cannot take.
[[gnu::noinline]] double extremeAngle(double x, double y, bool left) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    if (std::isinf(x) && std::isinf(y)) x = y = 1.0;
    const double large = std::fmax(x, y);
    const double small = std::fmin(x, y);
    if (std::isinf(large) || small == 0.0) return placed(x, y, left, {0.0, 0.0});
    // Both onto the scale of 1: exact, since small is normal after any scaling down.
    const int exponent = static_cast<int>(bitsOf(large) >> 52) - 1023;
    const double factor = powerOfTwo(-(exponent / 2));
    const double factor2 = powerOfTwo(-(exponent - exponent / 2));
    if (small * factor * factor2 < kFlatRatio * (large * factor * factor2)) {
        return placed(x, y, left, {small / large, 0.0});
    }
    return placed(x, y, left, ratioAngle(small * factor * factor2, large * factor * factor2));
}

struct Atan2 {
    RT_KERNEL double evaluate(double y, double x) {
        const double ay = std::fabs(y);
        const double ax = std::fabs(x);
        const bool left = bitsOf(x) >> 63 != 0;
        const bool steep = ay > ax;
        const double large = steep ? ay : ax;
        const double small = steep ? ax : ay;
        const bool ordinary = large < 0x1p500 && large > 0x1p-500 && small >= kFlatRatio * large;
        const double angle =
            ordinary ? placed(ax, ay, left, ratioAngle(small, large)) : extremeAngle(ax, ay, left);
        return std::copysign(angle, y);
    }
};

struct Atan {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (!(a >= kTiny)) return x;
        if (a > 0x1p54) return std::copysign(kHalfPiHi, x);
        const bool steep = a > 1.0;
        const DoubleDouble angle = steep ? ratioAngle(1.0, a) : ratioAngle(a, 1.0);
        return std::copysign(placed(1.0, a, false, angle), x);
    }
};

}  // namespace

double asin(double x) {
    return evaluate<Asin>(x);
}
double acos(double x) {
    return evaluate<Acos>(x);
}
double atan(double x) {
    return evaluate<Atan>(x);
}
double atan2(double y, double x) {
    return evaluate<Atan2>(y, x);
}

}  // namespace rt::portable
