// Which surfaces of the parts of combined solids lie along a ray, seen or not.
#pragma once

#include "rt/trace/render_scene.h"

#include <cstdint>

namespace rt {

/// Names the surfaces of parts that the ray crosses in `range`, its end included, and their order;
/// 0 where there are none. What is left of combined solids begins and ends where the outline or an
/// edge of a part does, or where surfaces of parts change places: between rays that cross the same
/// in the same order nothing of it is hidden but what may be hidden of the parts alone. A ray of
/// the world.
[[nodiscard]] std::uint64_t csgSignature(const RenderScene& scene, const Ray& ray, Interval range);

}  // namespace rt
