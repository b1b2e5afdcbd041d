// The Tracer's light at one point: Phong's local colour by one direction to each light, and what
// the objects in its way let through.
#pragma once

#include "rt/core/numeric.h"
#include "rt/sampling/warp.h"
#include "rt/shading/fresnel.h"
#include "rt/shading/phong.h"
#include "tracer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rt {

template <unsigned Features>
Color Tracer<Features>::ownColor(const Path& path, double own, const ShadePoint& point) {
    Color sum = point.material.diffuse * scene_.ambient;
    if constexpr (kManyLights) {
        if (settings_.lightsAtPoint > 0 && !scene_.lightTree.isEmpty()) {
            return sum + fromChosen(path, own, point);
        }
    }
    for (Index light = 0; light < scene_.lights.size(); ++light) {
        sum += lightFrom(light, 1.0, path, point);
    }
    return sum;
}

/// The expected sum over all lights, from a few. What counts for little gets fewer.
template <unsigned Features>
Color Tracer<Features>::fromChosen(const Path& path, double own, const ShadePoint& point) {
    const LightTree& tree = scene_.lightTree;
    const double share = std::min(largestOf(path.weight) * own, 1.0);
    const int count = static_cast<int>(std::ceil(share * settings_.lightsAtPoint));
    const auto noLight = static_cast<Index>(scene_.lights.size());
    const double shift = sampler_.light(path.node, noLight).x;
    const LightTree::Choice choice =
        tree.choose(point.position, point.geometricNormal, point.normal, count, shift);
    Color sum(0.0);
    for (const Index sun : tree.suns()) sum += lightFrom(sun, 1.0, path, point);
    for (int i = 0; i < choice.count; ++i) {
        const ChosenLight& chosen = choice.lights[static_cast<std::size_t>(i)];
        sum += lightFrom(chosen.light, chosen.weight, path, point);
    }
    return sum;
}

template <unsigned Features>
Color Tracer<Features>::lightFrom(Index index, double weight, const Path& path,
                                  const ShadePoint& point) {
    const Light& light = scene_.lights[index];
    const std::optional<LightView> view = viewOfLight(light, point.position);
    if (!view) return Color(0.0);
    LightRay ray = view->onlyRay();
    if constexpr (kAreaLights) {
        if (!view->isPoint()) ray = view->ray(sampler_.light(path.node, index), point.position);
    }
    const Color local = weight * lightAlong(ray, light.brightness, path, point);
    if (local == Color(0.0)) return local;
    const Share visible = visibilityOf(index, ray.w, view->reach(ray), path.media, point, nullptr);
    if constexpr (kTells) tellLight(index, ray.w, view->reach(ray), local, visible, point);
    return visible * local;
}

template <unsigned Features>
std::optional<LightView> Tracer<Features>::viewOfLight(const Light& light, const Vec3& from) const {
    if constexpr (kLightKinds) return viewOf(light, from);
    return viewOfBall(light, from);
}

/// V from the point; where that is 0, from the rounded surface that a facet stands for, if nothing
/// stands between the point and there: no light comes from beyond something else. What blocks is
/// among `occluders`, where these are known.
template <unsigned Features>
typename Tracer<Features>::Share Tracer<Features>::visibilityOf(Index light, const Vec3& w,
                                                                double reach,
                                                                const MediumSet& media,
                                                                const ShadePoint& point,
                                                                const Occluders* occluders) {
    const auto seen = [&](const Vec3& from) {
        const Ray ray{point.leave(from, w), w};
        return occluders ? visibilityPast(*occluders, light, ray, reach, media)
                         : visibility(light, ray, reach, media);
    };
    const Share visible = seen(point.position);
    if (largestOf(visible) > 0.0 || !point.isRounded()) return visible;
    const Share rounded = seen(point.shadowOrigin);
    if (largestOf(rounded) == 0.0) return Share(0.0);
    const Vec3 lift = point.shadowOrigin - point.position;
    const double height = glm::length(lift);
    ++counts_.rays.shadow;
    const Ray up{point.leave(point.position, point.geometricNormal), lift / height};
    return anyHit(scene_, up, {0.0, height}) ? Share(0.0) : rounded;
}

/// What light would bring along a ray with nothing in its way.
template <unsigned Features>
Color Tracer<Features>::lightAlong(const LightRay& ray, double brightness, const Path& path,
                                   const ShadePoint& point) const {
    if (!(glm::dot(ray.w, point.geometricNormal) > 0.0)) return Color(0.0);
    return ray.irradiance *
           phong(point.material, point.normal, -path.ray.direction, ray.w, brightness);
}

/// V, the share of the light that arrives. A surface that the light lies on does not hide it.
template <unsigned Features>
typename Tracer<Features>::Share Tracer<Features>::visibility(Index light, const Ray& ray,
                                                              double reach,
                                                              const MediumSet& media) {
    const double last = reach * (1.0 - kCoincidence);
    if constexpr (kRefraction) {
        return visibilityThroughGlass(light, ray, last, media);
    } else {
        ++counts_.rays.shadow;
        return lastBlockers_[light].anyHit(scene_, ray, {0.0, last}) ? Share(0.0) : Share(1.0);
    }
}

template <unsigned Features>
typename Tracer<Features>::Share Tracer<Features>::visibilityThroughGlass(Index light, Ray ray,
                                                                          double reach,
                                                                          MediumSet media) {
    Share visible(1.0);
    // Most rays meet nothing, or something opaque, which hides the light wherever it stands.
    const Obstacle obstacle = lastBlockers_[light].obstacle(scene_, ray, {0.0, reach});
    if (obstacle != Obstacle::kTransparent) {
        ++counts_.rays.shadow;
        if (obstacle == Obstacle::kOpaque) return Share(0.0);
        absorb(media, reach, visible);
        return visible;
    }
    if constexpr (kCaustics) {
        if (scene_.lights[light].byPhotons) return Share(0.0);
    }
    for (std::uint64_t left = settings_.raysPerSample; largestOf(visible) > 0.0; --left) {
        if (left == 0) {
            ++counts_.cutPaths;
            counts_.cutBound += filterWeight_ * largestOf(visible) * scene_.radianceBound;
            return Share(0.0);
        }
        ++counts_.rays.shadow;
        SceneHit hit;
        if (!nextHit(ray, media, {0.0, reach}, hit)) {
            absorb(media, reach, visible);
            return visible;
        }
        if (!lookOf(hit.instance).refracts) return Share(0.0);
        absorb(media, hit.at.t, visible);
        const ShadePoint point = shadePoint(scene_, hit, ray.direction, kImages);
        MediumSet beyond = beyondHit(media);
        visible *= transmitted(ray.direction, hit, point, media, beyond);
        reach -= hit.at.t;
        ray.origin = point.leave(point.position, ray.direction);
        media = std::move(beyond);
    }
    return Share(0.0);
}

/// What one crossing lets through of light that goes straight on: (1 - F), and (1 - f) of every
/// object that the light enters. It comes along the ray backwards, so it enters what the ray
/// leaves.
template <unsigned Features>
double Tracer<Features>::transmitted(const Vec3& direction, const SceneHit& hit,
                                     const ShadePoint& point, const MediumSet& media,
                                     const MediumSet& beyond) const {
    const double from = media.index(scene_);
    const double to = isSheet(hit.instance) ? lookOf(hit.instance).index : beyond.index(scene_);
    const double cosine = std::min(std::fabs(glm::dot(direction, point.normal)), 1.0);
    double share = 1.0 - fresnelFromThinSide(cosine, from, to);
    for (const SceneHit& crossing : together_) {
        if (isEntered(crossing.instance, beyond)) {
            share *= 1.0 - lookOf(crossing.instance).refractionOwnWeight;
        }
    }
    return share;
}

}  // namespace rt
