// Half of a ball: |p - c|^2 <= r^2, y >= cy; its dome and the disc below it.
//
// The dome as the sphere, cut by the plane of the base; the distance to the ray is taken at the
// ray's foot (rt/geometry/sphere.h).
//
// Texture: the dome by longitude and latitude, the whole image on it:
//     p = c + r (cos b sin a, sin b, cos b cos a),   u = 1/2 + a / 2 pi,   v = 2 b / pi.
// The base as the lower cap of a cylinder.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Hemisphere {
  public:
    static constexpr const char* kName = "hemisphere";
    static constexpr SolidKind kKind{.axis = 1};

    /// Refuses a radius that is not > 0 and finite, and a centre that is not finite
    /// (std::invalid_argument).
    Hemisphere(const Vec3& centre, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre. Parts: 0
    /// dome, 1 base.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 6 roundings of r and 2 of |x| + |y| + |z|.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    Vec3 centre_;
    double radius_;
};

}  // namespace rt
