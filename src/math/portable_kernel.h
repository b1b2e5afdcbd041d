// What the portable functions are made of: unevaluated sums, polynomials, and the choice between
// fused instructions and the C library's exact, slow fma.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

// Kernels are inlined into a caller that may use fused instructions and into one that may not.
#define RT_KERNEL [[gnu::always_inline]] static inline

namespace rt::portable {

/// hi + lo, |lo| at most half an ulp of hi.
struct DoubleDouble {
    double hi;
    double lo;
};

/// a + b exactly, for |a| >= |b| or a = 0 (Dekker 1971).
RT_KERNEL DoubleDouble fastTwoSum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly (Knuth, The Art of Computer Programming 2, section 4.2.2).
RT_KERNEL DoubleDouble twoSum(double a, double b) {
    const double sum = a + b;
    const double bPart = sum - a;
    return {sum, (a - (sum - bPart)) + (b - bPart)};
}

/// a b exactly.
RT_KERNEL DoubleDouble twoProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// a / b to about 2^-100.
RT_KERNEL DoubleDouble quotient(DoubleDouble a, DoubleDouble b) {
    const double q = a.hi / b.hi;
    const double rest = std::fma(-q, b.hi, a.hi) + (a.lo - q * b.lo);
    return {q, rest / b.hi};
}

/// Coefficients [First, First + Count) of c by Estrin's scheme; powers holds x, x^2, x^4, x^8.
template <int First, int Count, int N>
RT_KERNEL double estrin(const double (&c)[N], const double (&powers)[4]) {
    if constexpr (Count == 1) {
        return c[First];
    } else {
        constexpr int kLevel = Count > 8 ? 3 : Count > 4 ? 2 : Count > 2 ? 1 : 0;
        constexpr int kHalf = 1 << kLevel;
        return std::fma(estrin<First + kHalf, Count - kHalf>(c, powers), powers[kLevel],
                        estrin<First, kHalf>(c, powers));
    }
}

/// c[0] + c[1] x + ... + c[N-1] x^(N-1).
template <int N>
RT_KERNEL double polynomial(const double (&c)[N], double x) {
    static_assert(N <= 16);
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double powers[4] = {x, x2, x4, x4 * x4};
    return estrin<0, N>(c, powers);
}

/// Adding it rounds a double below 2^51 to an integer, whose low bits are then those of the sum.
inline constexpr double kRoundingShift = 0x1.8p52;

inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

RT_KERNEL std::uint64_t bitsOf(double x) {
    return std::bit_cast<std::uint64_t>(x);
}
RT_KERNEL double fromBits(std::uint64_t bits) {
    return std::bit_cast<double>(bits);
}

/// The integer that x + kRoundingShift holds in its low bits.
RT_KERNEL std::int64_t integerOf(double shifted) {
    return static_cast<std::int64_t>(bitsOf(shifted) - bitsOf(kRoundingShift));
}

/// 2^exponent for -1022 <= exponent <= 1023.
RT_KERNEL double powerOfTwo(std::int64_t exponent) {
    return fromBits(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

#ifdef __FMA__

/// Compiled for processors that have fused instructions: nothing to choose.
template <class Kernel, class... Arguments>
inline auto evaluate(Arguments... arguments) {
    return Kernel::evaluate(arguments...);
}

#else

/// False until static initialisation has looked at the processor; results do not depend on it.
extern bool gUseFused;

template <class Kernel, class... Arguments>
[[gnu::target("fma")]] auto evaluateFused(Arguments... arguments) {
    return Kernel::evaluate(arguments...);
}

template <class Kernel, class... Arguments>
inline auto evaluate(Arguments... arguments) {
    return gUseFused ? evaluateFused<Kernel>(arguments...) : Kernel::evaluate(arguments...);
}

#endif

}  // namespace rt::portable
