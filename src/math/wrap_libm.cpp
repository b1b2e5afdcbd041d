// Lets everything that is linked statically, the Lua library's math functions and its ^ operator
// included, use the portable functions. It takes effect with these linker options:
//
//   -Wl,-u,__wrap_sin
//   -Wl,--wrap=sin,--wrap=cos,--wrap=tan,--wrap=asin,--wrap=acos,--wrap=atan,--wrap=atan2
//   -Wl,--wrap=sincos,--wrap=exp,--wrap=exp2,--wrap=log,--wrap=log2,--wrap=log10,--wrap=pow
//   -Wl,--wrap=sinh,--wrap=cosh,--wrap=tanh,--wrap=cbrt,--wrap=hypot
//
// The first draws this file out of a static library that stands before the users of its symbols.
// Shared libraries are not affected, so Lua has to come from its archive.
#include "rt/math/portable.h"

// The names are the linker's: a reference to sin becomes one to __wrap_sin.
extern "C" {

double __wrap_sin(double x) {
    return rt::portable::sin(x);
}
double __wrap_cos(double x) {
    return rt::portable::cos(x);
}
void __wrap_sincos(double x, double* sine, double* cosine) {
    const rt::portable::SinCos both = rt::portable::sincos(x);
    *sine = both.sin;
    *cosine = both.cos;
}
double __wrap_tan(double x) {
    return rt::portable::tan(x);
}
double __wrap_asin(double x) {
    return rt::portable::asin(x);
}
double __wrap_acos(double x) {
    return rt::portable::acos(x);
}
double __wrap_atan(double x) {
    return rt::portable::atan(x);
}
double __wrap_atan2(double y, double x) {
    return rt::portable::atan2(y, x);
}
double __wrap_exp(double x) {
    return rt::portable::exp(x);
}
double __wrap_exp2(double x) {
    return rt::portable::exp2(x);
}
double __wrap_log(double x) {
    return rt::portable::log(x);
}
double __wrap_log2(double x) {
    return rt::portable::log2(x);
}
double __wrap_log10(double x) {
    return rt::portable::log10(x);
}
double __wrap_pow(double x, double y) {
    return rt::portable::pow(x, y);
}
double __wrap_sinh(double x) {
    return rt::portable::sinh(x);
}
double __wrap_cosh(double x) {
    return rt::portable::cosh(x);
}
double __wrap_tanh(double x) {
    return rt::portable::tanh(x);
}
double __wrap_cbrt(double x) {
    return rt::portable::cbrt(x);
}
double __wrap_hypot(double x, double y) {
    return rt::portable::hypot(x, y);
}

}  // extern "C"
