#include "portable_exp_log.h"

#include "rt/math/portable.h"

namespace rt::portable {
namespace {

using namespace tables;

/// Beyond these, exp is infinite or 0.
constexpr double kExpOverflow = 710.0;
constexpr double kExpUnderflow = -746.0;

RT_KERNEL bool isOrdinary(double x) {
    return x > 0.0 && x < HUGE_VAL;
}

/// log of 0, of negative numbers, of infinity and NaN.
RT_KERNEL double extremeLog(double x) {
    if (x == 0.0) return -HUGE_VAL;
    return x > 0.0 || std::isnan(x) ? x + x : (x - x) / 0.0;
}

struct Exp {
    RT_KERNEL double evaluate(double x) {
        if (!(x < kExpOverflow)) return x + HUGE_VAL;
        if (x < kExpUnderflow) return 0.0;
        return scaled(exponential(x, x, 0.0));
    }
};

struct Exp2 {
    RT_KERNEL double evaluate(double x) {
        if (!(x < 1024.0)) return x + HUGE_VAL;
        if (x < -1076.0) return 0.0;
        const double shifted = x * 128.0 + kRoundingShift;
        const double r = (x - (shifted - kRoundingShift) * (1.0 / 128.0));
        const std::int64_t steps = integerOf(shifted);
        const auto j = static_cast<std::uint64_t>(steps) & 127;
        const double s = r * kLn2;
        const double rest = std::fma(s * s, polynomial(kExp, s), kExpTail[j] + s);
        return scaled({steps >> 7, kExpTable[j], rest});
    }
};

/// log(x) for x > 0 and finite; the parts overlap, and r^2/2 is rounded to double.
RT_KERNEL DoubleDouble logParts(double x) {
    const LogReduction part = reduceLog(x);
    const double r = part.r.hi;
    const DoubleDouble head = fastTwoSum(part.high, r);
    const double square = std::fma(r, polynomial(kLog, r), -0.5);
    return {head.hi, head.lo + std::fma(r * r, square, part.low + part.r.lo)};
}

struct Log {
    RT_KERNEL double evaluate(double x) {
        if (!isOrdinary(x)) return extremeLog(x);
        const DoubleDouble value = logParts(x);
        return value.hi + value.lo;
    }
};

/// log(x) factor, for the other bases.
RT_KERNEL double logInBase(double x, DoubleDouble factor) {
    if (!isOrdinary(x)) return extremeLog(x);
    const DoubleDouble value = logarithm(x);
    const DoubleDouble product = twoProduct(value.hi, factor.hi);
    return product.hi + (product.lo + std::fma(value.hi, factor.lo, value.lo * factor.hi));
}

struct Log2 {
    RT_KERNEL double evaluate(double x) { return logInBase(x, {kLog2EHi, kLog2ELo}); }
};

struct Log10 {
    RT_KERNEL double evaluate(double x) { return logInBase(x, {kLog10EHi, kLog10ELo}); }
};

enum class Parity { kNotInteger, kEven, kOdd };

Parity parityOf(double y) {
    const double a = std::fabs(y);
    if (a >= 0x1p53) return Parity::kEven;
    if (std::floor(a) != a) return Parity::kNotInteger;
    return (static_cast<std::uint64_t>(a) & 1) != 0 ? Parity::kOdd : Parity::kEven;
}

/// x^y for x > 0 and finite, y finite.
RT_KERNEL double ordinaryPow(double x, double y) {
    const DoubleDouble log = logarithm(x);
    const double hi = y * log.hi;
    if (!(hi < kExpOverflow)) return HUGE_VAL;
    if (hi < kExpUnderflow) return 0.0;
    return scaled(exponential(hi, hi, std::fma(y, log.hi, -hi) + y * log.lo));
}

/// Annex F for x zero, negative, infinite or NaN, or y infinite or NaN.
[[gnu::noinline]] double extremePow(double x, double y) {
    if (y == 0.0 || x == 1.0) return 1.0;
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const double a = std::fabs(x);
    if (std::isinf(y)) {
        if (a == 1.0) return 1.0;
        return (a > 1.0) == (y > 0.0) ? HUGE_VAL : 0.0;
    }
    const Parity parity = parityOf(y);
    const bool negative = std::signbit(x) && parity == Parity::kOdd;
    double value = 0.0;
    if (a == 0.0 || std::isinf(a)) {
        value = (a == 0.0) == (y > 0.0) ? 0.0 : HUGE_VAL;
    } else {
        if (x < 0.0 && parity == Parity::kNotInteger) return (x - x) / 0.0;
        value = ordinaryPow(a, y);
    }
    return negative ? -value : value;
}

struct Pow {
    RT_KERNEL double evaluate(double x, double y) {
        if (!isOrdinary(x) || !std::isfinite(y)) return extremePow(x, y);
        return ordinaryPow(x, y);
    }
};

/// The last power that powUnit does not flush to 0 is exp of this, just above 2^-1022.
constexpr double kSmallestPower = -0x1.6232bdd7abcd2p9;

struct PowUnit {
    RT_KERNEL double evaluate(double x, double p) {
        if (!(x > 0.0 && x <= 1.0 && p >= 0.0 && p < HUGE_VAL)) {
            if (!(x == 0.0 && p >= 0.0 && p < HUGE_VAL)) return std::nan("");
            return p > 0.0 ? 0.0 : 1.0;
        }
        const DoubleDouble log = logParts(x);
        const double hi = p * log.hi;
        const double nearest = std::fma(p, log.lo, hi);
        if (!(nearest > kSmallestPower)) return 0.0;
        const Exponential e = exponential(nearest, hi, std::fma(p, log.hi, -hi) + p * log.lo);
        return std::fma(e.scale, e.rest, e.scale) * powerOfTwo(e.exponent);
    }
};

}  // namespace

double exp(double x) {
    return evaluate<Exp>(x);
}
double exp2(double x) {
    return evaluate<Exp2>(x);
}
double log(double x) {
    return evaluate<Log>(x);
}
double log2(double x) {
    return evaluate<Log2>(x);
}
double log10(double x) {
    return evaluate<Log10>(x);
}
double pow(double x, double y) {
    return evaluate<Pow>(x, y);
}
double powUnit(double x, double p) {
    return evaluate<PowUnit>(x, p);
}

}  // namespace rt::portable
