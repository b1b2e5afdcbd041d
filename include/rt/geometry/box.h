// Box: lo <= p <= lo + size, the faces parallel to the axes.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"

namespace rt {

class Box {
  public:
    /// Refuses sizes that are not > 0 and finite (std::invalid_argument).
    Box(const Vec3& lo, const Vec3& size);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre. Parts 0 ..
    /// 5: -x +x -y +y -z +z.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    SurfacePoint surface(const PrimitiveHit& hit) const;

  private:
    Vec3 lo_;
    Vec3 size_;
};

}  // namespace rt
