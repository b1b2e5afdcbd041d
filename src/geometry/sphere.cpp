#include "rt/geometry/sphere.h"

#include "rt/math/portable.h"
#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

[[gnu::always_inline]] inline bool cross(const Vec3& centre, double radius, const Ray& ray,
                                         Interval range, PrimitiveHit& hit) {
    const FootRay near = footRay(ray, centre, Vec3(0.0));
    // The foot is off the nearest point by the rounding of tFoot: beside the radius that counts
    // only where the origin is very far away, so most rays are decided without it.
    const double alongDirection = dot(near.foot, near.direction);
    const double toNearest = -alongDirection * near.inverseSquare;
    const double footRoom = radius * radius - dot(near.foot, near.foot);
    const double discriminant = footRoom - alongDirection * toNearest;
    if (!(footRoom >= 0.0) && !(discriminant >= 0.0)) return false;
    const double half = std::sqrt(discriminant * near.inverseSquare);
    double s = toNearest - half;
    double t = near.tFoot + s;
    if (!range.contains(t)) {
        s = toNearest + half;
        t = near.tFoot + s;
        if (!range.contains(t)) return false;
    }
    hit.t = t;
    hit.local = along(near, s);
    hit.part = 0;
    return true;
}

}  // namespace

Sphere::Sphere(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {
    requireFinite("sphere", "centre", centre);
    requirePositive("sphere", "radius", radius);
}

Bounds Sphere::bounds() const {
    const Vec3& c = centre_;
    return {Vec3(sumBelow(c.x, -radius_), sumBelow(c.y, -radius_), sumBelow(c.z, -radius_)),
            Vec3(sumAbove(c.x, radius_), sumAbove(c.y, radius_), sumAbove(c.z, radius_))};
}

bool Sphere::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
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

SurfacePoint Sphere::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Vec3 n = unitVector(hit.local);
    const Vec3 local = radius_ * n;
    SurfacePoint surface;
    placeSurface(surface, centre_, local, n);
    // Length, its inverse, and two products: 4.5 roundings of the radius.
    surface.error = gamma(6) * radius_ + placementError(surface.point);
    if (detail == SurfaceDetail::kShape) return surface;
    const Radial out = radial(hit.local.x, hit.local.z);
    const double across = std::sqrt(n.x * n.x + n.z * n.z);
    surface.uv = Vec2(turnFraction(out), latitudeFraction(n.y, across));
    surface.dpdu = kTurn * Vec3(local.z, 0.0, -local.x);
    surface.dpdv = (0.5 * kTurn * radius_) * Vec3(-n.y * out.x, across, -n.y * out.z);
    return surface;
}

}  // namespace rt
