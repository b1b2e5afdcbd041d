#include "photon_plan.h"

#include "rt/core/numeric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {
namespace {

/// Groups of a pass: their scatter tells the noise of the mean to about a quarter.
constexpr std::uint32_t kGroups = 8;

/// Photons of one group in one pass, and the least of one source.
constexpr std::uint32_t kPhotons = 8192;
constexpr std::uint32_t kLeastPhotons = 16;

/// Every photon is held against all targets.
constexpr std::size_t kMostTargets = 32;

/// In the world, around one object.
PhotonTarget ballAround(const RenderScene& scene, const Instance& instance) {
    const Shape& shape = scene.shapes[instance.shape];
    if (!kindOf(shape).bounded) return {};
    const Affine& toWorld = instance.transform.toWorld();
    const Bounds local = boundsOf(shape);
    if (std::holds_alternative<Sphere>(shape) && instance.objectScale > 0.0) {
        return {toWorld.point(local.centre()), 0.5 * local.extent().x / instance.objectScale};
    }
    const Bounds world = instance.transform.boundsToWorld(local);
    PhotonTarget ball{world.centre(), 0.5 * glm::length(world.extent())};
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape)) {
        double most = 0.0;
        for (const Vec3& p : (*mesh)->mesh.positions) {
            most = std::max(most, glm::distance(toWorld.point(p), ball.centre));
        }
        ball.radius = std::min(ball.radius, most);
    }
    return ball;
}

PhotonTarget around(const PhotonTarget& a, const PhotonTarget& b) {
    const Vec3 way = b.centre - a.centre;
    const double distance = glm::length(way);
    if (a.radius >= distance + b.radius) return a;
    if (b.radius >= distance + a.radius) return b;
    const double radius = 0.5 * (a.radius + distance + b.radius);
    return {a.centre + ((radius - a.radius) / distance) * way, radius};
}

/// Halves the balls along their longest axis until there are few enough, and joins what is left
/// together.
void join(std::vector<PhotonTarget>& balls, std::size_t begin, std::size_t end, std::size_t most,
          std::vector<PhotonTarget>& joined) {
    if (end - begin <= most) {
        joined.insert(joined.end(), balls.begin() + static_cast<std::ptrdiff_t>(begin),
                      balls.begin() + static_cast<std::ptrdiff_t>(end));
        return;
    }
    if (most == 1) {
        PhotonTarget all = balls[begin];
        for (std::size_t i = begin + 1; i < end; ++i) all = around(all, balls[i]);
        joined.push_back(all);
        return;
    }
    Bounds centres;
    for (std::size_t i = begin; i < end; ++i) centres.unite(balls[i].centre);
    const Vec3 extent = centres.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto at = [&](std::size_t i) { return balls.begin() + static_cast<std::ptrdiff_t>(i); };
    std::stable_sort(at(begin), at(end), [axis](const PhotonTarget& a, const PhotonTarget& b) {
        return a.centre[axis] < b.centre[axis];
    });
    const std::size_t middle = begin + (end - begin) / 2;
    join(balls, begin, middle, most / 2, joined);
    join(balls, middle, end, most - most / 2, joined);
}

double brightest(const Color& c) {
    return std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
}

/// About the flux from a light to a target.
double fluxTo(const Light& light, const PhotonTarget& target, const PhotonTarget& scene) {
    const PhotonTarget& ball = target.radius < kInfinity ? target : scene;
    const double reach = ball.radius + light.radius;
    if (light.kind == LightKind::kSun) {
        return std::numbers::pi * ball.radius * ball.radius * brightest(light.intensity);
    }
    const double d = std::max(glm::distance(light.position, ball.centre), reach);
    if (!(d > 0.0)) return 0.0;
    const double sine = reach / d;
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    return 2.0 * std::numbers::pi * sine * sine / (1.0 + cosine) * d * d *
           brightest(light.intensity) / (light.c0 + d * (light.c1 + d * light.c2));
}

}  // namespace

PhotonPlan photonPlan(const RenderScene& scene, std::uint64_t seed) {
    PhotonPlan plan;
    plan.groups = kGroups;
    plan.seed = seed;
    PhotonTarget all{Vec3(0.0), 1.0};
    if (!scene.tree.isEmpty()) {
        const Bounds bounds = scene.tree.bounds();
        all = {bounds.centre(), 0.5 * glm::length(bounds.extent())};
    }
    std::vector<PhotonTarget> balls;
    bool everywhere = false;
    for (const Instance& instance : scene.instances) {
        if (!scene.looks[instance.look].sendsOn()) continue;
        const PhotonTarget ball = ballAround(scene, instance);
        if (ball.radius < kInfinity) {
            balls.push_back(ball);
        } else {
            everywhere = true;
        }
    }
    join(balls, 0, balls.size(), kMostTargets, plan.targets);
    if (everywhere) plan.targets.emplace_back();
    for (const PhotonTarget& target : plan.targets) {
        const double radius = target.radius < kInfinity ? target.radius : all.radius;
        plan.reach = std::max(plan.reach, glm::distance(target.centre, all.centre) + radius);
    }
    plan.reach += all.radius;

    double sum = 0.0;
    std::vector<double> fluxes;
    for (Index light = 0; light < scene.lights.size(); ++light) {
        if (!scene.lights[light].byPhotons) continue;
        for (Index target = 0; target < plan.targets.size(); ++target) {
            plan.sources.push_back({light, target, kLeastPhotons});
            fluxes.push_back(fluxTo(scene.lights[light], plan.targets[target], all));
            sum += fluxes.back();
        }
    }
    for (std::size_t i = 0; i < fluxes.size() && sum > 0.0 && sum < kInfinity; ++i) {
        plan.sources[i].count =
            std::max(kLeastPhotons, static_cast<std::uint32_t>(kPhotons * (fluxes[i] / sum)));
    }
    return plan;
}

}  // namespace rt
