#include "portable_kernel.h"
#include "rt/math/portable.h"

namespace rt::portable {
namespace {

struct Cbrt {
    RT_KERNEL double evaluate(double x) {
        double a = std::fabs(x);
        if (!(a > 0.0 && a < HUGE_VAL)) return x + x;
        // Away from overflow and from rounding errors that underflow, by powers of 8.
        double unscale = 1.0;
        if (a < 0x1p-800) {
            a *= 0x1p600;
            unscale = 0x1p-200;
        } else if (a > 0x1p1000) {
            a *= 0x1p-600;
            unscale = 0x1p200;
        }
        // A third of the bit pattern is a third of the logarithm to 5 bits (Kahan); the constant
        // puts 1 on 1 and centres the error.
        double y = fromBits(bitsOf(a) / 3 + 0x2a9f7893782da1ce);
        for (int step = 0; step < 2; ++step) {
            // Halley's iteration triples the number of correct bits.
            const double cube = y * y * y;
            y *= (cube + 2.0 * a) / (2.0 * cube + a);
        }
        const DoubleDouble square = twoProduct(y, y);
        const DoubleDouble cube = twoProduct(square.hi, y);
        const double rest = (a - cube.hi) - std::fma(square.lo, y, cube.lo);
        return std::copysign((y + rest / (3.0 * square.hi)) * unscale, x);
    }
};

/// Borges, An improved algorithm for hypot(a, b), ACM TOMS 47, 2020, for a >= b without overflow.
RT_KERNEL double correctedHypot(double a, double b) {
    const double h = std::sqrt(std::fma(a, a, b * b));
    const DoubleDouble hh = twoProduct(h, h);
    const DoubleDouble aa = twoProduct(a, a);
    const double excess = std::fma(-b, b, hh.hi - aa.hi) + (hh.lo - aa.lo);
    return h - excess / (2.0 * h);
}

struct Hypot {
    RT_KERNEL double evaluate(double x, double y) {
        if (std::isinf(x) || std::isinf(y)) return HUGE_VAL;
        const double ax = std::fabs(x);
        const double ay = std::fabs(y);
        const double a = ax > ay ? ax : ay;
        const double b = ax > ay ? ay : ax;
        // b^2 / (2 a) is less than 2^-10 ulp of a then.
        if (!(b > a * 0x1p-32)) return std::isunordered(x, y) ? x + y : a;
        if (a > 0x1p510) return correctedHypot(a * 0x1p-600, b * 0x1p-600) * 0x1p600;
        if (b < 0x1p-450) return correctedHypot(a * 0x1p600, b * 0x1p600) * 0x1p-600;
        return correctedHypot(a, b);
    }
};

}  // namespace

double cbrt(double x) {
    return evaluate<Cbrt>(x);
}
double hypot(double x, double y) {
    return evaluate<Hypot>(x, y);
}

}  // namespace rt::portable
