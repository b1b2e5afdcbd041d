// The Tracer's way to look at corners of pixels: lights are proved lit or dark where a test of all
// that lies between can do so, and enter in closed form; only the others are sampled.
#pragma once

#include "csg_signature.h"
#include "light_mean.h"
#include "rt/sampling/warp.h"
#include "rt/trace/csg_shape.h"
#include "tracer.h"

#include <cmath>
#include <numbers>

namespace rt {

/// Names the surface at a hit; all of a mesh is one.
inline std::uint64_t pieceAt(const RenderScene& scene, const SceneHit& hit) {
    const Shape* shape = &scene.shapes[scene.instances[hit.instance].shape];
    if (const auto* csg = std::get_if<std::shared_ptr<const CsgShape>>(shape)) {
        shape = &(*csg)->leaves[hit.at.leaf].shape;
    }
    const bool isMesh = std::holds_alternative<std::shared_ptr<const MeshShape>>(*shape);
    const std::uint64_t face = isMesh ? 0 : hit.at.part;
    return std::uint64_t{hit.at.leaf} << 40 | std::uint64_t{hit.instance} << 8 | face;
}

/// A kernel of so many footprints (half diagonals of a pixel) leaves nothing to hide between
/// corners.
inline constexpr double kSmoothKernel = 4.0;

template <unsigned Features>
void Tracer<Features>::probeCorner(int x, int y, int spacing, std::uint32_t end, Probe& probe) {
    sampler_.start(x - kOtherPixels, y, 0);
    look(Vec2(x, y), spacing, end, probe);
}

template <unsigned Features>
void Tracer<Features>::probeCentre(int x, int y, std::uint32_t end, Probe& probe) {
    sampler_.start(x - kOtherPixels, y - kOtherPixels, 0);
    look(Vec2(x + 0.5, y + 0.5), 1, end, probe);
}

/// The path through an image point and the centre of the lens, which stands for a whole pixel.
template <unsigned Features>
typename Tracer<Features>::Path Tracer<Features>::pathThrough(const Vec2& at) {
    constexpr double kMiddle = 0.5;
    if (moment_) turnTo(kMiddle);
    Path path;
    path.ray = scene_.camera.ray(at.x, at.y, Vec2(0.0));
    if constexpr (kImages) {
        path.differential = cameraDifferential(scene_.camera, path.ray.direction);
        share_ = {};
    }
    if constexpr (kRefraction) path.media = mediaAt(path.ray.origin);
    return path;
}

template <unsigned Features>
void Tracer<Features>::look(const Vec2& at, int spacing, std::uint32_t end, Probe& probe) {
    Path path = pathThrough(at);
    raysLeft_ = settings_.raysPerSample;
    ++counts_.rays.camera;

    const std::uint32_t begin = probe.samples;
    ProbeSum sum{.begin = begin,
                 .middle = end / 2,
                 .end = end,
                 .spacing = static_cast<double>(spacing),
                 .evidence = &probe};
    probe.surfaces = 0;
    // What was uncertain stays so, though a look from nearer might prove it: its samples count.
    probe.marks &= kProbeUncertain;
    probe.lit = 0;
    probe.dark = 0;
    gather(std::move(path), sum);
    if (!fitsProbe(sum.first) || !fitsProbe(sum.second)) {
        // The pixels' own samples find it again, and report it where it is not finite.
        sum.first = sum.second = Color(0.0);
        probe.marks |= kProbeDetail;
    }
    probe.half = probe.sum + glm::vec3(sum.first);
    probe.sum += glm::vec3(sum.first + sum.second);
    probe.samples = end;
}

template <unsigned Features>
void Tracer<Features>::noteParts(const Path& path, double reach, ProbeSum& sum) const {
    if (!(scene_.features & kFeatureCsg) || path.depth > 0) return;
    std::uint64_t& surfaces = sum.evidence->surfaces;
    surfaces = subKey(surfaces, csgSignature(scene_, path.ray, {0.0, reach}));
}

/// Marks what is seen in mirrors or through glass where something narrow lies so near the ray that
/// corners may see past it. What the camera sees itself is marked beforehand (fine_pixels.h).
template <unsigned Features>
void Tracer<Features>::markNarrow(const Path& path, double distance, ProbeSum& sum) const {
    const double pixel = scene_.camera.pixelSize() * (path.travelled + distance);
    if (path.depth == 0 || scene_.thinnest >= kNarrowPixels * pixel) return;
    const double margin = kHalfDiagonal * sum.spacing * scene_.camera.pixelSize();
    const Occluders near = occludersIn(
        scene_,
        {path.ray.origin, margin * path.travelled, path.ray.origin + distance * path.ray.direction,
         margin * (path.travelled + distance)},
        kNone);
    bool narrow = near.overflow;
    for (unsigned i = 0; i < near.count && !narrow; ++i) {
        const double thickness = thicknessOf(scene_, scene_.instances[near.items[i]]);
        narrow = thickness > 0.0 && thickness < kNarrowPixels * pixel;
    }
    if (narrow) sum.evidence->marks |= kProbeDetail;
}

template <unsigned Features>
void Tracer<Features>::addMiss(const Path& path, ProbeSum& sum) const {
    Probe& evidence = *sum.evidence;
    if constexpr (kSecondary) {
        if (!scene_.tree.isEmpty()) markNarrow(path, wayOut(path.ray.origin), sum);
    }
    evidence.surfaces = subKey(evidence.surfaces, path.node);
    if (scene_.background.image) evidence.marks |= kProbeDetail;
    sum.addToAll(path.weight * scene_.background.at(path.ray.direction));
}

template <unsigned Features>
void Tracer<Features>::addOwn(const Path& path, double own, const SceneHit& hit,
                              const ShadePoint& point, ProbeSum& sum) {
    Probe& evidence = *sum.evidence;
    evidence.surfaces = subKey(evidence.surfaces, path.node);
    evidence.surfaces = subKey(evidence.surfaces, pieceAt(scene_, hit));
    if (path.depth == 0) {
        evidence.marks |= kProbeHit;
        evidence.position = glm::vec3(point.position - scene_.camera.eye());
        evidence.normal = glm::vec3(point.geometricNormal);
    }
    if constexpr (kImages) {
        if (lookAt(scene_, hit).isPictured()) evidence.marks |= kProbeDetail;
    }
    if constexpr (kSecondary) {
        markNarrow(path, glm::length(point.position - path.ray.origin), sum);
    }
    if constexpr (kCaustics) {
        // What photons bring is as smooth as the kernel is wide.
        const double margin = sum.spacing * footprint(path, point);
        if (settings_.photons && settings_.photons->mayLight(point.position, margin)) {
            if (settings_.photons->leastRadius < kSmoothKernel * margin) {
                evidence.marks |= kProbeDetail;
            } else {
                sum.addToAll(path.weight * own * caustics(path, hit, point));
            }
        }
    }
    sum.addToAll(path.weight * own * point.material.diffuse * scene_.ambient);
    for (Index light = 0; light < scene_.lights.size(); ++light) {
        probeLight(light, path, own, hit, point, sum);
    }
}

/// Half of a pixel's diagonal, on the surface.
template <unsigned Features>
double Tracer<Features>::footprint(const Path& path, const ShadePoint& point) const {
    const double distance = path.travelled + glm::length(point.position - path.ray.origin);
    const double cosine = std::fabs(glm::dot(point.geometricNormal, path.ray.direction));
    constexpr double kGrazing = 1.0 / 32;
    return kHalfDiagonal * scene_.camera.pixelSize() * distance / std::max(cosine, kGrazing);
}

template <unsigned Features>
bool Tracer<Features>::allOpaque(const Occluders& occluders) const {
    if constexpr (!kRefraction) return true;
    if (occluders.overflow) return false;
    for (unsigned i = 0; i < occluders.count; ++i) {
        if (lookOf(occluders.items[i]).refracts) return false;
    }
    return true;
}

/// All that lies between the neighbourhood of a point and a light. A sun's rays from neighbouring
/// points are parallel, and end where they have left the scene.
template <unsigned Features>
ShadowHull Tracer<Features>::hullTowards(const Light& light, const LightView& view,
                                         const Vec3& from, double margin) const {
    if (!kLightKinds || light.kind != LightKind::kSun)
        return {from, margin, light.position, light.radius};
    const double cosA = 1.0 - view.oneMinusCos;
    const double sinA = std::sqrt(view.oneMinusCos * (1.0 + cosA));
    const double length = ((scene_.tree.isEmpty() ? 0.0 : wayOut(from)) + margin) / cosA;
    return {from, margin, from + length * view.axis, length * sinA + margin, true};
}

/// How far a ray from here may go before it has left the box of all objects.
template <unsigned Features>
double Tracer<Features>::wayOut(const Vec3& from) const {
    const TreeFrame& frame = scene_.tree.frame();
    return glm::length(from - frame.centre) + std::numbers::sqrt3 / frame.scale;
}

template <unsigned Features>
void Tracer<Features>::probeLight(Index index, const Path& path, double own, const SceneHit& hit,
                                  const ShadePoint& point, ProbeSum& sum) {
    const Light& light = scene_.lights[index];
    const std::uint64_t bit = std::uint64_t{1} << (sum.lightsSeen++ & 63);
    const std::optional<LightView> view = viewOfLight(light, point.position);
    if (!view) return;
    const LightHorizon horizon = horizonOf(*view, point.geometricNormal, point.normal);
    if (horizon == LightHorizon::kBelow) {
        sum.evidence->dark |= bit;
        return;
    }
    const double margin = sum.spacing * footprint(path, point);
    const bool behind =
        horizon == LightHorizon::kAbove && !point.fromInside &&
        liesBehindTangentPlane(scene_.shapes[scene_.instances[hit.instance].shape], hit.at);
    const double lift = point.isRounded() ? glm::length(point.shadowOrigin - point.position) : 0.0;
    if (kLightKinds && light.kind == LightKind::kSpot) {
        const SpotPlace place = placeInSpot(light, point.position, margin);
        if (place == SpotPlace::kEdge) sum.evidence->marks |= kProbeDetail;
        if (place == SpotPlace::kDark) {
            sum.evidence->dark |= bit;
            return;
        }
    }
    const Occluders occluders =
        occluderCache_.occludersIn(scene_, hullTowards(light, *view, point.position, margin + lift),
                                   index, path.node, behind ? hit.instance : kNone);
    // The closed form is that of clear air.
    const bool clear = !(kAbsorption && absorbs(path.media));
    if (occluders.none() && clear && view->isEven()) {
        if (const std::optional<Color> mean = unoccludedMean(
                point.material, point.normal, -path.ray.direction, light, *view, horizon)) {
            sum.evidence->lit |= bit;
            sum.addToAll(path.weight * own * *mean);
            return;
        }
    } else if (!occluders.overflow && view->distance > light.radius && allOpaque(occluders)) {
        for (unsigned i = 0; i < occluders.count; ++i) {
            if (partThicknessOf(scene_, scene_.instances[occluders.items[i]]) < 2.0 * margin) {
                sum.evidence->marks |= kProbeDetail;
            }
        }
        const double cosA = 1.0 - view->oneMinusCos;
        const double tanA = std::sqrt(view->oneMinusCos * (1.0 + cosA)) / cosA;
        const Vec3 from = point.leave(point.position, view->axis);
        if (cosA > 0.0 && !point.isRounded() &&
            oneHidesCone(scene_, occluders, from, view->axis, tanA,
                         (view->distance - light.radius) * (1.0 - kCoincidence))) {
            sum.evidence->dark |= bit;
            return;
        }
    }
    sum.evidence->marks |= kProbeUncertain;
    if ((scene_.features & kFeatureCsg) && view->isPoint()) {
        const LightRay ray = view->onlyRay();
        const Ray towards{point.leave(point.position, ray.w), ray.w};
        const std::uint64_t parts = csgSignature(scene_, towards, {0.0, view->reach(ray)});
        if (parts != 0) sum.evidence->surfaces = subKey(sum.evidence->surfaces, parts);
    }
    const Share visible = probeOccluded(index, *view, occluders, path, own, point, sum);
    if (view->isPoint()) {
        (largestOf(visible) > 0.0 ? sum.evidence->lit : sum.evidence->dark) |= bit;
    }
}

/// Samples a light that is neither proved lit nor proved dark; the last visibility.
template <unsigned Features>
typename Tracer<Features>::Share Tracer<Features>::probeOccluded(Index index, const LightView& view,
                                                                 const Occluders& occluders,
                                                                 const Path& path, double own,
                                                                 const ShadePoint& point,
                                                                 ProbeSum& sum) {
    const Light& light = scene_.lights[index];
    Share visible(0.0);
    const std::uint32_t end = view.isPoint() ? sum.begin + 1 : sum.end;
    for (std::uint32_t i = sum.begin; i < end; ++i) {
        LightRay ray = view.onlyRay();
        if (!view.isPoint()) {
            sampler_.turnTo(i);
            ray = view.ray(sampler_.light(path.node, index), point.position);
        }
        const Color local = lightAlong(ray, light.brightness, path, point);
        if (local == Color(0.0)) continue;
        visible = visibilityOf(index, ray.w, view.reach(ray), path.media, point, &occluders);
        const Color value = path.weight * own * visible * local;
        if (view.isPoint()) {
            sum.addToAll(value);
        } else {
            (i < sum.middle ? sum.first : sum.second) += value;
        }
    }
    return visible;
}

/// V along a ray that only the occluders can block.
template <unsigned Features>
typename Tracer<Features>::Share Tracer<Features>::visibilityPast(const Occluders& occluders,
                                                                  Index light, const Ray& ray,
                                                                  double reach,
                                                                  const MediumSet& media) {
    if constexpr (kAbsorption) {
        if (absorbs(media)) return visibility(light, ray, reach, media);
    }
    if (occluders.none()) return Share(1.0);
    if (!allOpaque(occluders)) return visibility(light, ray, reach, media);
    ++counts_.rays.shadow;
    return anyBlocks(scene_, occluders, ray, {0.0, reach * (1.0 - kCoincidence)}) ? Share(0.0)
                                                                                  : Share(1.0);
}

}  // namespace rt
