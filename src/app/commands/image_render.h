// One image of a scene: compiled, rendered, saved, with its checkpoint and its snapshots.
#pragma once

#include "checkpoint_keeper.h"
#include "run_console.h"
#include "scene_hash.h"
#include "scene_renderer.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A signal came while an image was rendered or saved; it is saved, in part or whole.
struct Interrupted {};

/// A render was left because a file changed, or somebody stopped it, and the program goes on.
struct Left {};

/// What a script asked for, one image of it.
struct ImageRequest {
    const ScriptResult& script;
    std::size_t index;  ///< of the render
    std::int64_t frame;
    const std::string& output;
    CheckpointKeeper::Time scriptBegan;
};

/// The files that an output is written to: the image and its planes, or a shard.
std::vector<std::string> filesOf(const Options& options, const std::string& output);

class ImageRender {
  public:
    /// All three must outlive it.
    ImageRender(const Options& options, SceneRenderer& renderer, RunConsole& console)
        : options_(options), renderer_(renderer), console_(console) {}

    /// Adds what came of it to `stats`, if an image was saved. Throws Interrupted and Left after
    /// that, and Error.
    void run(const ImageRequest& request, Diagnostics& diagnostics,
             std::vector<RenderStats>& stats);

  private:
    void showPixel(const ImageRequest& request, const PreparedScene& prepared);
    void keepCheckpoint(const ImageRequest& request, const PreparedScene& prepared,
                        std::function<std::vector<Trait>()> traits);
    RenderListener listener();
    Picture rendered(const ImageRequest& request, const PreparedScene& prepared,
                     Diagnostics& diagnostics);
    void save(const Picture& picture, const std::string& output);
    void savePart(const Picture& picture, const std::string& name);
    void saveSnapshot(const Picture& picture, const std::string& name);
    void interrupted(const std::string& what);

    const Options& options_;
    SceneRenderer& renderer_;
    RunConsole& console_;
    std::optional<CheckpointKeeper> checkpoint_;
};

}  // namespace rt
