// Light that mirrors and glass send onto surfaces: photons, and what they add up to at a point.
//
// A photon stands for a share of a light's flux that has met at least one surface that mirrors or
// refracts. They come in passes i = 1, 2, ... of radii r_i that are the same everywhere and shrink;
// what a point shows is the mean over the passes of
//
//   sum over photons within r_i of  K(d / r_i) P (kd max(n.w, 0) + ks max(r.v, 0)^p) / (g.w)
//   K(x) = 2 (1 - x^2) / (pi r_i^2)
//
// with P the photon's flux, w to where it came from, g the geometric normal and the rest as in
// phong.h: flux over area is irradiance with the cosine g.w in it.
// Knaus and Zwicker, Progressive Photon Mapping: A Probabilistic Approach, ACM TOG 30(3), 2011;
// Jensen, Realistic Image Synthesis Using Photon Mapping, 2001. The kernel is Epanechnikov's.
#pragma once

#include "rt/core/vec.h"
#include "rt/sampling/random.h"
#include "rt/shading/phong.h"

#include <glm/ext/vector_float3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// Where a photon came down; lengths in the world.
struct Photon {
    Vec3 position{0.0};
    glm::vec3 flux{0.0F};    ///< of all photons of a pass together
    glm::vec3 from{0.0F};    ///< unit, to where it came from
    glm::vec3 normal{0.0F};  ///< geometric, on the side that it came to
    Index instance = kNone;
    std::uint16_t pass = 0;
    std::uint16_t group = 0;  ///< each pass is of the same groups, with random numbers of their own
};

/// A point that photons light, as the viewer sees it.
struct PhotonReceiver {
    Vec3 position{0.0};
    Vec3 geometricNormal{0.0};  ///< unit, towards the viewer
    Vec3 normal{0.0};           ///< that shades, unit
    Vec3 toViewer{0.0};         ///< unit
    Material material;
    Index instance = kNone;
};

/// Photons on surfaces that lean more than this (cosine) from a point's are another surface's.
inline constexpr double kSameSurface = 0.7;

/// What a photon brings to a point of its surface, but for the kernel.
inline Color broughtBy(const Photon& photon, const PhotonReceiver& to) {
    if (photon.instance != to.instance) return Color(0.0);
    if (!(glm::dot(Vec3(photon.normal), to.geometricNormal) > kSameSurface)) return Color(0.0);
    const Vec3 w(photon.from);
    const double cosine = glm::dot(w, to.geometricNormal);
    if (!(cosine > 0.0)) return Color(0.0);
    return Vec3(photon.flux) * phong(to.material, to.normal, to.toViewer, w, 0.0) / cosine;
}

/// All photons of a picture, in the buckets of a hashed grid: built once, then only read.
struct PhotonMap {
    struct Kernel {
        double squaredRadius = 0.0;
        double inverseSquare = 0.0;
        double peak = 0.0;  ///< K(0) over the number of passes
    };

    std::vector<Photon> photons;        ///< bucket by bucket, in each as they were traced
    std::vector<std::uint32_t> begins;  ///< of each of 2^n buckets, and the end
    std::vector<Kernel> kernels;        ///< of each pass
    double radius = 0.0;                ///< the largest
    double leastRadius = 0.0;
    double cell = 1.0;           ///< side, at least twice the largest radius asked for
    double radianceBound = 0.0;  ///< about the most that a point shows by photons

    bool isEmpty() const { return photons.empty(); }

    /// Calls use(photon, squared distance) for each photon within `reach`, at most half a cell.
    template <class Use>
    void forEachNear(const Vec3& at, double reach, const Use& use) const {
        const Vec3 low = glm::floor((at - reach) / cell);
        const Vec3 high = glm::floor((at + reach) / cell);
        std::array<std::uint32_t, 8> seen{};
        std::size_t count = 0;
        for (double z = low.z; z <= high.z; z += 1.0) {
            for (double y = low.y; y <= high.y; y += 1.0) {
                for (double x = low.x; x <= high.x && count < seen.size(); x += 1.0) {
                    const std::uint32_t bucket = bucketOf({x, y, z});
                    bool isNew = true;
                    for (std::size_t i = 0; i < count; ++i) isNew = isNew && seen[i] != bucket;
                    seen[count++] = bucket;
                    if (isNew) visit(bucket, at, reach * reach, use);
                }
            }
        }
    }

    /// What the photons show of a point.
    Color radianceAt(const PhotonReceiver& to) const {
        Color sum(0.0);
        if (isEmpty()) return sum;
        forEachNear(to.position, radius, [&](const Photon& photon, double squared) {
            const Kernel& kernel = kernels[photon.pass];
            if (squared >= kernel.squaredRadius) return;
            const double share = kernel.peak * (1.0 - squared * kernel.inverseSquare);
            sum += share * broughtBy(photon, to);
        });
        return sum;
    }

    /// Whether photons may light anything within `margin` of a point; true where that is too far to
    /// look.
    bool mayLight(const Vec3& at, double margin) const {
        if (isEmpty()) return false;
        const double reach = margin + radius;
        return !(reach <= kFarthestLook * cell) || anyAround(at, reach);
    }

    /// Of the cell with these whole-numbered coordinates.
    std::uint32_t bucketOf(const Vec3& place) const {
        constexpr double kFar = 0x1p62;
        const auto key = [=](double x) {
            return static_cast<std::uint64_t>(
                static_cast<std::int64_t>(std::clamp(x, -kFar, kFar)));
        };
        const std::uint64_t mixed =
            mixBits(key(place.x) * 0x9e3779b97f4a7c15 ^ key(place.y) * 0xc2b2ae3d27d4eb4f ^
                    key(place.z) * 0x165667b19e3779f9);
        return static_cast<std::uint32_t>(mixed & (begins.size() - 2));
    }

  private:
    static constexpr double kFarthestLook = 4.0;  ///< in cells

    template <class Use>
    void visit(std::uint32_t bucket, const Vec3& at, double squaredReach, const Use& use) const {
        for (std::uint32_t i = begins[bucket]; i < begins[bucket + 1]; ++i) {
            const Vec3 off = photons[i].position - at;
            const double squared = glm::dot(off, off);
            if (squared < squaredReach) use(photons[i], squared);
        }
    }

    bool anyAround(const Vec3& at, double reach) const {
        const Vec3 low = glm::floor((at - reach) / cell);
        const Vec3 high = glm::floor((at + reach) / cell);
        for (double z = low.z; z <= high.z; z += 1.0) {
            for (double y = low.y; y <= high.y; y += 1.0) {
                for (double x = low.x; x <= high.x; x += 1.0) {
                    const std::uint32_t bucket = bucketOf({x, y, z});
                    bool found = false;
                    visit(bucket, at, reach * reach, [&](const Photon&, double) { found = true; });
                    if (found) return true;
                }
            }
        }
        return false;
    }
};

}  // namespace rt
