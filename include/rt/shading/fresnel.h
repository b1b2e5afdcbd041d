// Refraction at the boundary of two media.
#pragma once

#include "rt/core/vec.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt {

/// Unpolarised Fresnel reflectance of a smooth boundary between dielectrics, in 0 .. 1; 1 beyond
/// the critical angle. `cosIncident` in 0 .. 1 is on the side of index `from`. Born and Wolf,
/// Principles of Optics, 7th edition, 1999, section 1.5.2.
inline double fresnelReflectance(double cosIncident, double from, double to) {
    if (from == to) return 0.0;
    const double eta = from / to;
    const double sin2 = eta * eta * (1.0 - cosIncident * cosIncident);
    if (!(sin2 < 1.0)) return 1.0;
    const double cosRefracted = std::sqrt(1.0 - sin2);
    const double parallel =
        (to * cosIncident - from * cosRefracted) / (to * cosIncident + from * cosRefracted);
    const double across =
        (from * cosIncident - to * cosRefracted) / (from * cosIncident + to * cosRefracted);
    return 0.5 * (parallel * parallel + across * across);
}

/// The same for light whose angle is known in the thinner of the two media, whichever side it comes
/// from: never totally reflected.
inline double fresnelFromThinSide(double cosInThinner, double a, double b) {
    return fresnelReflectance(cosInThinner, std::min(a, b), std::max(a, b));
}

/// Unit direction `d` mirrored at the unit normal `n`.
inline Vec3 mirrored(const Vec3& d, const Vec3& n) {
    return d - 2.0 * glm::dot(d, n) * n;
}

/// Unit direction `d` refracted by Snell's law at unit normal `n` (d.n <= 0), or nothing beyond the
/// critical angle.
inline std::optional<Vec3> refracted(const Vec3& d, const Vec3& n, double from, double to) {
    if (from == to) return d;
    const double eta = from / to;
    const double cosIncident = -glm::dot(d, n);
    const double cos2 = 1.0 - eta * eta * (1.0 - cosIncident * cosIncident);
    if (!(cos2 > 0.0)) return std::nullopt;
    return glm::normalize(eta * d + (eta * cosIncident - std::sqrt(cos2)) * n);
}

}  // namespace rt
