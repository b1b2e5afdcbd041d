// Elementary functions with the same bits on every x86-64 processor and compiler.
//
// The C library picks variants with or without fused multiply-add at run time, and their results
// differ in the last bit. These use IEEE +, -, *, /, sqrt, fma and integer operations alone, in an
// order that the source fixes, so their results are a function of their arguments only. They expect
// round-to-nearest, subnormals enabled, and a build with -ffp-contract=off; they do not set errno.
//
// Special values (infinities, NaN, signed zeros) are those of ISO C, Annex F. The bound beside each
// function is on |computed - exact| in ulp of the exact result, for all arguments unless said.
//
// Methods: Muller, Elementary Functions, 2016; Cody and Waite, Software Manual for the Elementary
// Functions, 1980 (argument reduction); Payne and Hanek, SIGNUM Newsletter 18, 1983 (huge
// arguments); Tang, ACM TOMS 15, 1989 and 16, 1990 (tables for exp and log); Borges, ACM TOMS 47,
// 2020 (hypot); Dekker, Numerische Mathematik 18, 1971 (unevaluated sums).
#pragma once

namespace rt::portable {

struct SinCos {
    double sin;
    double cos;
};

/// Angles in radians; infinities give NaN. 0.85 ulp.
double sin(double x);
double cos(double x);
SinCos sincos(double x);
/// 1.0 ulp.
double tan(double x);

/// Angles in degrees, 0.85 ulp for |x| >= 1e-290. Exact at multiples of 30 whose result is
/// rational: 0 (sine's with the sign of x, cosine's positive), +-1/2, +-1.
double sinDegrees(double x);
double cosDegrees(double x);

/// NaN for |x| > 1. 0.72 ulp.
double asin(double x);
double acos(double x);
/// 0.51 ulp.
double atan(double x);
/// Angle of the point (x, y) in [-pi, pi]. 0.51 ulp; 1 ulp where the result is subnormal.
double atan2(double y, double x);

/// 0.52 ulp.
double exp(double x);
double exp2(double x);
/// -infinity at 0, NaN below. 0.52 ulp.
double log(double x);
/// 0.51 ulp, exact for powers of two and of ten.
double log2(double x);
double log10(double x);

/// x^y. 0.52 ulp; 0^0 = 1; a negative x needs an integer y.
double pow(double x, double y);

/// x^p for a Phong lobe: 0 <= x <= 1 and finite p >= 0 (NaN otherwise), 0^0 = 1, powers below
/// 2^-1022 give 0. Error 0.55 + |ln x^p| / 100 ulp: 0.8 ulp down to 1e-10, 8 ulp at worst.
double powUnit(double x, double p);

/// 0.51 ulp.
double cbrt(double x);
/// sqrt(x^2 + y^2) without overflow or underflow on the way. 0.51 ulp; 0.76 where subnormal.
double hypot(double x, double y);

/// 0.55 ulp.
double sinh(double x);
double cosh(double x);
double tanh(double x);

/// Lets the fused instructions of the processor be used (the default where it has them) or not;
/// returns the earlier choice. No result depends on it: it exists so that tests can show that.
/// Not to be called while other threads compute.
bool selectFusedInstructions(bool wanted);

}  // namespace rt::portable
