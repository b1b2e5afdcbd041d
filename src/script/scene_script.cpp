#include "rt/script/scene_script.h"

#include "gr_library.h"
#include "lua_access.h"
#include "sandbox.h"
#include "scene_builder.h"

#include <algorithm>

namespace rt {
namespace {

/// The global `arg`, as Lua's own interpreter sets it: the script at 0, its arguments from 1.
void setArguments(lua_State* L, const std::string& script,
                  const std::vector<std::string>& arguments) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    const int globals = lua_gettop(L);
    lua_newtable(L);
    pushText(L, script);
    lua_rawseti(L, -2, 0);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        pushText(L, arguments[i]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    assignField(L, globals, "arg");
}

}  // namespace

ScriptResult runScript(const std::string& path, const ScriptSettings& settings,
                       Diagnostics& diagnostics) {
    const std::string folder = sceneFolderOf(path);
    SceneBuilder builder(path, folder, settings, diagnostics);
    std::vector<std::string> read;
    {
        LuaState lua({settings.memoryLimit, settings.timeLimit});
        openSandbox(lua, {folder, settings.trust, settings.printToStderr});
        openGr(lua, builder);
        lua.protect([&](lua_State* L) { setArguments(L, path, settings.arguments); });
        try {
            lua.runFile(path, settings.arguments);
        } catch (Error& error) {
            error.attach(lua.traceback());
            throw;
        }
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
