// Capped cone about y: (x-cx)^2 + (z-cz)^2 = (r/h)^2 (y-cy)^2 for cy <= y <= cy + h; apex c,
// opening upwards.
//
// The part of the ray inside the upper half of the double cone, cut by the plane of the cap. With f
// the ray's foot relative to the apex, d its direction and m = f x d, the discriminant of the
// quadratic is k^2 (mx^2 + mz^2) - my^2 with k = r/h: differences that are formed once, without
// cancellation, instead of from coefficients. A Newton step at the point itself follows.
//
// Texture: the side as seen from outside, upright: u = 1/2 + a / 2 pi with a = atan2(x, z) the
// angle from +z towards +x, so that the image's middle column faces +z and its edges meet at -z; v
// = y / h. On the cap, the image fills the square inscribed in the disc and repeats outside it, u
// and v brought back into [0,1]: u = 1/2 + x / q, v = 1/2 - z / q with q = sqrt 2 r (seen from
// above, -z up). At the apex a is taken as 0, and the normal is that of the side at +z.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Cone {
  public:
    static constexpr const char* kName = "cone";
    static constexpr SolidKind kKind{.axis = 1};

    /// Refuses a height or radius that is not > 0 and finite, and an apex that is not finite
    /// (std::invalid_argument).
    Cone(const Vec3& apex, double height, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the apex. Parts: 0 side,
    /// 1 cap (y = cy + h).
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 9 roundings of r, and 2 of |x| + |y| + |z| and of h.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    Vec3 apex_;
    double height_;
    double radius_;
    double slope_;         ///< k = r / h
    double normalRadial_;  ///< the side's normal: h / slant outwards,
    double normalDown_;    ///< and r / slant down
};

}  // namespace rt
