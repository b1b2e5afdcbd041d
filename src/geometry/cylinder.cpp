#include "rt/geometry/cylinder.h"

#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

enum Part : Index { kSide, kBase, kTop };

/// The part of the ray inside the infinite cylinder; empty where it misses.
inline InsideSpan insideTube(const FootRay& near, double radius) {
    const Vec3& f = near.foot;
    const Vec3& d = near.direction;
    const double across = d.x * d.x + d.z * d.z;
    if (!(across * near.inverseSquare > kParallelSine * kParallelSine)) {
        const bool inside = f.x * f.x + f.z * f.z <= radius * radius;
        return inside ? InsideSpan{{-kInfinity, kSide}, {kInfinity, kSide}}
                      : InsideSpan{{kInfinity, kSide}, {-kInfinity, kSide}};
    }
    // Distance of the ray to the axis, times the length of its part across.
    const double moment = differenceOfProducts(f.x, d.z, f.z, d.x);
    const double discriminant = radius * radius * across - moment * moment;
    if (!(discriminant >= 0.0)) return {{kInfinity, kSide}, {-kInfinity, kSide}};
    const double inverse = 1.0 / across;
    const double middle = -(f.x * d.x + f.z * d.z) * inverse;
    const double half = std::sqrt(discriminant) * inverse;
    return {{middle - half, kSide}, {middle + half, kSide}};
}

inline bool meet(const FootRay& near, const Crossing& at, double height, Interval range,
                 PrimitiveHit& hit) {
    const double t = near.tFoot + at.s;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = along(near, at.s);
    if (at.part != kSide) hit.local.y = at.part == kTop ? height : 0.0;
    hit.part = at.part;
    return true;
}

[[gnu::always_inline]] inline bool cross(const Vec3& base, double height, double radius,
                                         const Ray& ray, Interval range, PrimitiveHit& hit) {
    const FootRay near = footRay(ray, base, Vec3(0.0, 0.5 * height, 0.0));
    InsideSpan inside = insideTube(near, radius);
    const double inverse = 1.0 / near.direction.y;
    const double toBase = -near.foot.y * inverse;
    const double toTop = (height - near.foot.y) * inverse;
    if (inverse >= 0.0) {
        inside.enterAt(toBase, kBase);
        inside.leaveAt(toTop, kTop);
    } else {
        inside.enterAt(toTop, kTop);
        inside.leaveAt(toBase, kBase);
    }
    if (inside.isEmpty()) return false;
    return meet(near, inside.entry, height, range, hit) ||
           meet(near, inside.exit, height, range, hit);
}

}  // namespace

Cylinder::Cylinder(const Vec3& baseCentre, double height, double radius)
    : base_(baseCentre), height_(height), radius_(radius) {
    requireFinite("cylinder", "base centre", baseCentre);
    requirePositive("cylinder", "height", height);
    requirePositive("cylinder", "radius", radius);
}

Bounds Cylinder::bounds() const {
    const Vec3& c = base_;
    return {Vec3(sumBelow(c.x, -radius_), c.y, sumBelow(c.z, -radius_)),
            Vec3(sumAbove(c.x, radius_), sumAbove(c.y, height_), sumAbove(c.z, radius_))};
}

bool Cylinder::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    const double size = height_ + radius_;
    if (isOrdinary(size, ray.direction)) [[likely]] {
        return cross(base_, height_, radius_, ray, range, hit);
    }
    return intersectRescaled(
        std::max(height_, radius_), ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(scaleByPowerOfTwo(base_, exponent), std::ldexp(height_, exponent),
                         std::ldexp(radius_, exponent), scaled, scaledRange, found);
        });
}

SurfacePoint Cylinder::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Radial out = radial(hit.local.x, hit.local.z);
    const bool parametrised = detail == SurfaceDetail::kParametrised;
    SurfacePoint surface;
    if (hit.part == kSide) {
        const double y = std::min(std::max(hit.local.y, 0.0), height_);
        const Vec3 local(radius_ * out.x, y, radius_ * out.z);
        placeSurface(surface, base_, local, Vec3(out.x, 0.0, out.z));
        if (parametrised) {
            surface.uv = Vec2(turnFraction(out), clampToUnit(y / height_));
            surface.dpdu = kTurn * Vec3(local.z, 0.0, -local.x);
            surface.dpdv = Vec3(0.0, height_, 0.0);
        }
    } else {
        const double up = hit.part == kTop ? 1.0 : -1.0;
        const bool within = out.length <= radius_;
        const Vec3 local(within ? hit.local.x : radius_ * out.x, hit.part == kTop ? height_ : 0.0,
                         within ? hit.local.z : radius_ * out.z);
        placeSurface(surface, base_, local, Vec3(0.0, up, 0.0));
        if (parametrised) layOnCap(surface, local.x, local.z, radius_, up);
    }
    // Length, its inverse, and two products: 4.5 roundings of the radius.
    surface.error = gamma(6) * radius_ + placementError(surface.point);
    return surface;
}

}  // namespace rt
