// The Tracer's photons: on their way from lights through what mirrors and refracts, and what those
// that came down show of a point.
#pragma once

#include "tracer.h"

#include <algorithm>
#include <cmath>

namespace rt {

template <unsigned Features>
Color Tracer<Features>::caustics(const Path& path, const SceneHit& hit,
                                 const ShadePoint& point) const {
    if (!settings_.photons) return Color(0.0);
    return settings_.photons->radianceAt({point.position, point.geometricNormal, point.normal,
                                          -path.ray.direction, point.material, hit.instance});
}

template <unsigned Features>
void Tracer<Features>::addMiss(const Path& path, SeenSum& sum) const {
    sum.value += path.weight * scene_.background.at(path.ray.direction);
}

template <unsigned Features>
void Tracer<Features>::addOwn(const Path& path, double own, const SceneHit& hit,
                              const ShadePoint& point, SeenSum& sum) {
    sum.value += path.weight * own * ownColor(path, own, point);
    const double footprint = scene_.camera.pixelSize() * (path.travelled + hit.at.t);
    sum.points->push_back({{point.position, point.geometricNormal, point.normal,
                            -path.ray.direction, point.material, hit.instance},
                           Color(path.weight * own),
                           footprint});
}

template <unsigned Features>
void Tracer<Features>::see(int x, int y, int index, SeenPixel& seen) {
    Path path;
    const FilterSample at = startSample(x, y, index, path);
    SeenSum sum{.points = &seen.points};
    const std::size_t before = seen.points.size();
    gather(std::move(path), sum);
    seen.value += at.weight * sum.value;
    for (std::size_t i = before; i < seen.points.size(); ++i) seen.points[i].weight *= at.weight;
}

/// Weights and directions are those of a path of the eye that goes the same way. Where a normal
/// that leans off the surface steers the photon, the flux on both sides of the crossing is in
/// proportion to other cosines than the path's radiance (Veach, Robust Monte Carlo Methods for
/// Light Transport Simulation, 1997, section 5.3).
template <unsigned Features>
void Tracer<Features>::photon(const PhotonStart& start, std::uint64_t key, const Photon& like,
                              std::vector<Photon>& photons) {
    /// Photons of less than this share of their flux survive in proportion to it.
    constexpr double kFaint = 1.0 / 16;
    Path path;
    path.ray = start.ray;
    path.media = mediaAt(path.ray.origin);
    for (int depth = 0;; ++depth) {
        SceneHit hit;
        if (!nextHit(path.ray, path.media, {}, hit)) return;
        absorb(path.media, hit.at.t, path.weight);
        const Vec3& d = path.ray.direction;
        const ShadePoint point = shadePoint(scene_, hit, d, kImages);
        MediumSet beyond = beyondHit(path.media);
        path.depth = 0;
        const Split parts = split(path, hit, point, beyond);
        if (depth > 0 && parts.own > 0.0) putDown(start, path, hit, point, like, photons);
        const double onward = parts.reflected + parts.refracted;
        if (depth >= settings_.maxDepth || !(onward > 0.0)) return;

        const double choice = toUnit(subKey(key, 2 * static_cast<std::uint64_t>(depth)));
        const bool through = choice * onward < parts.refracted;
        const Vec3& w = through ? parts.refractedDirection : parts.reflectedDirection;
        double part = onward;
        if (point.normal != point.geometricNormal) {
            const auto cosine = [](const Vec3& a, const Vec3& b) {
                return std::fabs(glm::dot(a, b));
            };
            const double from = cosine(d, point.geometricNormal) * cosine(w, point.normal);
            const double to = cosine(w, point.geometricNormal) * cosine(d, point.normal);
            if (!(from > 0.0)) return;
            part *= to / from;
        }
        Path next = spawn(path, hit, point, w, part, through ? 1 : 0);
        next.media = through ? std::move(beyond) : std::move(path.media);
        path = std::move(next);
        const double left = largestOf(path.weight);
        if (left < kFaint) {
            if (toUnit(subKey(key, 2 * static_cast<std::uint64_t>(depth) + 1)) * kFaint >= left) {
                return;
            }
            path.weight *= kFaint / left;
        }
    }
}

template <unsigned Features>
void Tracer<Features>::putDown(const PhotonStart& start, const Path& path, const SceneHit& hit,
                               const ShadePoint& point, const Photon& like,
                               std::vector<Photon>& photons) const {
    const Material& material = point.material;
    if (material.diffuse == Color(0.0) && material.specular == Color(0.0)) return;
    const Color flux = path.weight * fluxAfter(start, path.travelled + hit.at.t);
    if (flux == Color(0.0) || !std::isfinite(flux.x + flux.y + flux.z)) return;
    Photon photon = like;
    photon.position = point.position;
    photon.flux = glm::vec3(flux);
    photon.from = glm::vec3(-path.ray.direction);
    photon.normal = glm::vec3(point.geometricNormal);
    photon.instance = hit.instance;
    photons.push_back(photon);
}

}  // namespace rt
