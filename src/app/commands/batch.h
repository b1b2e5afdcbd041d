// One run of the program over its scenes.
#pragma once

#include "dependency_file.h"
#include "image_render.h"
#include "output_names.h"
#include "run_console.h"
#include "scene_renderer.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

class Batch {
  public:
    /// Both must outlive it.
    Batch(const Options& options, RunConsole& console);

    /// From anew each time, but that files which were loaded need not be loaded again. Returns the
    /// exit code: the first failure's.
    int run();

    /// What came of the renders so far stays; these files are loaded again.
    void forget(const std::vector<std::string>& files);

  private:
    /// What came of a scene.
    struct Ended {
        std::string name;
        int code = 0;
        std::size_t images = 0;

        std::string line() const;
    };

    int attempt(const std::string& scene);
    int failed(const Error& error, const Diagnostics& diagnostics);
    void runScene(const std::string& path, std::int64_t frame, Diagnostics& diagnostics);
    ScriptResult ranScript(const std::string& path, std::int64_t frame, Diagnostics& diagnostics);
    void checkOutputs(const ScriptResult& script, const std::vector<std::string>& outputs) const;
    void sumUp();
    void report(const Diagnostics& diagnostics);

    const Options& options_;
    RunConsole& console_;
    SceneRenderer renderer_;
    ImageRender image_;
    CheckpointKeeper::Time scriptBegan_;
    std::optional<OutputNames> names_;
    std::vector<RenderStats> stats_;
    std::vector<DependencyRule> rules_;
    std::vector<Ended> ended_;
    bool begun_ = false;
    bool left_ = false;  ///< the run was left before its end
};

}  // namespace rt
