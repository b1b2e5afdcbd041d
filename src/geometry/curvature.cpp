#include "rt/geometry/curvature.h"

#include <cmath>

namespace rt {
namespace {

/// The part of `v` around an axis through the anchor, `outwards` being the unit vector from it.
Vec3 aroundAxis(const Vec3& v, const Vec3& outwards, int axis) {
    Vec3 flat = v;
    flat[axis] = 0.0;
    return flat - glm::dot(flat, outwards) * outwards;
}

struct FromAxis {
    FromAxis(Vec3 local, int axis) {
        local[axis] = 0.0;
        distance = glm::length(local);
        outwards = local / distance;
    }
    double distance;
    Vec3 outwards;
};

Vec3 onBall(const PrimitiveHit& hit, const Vec3& along) {
    const double radius = glm::length(hit.local);
    const Vec3 normal = hit.local / radius;
    return (along - glm::dot(along, normal) * normal) / radius;
}

}  // namespace

Vec3 normalChange(const Sphere&, const PrimitiveHit& hit, const Vec3& along) {
    return onBall(hit, along);
}

Vec3 normalChange(const Hemisphere&, const PrimitiveHit& hit, const Vec3& along) {
    return hit.part == 0 ? onBall(hit, along) : Vec3(0.0);
}

Vec3 normalChange(const Box&, const PrimitiveHit&, const Vec3&) {
    return Vec3(0.0);
}

Vec3 normalChange(const Cylinder&, const PrimitiveHit& hit, const Vec3& along) {
    if (hit.part != 0) return Vec3(0.0);
    const FromAxis place(hit.local, 1);
    return aroundAxis(along, place.outwards, 1) / place.distance;
}

Vec3 normalChange(const Cone&, const PrimitiveHit& hit, const Vec3& along) {
    if (hit.part != 0) return Vec3(0.0);
    const FromAxis place(hit.local, 1);
    const double radial = hit.local.y / glm::length(hit.local);
    return radial * aroundAxis(along, place.outwards, 1) / place.distance;
}

Vec3 normalChange(const Frustum& frustum, const PrimitiveHit& hit, const Vec3& along) {
    if (hit.part != 0) return Vec3(0.0);
    const FromAxis place(hit.local, 1);
    return frustum.normalRadial() * aroundAxis(along, place.outwards, 1) / place.distance;
}

Vec3 normalChange(const Quadric& quadric, const PrimitiveHit& hit, const Vec3& along) {
    if (hit.part != 0) return Vec3(0.0);
    const Vec3 slope = quadric.centred().halfSlope(hit.local);
    const double length = glm::length(slope);
    const Vec3 normal = slope / length;
    const Vec3 step = along - glm::dot(along, normal) * normal;
    const Vec3 change = quadric.centred().times(step);
    return (change - glm::dot(change, normal) * normal) / length;
}

Vec3 normalChange(const Torus& torus, const PrimitiveHit& hit, const Vec3& along) {
    const FromAxis place(hit.local, 2);
    const Vec3 normal = torus.surface(hit, SurfaceDetail::kShape).normal;
    const Vec3 around = aroundAxis(along, place.outwards, 2);
    const Vec3 meridian = along - around - glm::dot(along, normal) * normal;
    const double side = hit.part == 0 ? 1.0 : -1.0;
    return side * meridian / torus.minorRadius() +
           glm::dot(normal, place.outwards) * around / place.distance;
}

Vec3 normalChange(const TriangleMesh& mesh, const PrimitiveHit& hit, const Vec3& along) {
    if (mesh.normalCorners.empty()) return Vec3(0.0);
    const TriangleMesh::Corners& corners = mesh.triangles[hit.part];
    const Vec3& a = mesh.positions[corners[0]];
    const Vec3 e1 = mesh.positions[corners[1]] - a;
    const Vec3 e2 = mesh.positions[corners[2]] - a;
    const Vec3 across = glm::cross(e1, e2);
    const double square = glm::dot(across, across);
    const Vec3 geometric = across / std::sqrt(square);
    const auto normal = [&](std::size_t k) {
        const Index corner = mesh.normalCorners[hit.part][k];
        return corner == kNone ? geometric : mesh.normals[corner];
    };
    // along = b1 e1 + b2 e2.
    const double b1 = glm::dot(glm::cross(along, e2), across) / square;
    const double b2 = glm::dot(glm::cross(e1, along), across) / square;
    const Vec3 sum = hit.local[0] * normal(0) + hit.local[1] * normal(1) + hit.local[2] * normal(2);
    const Vec3 change = b1 * (normal(1) - normal(0)) + b2 * (normal(2) - normal(0));
    const double length = glm::length(sum);
    const Vec3 unit = sum / length;
    return (change - glm::dot(change, unit) * unit) / length;
}

}  // namespace rt
