// Rays against the whole scene: the tree over the instances, then each shape in its own space.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <cstdint>
#include <functional>
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

/// Whether one instance is hit in the range.
bool instanceBlocks(const RenderScene& scene, Index instance, const Ray& ray, Interval range);

/// Whether anything is hit at all.
bool anyHit(const RenderScene& scene, const Ray& ray, Interval range);

enum class Obstacle : std::uint8_t { kNothing, kTransparent, kOpaque };

/// What blocked the last ray to a light most likely blocks the next one too.
class LastBlocker {
  public:
    /// Whether anything is hit at all.
    bool anyHit(const RenderScene& scene, const Ray& ray, Interval range);
    /// Whether anything opaque is hit; if not, whether anything is.
    Obstacle obstacle(const RenderScene& scene, const Ray& ray, Interval range);

  private:
    /// After so many rays that nothing blocked the light has come out.
    static constexpr int kForgotten = 4;

    template <class IsTransparent>
    Obstacle find(const RenderScene& scene, const Ray& ray, Interval range,
                  const IsTransparent& isTransparent);

    Index instance_ = kNone;
    int passed_ = 0;
};

/// Every crossing in the range, of any instance, in no particular order.
void allCrossings(const RenderScene& scene, const Ray& ray, Interval range,
                  std::vector<SceneHit>& crossings);

/// Calls use(instance) for those whose boxes the ray may meet in the range, in no particular order,
/// and, by rounding, for some that it passes by.
void forEachMet(const RenderScene& scene, const Ray& ray, Interval range,
                const std::function<void(Index)>& use);

/// The nearest hit of a placed shape, and the unit geometric normal there, in world space.
bool intersectShape(const Shape& shape, const Transform& transform, const Ray& ray, Interval range,
                    PrimitiveHit& hit, Vec3& normal);

/// What the surface at a hit does with light.
inline const Look& lookAt(const RenderScene& scene, const SceneHit& hit) {
    return scene.looks[scene.instances[hit.instance].look + hit.at.leaf];
}

/// The object-space surface at a hit.
SurfacePoint surfaceAt(const RenderScene& scene, const SceneHit& hit, SurfaceDetail detail);

}  // namespace rt
