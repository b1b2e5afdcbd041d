// Rays against the whole scene: the tree over the instances, then each shape in its own space.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <vector>

namespace rt {

/// The nearest crossing of one instance. `ray` is in world space.
bool intersectInstance(const RenderScene& scene, Index instance, const Ray& ray, Interval range,
                       PrimitiveHit& hit);

/// How far apart in t two computed crossings of one surface may lie.
double coincidenceInT(const Ray& ray, double t);

/// The nearest hit. Hits that coincide with it (kCoincidence) go to the lowest instance, and
/// `*shared` says whether there were any.
bool closestHit(const RenderScene& scene, const Ray& ray, Interval range, SceneHit& hit,
                bool* shared = nullptr);

/// Whether anything is hit at all.
bool anyHit(const RenderScene& scene, const Ray& ray, Interval range);

/// Whether one instance is hit in the range.
bool instanceBlocks(const RenderScene& scene, Index instance, const Ray& ray, Interval range);

/// Every crossing in the range, of any instance, in no particular order.
void allCrossings(const RenderScene& scene, const Ray& ray, Interval range,
                  std::vector<SceneHit>& crossings);

/// The nearest hit of a placed shape, and the unit geometric normal there, in world space.
bool intersectShape(const Shape& shape, const Transform& transform, const Ray& ray, Interval range,
                    PrimitiveHit& hit, Vec3& normal);

/// The object-space surface at a hit.
SurfacePoint surfaceAt(const RenderScene& scene, const SceneHit& hit, SurfaceDetail detail);

}  // namespace rt
