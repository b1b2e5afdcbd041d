// Kernels of the exponential and the logarithm, shared by exp, log, pow and the hyperbolic
// functions.
#pragma once

#include "portable_kernel.h"
#include "portable_tables.h"

namespace rt::portable {

/// 2^exponent scale (1 + rest), scale = kExpTable[j] in [1, 2) and |rest| < 0.003.
struct Exponential {
    std::int64_t exponent;
    double scale;
    double rest;
};

/// exp(hi + lo) for |hi| < 2^11, |lo| < 2^-5; nearest is hi + lo to within 2^-20
/// (Tang, Table-driven implementation of the exponential function, ACM TOMS 15, 1989).
RT_KERNEL Exponential exponential(double nearest, double hi, double lo) {
    using namespace tables;
    const double shifted = nearest * (128.0 * kLog2EHi) + kRoundingShift;
    const double n = shifted - kRoundingShift;
    const double r = std::fma(n, -kLn2By128Lo, std::fma(n, -kLn2By128Hi, hi)) + lo;
    const std::int64_t steps = integerOf(shifted);
    const auto j = static_cast<std::uint64_t>(steps) & 127;
    return {steps >> 7, kExpTable[j], std::fma(r * r, polynomial(kExp, r), kExpTail[j] + r)};
}

/// The value of an exponential whose exponent may lie outside the range of doubles;
/// below the normal numbers it is rounded once.
RT_KERNEL double scaled(Exponential e) {
    const double tail = e.scale * e.rest;
    if (e.exponent >= -1021 && e.exponent <= 1022) {
        return (e.scale + tail) * powerOfTwo(e.exponent);
    }
    if (e.exponent > 1022) {
        if (e.exponent > 1025) return HUGE_VAL;
        return (e.scale + tail) * 0x1p1022 * powerOfTwo(e.exponent - 1022);
    }
    if (e.exponent < -1080) return 0.0;
    const double factor = powerOfTwo(e.exponent + 1022);
    const DoubleDouble sum = fastTwoSum(e.scale * factor, tail * factor);
    if (sum.hi >= 1.0) return (e.scale + tail) * factor * 0x1p-1022;
    // Added to 1, the value is rounded where the subnormals' last bit is.
    const DoubleDouble onGrid = fastTwoSum(1.0, sum.hi);
    return ((onGrid.hi + (onGrid.lo + sum.lo)) - 1.0) * 0x1p-1022;
}

/// What the two logarithms share: log(x) = high + log(1 + r), high exact up to low.
struct LogReduction {
    double high;
    double low;
    DoubleDouble r;
};

/// x > 0 and finite
/// (Tang, Table-driven implementation of the logarithm function, ACM TOMS 16, 1990).
RT_KERNEL LogReduction reduceLog(double x) {
    using namespace tables;
    constexpr std::uint64_t kFirstCell = 0x3fe6000000000000;  // 0.6875
    std::uint64_t bits = bitsOf(x);
    double shift = 0.0;
    if (bits < (std::uint64_t{1} << 52)) {
        bits = bitsOf(x * 0x1p54);
        shift = -54.0;
    }
    const std::uint64_t offset = bits - kFirstCell;
    const auto exponent = static_cast<std::int64_t>(offset) >> 52;
    const auto cell = offset >> 45 & 127;
    const double z = fromBits(bits - (static_cast<std::uint64_t>(exponent) << 52));
    const double k = static_cast<double>(exponent) + shift;
    const DoubleDouble product = twoProduct(z, kLogInverse[cell]);
    return {std::fma(k, kLn2Hi, kLogHi[cell]), std::fma(k, kLn2Lo, kLogLo[cell]),
            fastTwoSum(product.hi - 1.0, product.lo)};
}

/// log(x) with a relative error of about 2^-68, for x > 0 and finite.
RT_KERNEL DoubleDouble logarithm(double x) {
    const LogReduction part = reduceLog(x);
    const double r = part.r.hi;
    const DoubleDouble square = twoProduct(r, -0.5 * r);
    const DoubleDouble first = fastTwoSum(part.high, r);
    const DoubleDouble second = fastTwoSum(first.hi, square.hi);
    const double cubic =
        std::fma(r * r * r, polynomial(tables::kLog, r), std::fma(-r, part.r.lo, square.lo));
    return fastTwoSum(second.hi, (first.lo + second.lo) + ((part.low + part.r.lo) + cubic));
}

}  // namespace rt::portable
