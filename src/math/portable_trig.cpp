#include "portable_kernel.h"
#include "portable_tables.h"
#include "rt/math/portable.h"

namespace rt::portable {

namespace {

using namespace tables;

/// Below this, x^3/6 and x^3/3 are less than a quarter of an ulp of x.
constexpr double kTiny = 0x1p-27;
/// Up to here there is nothing to reduce.
constexpr double kQuarterPi = 0.5 * kHalfPiHi;
/// Up to here n = x / (pi/2) has 20 bits, and n kReduce1 is exact.
constexpr double kSmallLimit = 0x1p20;

/// angle = quadrant pi/2 + hi + lo, |hi| <= pi/4 up to rounding.
struct Reduced {
    double hi;
    double lo;
    std::uint64_t quadrant;
};

/// Cody and Waite's reduction with its rounding errors kept.
RT_KERNEL Reduced reduceSmall(double x) {
    const double shifted = x * kTwoOverPiNearest + kRoundingShift;
    const double n = shifted - kRoundingShift;
    const double first = std::fma(-n, kReduce1, x);
    const DoubleDouble second = twoProduct(n, kReduce2);
    const DoubleDouble difference = twoSum(first, -second.hi);
    const double rest = (difference.lo - second.lo) - n * kReduce3;
    const DoubleDouble angle = fastTwoSum(difference.hi, rest);
    return {angle.hi, angle.lo, bitsOf(shifted)};
}

/// 64 bits of 2/pi from bit position on, where bit 64 has the weight 1/2.
std::uint64_t twoOverPiBits(unsigned position) {
    const unsigned word = position / 64;
    const unsigned shift = position % 64;
    if (shift == 0) return kTwoOverPi[word];
    return kTwoOverPi[word] << shift | kTwoOverPi[word + 1] >> (64 - shift);
}

/// Payne and Hanek: x 2/pi modulo 4, from the 192 bits of 2/pi that can reach it.
[[gnu::noinline]] Reduced reduceHuge(double x) {
    __extension__ using Wide = unsigned __int128;
    const std::uint64_t bits = bitsOf(x);
    const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;
    const auto exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1075;
    // Bits of 2/pi whose product with the mantissa is a multiple of 4 are left out.
    const auto start = static_cast<unsigned>(exponent - 2 + 64);
    const Wide low = static_cast<Wide>(mantissa) * twoOverPiBits(start + 128);
    const Wide middle = static_cast<Wide>(mantissa) * twoOverPiBits(start + 64) +
                        static_cast<std::uint64_t>(low >> 64);
    const std::uint64_t high =
        mantissa * twoOverPiBits(start) + static_cast<std::uint64_t>(middle >> 64);
    const Wide top = static_cast<Wide>(high) << 64 | static_cast<std::uint64_t>(middle);
    Wide fraction = top << 2 | static_cast<std::uint64_t>(low) >> 62;
    std::uint64_t quadrant = high >> 62;
    const bool above = fraction >> 127 != 0;
    if (above) {
        fraction = -fraction;
        ++quadrant;
    }
    const auto head = static_cast<std::uint64_t>(fraction >> 64);
    const int zeros = head != 0 ? std::countl_zero(head) : 64;
    fraction <<= zeros;
    const double scale = powerOfTwo(-zeros);
    const double hi = static_cast<double>(static_cast<std::uint64_t>(fraction >> 75)) * 0x1p-53;
    const double lo =
        static_cast<double>(static_cast<std::uint64_t>(fraction >> 22) & 0x1fffffffffffff) *
        0x1p-106;
    const DoubleDouble product = twoProduct(hi, kHalfPiHi);
    const DoubleDouble angle =
        fastTwoSum(product.hi, product.lo + (hi * kHalfPiLo + lo * kHalfPiHi));
    const double sign = (bits >> 63 != 0) != above ? -scale : scale;
    return {angle.hi * sign, angle.lo * sign, bits >> 63 != 0 ? 0 - quadrant : quadrant};
}

RT_KERNEL Reduced reduce(double x) {
    return std::fabs(x) < kSmallLimit ? reduceSmall(x) : reduceHuge(x);
}

/// sin(hi + lo) = sum of the two parts, |hi| <= pi/4.
RT_KERNEL DoubleDouble sinParts(double hi, double lo) {
    const double z = hi * hi;
    return {hi, std::fma(z * hi, polynomial(kSin, z), lo * std::fma(-0.5, z, 1.0))};
}

/// cos(hi + lo) = sum of the two parts, |hi| <= pi/4.
RT_KERNEL DoubleDouble cosParts(double hi, double lo) {
    const DoubleDouble z = twoProduct(hi, hi);
    const DoubleDouble head = fastTwoSum(1.0, -0.5 * z.hi);
    const double tail = std::fma(hi, lo, 0.5 * z.lo);
    return {head.hi, head.lo + std::fma(z.hi * z.hi, polynomial(kCos, z.hi), -tail)};
}

RT_KERNEL DoubleDouble normalized(DoubleDouble parts) {
    return fastTwoSum(parts.hi, parts.lo);
}

RT_KERNEL double total(DoubleDouble parts) {
    return parts.hi + parts.lo;
}

/// sin(quadrant pi/2 + hi + lo).
RT_KERNEL double sinOf(Reduced angle, std::uint64_t quadrant) {
    const double value = (quadrant & 1) != 0 ? total(cosParts(angle.hi, angle.lo))
                                             : total(sinParts(angle.hi, angle.lo));
    return (quadrant & 2) != 0 ? -value : value;
}

struct Sin {
    RT_KERNEL double evaluate(double x) {
        if (std::fabs(x) < kTiny) return x;
        if (!std::isfinite(x)) return x - x;
        const Reduced angle = reduce(x);
        return sinOf(angle, angle.quadrant);
    }
};

struct Cos {
    RT_KERNEL double evaluate(double x) {
        if (!std::isfinite(x)) return x - x;
        const Reduced angle = reduce(x);
        return sinOf(angle, angle.quadrant + 1);
    }
};

struct Both {
    RT_KERNEL SinCos evaluate(double x) {
        if (std::fabs(x) <= kQuarterPi) {
            const double cosine = total(cosParts(x, 0.0));
            return {std::fabs(x) < kTiny ? x : total(sinParts(x, 0.0)), cosine};
        }
        if (!std::isfinite(x)) return {x - x, x - x};
        const Reduced angle = reduce(x);
        const double s = total(sinParts(angle.hi, angle.lo));
        const double c = total(cosParts(angle.hi, angle.lo));
        const bool odd = (angle.quadrant & 1) != 0;
        const double sine = odd ? c : s;
        const double cosine = odd ? s : c;
        return {(angle.quadrant & 2) != 0 ? -sine : sine,
                ((angle.quadrant + 1) & 2) != 0 ? -cosine : cosine};
    }
};

struct Tan {
    RT_KERNEL double evaluate(double x) {
        if (std::fabs(x) < kTiny) return x;
        if (!std::isfinite(x)) return x - x;
        const Reduced angle = reduce(x);
        const DoubleDouble sine = normalized(sinParts(angle.hi, angle.lo));
        const DoubleDouble cosine = normalized(cosParts(angle.hi, angle.lo));
        if ((angle.quadrant & 1) == 0) return total(quotient(sine, cosine));
        return total(quotient({-cosine.hi, -cosine.lo}, sine));
    }
};

/// sin(x degrees + shift right angles).
struct SinDegrees {
    RT_KERNEL double evaluate(double x, std::uint64_t shift) {
        if (!std::isfinite(x)) return x - x;
        const double turn = std::fmod(x, 360.0);
        const double shifted = turn * (1.0 / 90.0) + kRoundingShift;
        const std::uint64_t quadrant = bitsOf(shifted) + shift;
        // Exact: a multiple of the ulp of turn, and at most 45.
        const double rest = std::fma(shifted - kRoundingShift, -90.0, turn);
        if (rest == 0.0 && (quadrant & 1) == 0) return shift == 0 ? std::copysign(0.0, x) : 0.0;
        const double hi = rest * kDegreeHi;
        const double lo = std::fma(rest, kDegreeHi, -hi) + rest * kDegreeLo;
        return sinOf({hi, lo, quadrant}, quadrant);
    }
};

}  // namespace

double sin(double x) {
    return evaluate<Sin>(x);
}
double cos(double x) {
    return evaluate<Cos>(x);
}
SinCos sincos(double x) {
    return evaluate<Both>(x);
}
double tan(double x) {
    return evaluate<Tan>(x);
}
double sinDegrees(double x) {
    return evaluate<SinDegrees>(x, std::uint64_t{0});
}
double cosDegrees(double x) {
    return evaluate<SinDegrees>(x, std::uint64_t{1});
}

}  // namespace rt::portable
