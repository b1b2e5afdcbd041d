// Torus about z: (|p-c|^2 + R^2 - r^2)^2 = 4 R^2 ((x-cx)^2 + (y-cy)^2). r >= R (horn, spindle) is
// allowed: all of the quartic is surface.
//
// With q = p - c and rho the distance to the axis the quartic is a product of two sheets,
//
//     ((rho - R)^2 + qz^2 - r^2) ((rho + R)^2 + qz^2 - r^2) = 0,
//
// the tube and, where r > R, the lemon inside it. Along a line each factor f has
// f'' / 2 = d.d -+ R J / rho^3 with J = (qx dy - qy dx)^2, the same everywhere on the line. So the
// lemon is met where a convex function is zero, and the tube where one is that is convex, concave
// while rho^3 < R J / d.d, and convex: at most two roots in each stretch, found by Halley's
// iteration in a bracket. No coefficient of the quartic is formed. The line starts from the foot of
// the perpendicular from c, by exact differences, so that a far origin costs no digits.
//
// Sources: Yuksel, High-Performance Polynomial Root Finding for Graphics, HPG 2022 (stretches
// between the roots of derivatives); Traub, Iterative Methods for the Solution of Equations, 1964
// (Halley's iteration); Wald, Improving Numerical Precision in Intersection Programs, Ray Tracing
// Gems II, 2021, chapter 34 (moving the origin).
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Torus {
  public:
    static constexpr const char* kName = "torus";
    static constexpr SolidKind kKind{.convex = false, .axis = 2};

    /// Refuses radii that are not > 0 and finite (std::invalid_argument).
    Torus(const Vec3& centre, double majorRadius, double minorRadius);

    const Vec3& centre() const { return centre_; }
    double majorRadius() const { return major_; }
    double minorRadius() const { return minor_; }
    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre and within a
    /// few roundings of R + r of the surface. Parts: 0 the tube, 1 the lemon. A crossing that
    /// cannot be told from `range.min` counts as lying there, so that asking again from the t of a
    /// hit never gives the same one.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// Whether a hit lies where the tube curves away from its tangent plane: rho >= R, r < R.
    bool isOuterHalf(const PrimitiveHit& hit) const {
        const double squared = hit.local.x * hit.local.x + hit.local.y * hit.local.y;
        return minor_ < major_ && squared >= major_ * major_;
    }
    /// The normal is along the gradient of the quartic, so on the lemon it points to the centre.
    /// u is the angle about z from x, v the angle on the tube from the outer equator upwards, both
    /// in turns; dpdu x dpdv is along the normal.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

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
