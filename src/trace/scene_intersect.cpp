#include "scene_intersect.h"

#include "rt/accel/traverse.h"
#include "rt/core/numeric.h"
#include "with_shape.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {
namespace {

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
    bool operator()(const CsgPointer& shape) const { return intersectCsg(*shape, ray, range, hit); }
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
    bool operator()(const CsgPointer& shape) const {
        PrimitiveHit hit;
        return intersectCsg(*shape, ray, range, hit);
    }
};

[[gnu::always_inline]] inline bool nearestOn(const Shape& shape, const Transform& transform,
                                             const Ray& ray, Interval range, PrimitiveHit& hit) {
    return inObjectSpace(transform, ray, [&](const Ray& local) {
        return withShape(shape, IntersectShape{local, range, hit});
    });
}

/// Whether an instance may be met in `range`. `slabs` is the ray in the world.
[[gnu::always_inline]] inline bool meetsBox(const RenderScene& scene, Index item, const Ray& ray,
                                            const SlabRay& slabs, Interval range) {
    const Instance& placed = scene.instances[item];
    if (!placed.boxed) return true;
    const PaddedBox& box = scene.shapeBoxes[placed.shape];
    if (placed.transform.isIdentity()) return slabs.meets(box, range);
    SlabRay local;
    return !local.make(placed.transform, ray) || local.meets(box, range);
}

/// The same through the tree; `slabs` is the ray in the world, if it has boxes in double precision.
template <class Test>
[[gnu::noinline]] void visitTreeNearFirst(const RenderScene& scene, const Ray& ray,
                                          const SlabRay* slabs, Interval range, const Test& test) {
    traverseClosest(scene.tree, ray, range, [&](Index item, Interval now) {
        if (slabs && !meetsBox(scene, item, ray, *slabs, now)) return now.max;
        return test(item, now);
    });
}

template <class Test>
[[gnu::noinline]] bool visitTreeUntil(const RenderScene& scene, const Ray& ray,
                                      const SlabRay* slabs, Interval range, const Test& test) {
    return traverseAny(scene.tree, ray, range, [&](Index item) {
        if (slabs && !meetsBox(scene, item, ray, *slabs, range)) return false;
        return test(item);
    });
}

/// The same for what has no box; out of the way of scenes that have no such thing.
template <class Test>
[[gnu::noinline]] double nearestUnbounded(const RenderScene& scene, Interval range,
                                          const Test& test) {
    for (const Index item : scene.unbounded) range.max = std::min(range.max, test(item, range));
    return range.max;
}

template <class Test>
[[gnu::noinline]] bool anyUnbounded(const RenderScene& scene, const Test& test) {
    for (const Index item : scene.unbounded) {
        if (test(item)) return true;
    }
    return false;
}

/// Bit i: the ray meets the box of instance i, at `entries[i]` first.
[[gnu::always_inline]] inline unsigned metOfFew(const RenderScene& scene, const SlabRay& slabs,
                                                Interval range, double* entries) {
    const QuadTester tester(slabs);
    const BoxQuad* quads = scene.quads.data();
    const auto count = static_cast<unsigned>(scene.quads.size());
    unsigned met = 0;
    for (unsigned i = 0; i < count; ++i) {
        met |= tester.meet(quads[i], range, entries + 4 * i) << 4 * i;
    }
    return met;
}

/// Calls test(item, Interval now) -> double for the instances whose boxes meet the ray, near ones
/// first, with the range that is left; it returns the range's new max.
template <class Test>
[[gnu::always_inline]] inline void visitNearFirst(const RenderScene& scene, const Ray& ray,
                                                  Interval range, const Test& test) {
    if (!scene.unbounded.empty()) [[unlikely]]
        range.max = nearestUnbounded(scene, range, test);
    SlabRay slabs;
    const bool made = slabs.make(ray);
    if (!made || scene.quads.empty()) {
        return visitTreeNearFirst(scene, ray, made ? &slabs : nullptr, range, test);
    }
    double entries[kFewBoxes];
    unsigned waiting = metOfFew(scene, slabs, range, entries);
    while (waiting != 0) {
        int nearest = std::countr_zero(waiting);
        for (unsigned rest = waiting & (waiting - 1); rest != 0; rest &= rest - 1) {
            const int next = std::countr_zero(rest);
            if (entries[next] < entries[nearest]) nearest = next;
        }
        if (!(entries[nearest] <= range.max)) return;
        waiting &= ~(1u << nearest);
        range.max = std::min(range.max, test(static_cast<Index>(nearest), range));
    }
}

/// Calls test(item) -> bool for the instances whose boxes meet the ray in `range`, until it returns
/// true; returns whether it did.
template <class Test>
[[gnu::always_inline]] inline bool visitUntil(const RenderScene& scene, const Ray& ray,
                                              Interval range, const Test& test) {
    if (!scene.unbounded.empty() && anyUnbounded(scene, test)) [[unlikely]]
        return true;
    SlabRay slabs;
    const bool made = slabs.make(ray);
    if (!made || scene.quads.empty()) {
        return visitTreeUntil(scene, ray, made ? &slabs : nullptr, range, test);
    }
    double entries[kFewBoxes];
    for (unsigned met = metOfFew(scene, slabs, range, entries); met != 0; met &= met - 1) {
        if (test(static_cast<Index>(std::countr_zero(met)))) return true;
    }
    return false;
}

double largest(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Of the hits up to `tLast`, the one of the lowest instance.
void firstOfCoincident(const RenderScene& scene, const Ray& ray, Interval range, SceneHit& hit) {
    SceneHit lowest = hit;
    visitNearFirst(scene, ray, range, [&](Index item, Interval now) {
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
    normal = withShape(shape, SurfaceOfShape{hit, SurfaceDetail::kShape}).normal;
    if (!transform.isIdentity()) normal = transform.normalToWorld(normal);
    return true;
}

bool closestHit(const RenderScene& scene, const Ray& ray, Interval range, SceneHit& hit,
                bool* shared) {
    SceneHit best;
    bool coincident = false;
    double last = range.max;  // of what coincides with the best
    visitNearFirst(scene, ray, range, [&](Index item, Interval now) {
        PrimitiveHit found;
        const Instance& placed = scene.instances[item];
        if (!nearestOn(scene.shapes[placed.shape], placed.transform, ray, now, found)) {
            return now.max;
        }
        if (best.instance == kNone || found.t < best.at.t) {
            const double reach = found.t + coincidenceInT(ray, found.t);
            coincident = best.instance != kNone && best.at.t < reach;
            best = {found, item};
            last = std::min(range.max, reach);
        } else {
            coincident = true;
            if (found.t == best.at.t && item < best.instance) best = {found, item};
        }
        return last;
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
        return withShape(scene.shapes[instance.shape], MeetsShape{local, range});
    });
}

bool anyHit(const RenderScene& scene, const Ray& ray, Interval range) {
    return visitUntil(scene, ray, range,
                      [&](Index item) { return instanceBlocks(scene, item, ray, range); });
}

template <class IsTransparent>
Obstacle LastBlocker::find(const RenderScene& scene, const Ray& ray, Interval range,
                           const IsTransparent& isTransparent) {
    if (instance_ != kNone && instanceBlocks(scene, instance_, ray, range)) {
        passed_ = 0;
        return Obstacle::kOpaque;
    }
    bool transparent = false;
    Index blocker = kNone;
    visitUntil(scene, ray, range, [&](Index item) {
        if (item == instance_) return false;
        const bool through = isTransparent(item);
        if (through && transparent) return false;
        if (!instanceBlocks(scene, item, ray, range)) return false;
        transparent = transparent || through;
        if (!through) blocker = item;
        return !through;
    });
    if (blocker != kNone) {
        instance_ = blocker;
        passed_ = 0;
        return Obstacle::kOpaque;
    }
    if (++passed_ == kForgotten) instance_ = kNone;
    return transparent ? Obstacle::kTransparent : Obstacle::kNothing;
}

bool LastBlocker::anyHit(const RenderScene& scene, const Ray& ray, Interval range) {
    return find(scene, ray, range, [](Index) { return false; }) == Obstacle::kOpaque;
}

Obstacle LastBlocker::obstacle(const RenderScene& scene, const Ray& ray, Interval range) {
    return find(scene, ray, range,
                [&](Index item) { return scene.looks[scene.instances[item].look].refracts; });
}

void allCrossings(const RenderScene& scene, const Ray& ray, Interval range,
                  std::vector<SceneHit>& crossings) {
    forEachMet(scene, ray, range, [&](Index item) {
        Interval rest = range;
        PrimitiveHit found;
        while (intersectInstance(scene, item, ray, rest, found)) {
            crossings.push_back({found, item});
            rest.min = found.t;
        }
    });
}

void forEachMet(const RenderScene& scene, const Ray& ray, Interval range,
                const std::function<void(Index)>& use) {
    visitUntil(scene, ray, range, [&](Index item) {
        use(item);
        return false;
    });
}

SurfacePoint surfaceAt(const RenderScene& scene, const SceneHit& hit, SurfaceDetail detail) {
    const Instance& instance = scene.instances[hit.instance];
    return withShape(scene.shapes[instance.shape], SurfaceOfShape{hit.at, detail});
}

}  // namespace rt
