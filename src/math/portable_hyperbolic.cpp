#include "portable_exp_log.h"
#include "rt/math/portable.h"

namespace rt::portable {
namespace {

/// Below this the cubic terms are less than a quarter of an ulp.
constexpr double kTiny = 0x1p-27;
/// From here on exp(-x) no longer changes the last bit of cosh.
constexpr double kOneSided = 20.0;
/// Below this exp(x) - exp(-x) would cancel too much.
constexpr double kSeriesLimit = 0.25;

/// (sinh(x) - x) / x^3 for |x| <= 1/4: the Taylor series to x^15, relative error below 2^-66.
constexpr double kSinhSeries[] = {1.0 / 6.0,      1.0 / 120.0,      1.0 / 5040.0,
                                  1.0 / 362880.0, 1.0 / 39916800.0, 1.0 / 6227020800.0};
/// (cosh(x) - 1 - x^2/2) / x^4 likewise.
constexpr double kCoshSeries[] = {1.0 / 24.0,      1.0 / 720.0,       1.0 / 40320.0,
                                  1.0 / 3628800.0, 1.0 / 479001600.0, 1.0 / 87178291200.0};

struct BothExponentials {
    DoubleDouble plus;
    DoubleDouble minus;
};

/// exp(x)/2 and exp(-x)/2 for 0 <= x < kOneSided.
RT_KERNEL BothExponentials halfExponentials(double x) {
    const Exponential e = exponential(x, x, 0.0);
    const double scale = e.scale * powerOfTwo(e.exponent);
    const DoubleDouble plus = fastTwoSum(scale, scale * e.rest);
    const double inverse = 1.0 / plus.hi;
    const double rest = std::fma(-inverse, plus.hi, 1.0) - inverse * plus.lo;
    return {{0.5 * plus.hi, 0.5 * plus.lo}, {0.5 * inverse, 0.5 * inverse * rest}};
}

RT_KERNEL DoubleDouble sum(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble head = fastTwoSum(a.hi, b.hi);
    return {head.hi, head.lo + (a.lo + b.lo)};
}

RT_KERNEL DoubleDouble sinhParts(BothExponentials e) {
    return sum(e.plus, {-e.minus.hi, -e.minus.lo});
}

RT_KERNEL DoubleDouble sinhSeries(double x) {
    const double z = x * x;
    return fastTwoSum(x, x * z * polynomial(kSinhSeries, z));
}

/// exp(a)/2 for a >= kOneSided, also where exp(a) overflows.
RT_KERNEL double halfExp(double a) {
    if (!(a < 720.0)) return a + HUGE_VAL;
    Exponential e = exponential(a, a, 0.0);
    --e.exponent;
    return scaled(e);
}

struct Sinh {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (a < kTiny) return x;
        if (!(a < kOneSided)) return std::copysign(halfExp(a), x);
        const DoubleDouble value =
            a < kSeriesLimit ? sinhSeries(a) : sinhParts(halfExponentials(a));
        return std::copysign(value.hi + value.lo, x);
    }
};

struct Cosh {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (!(a < kOneSided)) return halfExp(a);
        const BothExponentials e = halfExponentials(a);
        const DoubleDouble value = sum(e.plus, e.minus);
        return value.hi + value.lo;
    }
};

struct Tanh {
    RT_KERNEL double evaluate(double x) {
        const double a = std::fabs(x);
        if (a < kTiny || std::isnan(x)) return x;
        if (!(a < kOneSided)) return std::copysign(1.0, x);
        DoubleDouble value{};
        if (a < kSeriesLimit) {
            const double z = a * a;
            const DoubleDouble head = fastTwoSum(1.0, 0.5 * z);
            const double rest = head.lo + z * z * polynomial(kCoshSeries, z);
            value = quotient(sinhSeries(a), fastTwoSum(head.hi, rest));
        } else {
            const BothExponentials e = halfExponentials(a);
            value = quotient(sinhParts(e), sum(e.plus, e.minus));
        }
        return std::copysign(value.hi + value.lo, x);
    }
};

}  // namespace

double sinh(double x) {
    return evaluate<Sinh>(x);
}
double cosh(double x) {
    return evaluate<Cosh>(x);
}
double tanh(double x) {
    return evaluate<Tanh>(x);
}

}  // namespace rt::portable
