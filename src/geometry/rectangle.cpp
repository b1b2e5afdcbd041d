#include "rt/geometry/rectangle.h"

#include "ground_crossing.h"
#include "solid_texture.h"

namespace rt {
namespace {

inline bool cross(double width, double depth, const Ray& ray, Interval range, PrimitiveHit& hit) {
    PrimitiveHit found;
    if (!crossGround(ray, range, found)) return false;
    const Vec3& p = found.local;
    if (!(p.x >= 0.0 && p.x <= width && p.z >= 0.0 && p.z <= depth)) return false;
    hit = found;
    return true;
}

}  // namespace

Rectangle::Rectangle(double width, double depth) : width_(width), depth_(depth) {
    requirePositive("rectangle", "width", width);
    requirePositive("rectangle", "depth", depth);
}

bool Rectangle::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(width_ + depth_, ray.direction)) [[likely]] {
        return cross(width_, depth_, ray, range, hit);
    }
    return intersectRescaled(
        std::max(width_, depth_), ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(std::ldexp(width_, exponent), std::ldexp(depth_, exponent), scaled,
                         scaledRange, found);
        });
}

SurfacePoint Rectangle::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const Vec3 local(std::min(std::max(hit.local.x, 0.0), width_), 0.0,
                     std::min(std::max(hit.local.z, 0.0), depth_));
    SurfacePoint surface;
    placeSurface(surface, Vec3(0.0), local, Vec3(0.0, 1.0, 0.0));
    if (detail == SurfaceDetail::kParametrised) {
        surface.uv = Vec2(clampToUnit(local.x / width_), clampToUnit(1.0 - local.z / depth_));
        surface.dpdu = Vec3(width_, 0.0, 0.0);
        surface.dpdv = Vec3(0.0, 0.0, -depth_);
    }
    return surface;
}

}  // namespace rt
