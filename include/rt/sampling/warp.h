// Maps of the unit square onto the shapes that are sampled; each keeps areas in proportion, so
// uniform points stay uniform, and keeps neighbours together, so well-spread points stay so.
#pragma once

#include "rt/core/vec.h"
#include "rt/math/portable.h"

#include <cmath>

namespace rt {

/// The unit disc. With (a, b) = 2u - 1: radius r = a, angle pi/4 b/a where |a| > |b|, and
/// r = b, angle pi/2 - pi/4 a/b elsewhere
/// (Shirley and Chiu, A Low Distortion Map Between Disk and Square, J. Graphics Tools 2(3), 1997).
inline Vec2 concentricDisc(const Vec2& u) {
    constexpr double kQuarterPi = 0x1.921fb54442d18p-1;
    const double a = 2.0 * u.x - 1.0;
    const double b = 2.0 * u.y - 1.0;
    const bool sideways = std::fabs(a) > std::fabs(b);
    const double radius = sideways ? a : b;
    const double other = sideways ? b : a;
    if (radius == 0.0) return Vec2(0.0);
    const portable::SinCos angle = portable::sincos(kQuarterPi * (other / radius));
    const double along = radius * angle.cos;
    const double across = radius * angle.sin;
    return {sideways ? along : across, sideways ? across : along};
}

/// Two unit vectors that make a right-handed orthonormal system with the unit vector that was given
/// (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017).
struct Basis {
    Vec3 tangent;
    Vec3 bitangent;
};
inline Basis orthonormalBasis(const Vec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// A unit direction, uniform in solid angle, in the cone of half-angle A about a unit axis;
/// oneMinusCos = 1 - cos A in [0, 2]. With the disc point d: 1 - cos t = |d|^2 (1 - cos A) and
/// sin t = |d| sqrt((1 - cos A)(2 - |d|^2 (1 - cos A))), which loses nothing in the tiniest cone.
inline Vec3 coneDirection(const Vec3& axis, double oneMinusCos, const Vec2& u) {
    const Vec2 disc = concentricDisc(u);
    const double drop = oneMinusCos * (disc.x * disc.x + disc.y * disc.y);
    const double spread = std::sqrt(oneMinusCos * (2.0 - drop));
    const Basis basis = orthonormalBasis(axis);
    return (1.0 - drop) * axis + (spread * disc.x) * basis.tangent +
           (spread * disc.y) * basis.bitangent;
}

}  // namespace rt
