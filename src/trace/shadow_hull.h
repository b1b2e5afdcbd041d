// All that lies between the neighbourhood of a point and a light: the convex hull of two balls, of
// which the second holds the light. What no object meets is wholly lit.
#pragma once

#include "rt/core/bounds.h"
#include "rt/trace/trace_kernel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rt {

/// The convex hull of the ball about `from` and the ball about `to`.
struct ShadowHull {
    Vec3 from{0.0};
    double fromRadius = 0.0;
    Vec3 to{0.0};
    double toRadius = 0.0;
    /// `to` moves with `from`, and is farther from it than all objects.
    bool parallel = false;

    /// Whether it may meet a box; true for some that it passes by at their edges.
    bool mayMeet(const Bounds& box) const;
    /// Whether it meets the ball about `centre`, in the plane of axes i and j alone (an upright
    /// cylinder), or in all three.
    bool meetsCylinder(const Vec3& centre, double radius, int i, int j) const;
    bool meetsBall(const Vec3& centre, double radius) const;
    /// Whether it meets the plane y = 0; if it is parallel, also beyond its far end.
    bool meetsGround() const;
};

/// A few instances, or more than fit.
struct Occluders {
    static constexpr unsigned kMost = 8;

    std::array<Index, kMost> items{};
    unsigned count = 0;
    bool overflow = false;

    bool none() const { return count == 0 && !overflow; }
    void add(Index item) {
        if (count == kMost) {
            overflow = true;
        } else {
            items[count++] = item;
        }
    }
};

/// Whether all of the shape lies behind its tangent plane at a hit, so that it casts no shadow on
/// that point from any light before the plane: convex solids, and the outer half of a torus.
bool liesBehindTangentPlane(const Shape& shape, const PrimitiveHit& hit);

/// Whether the hull may meet an instance.
bool meetsHull(const RenderScene& scene, const ShadowHull& hull, Index instance);

/// Lists the instances that may meet the hull; false if they are more than `most`.
bool candidatesIn(const RenderScene& scene, const ShadowHull& hull, std::size_t most,
                  std::vector<Index>& instances);

/// The instances that may meet the hull, `except` left out.
Occluders occludersIn(const RenderScene& scene, const ShadowHull& hull, Index except);

/// Whether one of the occluders blocks the ray.
bool anyBlocks(const RenderScene& scene, const Occluders& occluders, const Ray& ray,
               Interval range);

/// Whether one convex occluder hides all of the cone about the unit `axis` of half-angle A, tangent
/// tanA, from `from`, before `reach`: rays through the corners of a square around the cone all hit
/// it, and so does every ray between them.
bool oneHidesCone(const RenderScene& scene, const Occluders& occluders, const Vec3& from,
                  const Vec3& axis, double tanA, double reach);

}  // namespace rt
