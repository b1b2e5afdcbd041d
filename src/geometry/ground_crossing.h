// What the flat primitives share: where a ray crosses the plane y = 0.
#pragma once

#include "solid_frame.h"

namespace rt {

/// t as rounded is off by a rounding of the ray's way to the plane; the point that it gives is on
/// the ray to a rounding of its own size, so its height tells how far to go on. Nothing for a ray
/// within the plane.
inline bool crossGround(const Ray& ray, Interval range, PrimitiveHit& hit) {
    const Vec3& o = ray.origin;
    const Vec3& d = ray.direction;
    const double inverse = 1.0 / d.y;
    const double rough = -o.y * inverse;
    if (!(std::fabs(rough) < kInfinity)) return false;
    const Vec3 p(std::fma(rough, d.x, o.x), std::fma(rough, d.y, o.y), std::fma(rough, d.z, o.z));
    const double further = -p.y * inverse;
    const double t = rough + further;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = Vec3(std::fma(further, d.x, p.x), 0.0, std::fma(further, d.z, p.z));
    hit.part = 0;
    return true;
}

}  // namespace rt
