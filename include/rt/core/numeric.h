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

/// a b - c d with an error of at most 1.5 roundings of the result, without cancellation
/// (Kahan's difference of products; Jeannerod, Louvet, Muller, Math. Comp. 82, 2013).
inline double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    const double error = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + error;
}

}  // namespace rt
