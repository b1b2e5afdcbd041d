#include "rt/geometry/cone.h"

#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

enum Part : Index { kSide, kCap };

/// The cone as the intersection sees it, the apex at the origin.
struct ConeShape {
    double height;
    double slope;
};

constexpr InsideSpan kOutside{{kInfinity, kSide}, {-kInfinity, kSide}};

/// The part of the ray inside the upper half of the infinite double cone x^2 + z^2 = k^2 y^2, which
/// it crosses where A s^2 + 2 B s + C = 0.
inline InsideSpan insideUpperHalf(const FootRay& near, double k) {
    const Vec3& f = near.foot;
    const Vec3& d = near.direction;
    const double mx = differenceOfProducts(f.y, d.z, f.z, d.y);
    const double my = differenceOfProducts(f.z, d.x, f.x, d.z);
    const double mz = differenceOfProducts(f.x, d.y, f.y, d.x);
    const double discriminant = k * k * (mx * mx + mz * mz) - my * my;
    if (!(discriminant >= 0.0)) return kOutside;

    const double kdy = k * d.y;
    const double kfy = k * f.y;
    // -0 where the ray is parallel to the side: the far root then lies beyond the right end.
    const double a = -(kdy * kdy - (d.x * d.x + d.z * d.z));
    const double b = f.x * d.x + f.z * d.z - kfy * kdy;
    const double c = f.x * f.x + f.z * f.z - kfy * kfy;
    const double w = -(b + std::copysign(std::sqrt(discriminant), b));
    const double s1 = w / a;
    const double s2 = w != 0.0 ? c / w : s1;
    if (a > 0.0) {
        // Both roots are on one half of the double cone: where the middle between them is.
        if (!(d.z * mx - d.x * mz > 0.0)) return kOutside;
        return {{std::min(s1, s2), kSide}, {std::max(s1, s2), kSide}};
    }
    // One root on each half; the ray stays inside beyond them.
    if (d.y > 0.0) return {{std::max(s1, s2), kSide}, {kInfinity, kSide}};
    return {{-kInfinity, kSide}, {std::min(s1, s2), kSide}};
}

/// A Newton step from s on the side, whose equation is far better conditioned at the point itself,
/// near the apex above all, than in coefficients. None where the ray grazes: there the
/// discriminant knows better, and the step is not small.
inline double refined(const FootRay& near, double s, const ConeShape& cone) {
    const double k = cone.slope;
    const Vec3& d = near.direction;
    const Vec3 p = along(near, s);
    const double ky = k * p.y;
    const double value = differenceOfProducts(p.x, p.x, ky, ky) + p.z * p.z;
    const double halfSlope = p.x * d.x + p.z * d.z - ky * (k * d.y);
    const double step = 0.5 * value / halfSlope;
    const double reach = kNewtonReach * cone.height;
    return step * step <= reach * reach * near.inverseSquare ? s - step : s;
}

inline bool meet(const FootRay& near, const Crossing& at, const ConeShape& cone, Interval range,
                 PrimitiveHit& hit) {
    if (!(std::fabs(at.s) < kInfinity)) return false;
    const double s = at.part == kSide ? refined(near, at.s, cone) : at.s;
    const double t = near.tFoot + s;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = along(near, s);
    if (at.part == kCap) hit.local.y = cone.height;
    hit.part = at.part;
    return true;
}

[[gnu::always_inline]] inline bool cross(const Vec3& apex, const ConeShape& cone, const Ray& ray,
                                         Interval range, PrimitiveHit& hit) {
    const FootRay near = footRay(ray, apex, Vec3(0.0, 0.5 * cone.height, 0.0));
    InsideSpan inside = insideUpperHalf(near, cone.slope);
    const double inverse = 1.0 / near.direction.y;
    const double toCap = (cone.height - near.foot.y) * inverse;
    if (inverse >= 0.0) {
        inside.leaveAt(toCap, kCap);
    } else {
        inside.enterAt(toCap, kCap);
    }
    if (inside.isEmpty()) return false;
    return meet(near, inside.entry, cone, range, hit) || meet(near, inside.exit, cone, range, hit);
}

}  // namespace

Cone::Cone(const Vec3& apex, double height, double radius)
    : apex_(apex), height_(height), radius_(radius) {
    requireFinite("cone", "apex", apex);
    requirePositive("cone", "height", height);
    requirePositive("cone", "radius", radius);
    slope_ = radius / height;
    const Vec3 normal = unitVector(Vec3(height, radius, 0.0));
    normalRadial_ = normal.x;
    normalDown_ = normal.y;
}

Bounds Cone::bounds() const {
    const Vec3& c = apex_;
    return {Vec3(sumBelow(c.x, -radius_), c.y, sumBelow(c.z, -radius_)),
            Vec3(sumAbove(c.x, radius_), sumAbove(c.y, height_), sumAbove(c.z, radius_))};
}

bool Cone::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(height_ + radius_, ray.direction)) [[likely]] {
        return cross(apex_, {height_, slope_}, ray, range, hit);
    }
    return intersectRescaled(
        std::max(height_, radius_), ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(scaleByPowerOfTwo(apex_, exponent),
                         {std::ldexp(height_, exponent), slope_}, scaled, scaledRange, found);
        });
}

SurfacePoint Cone::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Radial out = radial(hit.local.x, hit.local.z);
    const bool parametrised = detail == SurfaceDetail::kParametrised;
    SurfacePoint surface;
    if (hit.part == kSide) {
        const double y = std::min(std::max(hit.local.y, 0.0), height_);
        const double across = slope_ * y;
        const Vec3 local(across * out.x, y, across * out.z);
        const Vec3 normal(normalRadial_ * out.x, -normalDown_, normalRadial_ * out.z);
        placeSurface(surface, apex_, local, normal);
        if (parametrised) {
            surface.uv = Vec2(turnFraction(out), clampToUnit(y / height_));
            surface.dpdu = kTurn * Vec3(local.z, 0.0, -local.x);
            surface.dpdv = Vec3(radius_ * out.x, height_, radius_ * out.z);
        }
    } else {
        const bool within = out.length <= radius_;
        const Vec3 local(within ? hit.local.x : radius_ * out.x, height_,
                         within ? hit.local.z : radius_ * out.z);
        placeSurface(surface, apex_, local, Vec3(0.0, 1.0, 0.0));
        if (parametrised) layOnCap(surface, local.x, local.z, radius_, 1.0);
    }
    // Slope, radius there, length, its inverse, and two products: 6.5 roundings of the radius.
    surface.error = gamma(8) * radius_ + placementError(surface.point);
    return surface;
}

}  // namespace rt
