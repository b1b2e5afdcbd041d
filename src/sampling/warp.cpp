#include "rt/sampling/warp.h"

#include "rt/math/portable.h"

#include <cmath>

namespace rt {

Vec2 concentricDisc(const Vec2& u) {
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

Basis orthonormalBasis(const Vec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

Vec3 coneDirection(const Vec3& axis, double oneMinusCos, const Vec2& u) {
    const Vec2 disc = concentricDisc(u);
    const double drop = oneMinusCos * (disc.x * disc.x + disc.y * disc.y);
    const double spread = std::sqrt(oneMinusCos * (2.0 - drop));
    const Basis basis = orthonormalBasis(axis);
    return (1.0 - drop) * axis + (spread * disc.x) * basis.tangent +
           (spread * disc.y) * basis.bitangent;
}

}  // namespace rt
