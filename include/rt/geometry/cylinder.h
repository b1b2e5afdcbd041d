// Capped cylinder about y: (x-cx)^2 + (z-cz)^2 = r^2 for cy <= y <= cy + h, c the base disc's
// centre.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"

namespace rt {

class Cylinder {
  public:
    /// Refuses a height or radius that is not > 0 and finite (std::invalid_argument).
    Cylinder(const Vec3& baseCentre, double height, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the base centre. Parts:
    /// 0 side, 1 base (y = cy), 2 top (y = cy + h).
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    SurfacePoint surface(const PrimitiveHit& hit) const;

  private:
    Vec3 base_;
    double height_;
    double radius_;
};

}  // namespace rt
