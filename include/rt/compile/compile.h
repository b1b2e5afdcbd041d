// What a script described -> what the renderer reads.
#pragma once

#include "rt/compile/asset_cache.h"
#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"
#include "rt/trace/render_scene.h"

#include <cstddef>
#include <cstdint>

namespace rt {

struct CompileSettings {
    int width = 0;  ///< 0: as the script says
    int height = 0;
    int threads = 1;
    double smoothAngleDegrees = 40.0;  ///< for meshes that do not say
    bool flipV = false;
    bool caustics =
        false;          ///< light comes through refracting and off reflecting objects by photons
    bool srgb = false;  ///< images hold sRGB values, to be made linear
    std::uint64_t maxInstances = 10'000'000;
    std::uint64_t maxPixels = std::uint64_t{1} << 27;  ///< of an image that a scene reads
};

/// Compiles one render of the description: the node graph flattened to instances that share their
/// shapes, assets loaded as far as this render needs them, the tree built. Meshes and images stay
/// in `assets` for the renders that follow. Throws SceneError with the node's line for a geometry
/// without an appearance, LimitError, before memory is used, for more than `maxInstances`.
RenderScene compileScene(const SceneDesc& scene, std::size_t render,
                         const CompileSettings& settings, AssetCache& assets,
                         Diagnostics& diagnostics);

}  // namespace rt
