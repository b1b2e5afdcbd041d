// Cone without its tip, about y: (x-cx)^2 + (z-cz)^2 = (r0 + k (y-cy))^2 for cy <= y <= cy + h,
// with k = (r1 - r0) / h, and a cap at either end.
//
// The ray is inside where A s^2 + 2 B s + C <= 0. With f its foot relative to c, d its direction,
// q = r0 + k fy, e = k dy and g = q (dx, dz) - e (fx, fz), the discriminant B^2 - A C is
// |g|^2 - (fx dz - fz dx)^2: differences that are formed once, without cancellation, as for the
// cone (rt/geometry/cone.h), but without its apex, which may be far away. A Newton step follows.
//
// Texture: the side and the caps as on a cylinder.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Frustum {
  public:
    static constexpr const char* kName = "frustum";
    static constexpr SolidKind kKind{.axis = 1};

    /// Refuses a height or radius that is not > 0 and finite, equal radii (a cylinder), and a base
    /// that is not finite (std::invalid_argument).
    Frustum(const Vec3& baseCentre, double height, double baseRadius, double topRadius);

    const Vec3& base() const { return base_; }
    double height() const { return height_; }
    double baseRadius() const { return baseRadius_; }
    double topRadius() const { return topRadius_; }
    /// The part of the side's normal away from the axis.
    double normalRadial() const { return normalRadial_; }
    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the base's centre.
    /// Parts: 0 side, 1 base, 2 top.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 10 roundings of the larger radius, and 2 of |x| + |y| + |z|.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    double widest() const { return baseRadius_ > topRadius_ ? baseRadius_ : topRadius_; }

    Vec3 base_;
    double height_;
    double baseRadius_;
    double topRadius_;
    double slope_;         ///< k
    double normalRadial_;  ///< the side's normal: h / slant outwards,
    double normalDown_;    ///< and (r1 - r0) / slant down
};

}  // namespace rt
