#include "rt/shading/bump.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

double decodedCode(double code) {
    return std::max(-1.0, (code - 128.0) / 127.0);
}

/// v / |v|, or `otherwise` if v is 0, too small to have a direction, or not finite.
Vec3 normalizedOr(const Vec3& v, const Vec3& otherwise) {
    const double squared = glm::dot(v, v);
    if (!(squared > 0.0 && squared < kInfinity)) return otherwise;
    return v / std::sqrt(squared);
}

Vec3 mappedNormal(const Texture& map, const SurfacePoint& surface) {
    Vec3 local = decodedNormal(map.bilinearCodes(surface.uv));
    if (local.x == 0.0 && local.y == 0.0) return surface.shadingNormal;
    // Green leans towards the top of the image, which flipping V makes the way of falling v.
    if (map.flipsV()) local.y = -local.y;
    const Vec3& n = surface.shadingNormal;
    const Vec3 t = normalizedOr(surface.dpdu - glm::dot(n, surface.dpdu) * n, Vec3(0.0));
    const Vec3 side = glm::cross(n, t);
    const Vec3 b = glm::dot(side, surface.dpdv) < 0.0 ? -side : side;
    if (t == Vec3(0.0) || glm::dot(b, surface.dpdv) == 0.0) return n;
    return normalizedOr(local.x * t + local.y * b + local.z * n, n);
}

Vec3 raisedNormal(const Texture& map, const SurfacePoint& surface) {
    const Vec2 slope = map.gradient(surface.uv);
    if (slope == Vec2(0.0)) return surface.shadingNormal;
    const Vec3& n = surface.shadingNormal;
    const Vec3 across = glm::cross(surface.dpdu, surface.dpdv);
    const double area = glm::dot(n, across);
    const double unit = kHeightOfWhite * std::sqrt(std::sqrt(glm::dot(across, across)));
    const Vec3 lean = slope.x * glm::cross(surface.dpdv, n) + slope.y * glm::cross(n, surface.dpdu);
    const Vec3 raised = n - (unit / area) * lean;
    // No area, no parametrisation: the division leaves nothing finite.
    return normalizedOr(raised, n);
}

}  // namespace

Vec3 decodedNormal(const Color& codes) {
    return {decodedCode(codes.x), decodedCode(codes.y), decodedCode(codes.z)};
}

Vec3 bumpedNormal(const Texture& map, const SurfacePoint& surface) {
    return map.channels() == 1 ? raisedNormal(map, surface) : mappedNormal(map, surface);
}

}  // namespace rt
