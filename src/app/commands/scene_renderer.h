// script -> description -> compiled scene -> tiles -> film: the one way to a picture that all
// commands share.
#pragma once

#include "picture_part.h"
#include "rt/app/options.h"
#include "rt/app/stats.h"
#include "rt/compile/asset_cache.h"
#include "rt/core/diagnostics.h"
#include "rt/output/image_writer.h"
#include "rt/output/pixel_image.h"
#include "rt/render/renderer.h"
#include "rt/script/scene_script.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rt {

/// A description's render, compiled, and what it was told.
struct PreparedScene {
    RenderOptions options;  ///< of the command line over the script's
    RenderScene scene;
    double buildSeconds = 0.0;
};

/// Finished pixels, and what is known about them; `stats.output` and `stats.warnings` are the
/// caller's to fill.
struct Picture {
    PixelImage image;
    ImageSettings settings;
    RenderStats stats;
    std::optional<PicturePart> part;  ///< of a shard, instead of an image; without the scene's hash
    bool cancelled = false;
    std::uint64_t nonFinite = 0;  ///< samples; they count as black
};

/// One pixel of a picture, and what its samples were taken with.
struct PixelTrace {
    PixelPlace place;
    PixelState state;
    TraceSettings settings;
    std::shared_ptr<const PhotonMap> photons;  ///< that the settings name
    bool cancelled = false;
};

/// Who is told how a render goes; see RenderJob. None of them need be there.
struct RenderListener {
    std::function<void(double share)> onProgress;
    std::function<void(double error)> onEstimate;
    std::function<void(RenderSnapshot snapshot)> onSnapshot;
    const std::atomic<bool>* wantsSnapshot = nullptr;
    RenderLog* log = nullptr;
    std::function<void()> onCheckpoint;
    double checkpointEvery = 0.0;
};

/// What a file says about the picture.
ImageMetadata metadataOf(const RenderStats& stats);

/// Warnings of one scene, as lines to show.
std::vector<std::string> warningLines(const Diagnostics& diagnostics);

/// Renders scenes with the options of one run. Keeps assets from one scene to the next.
class SceneRenderer {
  public:
    /// `options` must outlive it.
    explicit SceneRenderer(const Options& options);

    int threads() const { return threads_; }

    /// `files`, if not null, is filled whatever happens.
    ScriptResult runScript(const std::string& path, std::int64_t frame, Diagnostics& diagnostics,
                           ScriptFiles* files = nullptr);

    /// What can be known about an output before there is anything to write.
    void checkOutput(const std::string& output, const RenderDesc& render) const;

    PreparedScene prepare(const SceneDesc& desc, std::size_t index, Diagnostics& diagnostics);

    Picture render(const SceneDesc& desc, std::size_t index, const PreparedScene& prepared,
                   const RenderListener& listener, Diagnostics& diagnostics) const;

    /// The pixel that the options name, as the picture has it. UsageError where there is none, or
    /// where time decides.
    PixelTrace renderPixel(const PreparedScene& prepared, const RenderListener& listener) const;

    /// What was loaded from a file is loaded again.
    void forget(const std::string& file) { assets_.forgetFile(file); }

  private:
    RenderScene compiled(const SceneDesc& desc, std::size_t index, const RenderOptions& options,
                         Diagnostics& diagnostics);
    void checkShard(const RenderDesc& render) const;
    void refuseTooManyPixels(const RenderDesc& render) const;
    RenderJob jobFor(const RenderScene& scene, const RenderOptions& options,
                     const RenderListener& listener) const;
    std::vector<ImagePlane> planesBeside(const RenderOutcome& outcome,
                                         const PreparedScene& prepared, const Tile& area) const;
    PartTile partTileOf(const RenderOutcome& outcome, const PreparedScene& prepared,
                        const Tile& place) const;
    PicturePart partOf(const RenderOutcome& outcome, const PreparedScene& prepared,
                       const RenderStats& stats) const;
    Tile areaOf(const RenderScene& scene) const;
    RenderStats statsOf(const RenderScene& scene, const RenderOptions& options,
                        const RenderOutcome& outcome) const;

    const Options& options_;
    int threads_;
    const TraceKernel& kernel_;
    AssetCache assets_;
};

}  // namespace rt
