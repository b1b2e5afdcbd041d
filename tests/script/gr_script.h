// Runs a scene script in a folder of its own, and keeps everything that came of it.
#pragma once

#include "rt/script/scene_script.h"

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace rt::test {

/// A folder that is gone with its owner.
class SceneFolder {
  public:
    SceneFolder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "gr_script_XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp");
        path_ = std::filesystem::canonical(pattern);
    }
    ~SceneFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string write(const std::string& name, const std::string& text = "x") const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

  private:
    std::filesystem::path path_;
};

struct ScriptRun {
    std::optional<ScriptResult> result;
    std::string error;  ///< without the folder in front of scene.lua; "" for a run that went well
    ExitCode code = ExitCode::kDone;
    Diagnostics diagnostics;

    const SceneDesc& scene() const { return result.value().scene; }
    /// How many of the warnings shown hold `text`, which may start with "scene.lua:N: ".
    int warnings(const std::string& text) const {
        int count = 0;
        for (const Diagnostics::Warning& warning : diagnostics.shown()) {
            const std::string where = warning.where.prefix();
            const std::size_t start = where.rfind('/') + 1;
            if ((where.substr(start) + warning.message).find(text) != std::string::npos) ++count;
        }
        return count;
    }
};

inline ScriptRun runScene(const SceneFolder& folder, const std::string& text,
                          const ScriptSettings& settings = {}) {
    ScriptRun run;
    const std::string path = folder.write("scene.lua", text);
    try {
        run.result = runScript(path, settings, run.diagnostics);
    } catch (const Error& error) {
        run.code = error.code();
        run.error = error.what();
        const std::string front = folder.path().string() + "/";
        if (run.error.compare(0, front.size(), front) == 0) run.error.erase(0, front.size());
    }
    return run;
}

inline ScriptRun runScene(const std::string& text, const ScriptSettings& settings = {}) {
    return runScene(SceneFolder(), text, settings);
}

}  // namespace rt::test
