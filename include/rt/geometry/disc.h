// Disc: x^2 + z^2 <= r^2 in the plane y = 0, facing +y; a sheet.
//
// Texture: as on the cap of a cylinder: the image fills the square inscribed in the disc and
// repeats outside it: u = 1/2 + x / q, v = 1/2 - z / q with q = sqrt 2 r (seen from above, -z up).
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Disc {
  public:
    static constexpr const char* kName = "disc";
    static constexpr SolidKind kKind{.closed = false, .axis = 1};

    /// Refuses a radius that is not > 0 and finite (std::invalid_argument).
    explicit Disc(double radius);

    Bounds bounds() const { return {Vec3(-radius_, 0.0, -radius_), Vec3(radius_, 0.0, radius_)}; }
    /// The crossing in `range`, if any; none for a ray within the plane.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 4 roundings of r.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    double radius_;
};

}  // namespace rt
