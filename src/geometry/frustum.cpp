#include "rt/geometry/frustum.h"

#include "solid_frame.h"
#include "solid_texture.h"

#include <stdexcept>

namespace rt {
namespace {

enum Part : Index { kSide, kBase, kTop };

/// The frustum as the intersection sees it, its base's centre at the origin.
struct FrustumShape {
    double height;
    double radius;  ///< of the base
    double slope;
};

constexpr InsideSpan kOutside{{kInfinity, kSide}, {-kInfinity, kSide}};

/// The part of the ray inside that half of the double cone whose radius r0 + k y is positive.
inline InsideSpan insideSide(const FootRay& near, const FrustumShape& shape) {
    const Vec3& f = near.foot;
    const Vec3& d = near.direction;
    const double q = std::fma(shape.slope, f.y, shape.radius);
    const double e = shape.slope * d.y;
    const double gx = differenceOfProducts(q, d.x, e, f.x);
    const double gz = differenceOfProducts(q, d.z, e, f.z);
    const double moment = differenceOfProducts(f.x, d.z, f.z, d.x);
    const double discriminant = gx * gx + gz * gz - moment * moment;
    if (!(discriminant >= 0.0)) return kOutside;

    // -0 where the ray is parallel to the side: the far root then lies beyond the right end.
    const double a = -(e * e - (d.x * d.x + d.z * d.z));
    const double b = f.x * d.x + f.z * d.z - q * e;
    const double c = f.x * f.x + f.z * f.z - q * q;
    const double w = -(b + std::copysign(std::sqrt(discriminant), b));
    const double s1 = w / a;
    const double s2 = w != 0.0 ? c / w : s1;
    if (a > 0.0) {
        // Both roots are on one half of the double cone: where the middle between them is.
        if (!(d.x * gx + d.z * gz > 0.0)) return kOutside;
        return {{std::min(s1, s2), kSide}, {std::max(s1, s2), kSide}};
    }
    // One root on each half; the ray stays inside beyond them.
    if (e > 0.0) return {{std::max(s1, s2), kSide}, {kInfinity, kSide}};
    return {{-kInfinity, kSide}, {std::min(s1, s2), kSide}};
}

/// A Newton step from s on the side, whose equation is better conditioned at the point itself than
/// in coefficients. None where the ray grazes: there the discriminant knows better.
inline double refined(const FootRay& near, double s, const FrustumShape& shape) {
    const Vec3& d = near.direction;
    const Vec3 p = along(near, s);
    const double q = std::fma(shape.slope, p.y, shape.radius);
    const double value = differenceOfProducts(p.x, p.x, q, q) + p.z * p.z;
    const double halfSlope = p.x * d.x + p.z * d.z - q * (shape.slope * d.y);
    const double step = 0.5 * value / halfSlope;
    const double reach = kNewtonReach * shape.height;
    return step * step <= reach * reach * near.inverseSquare ? s - step : s;
}

inline bool meet(const FootRay& near, const Crossing& at, const FrustumShape& shape, Interval range,
                 PrimitiveHit& hit) {
    if (!(std::fabs(at.s) < kInfinity)) return false;
    const double s = at.part == kSide ? refined(near, at.s, shape) : at.s;
    const double t = near.tFoot + s;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = along(near, s);
    if (at.part != kSide) hit.local.y = at.part == kTop ? shape.height : 0.0;
    hit.part = at.part;
    return true;
}

inline bool cross(const Vec3& base, const FrustumShape& shape, const Ray& ray, Interval range,
                  PrimitiveHit& hit) {
    const FootRay near = footRay(ray, base, Vec3(0.0, 0.5 * shape.height, 0.0));
    InsideSpan inside = insideSide(near, shape);
    const double inverse = 1.0 / near.direction.y;
    const double toBase = -near.foot.y * inverse;
    const double toTop = (shape.height - near.foot.y) * inverse;
    if (inverse >= 0.0) {
        inside.enterAt(toBase, kBase);
        inside.leaveAt(toTop, kTop);
    } else {
        inside.enterAt(toTop, kTop);
        inside.leaveAt(toBase, kBase);
    }
    if (inside.isEmpty()) return false;
    return meet(near, inside.entry, shape, range, hit) ||
           meet(near, inside.exit, shape, range, hit);
}

}  // namespace

Frustum::Frustum(const Vec3& baseCentre, double height, double baseRadius, double topRadius)
    : base_(baseCentre), height_(height), baseRadius_(baseRadius), topRadius_(topRadius) {
    requireFinite("frustum", "base centre", baseCentre);
    requirePositive("frustum", "height", height);
    requirePositive("frustum", "base radius", baseRadius);
    requirePositive("frustum", "top radius", topRadius);
    if (baseRadius == topRadius) throw std::invalid_argument("frustum: the radii must differ");
    slope_ = (topRadius - baseRadius) / height;
    // Twice, for what the first time leaves of its length would add to that of each hit's normal.
    const Vec3 normal = unitVector(unitVector(Vec3(height, topRadius - baseRadius, 0.0)));
    normalRadial_ = normal.x;
    normalDown_ = normal.y;
}

Bounds Frustum::bounds() const {
    const Vec3& c = base_;
    const double r = widest();
    return {Vec3(sumBelow(c.x, -r), c.y, sumBelow(c.z, -r)),
            Vec3(sumAbove(c.x, r), sumAbove(c.y, height_), sumAbove(c.z, r))};
}

bool Frustum::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(height_ + widest(), ray.direction)) [[likely]] {
        return cross(base_, {height_, baseRadius_, slope_}, ray, range, hit);
    }
    return intersectRescaled(
        std::max(height_, widest()), ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(scaleByPowerOfTwo(base_, exponent),
                         {std::ldexp(height_, exponent), std::ldexp(baseRadius_, exponent), slope_},
                         scaled, scaledRange, found);
        });
}

SurfacePoint Frustum::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Radial out = radial(hit.local.x, hit.local.z);
    const bool parametrised = detail == SurfaceDetail::kParametrised;
    SurfacePoint surface;
    if (hit.part == kSide) {
        const double y = std::min(std::max(hit.local.y, 0.0), height_);
        const double across = std::fma(slope_, y, baseRadius_);
        const Vec3 local(across * out.x, y, across * out.z);
        const Vec3 normal(normalRadial_ * out.x, -normalDown_, normalRadial_ * out.z);
        placeSurface(surface, base_, local, normal);
        if (parametrised) {
            const double widening = topRadius_ - baseRadius_;
            surface.uv = Vec2(turnFraction(out), clampToUnit(y / height_));
            surface.dpdu = kTurn * Vec3(local.z, 0.0, -local.x);
            surface.dpdv = Vec3(widening * out.x, height_, widening * out.z);
        }
    } else {
        const bool top = hit.part == kTop;
        const double radius = top ? topRadius_ : baseRadius_;
        const bool within = out.length <= radius;
        const Vec3 local(within ? hit.local.x : radius * out.x, top ? height_ : 0.0,
                         within ? hit.local.z : radius * out.z);
        placeSurface(surface, base_, local, Vec3(0.0, top ? 1.0 : -1.0, 0.0));
        if (parametrised) layOnCap(surface, local.x, local.z, radius, top ? 1.0 : -1.0);
    }
    // Slope, radius there, length, its inverse, and two products: 8 roundings of the radius.
    surface.error = gamma(10) * widest() + placementError(surface.point);
    return surface;
}

}  // namespace rt
