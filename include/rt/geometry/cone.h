// Capped cone about y: (x-cx)^2 + (z-cz)^2 = (r/h)^2 (y-cy)^2 for cy <= y <= cy + h; apex c,
// opening upwards.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"

namespace rt {

class Cone {
  public:
    /// Refuses a height or radius that is not > 0 and finite (std::invalid_argument).
    Cone(const Vec3& apex, double height, double radius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the apex. Parts: 0 side,
    /// 1 cap (y = cy + h).
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    SurfacePoint surface(const PrimitiveHit& hit) const;

  private:
    Vec3 apex_;
    double height_;
    double radius_;
};

}  // namespace rt
