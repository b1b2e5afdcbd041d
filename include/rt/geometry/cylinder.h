// Capped cylinder about y: (x-cx)^2 + (z-cz)^2 = r^2 for cy <= y <= cy + h, c the base disc's
// centre.
//
// The part of the ray inside the infinite cylinder, cut by the two planes of the caps: no decision
// about a rim is taken twice, so nothing slips between side and cap. The discriminant is taken from
// the moment of the ray about the axis, at the ray's foot near the solid.
//
// Texture: the side as seen from outside, upright: u = 1/2 + a / 2 pi with a = atan2(x, z) the
// angle from +z towards +x, so that the image's middle column faces +z and its edges meet at -z; v
// = y / h. On a cap, the image fills the square inscribed in the disc (sides parallel to x and z)
// and repeats outside it, u and v brought back into [0,1]: with q = sqrt 2 r,
//     top:   u = 1/2 + x / q,  v = 1/2 - z / q  (seen from above, -z up)
//     base:  u = 1/2 + x / q,  v = 1/2 + z / q  (seen from below, +z up).
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Cylinder {
  public:
    static constexpr const char* kName = "cylinder";
    static constexpr SolidKind kKind{.axis = 1};

    /// Refuses a height or radius that is not > 0 and finite, and a base centre that is not finite
    /// (std::invalid_argument).
    Cylinder(const Vec3& baseCentre, double height, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the base centre. Parts:
    /// 0 side, 1 base (y = cy), 2 top (y = cy + h).
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 6 roundings of r, and 2 of |x| + |y| + |z| and of h.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    Vec3 base_;
    double height_;
    double radius_;
};

}  // namespace rt
