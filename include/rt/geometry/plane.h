// Plane: y = 0, facing +y; a sheet without bounds. What of it is farther from the origin than
// kFarthestOfPlane, in its own units, is left out.
//
// Texture: the image fills squares of side 1, seen from above with -z up: u = x, v = -z, brought
// into [0,1].
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Plane {
  public:
    static constexpr const char* kName = "plane";
    static constexpr SolidKind kKind{.closed = false, .bounded = false};

    Bounds bounds() const {
        return {Vec3(-kInfinity, 0.0, -kInfinity), Vec3(kInfinity, 0.0, kInfinity)};
    }
    /// The crossing in `range`, if any; none for a ray within the plane.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is 0: the point is on the plane.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;
};

}  // namespace rt
