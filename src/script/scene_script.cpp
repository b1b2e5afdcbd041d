#include "rt/script/scene_script.h"

#include "gr_library.h"
#include "lua_access.h"
#include "painted_images.h"
#include "sandbox.h"
#include "scene_builder.h"

#include <set>
#include <utility>

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

/// What the state and the builder know, each file once.
ScriptFiles filesOf(lua_State* L, const SceneBuilder& builder) {
    ScriptFiles files{filesRead(L), {filesAbsent(L).begin(), filesAbsent(L).end()}};
    const auto addOnce = [](std::vector<std::string>& to, const std::vector<std::string>& from) {
        std::set<std::string> known(to.begin(), to.end());
        for (const std::string& file : from) {
            if (known.insert(file).second) to.push_back(file);
        }
    };
    addOnce(files.read, builder.files().read);
    addOnce(files.absent, builder.files().absent);
    return files;
}

}  // namespace

ScriptResult runScript(const std::string& path, const ScriptSettings& settings,
                       Diagnostics& diagnostics, ScriptFiles* files) {
    const std::string folder = sceneFolderOf(path);
    SceneBuilder builder(path, folder, settings, diagnostics);
    ScriptFiles found;
    {
        LuaState lua({settings.memoryLimit, settings.timeLimit});
        openSandbox(lua, {folder, settings.trust, settings.printToStderr});
        openGr(lua, builder);
        lua.protect([&](lua_State* L) { setArguments(L, path, settings.arguments); });
        try {
            builder.readParameters();
            lua.runFile(path, settings.arguments);
            lua.protect([&](lua_State* L) { paintImages(L, builder); });
        } catch (Error& error) {
            error.attach(lua.traceback());
            if (files) *files = filesOf(lua.get(), builder);
            throw;
        }
        found = filesOf(lua.get(), builder);
    }
    if (files) *files = found;
    ScriptResult result = builder.finish();
    result.filesRead = std::move(found.read);
    return result;
}

}  // namespace rt
