#include "ray_differential.h"

#include "rt/geometry/curvature.h"
#include "rt/shading/fresnel.h"
#include "scene_intersect.h"
#include "with_shape.h"

#include <cmath>
#include <limits>

namespace rt {
namespace {

/// Where the ray's neighbour meets the plane through the hit, relative to it.
Vec3 onPlane(const Vec3& apart, const Vec3& direction, const Vec3& normal) {
    return apart - direction * (glm::dot(apart, normal) / glm::dot(direction, normal));
}

/// The derivative of the unit normal `n` where that of the object's normal `outside`, of any
/// length, is `change`.
Vec3 changeThrough(const Affine& toObject, const Vec3& change, const Vec3& outside, const Vec3& n) {
    const Mat3 forNormals = glm::transpose(toObject.linear);
    const Vec3 moved = forNormals * change;
    const Vec3 normal = forNormals * outside;
    const double side = glm::dot(normal, n) < 0.0 ? -1.0 : 1.0;
    return side * (moved - glm::dot(moved, n) * n) / glm::length(normal);
}

struct NormalChange {
    const PrimitiveHit& hit;
    const Vec3& along;

    template <class Solid>
    Vec3 operator()(const Solid& solid) const {
        return normalChange(solid, hit, along);
    }
    Vec3 operator()(const MeshPointer& shape) const {
        return normalChange(shape->mesh, hit, along);
    }
    Vec3 operator()(const CsgPointer& shape) const {
        const CsgLeaf& leaf = shape->leaves[hit.leaf];
        const Affine& toLeaf = leaf.transform.toObject();
        const Vec3 alongLeaf = toLeaf.vector(along);
        const Vec3 change = withShape(leaf.shape, NormalChange{hit, alongLeaf});
        if (change == Vec3(0.0)) return change;
        const SurfaceOfShape surfaceOf{hit, SurfaceDetail::kShape};
        return changeThrough(toLeaf, change, withShape(leaf.shape, surfaceOf).shadingNormal,
                             surfaceOf(shape).shadingNormal);
    }
};

/// The derivative of the unit normal `n`, which may be turned to either side, in the world.
Vec3 worldNormalChange(const RenderScene& scene, const SceneHit& hit, const Vec3& n,
                       const Vec3& along) {
    const Instance& instance = scene.instances[hit.instance];
    const Shape& shape = scene.shapes[instance.shape];
    const Affine& toObject = instance.transform.toObject();
    const Vec3 alongInObject = toObject.vector(along);
    const Vec3 change = std::visit(NormalChange{hit.at, alongInObject}, shape);
    if (change == Vec3(0.0)) return change;
    return changeThrough(toObject, change,
                         surfaceAt(scene, hit, SurfaceDetail::kShape).shadingNormal, n);
}

RayDifferential unknown() {
    const Vec3 nan(std::numeric_limits<double>::quiet_NaN());
    return {{{{nan, nan}, {nan, nan}}}};
}

}  // namespace

RayDifferential cameraDifferential(const Camera& camera, const Vec3& direction) {
    const auto by = [&](const Vec3& perPixel) {
        // The derivative of a vector that is made unit, of a length whose inverse is D . forward.
        const Vec3 change = perPixel - glm::dot(perPixel, direction) * direction;
        return RayDifferential::By{Vec3(0.0), glm::dot(direction, camera.forward()) * change};
    };
    return {{by(camera.perPixelRight()), by(camera.perPixelDown())}};
}

RayDifferential differentialBeyond(const RayDifferential& before, const RenderScene& scene,
                                   const Ray& ray, const SceneHit& hit, const ShadePoint& point,
                                   const Vec3& direction, double ratio) {
    const bool straight = ratio == 1.0;
    const Vec3& d = ray.direction;
    const Look& look = lookAt(scene, hit);
    const bool facing = glm::dot(d, point.normal) < 0.0;
    const Vec3& n = facing ? point.normal : point.geometricNormal;
    // The slope of a bump map's normals is not followed, nor that of directions brought to a side.
    if (!straight && look.bump) return unknown();
    if (ratio == 0.0 && direction != mirrored(d, n)) return unknown();
    RayDifferential after;
    for (std::size_t i = 0; i < 2; ++i) {
        const RayDifferential::By& by = before.by[i];
        const Vec3 along = onPlane(by.position + hit.at.t * by.direction, d, point.geometricNormal);
        after.by[i].position = along;
        if (straight) {
            after.by[i].direction = by.direction;
            continue;
        }
        const Vec3 dn = facing ? worldNormalChange(scene, hit, n, along) : Vec3(0.0);
        const double c = -glm::dot(d, n);
        const double dc = -(glm::dot(by.direction, n) + glm::dot(d, dn));
        if (ratio == 0.0) {
            after.by[i].direction = by.direction + 2.0 * (c * dn + dc * n);
        } else {
            const double beyond = -glm::dot(direction, n);
            const double dBeyond = ratio * ratio * c * dc / beyond;
            after.by[i].direction =
                ratio * by.direction + (ratio * c - beyond) * dn + (ratio * dc - dBeyond) * n;
        }
    }
    return after;
}

std::array<Vec3, 2> Beam::sidesOn(const SurfacePoint& surface, const Transform& transform,
                                  double t) const {
    const Affine& toObject = transform.toObject();
    const Vec3 direction = toObject.vector(ray.direction);
    const auto by = [&](const RayDifferential::By& change, double size) {
        const Vec3 apart = toObject.vector(size * (change.position + t * change.direction));
        return onPlane(apart, direction, surface.normal);
    };
    return {by(differential.by[0], share.size.x), by(differential.by[1], share.size.y)};
}

TextureFootprint Beam::on(const SurfacePoint& surface, const Transform& transform, double t) const {
    // uv of a step in the tangent plane: step = dpdu u + dpdv v.
    const double uu = glm::dot(surface.dpdu, surface.dpdu);
    const double uv = glm::dot(surface.dpdu, surface.dpdv);
    const double vv = glm::dot(surface.dpdv, surface.dpdv);
    const double determinant = uu * vv - uv * uv;
    const auto inUv = [&](const Vec3& step) {
        const double alongU = glm::dot(step, surface.dpdu);
        const double alongV = glm::dot(step, surface.dpdv);
        return Vec2(alongU * vv - alongV * uv, alongV * uu - alongU * uv) / determinant;
    };
    const std::array<Vec3, 2> sides = sidesOn(surface, transform, t);
    return {inUv(sides[0]), inUv(sides[1]), share.phase};
}

}  // namespace rt
