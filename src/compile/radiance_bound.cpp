#include "radiance_bound.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

double brightest(const Color& c) {
    return std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
}

bool isNegative(const Color& c) {
    return std::min({c.x, c.y, c.z}) < 0.0;
}

/// Images hold nothing below zero.
bool hasNegative(const RenderScene& scene) {
    const auto dark = [](const Look& look) {
        return isNegative(look.material.diffuse) || isNegative(look.material.specular);
    };
    const auto takes = [](const Light& light) { return isNegative(light.intensity); };
    return isNegative(scene.ambient) || isNegative(scene.background.bottom) ||
           isNegative(scene.background.top) ||
           std::any_of(scene.looks.begin(), scene.looks.end(), dark) ||
           std::any_of(scene.lights.begin(), scene.lights.end(), takes);
}

double distanceTo(const Bounds& box, const Vec3& p) {
    const Vec3 outside = glm::max(glm::max(box.min - p, p - box.max), Vec3(0.0));
    return glm::length(outside);
}

double brightestDiffuse(const Look& look) {
    if (look.texture) return look.texture->largestValue();
    if (look.pattern)
        return std::max(brightest(look.pattern->first), brightest(look.pattern->second));
    return brightest(look.material.diffuse);
}

/// The largest diffuse and specular parts of all looks.
struct Brightest {
    double diffuse = 0.0;
    double specular = 0.0;
};

Brightest brightestLook(const RenderScene& scene) {
    Brightest all;
    for (const Look& look : scene.looks) {
        all.diffuse = std::max(all.diffuse, brightestDiffuse(look));
        all.specular = std::max(all.specular, brightest(look.material.specular));
    }
    return all;
}

/// The greatest irradiance that a light gives on anything, its weight included.
double lightBound(const Light& light, const RenderScene& scene) {
    // What has no bounds may be anywhere.
    const double toCentre =
        scene.unbounded.empty() ? distanceTo(scene.tree.bounds(), light.position) : 0.0;
    const bool isRectangle = light.kind == LightKind::kRectangle;
    const double d =
        isRectangle ? std::max(toCentre - light.radius, 0.0) : std::max(light.radius, toCentre);
    const double falloff = light.c0 + d * (light.c1 + d * light.c2);
    const double weight = isRectangle || isPointLike(light) ? 1.0 : 2.0;
    return falloff > 0.0 ? weight * brightest(light.intensity) / falloff : kInfinity;
}

}  // namespace

double localBound(const RenderScene& scene) {
    const Brightest look = brightestLook(scene);
    return look.diffuse + look.specular;
}

double radianceBound(const RenderScene& scene) {
    double sky = std::max(brightest(scene.background.bottom), brightest(scene.background.top));
    if (scene.background.image) sky = scene.background.image->largestValue();
    const Brightest look = brightestLook(scene);
    double own = look.diffuse * brightest(scene.ambient);
    for (const Light& light : scene.lights) {
        const double bright = lightBound(light, scene);
        const double local = look.diffuse * std::max(1.0, light.brightness) + look.specular;
        if (local > 0.0) own += bright * local;
    }
    const double largest = std::max(own, sky);
    return hasNegative(scene) ? 2.0 * largest : largest;
}

}  // namespace rt
