// Solid angles, cosines and reflectances on paper, by other ways than the renderer's.
#pragma once

#include <algorithm>
#include <cmath>

namespace rt::test {

/// Solid angle of a cap.
inline double capOf(double halfAngle) {
    return 2.0 * std::acos(-1.0) * (1.0 - std::cos(halfAngle));
}

/// Solid angle that caps of half-angles a and b have in common, their axes d apart and their rims
/// crossing (Tovchigrechko and Vakser, How common is the funnel-like energy landscape in
/// protein-protein interactions?, Protein Science 10, 2001). A half-space is a cap of pi / 2.
inline double commonCap(double a, double b, double d) {
    const double ca = std::cos(a);
    const double cb = std::cos(b);
    const double cd = std::cos(d);
    const double sa = std::sin(a);
    const double sb = std::sin(b);
    const double sd = std::sin(d);
    return 2.0 * (std::acos(-1.0) - std::acos((cd - ca * cb) / (sa * sb)) -
                  std::acos((cb - cd * ca) / (sd * sa)) * ca -
                  std::acos((ca - cd * cb) / (sd * sb)) * cb);
}

/// Weight of a sphere light that fills a cone of half-angle a.
inline double lightWeight(double a) {
    return 2.0 / (1.0 + std::cos(a));
}

/// The mean over a cone of half-angle a, its axis b off the normal, of max(n.w, 0), for a cone that
/// the horizon cuts: pi times the configuration factor from an element to a sphere (Howell, A
/// Catalog of Radiation Heat Transfer Configuration Factors, factor B-43), over the solid angle.
inline double meanCosineOfCutCone(double a, double b) {
    const double x = std::cos(a) / std::sin(a);  // sqrt(h^2 - 1), h = 1 / sin a
    const double y = -x * std::cos(b) / std::sin(b);
    const double part = std::sqrt(1.0 - y * y);
    const double factor =
        std::sin(a) * std::sin(a) * (std::cos(b) * std::acos(y) - x * std::sin(b) * part) +
        std::atan(std::sin(b) * part / x);
    return factor / capOf(a);
}

/// Fresnel's reflectance of unpolarised light by the sines and tangents of the sum and the
/// difference of the two angles (Born and Wolf, Principles of Optics, 1999, section 1.5.2). 1
/// beyond the critical angle.
inline double reflectanceByAngles(double angle, double from, double to) {
    const long double sine = from / static_cast<long double>(to) * std::sin(1.0L * angle);
    if (sine >= 1.0L) return 1.0;
    const long double other = std::asin(sine);
    if (angle < 1e-5) return std::pow((from - to) / (from + to), 2.0);
    const long double s = std::sin(angle - other) / std::sin(angle + other);
    const long double p = std::tan(angle - other) / std::tan(angle + other);
    return static_cast<double>(0.5L * (s * s + p * p));
}

/// The mean of f over the cone of half-angle a about +z, f being a function of the angle to the
/// axis and the angle about it; by the midpoint rule.
template <class F>
double meanOverCone(double a, F f) {
    constexpr int kRings = 400;
    constexpr int kTurns = 400;
    const double pi = std::acos(-1.0);
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        // Rings of equal solid angle.
        const double cosine = 1.0 - (i + 0.5) / kRings * (1.0 - std::cos(a));
        const double t = std::acos(std::min(cosine, 1.0));
        for (int k = 0; k < kTurns; ++k) sum += f(t, 2.0 * pi * (k + 0.5) / kTurns);
    }
    return sum / (kRings * kTurns);
}

}  // namespace rt::test
