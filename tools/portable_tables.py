#!/usr/bin/env python3
"""Writes src/math/portable_tables.h: polynomials and tables of the portable elementary functions.

Usage: tools/portable_tables.py > src/math/portable_tables.h     (needs python3-mpmath)

Polynomials interpolate at Chebyshev nodes in 60 digits, which is within a factor of about two of
the minimax error (Muller, Elementary Functions, 2016, section 3.2); the error that remains after
rounding the coefficients to double is measured on a grid and written beside them.
"""
from mpmath import mp, mpf, asin, atan, cos, exp, floor, log, lu_solve, matrix, pi, sin, sqrt

mp.prec = 1400  # 2/pi needs 1152 bits, everything else far fewer


def double(value):
    """The double nearest to value."""
    return float(value)


def bits_of(value, bits):
    """value cut to the given number of significant bits, so that small integers times it are exact."""
    scale = mpf(2) ** (bits - 1 - int(floor(log(abs(value), 2))))
    return mpf(int(floor(value * scale))) / scale


def interpolate(function, low, high, count):
    """Monomial coefficients of the interpolant of function on [low, high], rounded to double."""
    middle, half = (mpf(low) + high) / 2, (mpf(high) - low) / 2
    nodes = [middle + half * cos(pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    powers = matrix([[x**j for j in range(count)] for x in nodes])
    return [double(c) for c in lu_solve(powers, matrix([function(x) for x in nodes]))]


def error_of(coefficients, function, low, high, weight):
    """Base-2 logarithm of the largest weighted error on a grid that avoids the removable zero."""
    worst = mpf(0)
    for i in range(400):
        x = mpf(low) + (mpf(high) - low) * (2 * i + 1) / 800
        value = sum(mpf(c) * x**j for j, c in enumerate(coefficients))
        worst = max(worst, abs(value - function(x)) * weight(x))
    return float(log(worst, 2))


def hexadecimal(value):
    return double(value).hex().replace("0x0.0p+0", "0.0").replace("0x1.0000000000000p", "0x1p")


def rows(name, values, kind="double", per_line=3, text=hexadecimal):
    print(f"inline constexpr {kind} {name}[] = {{")
    for i in range(0, len(values), per_line):
        print("    " + ", ".join(text(v) for v in values[i:i + per_line]) + ",")
    print("};\n")


def polynomial(name, comment, function, interval, count, weight):
    coefficients = interpolate(function, *interval, count)
    exponent = error_of(coefficients, function, *interval, weight)
    print(f"/// {comment} error 2^{exponent:.1f}.")
    rows(name, coefficients)


def pair(name, comment, value, high_bits=53):
    high = mpf(double(bits_of(value, high_bits) if high_bits < 53 else value))
    print(f"/// {comment}")
    print(f"inline constexpr double {name}Hi = {hexadecimal(high)};")
    print(f"inline constexpr double {name}Lo = {hexadecimal(value - high)};\n")


def polynomials():
    quarter = (pi / 4 * (1 + mpf(2) ** -20)) ** 2
    polynomial("kSin", "sin(r) = r + r^3 S(r^2) for |r| <= pi/4: relative",
               lambda z: (sin(sqrt(z)) / sqrt(z) - 1) / z, (0, quarter), 7, lambda z: z)
    polynomial("kCos", "cos(r) = 1 - r^2/2 + r^4 C(r^2) for |r| <= pi/4: absolute",
               lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2, (0, quarter), 7, lambda z: z**2)
    edge = log(2) / 256 * (1 + mpf(2) ** -20)
    polynomial("kExp", "exp(r) = 1 + r + r^2 E(r) for |r| <= ln 2 / 256: absolute",
               lambda r: (exp(r) - 1 - r) / r**2, (-edge, edge), 4, lambda r: r**2)
    polynomial("kLog", "log(1 + r) = r - r^2/2 + r^3 L(r) for -2^-8 <= r <= 2^-7: relative",
               lambda r: (log(1 + r) - r + r**2 / 2) / r**3,
               (-mpf(2) ** -8, mpf(2) ** -7), 7, lambda r: r**2)
    polynomial("kAtan", "atan(t) = t + t^3 A(t^2) for |t| <= 1/128: relative",
               lambda z: (atan(sqrt(z)) / sqrt(z) - 1) / z, (0, mpf(2) ** -14), 4, lambda z: z)
    polynomial("kAsin", "asin(s) = s + s^3 P(s^2) for |s| <= 1/2: relative",
               lambda z: (asin(sqrt(z)) / sqrt(z) - 1) / z, (0, mpf(1) / 4), 14, lambda z: z)


def exponential_table():
    exact = [mpf(2) ** (mpf(j) / 128) for j in range(128)]
    print("/// 2^(j/128) rounded to double, j = 0 .. 127 (Tang, ACM TOMS 15, 1989).")
    rows("kExpTable", exact)
    print("/// What the rounding left, relative: 2^(j/128) / kExpTable[j] - 1.")
    rows("kExpTail", [e / mpf(double(e)) - 1 for e in exact])


def logarithm_table():
    """Cell i holds the doubles of [0.6875, 1.375) whose bits are those of 0.6875 + i 2^45 and on."""
    inverse, high, low = [], [], []
    for i in range(128):
        # cells below 1 are 2^-8 wide and start at 0.6875, those from 1 on are 2^-7 wide
        start = mpf("0.6875") + mpf(i) / 256 if i < 80 else 1 + mpf(i - 80) / 128
        width = mpf(1) / 256 if i < 80 else mpf(1) / 128
        reciprocal = mpf(1) if i in (79, 80) else mpf(double(1 / (start + width / 2)))
        value = -log(reciprocal)
        coarse = floor(value * mpf(2) ** 42 + mpf(1) / 2) / mpf(2) ** 42
        inverse.append(reciprocal)
        high.append(coarse)
        low.append(value - coarse)
    print("/// 1/c, c the middle of the cell; 1 in both cells that touch 1.")
    rows("kLogInverse", inverse)
    print("/// log(c) to a multiple of 2^-42, so that k ln 2 + log(c) is exact.")
    rows("kLogHi", high)
    print("/// The rest of log(c).")
    rows("kLogLo", low)


def arctangent_table():
    exact = [atan(mpf(i) / 64) for i in range(65)]
    print("/// atan(i/64), i = 0 .. 64.")
    rows("kAtanHi", exact)
    print("/// The rest of atan(i/64).")
    rows("kAtanLo", [e - mpf(double(e)) for e in exact])


def constants():
    pair("kHalfPi", "pi/2 as an unevaluated sum.", pi / 2)
    pair("kPi", "pi as an unevaluated sum.", +pi)
    first = bits_of(pi / 2, 33)
    print("/// pi/2 in three parts for the reduction; the first has 33 bits, so that n times it is exact")
    print("/// for |n| < 2^20 (Cody and Waite, Software Manual for the Elementary Functions, 1980).")
    print(f"inline constexpr double kReduce1 = {hexadecimal(first)};")
    second = mpf(double(pi / 2 - first))
    print(f"inline constexpr double kReduce2 = {hexadecimal(second)};")
    print(f"inline constexpr double kReduce3 = {hexadecimal(pi / 2 - first - second)};\n")
    print("/// 2/pi and ln 2 rounded to double.")
    print(f"inline constexpr double kTwoOverPiNearest = {hexadecimal(2 / pi)};")
    print(f"inline constexpr double kLn2 = {hexadecimal(log(2))};\n")
    pair("kDegree", "pi/180 as an unevaluated sum.", pi / 180)
    pair("kLn2", "ln 2; the first part has 41 bits on the grid of kLogHi, so that k ln 2 is exact.",
         log(2), 41)
    pair("kLn2By128", "ln 2 / 128 as an unevaluated sum.", log(2) / 128)
    pair("kLog2E", "1 / ln 2 as an unevaluated sum.", 1 / log(2))
    pair("kLog10E", "1 / ln 10 as an unevaluated sum.", 1 / log(10))
    words = [int(floor(2 / pi * mpf(2) ** (64 * i))) % 2**64 for i in range(21)]
    print("/// The bits of 2/pi, 64 a word; the word before the point, which is 0, comes first.")
    rows("kTwoOverPi", words, "std::uint64_t", 4, lambda w: f"0x{w:016x}")


def main():
    print("// Written by tools/portable_tables.py; edit that, not this.")
    print("// clang-format off")
    print("#pragma once\n\n#include <cstdint>\n\nnamespace rt::portable::tables {\n")
    constants()
    polynomials()
    exponential_table()
    logarithm_table()
    arctangent_table()
    print("}  // namespace rt::portable::tables")


main()
