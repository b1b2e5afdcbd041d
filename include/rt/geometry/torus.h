// Torus about z: (|p-c|^2 + R^2 - r^2)^2 = 4 R^2 ((x-cx)^2 + (y-cy)^2). r >= R (horn, spindle) is
// allowed: all of the quartic is surface.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"

namespace rt {

class Torus {
  public:
    /// Refuses radii that are not > 0 and finite (std::invalid_argument).
    Torus(const Vec3& centre, double majorRadius, double minorRadius);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    SurfacePoint surface(const PrimitiveHit& hit) const;

  private:
    Vec3 centre_;
    double major_;
    double minor_;
    // Lengths are scaled by a power of two that makes the larger radius lie in [1/2, 1).
    double unit_;
    double perUnit_;
    double scaledMajor_;
    double scaledMinor_;
};

}  // namespace rt
