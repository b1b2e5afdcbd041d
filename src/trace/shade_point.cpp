#include "shade_point.h"

#include "ray_differential.h"
#include "rt/core/numeric.h"
#include "rt/shading/bump.h"
#include "scene_intersect.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

double largest(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// The shading normal of the object-space surface, bump map applied.
Vec3 objectNormal(const Look& look, const SurfacePoint& surface, bool images) {
    if (!images || !look.bump) return surface.shadingNormal;
    return bumpedNormal(*look.bump, surface);
}

/// Normals cannot be averaged like colours, and vary with them: beside a bump map nothing is.
Color textureColor(const Look& look, const SurfacePoint& surface, const Transform& transform,
                   double t, const Beam* beam) {
    if (!beam || look.bump) return look.texture->bilinear(surface.uv);
    return look.texture->filtered(surface.uv, beam->on(surface, transform, t));
}

Color patternColor(const Look& look, const SurfacePoint& surface, const Transform& transform,
                   double t, const Beam* beam) {
    const Pattern& pattern = *look.pattern;
    const Affine* space = look.patternSpace.get();
    const Vec3 at = space ? space->point(surface.point) : surface.point;
    const Vec3 out = space ? glm::normalize(space->vector(surface.normal)) : surface.normal;
    // A face that lies where two cells meet shows the inner ones.
    const Vec3 p = at - (kPatternDepth * pattern.size) * out;
    if (!beam) return pattern.at(p);
    std::array<Vec3, 2> sides = beam->sidesOn(surface, transform, t);
    if (space) sides = {space->vector(sides[0]), space->vector(sides[1])};
    return pattern.mean(p, sides[0], sides[1], beam->share.phase);
}

}  // namespace

ShadePoint shadePoint(const RenderScene& scene, const SceneHit& hit, const Vec3& rayDirection,
                      bool images, const Beam* beam) {
    const Instance& instance = scene.instances[hit.instance];
    const Look& look = lookAt(scene, hit);
    const Transform& transform = instance.transform;
    const bool pictured = images && (look.texture || look.bump);
    const SurfacePoint surface =
        surfaceAt(scene, hit, pictured ? SurfaceDetail::kParametrised : SurfaceDetail::kShape);

    ShadePoint point;
    point.material = look.material;
    if (images && look.texture) {
        point.material.diffuse = textureColor(look, surface, transform, hit.at.t, beam);
    } else if (images && look.pattern) {
        point.material.diffuse = patternColor(look, surface, transform, hit.at.t, beam);
    }
    const Vec3 shading = objectNormal(look, surface, images);
    const bool smooth = shading != surface.normal;
    if (transform.isIdentity()) {
        point.position = surface.point;
        point.shadowOrigin = surface.shadowOrigin;
        point.geometricNormal = surface.normal;
        point.normal = shading;
        point.clearance = surface.error;
    } else {
        point.position = transform.toWorld().point(surface.point);
        point.shadowOrigin = surface.shadowOrigin == surface.point
                                 ? point.position
                                 : transform.toWorld().point(surface.shadowOrigin);
        point.geometricNormal = transform.normalToWorld(surface.normal);
        point.normal = smooth ? transform.normalToWorld(shading) : point.geometricNormal;
        point.clearance = transform.errorToWorld(surface.point, surface.error);
    }
    point.clearance = 2.0 * point.clearance + kCoincidence * largest(point.position);
    // Past all the crossings that count as one with this, lest one of them be met again.
    point.clearance += hit.spread * std::fabs(glm::dot(point.geometricNormal, rayDirection));

    if (glm::dot(point.geometricNormal, rayDirection) > 0.0) {
        point.geometricNormal = -point.geometricNormal;
        point.fromInside = true;
        // From behind, the interpolated surface bulges the other way: rays start on the triangle.
        point.shadowOrigin = point.position;
    }
    if (glm::dot(point.normal, point.geometricNormal) < 0.0) point.normal = -point.normal;
    return point;
}

}  // namespace rt
