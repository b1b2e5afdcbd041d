#include "rt/script/scene_script.h"

#include "gr_library.h"
#include "sandbox.h"
#include "scene_builder.h"

#include <algorithm>

namespace rt {

ScriptResult runScript(const std::string& path, const ScriptSettings& settings,
                       Diagnostics& diagnostics) {
    const std::string folder = sceneFolderOf(path);
    SceneBuilder builder(path, folder, settings, diagnostics);
    std::vector<std::string> read;
    {
        LuaState lua({settings.memoryLimit, settings.timeLimit});
        openSandbox(lua, {folder, settings.trust, settings.printToStderr});
        openGr(lua, builder);
        lua.runFile(path, settings.arguments);
        read = filesRead(lua.get());
    }
    ScriptResult result = builder.finish();
    const auto isKnown = [&](const std::string& file) {
        return std::find(read.begin(), read.end(), file) != read.end();
    };
    for (std::string& file : result.filesRead) {
        if (!isKnown(file)) read.push_back(std::move(file));
    }
    result.filesRead = std::move(read);
    return result;
}

}  // namespace rt
