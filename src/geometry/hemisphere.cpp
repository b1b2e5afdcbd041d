#include "rt/geometry/hemisphere.h"

#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

enum Part : Index { kDome, kBase };

inline bool meet(const FootRay& near, const Crossing& at, Interval range, PrimitiveHit& hit) {
    const double t = near.tFoot + at.s;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = along(near, at.s);
    if (at.part == kBase) hit.local.y = 0.0;
    hit.part = at.part;
    return true;
}

inline bool cross(const Vec3& centre, double radius, const Ray& ray, Interval range,
                  PrimitiveHit& hit) {
    const FootRay near = footRay(ray, centre, Vec3(0.0));
    const double alongDirection = dot(near.foot, near.direction);
    const double toNearest = -alongDirection * near.inverseSquare;
    const double discriminant =
        (radius * radius - dot(near.foot, near.foot)) - alongDirection * toNearest;
    if (!(discriminant >= 0.0)) return false;
    const double half = std::sqrt(discriminant * near.inverseSquare);
    InsideSpan inside{{toNearest - half, kDome}, {toNearest + half, kDome}};
    const double inverse = 1.0 / near.direction.y;
    const double toBase = -near.foot.y * inverse;
    if (inverse >= 0.0) {
        inside.enterAt(toBase, kBase);
    } else {
        inside.leaveAt(toBase, kBase);
    }
    if (inside.isEmpty()) return false;
    return meet(near, inside.entry, range, hit) || meet(near, inside.exit, range, hit);
}

}  // namespace

Hemisphere::Hemisphere(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {
    requireFinite("hemisphere", "centre", centre);
    requirePositive("hemisphere", "radius", radius);
}

Bounds Hemisphere::bounds() const {
    const Vec3& c = centre_;
    return {Vec3(sumBelow(c.x, -radius_), c.y, sumBelow(c.z, -radius_)),
            Vec3(sumAbove(c.x, radius_), sumAbove(c.y, radius_), sumAbove(c.z, radius_))};
}

bool Hemisphere::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(radius_, ray.direction)) [[likely]] {
        return cross(centre_, radius_, ray, range, hit);
    }
    return intersectRescaled(
        radius_, ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(scaleByPowerOfTwo(centre_, exponent), std::ldexp(radius_, exponent),
                         scaled, scaledRange, found);
        });
}

SurfacePoint Hemisphere::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const bool parametrised = detail == SurfaceDetail::kParametrised;
    const Radial out = radial(hit.local.x, hit.local.z);
    SurfacePoint surface;
    if (hit.part == kDome) {
        // The rounding of a point at the rim may have put it below.
        const Vec3 n = unitVector(Vec3(hit.local.x, std::max(hit.local.y, 0.0), hit.local.z));
        placeSurface(surface, centre_, radius_ * n, n);
        if (parametrised) {
            const double across = std::sqrt(n.x * n.x + n.z * n.z);
            surface.uv =
                Vec2(turnFraction(out), clampToUnit(2.0 * latitudeFraction(n.y, across) - 1.0));
            surface.dpdu = (kTurn * radius_) * Vec3(n.z, 0.0, -n.x);
            surface.dpdv = (0.25 * kTurn * radius_) * Vec3(-n.y * out.x, across, -n.y * out.z);
        }
    } else {
        const bool within = out.length <= radius_;
        const Vec3 local(within ? hit.local.x : radius_ * out.x, 0.0,
                         within ? hit.local.z : radius_ * out.z);
        placeSurface(surface, centre_, local, Vec3(0.0, -1.0, 0.0));
        if (parametrised) layOnCap(surface, local.x, local.z, radius_, -1.0);
    }
    // Length, its inverse, and two products: 4.5 roundings of the radius.
    surface.error = gamma(6) * radius_ + placementError(surface.point);
    return surface;
}

}  // namespace rt
