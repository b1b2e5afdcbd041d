// Rectangle: 0 <= x <= width, 0 <= z <= depth in the plane y = 0, facing +y; a sheet.
//
// Texture: the image as seen from above with -z up: u = x / width, v = 1 - z / depth.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Rectangle {
  public:
    static constexpr const char* kName = "quad";
    static constexpr SolidKind kKind{.closed = false};

    /// Refuses sides that are not > 0 and finite (std::invalid_argument).
    Rectangle(double width, double depth);

    Bounds bounds() const { return {Vec3(0.0), Vec3(width_, 0.0, depth_)}; }
    /// The crossing in `range`, if any; none for a ray within the plane.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is 0: the point is on the rectangle.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    double width_;
    double depth_;
};

}  // namespace rt
