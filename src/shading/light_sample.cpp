#include "rt/shading/light_sample.h"

#include "rt/core/numeric.h"
#include "rt/math/portable.h"

namespace rt {
namespace {

double smoothStep(double from, double to, double x) {
    if (!(from < to)) return x >= to ? 1.0 : 0.0;
    const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

LightView viewOfSun(const Light& sun) {
    LightView view;
    view.axis = -sun.direction;
    view.distance = kInfinity;
    view.oneMinusCos = sun.oneMinusCos;
    view.weight = 2.0 / (2.0 - sun.oneMinusCos);
    view.irradiance = sun.intensity;
    return view;
}

}  // namespace

std::optional<LightView> viewOfOther(const Light& light, const Vec3& from) {
    if (light.kind == LightKind::kSun) return viewOfSun(light);
    std::optional<LightView> view = viewOfBall(light, from);
    if (!view) return view;
    if (light.kind == LightKind::kSpot) {
        const double cosine = -glm::dot(view->axis, light.direction);
        view->irradiance *= smoothStep(light.outerCosine, light.innerCosine, cosine);
    } else {
        view->rectangle = &light;
        view->weight = 1.0;
    }
    return view;
}

LightRay rayToRectangle(const LightView& view, const Vec2& u, const Vec3& from) {
    const Light& light = *view.rectangle;
    const Vec3 onLight =
        light.position + (2.0 * u.x - 1.0) * light.halfU + (2.0 * u.y - 1.0) * light.halfV;
    const Vec3 way = onLight - from;
    const double d = glm::length(way);
    if (!(d > 0.0)) return {view.axis, Color(0.0)};
    return {way / d, light.intensity / (light.c0 + d * (light.c1 + d * light.c2)), d};
}

SpotPlace placeInSpot(const Light& spot, const Vec3& point, double radius) {
    // So many balls side by side span an edge that is not one to them.
    constexpr double kRoom = 16.0;
    const Vec3 way = point - spot.position;
    const double distance = glm::length(way);
    if (!(distance > radius)) return SpotPlace::kEdge;
    const double cosine = std::clamp(glm::dot(way, spot.direction) / distance, -1.0, 1.0);
    const double angle = portable::acos(cosine);
    // The angle is off by the rounding of its cosine, which is at its worst along the axis.
    const double blur = portable::asin(std::min(radius / distance, 1.0)) + std::sqrt(kUnitDotError);
    if (angle + blur < spot.inner) return SpotPlace::kLit;
    if (angle - blur > spot.outer) return SpotPlace::kDark;
    return spot.outer - spot.inner > kRoom * blur ? SpotPlace::kFading : SpotPlace::kEdge;
}

}  // namespace rt
