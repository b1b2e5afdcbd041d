// The Tracer's paths: what a ray meets, what of it is mirrored and what shines through, and what
// all of that adds up to.
#pragma once

#include "rt/core/numeric.h"
#include "rt/sampling/warp.h"
#include "rt/shading/absorption.h"
#include "rt/shading/fresnel.h"
#include "rt/shading/phong.h"
#include "tracer.h"
#include "tracer_light.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rt {

template <unsigned Features>
Tracer<Features>::Tracer(const RenderScene& scene, const TraceSettings& settings,
                         TraceCounts& counts)
    : moments_(scene.moments.get()),
      moment_(moments_ ? moments_->lend(scene) : nullptr),
      scene_(moment_ ? *moment_ : scene),
      settings_(settings),
      counts_(counts),
      sampler_({settings.sampler, settings.filter, settings.seed, settings.spp}),
      lastBlockers_(scene.lights.size()) {}

template <unsigned Features>
Tracer<Features>::~Tracer() {
    if (moment_) moments_->takeBack(std::move(moment_));
}

/// Turns to a sample, and to the path that it begins with.
template <unsigned Features>
FilterSample Tracer<Features>::startSample(int x, int y, int index, Path& path) {
    sampler_.start(x, y, index);
    if (moment_) [[unlikely]]
        turnTo(sampler_.time());
    const FilterSample at = sampler_.pixel();
    const Vec2 lens = scene_.camera.hasLens() ? concentricDisc(sampler_.lens()) : Vec2(0.0);
    path.ray = scene_.camera.ray(x + 0.5 + at.offset.x, y + 0.5 + at.offset.y, lens);
    if constexpr (kImages) {
        path.differential = cameraDifferential(scene_.camera, path.ray.direction);
        share_ = pixelShare(static_cast<std::uint32_t>(index), settings_.textureShares,
                            sampler_.pixelPoint());
    }
    if constexpr (kRefraction) path.media = mediaAt(path.ray.origin);
    raysLeft_ = settings_.raysPerSample;
    filterWeight_ = std::fabs(at.weight);
    ++counts_.rays.camera;
    return at;
}

template <unsigned Features>
Color Tracer<Features>::sample(int x, int y, int index) {
    Path path;
    const FilterSample at = startSample(x, y, index, path);
    SampleSum sum;
    gather(std::move(path), sum);
    return at.weight * sum.value;
}

template <unsigned Features>
void Tracer<Features>::turnTo(double s) {
    for (const Motion& motion : moment_->moving) {
        Transform& transform = moment_->instances[motion.instance].transform;
        // The scene's compiler made sure that there is one at both ends.
        if (Transform now; Transform::make(motion.path.at(s), now)) transform = now;
    }
}

template <unsigned Features>
template <class Sum>
void Tracer<Features>::gather(Path path, Sum& sum) {
    follow(std::move(path), sum);
    while (!pending_.empty()) {
        Path next = std::move(pending_.back());
        pending_.pop_back();
        follow(std::move(next), sum);
    }
}

template <unsigned Features>
template <class Sum>
void Tracer<Features>::follow(Path path, Sum& sum) {
    for (;;) {
        if constexpr (kTells) tellRay(path);
        SceneHit hit;
        const bool met = nextHit(path.ray, path.media, {}, hit);
        if constexpr (std::is_same_v<Sum, ProbeSum>) noteParts(path, hit.at.t, sum);
        if (!met) {
            addMiss(path, sum);
            return;
        }
        if constexpr (kAbsorption) absorb(path.media, hit.at.t, path.weight);
        const ShadePoint point = pointAt(path, hit);
        if constexpr (kTells) tellHit(path, hit, point);
        if constexpr (!kSecondary) {
            addOwn(path, 1.0, hit, point, sum);
            return;
        } else {
            MediumSet beyond = beyondHit(path.media);
            Split parts = split(path, hit, point, beyond);
            if constexpr (kTells) toldRay().parts.cut = parts.own;
            cutSmall(path, parts.reflected, parts);
            cutSmall(path, parts.refracted, parts);
            if constexpr (kTells) {
                toldRay().parts = {parts.own, parts.own - toldRay().parts.cut, parts.reflected,
                                   parts.refracted};
            }
            if (parts.own > 0.0) addOwn(path, parts.own, hit, point, sum);

            Path through;
            if (parts.refracted > 0.0) {
                ++counts_.rays.refraction;
                through = spawn(path, hit, point, parts.refractedDirection, parts.refracted, 1);
                through.media = std::move(beyond);
                if constexpr (kImages) {
                    through.differential =
                        differentialBeyond(path.differential, scene_, path.ray, hit, point,
                                           parts.refractedDirection, parts.indexRatio);
                }
            }
            if (parts.reflected > 0.0) {
                ++counts_.rays.reflection;
                Path mirror = spawn(path, hit, point, parts.reflectedDirection, parts.reflected, 0);
                mirror.media = std::move(path.media);
                if constexpr (kImages) {
                    mirror.differential =
                        differentialBeyond(path.differential, scene_, path.ray, hit, point,
                                           parts.reflectedDirection, 0.0);
                }
                if (parts.refracted > 0.0) {
                    pending_.push_back(std::move(mirror));
                } else {
                    through = std::move(mirror);
                }
            }
            if (!(parts.reflected + parts.refracted > 0.0)) return;
            path = std::move(through);
        }
    }
}

/// The next surface, and in `together_` all that coincide with it. An opaque one among them hides
/// the rest; otherwise the hit is on the solid that the path enters, of several the one created
/// last.
template <unsigned Features>
bool Tracer<Features>::nextHit(const Ray& ray, const MediumSet& media, Interval range,
                               SceneHit& hit) {
    if constexpr (!kRefraction) {
        return closestHit(scene_, ray, range, hit);
    } else {
        bool shared = false;
        if (!closestHit(scene_, ray, range, hit, &shared)) return false;
        together_.assign(1, hit);
        if (!shared) return true;

        together_.clear();
        const double slack = coincidenceInT(ray, hit.at.t);
        allCrossings(scene_, ray, {std::max(0.0, hit.at.t - slack), hit.at.t + slack}, together_);
        const auto better = [&](const SceneHit& a, const SceneHit& b) {
            const bool opaqueA = !lookOf(a.instance).refracts;
            const bool opaqueB = !lookOf(b.instance).refracts;
            if (opaqueA != opaqueB) return opaqueA;
            if (opaqueA) return a.instance < b.instance;
            const bool entersA = isEntered(a.instance, media);
            const bool entersB = isEntered(b.instance, media);
            if (entersA != entersB) return entersA;
            return scene_.instances[a.instance].order > scene_.instances[b.instance].order;
        };
        if (together_.empty()) return true;
        hit = *std::min_element(together_.begin(), together_.end(), better);
        hit.spread = slack;
        return true;
    }
}

template <unsigned Features>
MediumSet Tracer<Features>::beyondHit(const MediumSet& media) const {
    MediumSet beyond = media;
    if constexpr (kRefraction) {
        for (const SceneHit& crossing : together_) {
            const Index instance = crossing.instance;
            if (lookOf(instance).refracts && !isSheet(instance)) beyond.toggle(instance);
        }
    }
    return beyond;
}

template <unsigned Features>
typename Tracer<Features>::Split Tracer<Features>::split(const Path& path, const SceneHit& hit,
                                                         const ShadePoint& point,
                                                         const MediumSet& beyond) const {
    Split parts;
    if (path.depth >= settings_.maxDepth) return parts;
    const Look& look = lookAt(scene_, hit);
    const bool solid = !(kRefraction && look.refracts);
    if (solid && !look.reflects) return parts;

    const Vec3& d = path.ray.direction;
    const Vec3& n = glm::dot(d, point.normal) < 0.0 ? point.normal : point.geometricNormal;
    parts.reflectedDirection = broughtToSide(mirrored(d, n), point.geometricNormal, 1.0);
    if (!solid) shineThrough(path, hit, point, beyond, parts);
    if (look.reflects && (solid || isEntered(hit.instance, path.media))) {
        const double own = look.reflectionOwnWeight;
        parts.own *= own;
        parts.refracted *= own;
        parts.reflected = own * parts.reflected + (1.0 - own);
    }
    return parts;
}

/// The refracting part of a split: Snell between the media on both sides, total internal reflection
/// beyond the critical angle, Fresnel's split where it is asked for. Sheets do not bend.
template <unsigned Features>
void Tracer<Features>::shineThrough(const Path& path, const SceneHit& hit, const ShadePoint& point,
                                    const MediumSet& beyond, Split& parts) const {
    const Look& look = lookAt(scene_, hit);
    const Vec3& d = path.ray.direction;
    const Vec3& n = glm::dot(d, point.normal) < 0.0 ? point.normal : point.geometricNormal;
    const bool sheet = isSheet(hit.instance);
    parts.own = isEntered(hit.instance, path.media) ? look.refractionOwnWeight : 0.0;
    const double shining = 1.0 - parts.own;
    const double from = path.media.index(scene_);
    const double to = sheet ? look.index : beyond.index(scene_);

    const std::optional<Vec3> bent = sheet ? d : refracted(d, n, from, to);
    if (!bent) {
        parts.reflected = shining;
        return;
    }
    parts.refractedDirection = broughtToSide(*bent, point.geometricNormal, -1.0);
    if (!sheet) parts.indexRatio = from / to;
    const double mirrorShare =
        look.fresnel ? fresnelReflectance(std::min(-glm::dot(d, n), 1.0), from, to) : 0.0;
    parts.reflected = shining * mirrorShare;
    parts.refracted = shining * (1.0 - mirrorShare);
}

/// Gives a part that could bring less than the cutoff, or that is over the ray budget, to the own
/// colour, and books what it could have brought.
template <unsigned Features>
void Tracer<Features>::cutSmall(const Path& path, double& part, Split& parts) {
    if (!(part > 0.0)) return;
    double radiance = scene_.radianceBound;
    if constexpr (kCaustics) {
        if (settings_.photons) radiance += settings_.photons->radianceBound;
    }
    const double bound = largestOf(path.weight) * part * radiance;
    if (raysLeft_ > 0 && !(bound < settings_.cutoff)) {
        --raysLeft_;
        return;
    }
    parts.own += part;
    part = 0.0;
    ++counts_.cutPaths;
    counts_.cutBound += filterWeight_ * bound;
}

template <unsigned Features>
typename Tracer<Features>::Path Tracer<Features>::spawn(const Path& from, const SceneHit& hit,
                                                        const ShadePoint& point,
                                                        const Vec3& direction, double part,
                                                        unsigned branch) const {
    Path path;
    path.ray = {point.leave(point.position, direction), direction};
    path.weight = from.weight * part;
    path.depth = from.depth + 1;
    path.travelled = from.travelled + hit.at.t;
    path.node = 2 * from.node + branch;
    return path;
}

template <unsigned Features>
void Tracer<Features>::addMiss(const Path& path, SampleSum& sum) {
    const Color color = scene_.background.at(path.ray.direction);
    if constexpr (kTells) toldRay().color = color;
    sum.value += path.weight * color;
}

template <unsigned Features>
void Tracer<Features>::addOwn(const Path& path, double own, [[maybe_unused]] const SceneHit& hit,
                              const ShadePoint& point, SampleSum& sum) {
    Color color = ownColor(path, own, point);
    if constexpr (kCaustics) {
        const Color thrown = caustics(path, hit, point);
        if constexpr (kTells) toldRay().thrown = thrown;
        color += thrown;
    }
    if constexpr (kTells) toldRay().color = color;
    sum.value += path.weight * own * color;
}

template <unsigned Features>
ShadePoint Tracer<Features>::pointAt(const Path& path, const SceneHit& hit) const {
    if constexpr (kImages) {
        const Beam beam{path.ray, path.differential, share_};
        return shadePoint(scene_, hit, path.ray.direction, true,
                          settings_.textureShares > 0 ? &beam : nullptr);
    } else {
        return shadePoint(scene_, hit, path.ray.direction, false);
    }
}

/// The refracting solids around a point, by the parity of crossings on a ray to infinity. The
/// direction is arbitrary; it only should not lie along faces that people model.
template <unsigned Features>
MediumSet Tracer<Features>::mediaAt(const Vec3& point) {
    MediumSet media;
    const Bounds& bounds = scene_.refractingBounds;
    const bool outside =
        glm::any(glm::lessThan(point, bounds.min)) || glm::any(glm::greaterThan(point, bounds.max));
    if (outside) return media;
    together_.clear();
    allCrossings(scene_, {point, glm::normalize(Vec3(0.5377, 0.7311, -0.4201))}, {}, together_);
    for (const SceneHit& crossing : together_) {
        const Index instance = crossing.instance;
        if (lookOf(instance).refracts && !isSheet(instance)) media.toggle(instance);
    }
    return media;
}

template <unsigned Features>
bool Tracer<Features>::absorbs(const MediumSet& media) const {
    const Look* look = media.look(scene_);
    return look && look->absorption != Color(0.0);
}

template <unsigned Features>
void Tracer<Features>::absorb(const MediumSet& media, double distance, Share& share) const {
    if constexpr (kAbsorption) {
        if (absorbs(media)) share *= transmittance(media.look(scene_)->absorption, distance);
    }
}

}  // namespace rt
