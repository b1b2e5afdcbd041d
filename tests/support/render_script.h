// Renders a script's text the way the program does, without its files and messages.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/render/renderer.h"
#include "rt/scene/scene_desc.h"
#include "rt/script/scene_script.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rt::test {

/// A folder that is gone, with all in it, at the end of its scope.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }
    /// Writes a text file and gives its path.
    std::string write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Color> pixels;
    TraceCounts counts;
    std::optional<double> errorEstimate;
    bool converged = false;

    const Color& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

struct PictureSettings {
    RenderOptions options;  ///< win over the script's own
    int threads = 1;
    std::string kernel;      ///< "": the fastest
    std::size_t render = 0;  ///< which gr.render of the script
    std::string folder;      ///< where the script is put; "": a temporary one
    /// Changes the job before it is rendered; need not be there.
    std::function<void(RenderJob& job)> adjust;
};

/// Runs, compiles and renders `script`. Throws what the program would report.
Picture renderScript(const std::string& script, const PictureSettings& settings = {});

/// What running `script` describes, and the warnings it gave.
struct Described {
    SceneDesc scene;
    Diagnostics diagnostics;
};
Described describe(const std::string& script);

}  // namespace rt::test
