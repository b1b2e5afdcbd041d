// Quadric in a box: lo <= p <= hi and q(p) <= 0, with
//
//     q(p) = xx x^2 + yy y^2 + zz z^2 + xy x y + yz y z + zx z x + x_ x + y_ y + z_ z + c,
//
// closed by the faces of the box where q < 0 on them.
//
// About a point m of the box, q(m + l) = l . A l + 2 b . l + c', its coefficients formed in twice
// the precision, once, so that a box far from the origin costs no digits. m is where q adds up
// least: the least solution of A l = -b (Tikhonov's, iterated), which is an ellipsoid's middle, a
// cone's apex or a point of an axis; the box's centre where that lies beyond the box by more than
// half of it. So near an apex, or on a quadric much smaller than its box, no digits are lost to
// what lies far from it. Along a ray, from its foot near m, q = a s^2 + 2 B s + C. Where the point
// between the roots, s0 = -B / a, lies near the box, q is evaluated there anew, and the roots are
// s0 -+ sqrt(-q(s0) / a): no difference of squares of far larger numbers decides whether a ray that
// grazes is a hit. Else they are those of the quadratic without cancellation. The ray is inside
// between them (a > 0) or beyond them (a < 0), cut by the box's slabs; Newton steps follow at
// each point of the quadric.
//
// Texture: on the quadric u and v are longitude and latitude about the box's centre, as on a
// sphere; on a face of the box as there.
//
// Sources: Levin, A parametric algorithm for drawing pictures of solid objects composed of quadric
// surfaces, Communications of the ACM 19(10), 1976; Ogita, Rump, Oishi, Accurate sum and dot
// product, SIAM J. Sci. Comput. 26(6), 2005; King, Chillingworth, Approximation of generalized
// inverses by iterated regularization, Numerical Functional Analysis and Optimization 1(5), 1979.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

/// Of q, by the products that they belong to.
struct QuadricCoefficients {
    double xx = 0.0;
    double yy = 0.0;
    double zz = 0.0;
    double xy = 0.0;
    double yz = 0.0;
    double zx = 0.0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double c = 0.0;
};

/// q about a point: l . A l + 2 b . l + c.
struct CentredQuadric {
    Vec3 diagonal{0.0};  ///< of A
    Vec3 mixed{0.0};     ///< its entries yz, zx, xy
    Vec3 linear{0.0};    ///< b
    double constant = 0.0;

    /// A l.
    Vec3 times(const Vec3& l) const;
    double value(const Vec3& l) const;
    /// Sum of the magnitudes that `value` adds up.
    double magnitude(const Vec3& l) const;
    /// Half of the gradient.
    Vec3 halfSlope(const Vec3& l) const { return times(l) + linear; }
};

class Quadric {
  public:
    static constexpr const char* kName = "quadric";
    static constexpr SolidKind kKind{.convex = false};

    /// Refuses coefficients that are not finite, of which all but c are 0, or that are not finite
    /// about the box's centre; and corners that are not finite, or of which hi is not above lo
    /// (std::invalid_argument).
    Quadric(const QuadricCoefficients& coefficients, const Vec3& lo, const Vec3& hi);

    /// q about the anchor.
    const CentredQuadric& centred() const { return q_; }
    const Vec3& anchor() const { return anchor_; }
    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to m. Parts:
    /// 0 the quadric, 1 .. 6 the faces -x +x -y +y -z +z.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` on the quadric is what q's own rounding moves it by: 16 roundings of what `value`
    /// adds up, over |gradient|; but near a point without one, such as the apex of a cone, the
    /// square root of that over the largest coefficient of A. On faces as a box has it.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    CentredQuadric q_;
    Vec3 anchor_;  ///< m
    /// The corners relative to it.
    Vec3 lo_;
    Vec3 hi_;
    double size_;  ///< the largest of their components
};

}  // namespace rt
