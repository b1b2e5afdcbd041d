// Sphere: |p - c|^2 = r^2.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"

namespace rt {

class Sphere {
  public:
    /// Refuses a radius that is not > 0 and finite (std::invalid_argument).
    Sphere(const Vec3& centre, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    SurfacePoint surface(const PrimitiveHit& hit) const;

  private:
    Vec3 centre_;
    double radius_;
};

}  // namespace rt
