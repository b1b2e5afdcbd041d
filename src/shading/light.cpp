#include "rt/shading/light.h"

#include "rt/math/portable.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr double kRadiansPerDegree = 0x1.1df46a2529d39p-6;

}  // namespace

bool isPointLike(const Light& light) {
    return light.radius == 0.0 && light.oneMinusCos == 0.0;
}

Light spotLight(Light ball, const Vec3& direction, double innerDegrees, double outerDegrees) {
    ball.kind = LightKind::kSpot;
    ball.direction = direction;
    ball.inner = innerDegrees * kRadiansPerDegree;
    ball.outer = outerDegrees * kRadiansPerDegree;
    ball.innerCosine = portable::cosDegrees(innerDegrees);
    ball.outerCosine = portable::cosDegrees(outerDegrees);
    return ball;
}

Light sunLight(const Vec3& direction, const Color& intensity, double halfAngleDegrees,
               double brightness) {
    Light light;
    light.kind = LightKind::kSun;
    light.direction = direction;
    light.intensity = intensity;
    light.brightness = brightness;
    const double half = portable::sinDegrees(0.5 * halfAngleDegrees);
    light.oneMinusCos = 2.0 * half * half;
    return light;
}

Light rectangleLight(Light point, const Vec3& corner, const Vec3& u, const Vec3& v) {
    point.kind = LightKind::kRectangle;
    point.halfU = 0.5 * u;
    point.halfV = 0.5 * v;
    point.position = corner + point.halfU + point.halfV;
    point.radius =
        std::max(glm::length(point.halfU + point.halfV), glm::length(point.halfU - point.halfV));
    return point;
}

}  // namespace rt
