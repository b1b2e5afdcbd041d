// What a compiled scene uses, and what its render leaves out: for --explain and --stats.
#pragma once

#include "rt/app/stats.h"
#include "rt/trace/render_scene.h"

#include <string>
#include <vector>

namespace rt {

std::vector<std::string> featuresOf(const RenderScene& scene);
std::vector<SkippedFeature> skippedBy(const RenderScene& scene);

struct SceneCounts {
    std::uint64_t triangles = 0;   ///< of meshes, each counted once however often it is placed
    std::uint64_t primitives = 0;  ///< hand-written solids, counted as placed
};
SceneCounts countsOf(const RenderScene& scene);

/// Lines for --explain.
std::string explanation(const RenderScene& scene);

}  // namespace rt
