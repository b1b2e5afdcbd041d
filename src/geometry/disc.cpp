#include "rt/geometry/disc.h"

#include "ground_crossing.h"
#include "solid_texture.h"

namespace rt {
namespace {

inline bool cross(double radius, const Ray& ray, Interval range, PrimitiveHit& hit) {
    PrimitiveHit found;
    if (!crossGround(ray, range, found)) return false;
    const Vec3& p = found.local;
    if (!(p.x * p.x + p.z * p.z <= radius * radius)) return false;
    hit = found;
    return true;
}

}  // namespace

Disc::Disc(double radius) : radius_(radius) {
    requirePositive("disc", "radius", radius);
}

bool Disc::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(radius_, ray.direction)) [[likely]] {
        return cross(radius_, ray, range, hit);
    }
    return intersectRescaled(
        radius_, ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(std::ldexp(radius_, exponent), scaled, scaledRange, found);
        });
}

SurfacePoint Disc::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    SurfacePoint surface;
    placeSurface(surface, Vec3(0.0), Vec3(hit.local.x, 0.0, hit.local.z), Vec3(0.0, 1.0, 0.0));
    // Two squares, their sum and that of r: half of 3 roundings of the radius beyond the rim.
    surface.error = gamma(4) * radius_;
    if (detail == SurfaceDetail::kParametrised) {
        layOnCap(surface, hit.local.x, hit.local.z, radius_, 1.0);
    }
    return surface;
}

}  // namespace rt
