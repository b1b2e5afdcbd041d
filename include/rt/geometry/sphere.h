// Sphere: |p - c|^2 = r^2.
//
// The distance to the ray is taken at the ray's foot, near the centre, instead of at its origin
// (Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray
// Tracing Gems, 2019, ch. 7), and the foot lies on the exact ray (src/geometry/solid_frame.h).
//
// Texture: longitude and latitude about y, north (+y) up, as seen from outside; the image's middle
// column faces +z and its right half +x, its two side edges meet at -z:
//     p = c + r (cos b sin a, sin b, cos b cos a),   u = 1/2 + a / 2 pi,   v = 1/2 + b / pi.
// At the poles a is taken as 0, and dpdu is 0.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Sphere {
  public:
    static constexpr const char* kName = "sphere";
    static constexpr SolidKind kKind{};

    /// Refuses a radius that is not > 0 and finite, and a centre that is not finite
    /// (std::invalid_argument).
    Sphere(const Vec3& centre, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre, off
    /// the exact point by a few roundings of the radius, over the cosine of incidence.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 6 roundings of r and 2 of |x| + |y| + |z|.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    Vec3 centre_;
    double radius_;
};

}  // namespace rt
