#include "scene_intersect.h"

#include "rt/accel/traverse.h"
#include "rt/core/numeric.h"
#include "rt/geometry/triangle.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

using MeshPointer = std::shared_ptr<const MeshShape>;

struct IntersectShape {
    const Ray& ray;
    Interval range;
    PrimitiveHit& hit;

    template <class Solid>
    bool operator()(const Solid& solid) const {
        return solid.intersect(ray, range, hit);
    }
    bool operator()(const MeshPointer& shape) const {
        return shape->tree.closestHit(ray, range, hit);
    }
};

struct MeetsShape {
    const Ray& ray;
    Interval range;

    template <class Solid>
    bool operator()(const Solid& solid) const {
        PrimitiveHit hit;
        return solid.intersect(ray, range, hit);
    }
    bool operator()(const MeshPointer& shape) const { return shape->tree.anyHit(ray, range); }
};

struct SurfaceOfShape {
    const PrimitiveHit& hit;
    SurfaceDetail detail;

    template <class Solid>
    SurfacePoint operator()(const Solid& solid) const {
        return solid.surface(hit, detail);
    }
    SurfacePoint operator()(const MeshPointer& shape) const {
        return triangleSurface(shape->mesh, hit.part, hit);
    }
};

/// Calls use(object-space ray) without copying the ray where the instance is not moved.
template <class Use>
bool inObjectSpace(const Transform& transform, const Ray& ray, Use&& use) {
    if (transform.isIdentity()) return use(ray);
    const Ray local = transform.toObject(ray);
    return use(local);
}

bool nearestOn(const Shape& shape, const Transform& transform, const Ray& ray, Interval range,
               PrimitiveHit& hit) {
    return inObjectSpace(transform, ray, [&](const Ray& local) {
        return std::visit(IntersectShape{local, range, hit}, shape);
    });
}

double largest(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Of the hits up to `tLast`, the one of the lowest instance.
void firstOfCoincident(const RenderScene& scene, const Ray& ray, Interval range, SceneHit& hit) {
    SceneHit lowest = hit;
    traverseClosest(scene.tree, ray, range, [&](Index item, Interval now) {
        PrimitiveHit found;
        if (item < lowest.instance && intersectInstance(scene, item, ray, now, found)) {
            lowest = {found, item};
        }
        return now.max;
    });
    hit = lowest;
}

}  // namespace

double coincidenceInT(const Ray& ray, double t) {
    const double speed = largest(ray.direction);
    return kCoincidence * (largest(ray.origin) / speed + std::fabs(t));
}

bool intersectInstance(const RenderScene& scene, Index instance, const Ray& ray, Interval range,
                       PrimitiveHit& hit) {
    const Instance& placed = scene.instances[instance];
    return nearestOn(scene.shapes[placed.shape], placed.transform, ray, range, hit);
}

bool intersectShape(const Shape& shape, const Transform& transform, const Ray& ray, Interval range,
                    PrimitiveHit& hit, Vec3& normal) {
    if (!nearestOn(shape, transform, ray, range, hit)) return false;
    normal = std::visit(SurfaceOfShape{hit, SurfaceDetail::kShape}, shape).normal;
    if (!transform.isIdentity()) normal = transform.normalToWorld(normal);
    return true;
}

bool closestHit(const RenderScene& scene, const Ray& ray, Interval range, SceneHit& hit,
                bool* shared) {
    SceneHit best;
    bool coincident = false;
    traverseClosest(scene.tree, ray, range, [&](Index item, Interval now) {
        PrimitiveHit found;
        if (!intersectInstance(scene, item, ray, now, found)) return now.max;
        const double slack = coincidenceInT(ray, found.t);
        if (best.instance != kNone && std::fabs(found.t - best.at.t) <= slack) coincident = true;
        const bool nearer = found.t < best.at.t || (found.t == best.at.t && item < best.instance);
        if (nearer) best = {found, item};
        return std::min(range.max, best.at.t + slack);
    });
    if (best.instance == kNone) return false;
    if (coincident) {
        const double slack = coincidenceInT(ray, best.at.t);
        firstOfCoincident(scene, ray, {range.min, std::min(range.max, best.at.t + slack)}, best);
        best.spread = slack;
    }
    if (shared) *shared = coincident;
    hit = best;
    return true;
}

bool instanceBlocks(const RenderScene& scene, Index item, const Ray& ray, Interval range) {
    const Instance& instance = scene.instances[item];
    return inObjectSpace(instance.transform, ray, [&](const Ray& local) {
        return std::visit(MeetsShape{local, range}, scene.shapes[instance.shape]);
    });
}

bool anyHit(const RenderScene& scene, const Ray& ray, Interval range) {
    return traverseAny(scene.tree, ray, range,
                       [&](Index item) { return instanceBlocks(scene, item, ray, range); });
}

void allCrossings(const RenderScene& scene, const Ray& ray, Interval range,
                  std::vector<SceneHit>& crossings) {
    traverseAny(scene.tree, ray, range, [&](Index item) {
        Interval rest = range;
        PrimitiveHit found;
        while (intersectInstance(scene, item, ray, rest, found)) {
            crossings.push_back({found, item});
            rest.min = found.t;
        }
        return false;
    });
}

SurfacePoint surfaceAt(const RenderScene& scene, const SceneHit& hit, SurfaceDetail detail) {
    const Instance& instance = scene.instances[hit.instance];
    return std::visit(SurfaceOfShape{hit.at, detail}, scene.shapes[instance.shape]);
}

}  // namespace rt
