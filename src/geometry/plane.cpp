#include "rt/geometry/plane.h"

#include "ground_crossing.h"
#include "solid_texture.h"

namespace rt {

bool Plane::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    PrimitiveHit found;
    if (!crossGround(ray, range, found)) return false;
    const double away = std::fabs(found.local.x) + std::fabs(found.local.z);
    if (!(away <= kFarthestOfPlane)) return false;
    hit = found;
    return true;
}

SurfacePoint Plane::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Vec3 local(hit.local.x, 0.0, hit.local.z);
    SurfacePoint surface;
    placeSurface(surface, Vec3(0.0), local, Vec3(0.0, 1.0, 0.0));
    if (detail == SurfaceDetail::kParametrised) {
        surface.uv = Vec2(local.x - std::floor(local.x), -local.z - std::floor(-local.z));
        surface.dpdu = Vec3(1.0, 0.0, 0.0);
        surface.dpdv = Vec3(0.0, 0.0, -1.0);
    }
    return surface;
}

}  // namespace rt
