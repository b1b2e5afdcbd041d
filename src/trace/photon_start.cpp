#include "photon_start.h"

#include "rt/sampling/warp.h"
#include "rt/shading/light_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {
namespace {

/// The directions from a point that may meet a target, from within `spread` beside it.
struct TargetCone {
    Vec3 axis{0.0, 1.0, 0.0};
    double oneMinusCos = 2.0;

    bool contains(const Vec3& direction) const {
        return 1.0 - glm::dot(direction, axis) <= oneMinusCos;
    }
};

TargetCone coneOf(const PhotonTarget& target, const Vec3& from, double spread) {
    const Vec3 way = target.centre - from;
    const double distance = glm::length(way);
    const double reach = target.radius + spread;
    if (!(distance > reach)) return {};
    const double sine = reach / distance;
    return {way / distance, sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)))};
}

Vec3 acrossOf(const Vec3& direction, const Vec2& disc) {
    const Basis basis = orthonormalBasis(direction);
    return disc.x * basis.tangent + disc.y * basis.bitangent;
}

PhotonStart sunStart(const Light& sun, const PhotonPlan& plan, const PhotonSource& source,
                     const Vec2& onTarget, const Vec2& inDisc) {
    const PhotonTarget& target = plan.targets[source.target];
    const Vec3 direction = -coneDirection(-sun.direction, sun.oneMinusCos, inDisc);
    const Vec3 through =
        target.centre + target.radius * acrossOf(direction, concentricDisc(onTarget));
    int sharing = 0;
    for (Index i = 0; i < plan.targets.size(); ++i) {
        const Vec3 way = plan.targets[i].centre - through;
        const Vec3 aside = way - glm::dot(way, direction) * direction;
        if (i == source.target || glm::length(aside) <= plan.targets[i].radius) ++sharing;
    }
    PhotonStart start;
    start.light = &sun;
    start.ray = {through - plan.reach * direction, direction};
    start.share =
        std::numbers::pi * target.radius * target.radius * 2.0 / (2.0 - sun.oneMinusCos) / sharing;
    return start;
}

}  // namespace

PhotonStart photonStart(const RenderScene& scene, const PhotonPlan& plan,
                        const PhotonSource& source, const UnitPoint& direction,
                        const UnitPoint& place) {
    const Light& light = scene.lights[source.light];
    const Vec2 first(direction.x, direction.y);
    const Vec2 second(place.x, place.y);
    if (light.kind == LightKind::kSun) return sunStart(light, plan, source, first, second);

    PhotonStart start;
    start.light = &light;
    start.centre = light.position;
    double radius = light.radius;
    if (light.kind == LightKind::kRectangle) {
        start.centre += (2.0 * second.x - 1.0) * light.halfU + (2.0 * second.y - 1.0) * light.halfV;
        radius = 0.0;
    }
    const TargetCone cone = coneOf(plan.targets[source.target], start.centre, radius);
    start.ray = {start.centre, coneDirection(cone.axis, cone.oneMinusCos, first)};
    int sharing = 0;
    for (Index i = 0; i < plan.targets.size(); ++i) {
        if (i == source.target ||
            coneOf(plan.targets[i], start.centre, radius).contains(start.ray.direction)) {
            ++sharing;
        }
    }
    if (radius > 0.0) {
        const Vec2 disc = concentricDisc(second);
        const double height = std::sqrt(std::max(1.0 - disc.x * disc.x - disc.y * disc.y, 0.0));
        start.ray.origin +=
            radius * (acrossOf(start.ray.direction, disc) + height * start.ray.direction);
    }
    start.share = 2.0 * std::numbers::pi * cone.oneMinusCos / sharing;
    return start;
}

Color fluxAfter(const PhotonStart& start, double way) {
    const Light& light = *start.light;
    const Vec3 at = start.ray.at(way);
    if (light.kind == LightKind::kSun) return start.share * light.intensity;
    const double squared = glm::dot(at - start.centre, at - start.centre);
    if (light.kind == LightKind::kRectangle) {
        const double d = std::sqrt(squared);
        return (start.share * squared / (light.c0 + d * (light.c1 + d * light.c2))) *
               light.intensity;
    }
    const std::optional<LightView> view = viewOf(light, at);
    return view ? start.share * squared * view->irradiance : Color(0.0);
}

}  // namespace rt
