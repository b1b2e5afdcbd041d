// require, dofile, loadfile and load: text chunks from the scene's folder.
#include "lua_access.h"
#include "sandbox.h"
#include "sandbox_parts.h"
#include "script_host.h"
#include "script_text.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace rt {
namespace {

const char* const kModulePath = "?.lua;?/init.lua";

std::string textArgument(lua_State* state, const char* function) {
    if (lua_type(state, 1) == LUA_TSTRING) return *toText(state, 1);
    throw SceneError(std::string("bad argument #1 to '") + function + "' (string expected, got " +
                     typeNameOf(state, 1) + ")");
}

/// Pushes the chunk in a file that the cage has found. `name` is the file as the script wrote it.
void pushFileChunk(lua_State* state, const std::string& resolved, const std::string& name) {
    ScriptHost& host = hostOf(state);
    const std::string shown = name.starts_with('/') ? name : host.shownFolder + name;
    const std::string text = readRegularFile(resolved, shown, LuaState::kMostScriptBytes);
    noteFileRead(state, resolved);
    loadChunk(state, text, shown);
}

std::string outsideMessage(const std::string& name) {
    return quoted(name) + " is outside of the scene's folder (see --trust)";
}

/// The file names that a module may have, by the templates of package.path.
std::vector<std::string> moduleFiles(lua_State* state, std::string module) {
    if (module.find('/') == std::string::npos) std::replace(module.begin(), module.end(), '.', '/');
    const StackGuard guard(state);
    pushLibrary(state, "package");
    std::string path = kModulePath;
    if (lua_istable(state, -1) && pushField(state, -1, "path")) {
        path = toText(state, -1).value_or(path);
    }
    std::vector<std::string> files;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find(';', start), path.size());
        std::string file;
        for (const char c : path.substr(start, end - start)) {
            file += c == '?' ? module : std::string(1, c);
        }
        if (!file.empty()) files.push_back(file);
        start = end + 1;
    }
    return files;
}

/// Pushes a function that gives a module its value, and the name of its file: from
/// package.preload or a file. Otherwise pushes nothing and gives the list of what was tried.
std::string pushModuleLoader(lua_State* state, const std::string& module) {
    lua_getfield(state, LUA_REGISTRYINDEX, LUA_PRELOAD_TABLE);
    if (pushField(state, -1, module)) {
        lua_remove(state, -2);
        pushText(state, ":preload:");
        return "";
    }
    lua_pop(state, 2);
    std::string tried = "\n\tno field package.preload[" + quoted(module) + "]";
    for (const std::string& file : moduleFiles(state, module)) {
        const Resolved found = findFile(state, file);
        if (found.kind == Resolved::Kind::kFound) {
            pushFileChunk(state, found.path, file);
            pushText(state, file);
            return "";
        }
        const bool outside = found.kind == Resolved::Kind::kOutside;
        tried += outside ? "\n\t" + outsideMessage(file) : "\n\tno file " + quoted(file);
    }
    return tried;
}

/// Marks a module as being loaded; refuses to load it while it is.
class LoadingMark {
  public:
    LoadingMark(std::vector<std::string>& loading, const std::string& module) : loading_(loading) {
        const auto first = std::find(loading_.begin(), loading_.end(), module);
        if (first != loading_.end()) {
            std::string loop;
            for (auto name = first; name != loading_.end(); ++name) loop += *name + " -> ";
            throw SceneError("loop: modules require each other: " + loop + module);
        }
        loading_.push_back(module);
    }
    ~LoadingMark() { loading_.pop_back(); }
    LoadingMark(const LoadingMark&) = delete;
    LoadingMark& operator=(const LoadingMark&) = delete;

  private:
    std::vector<std::string>& loading_;
};

/// With trust, what is not in the scene's folder is left to Lua. Upvalue 1 is Lua's require.
int requireElsewhere(lua_State* state, const std::string& module, const std::string& tried) {
    if (!hostOf(state).cage.trust()) {
        throw SceneError("module " + quoted(module) + " not found:" + tried);
    }
    lua_pushvalue(state, lua_upvalueindex(1));
    pushText(state, module);
    protectedCall(state, 1, 1);
    return 1;
}

int require(lua_State* state) {
    const std::string module = textArgument(state, "require");
    lua_settop(state, 1);
    ensureStack(state, 10);
    lua_getfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    if (pushField(state, 2, module) && lua_toboolean(state, -1) != 0) return 1;
    lua_settop(state, 2);
    const LoadingMark mark(hostOf(state).loading, module);
    const std::string tried = pushModuleLoader(state, module);
    if (!tried.empty()) return requireElsewhere(state, module, tried);
    pushText(state, module);
    lua_insert(state, -2);
    protectedCall(state, 2, 1);
    if (!lua_isnil(state, -1)) assignField(state, 2, module);
    lua_settop(state, 2);
    if (pushField(state, 2, module)) return 1;
    lua_pushboolean(state, 1);
    assignField(state, 2, module);
    lua_pushboolean(state, 1);
    return 1;
}

/// The chunk of dofile: missing files are errors.
int pushDofileChunk(lua_State* state) {
    const std::string name = textArgument(state, "dofile");
    const Resolved found = findFile(state, name);
    if (found.kind == Resolved::Kind::kOutside) throw SceneError("dofile: " + outsideMessage(name));
    if (found.kind == Resolved::Kind::kMissing) {
        throw SceneError("dofile: cannot open " + quoted(name) +
                         ": no such file in the scene's folder");
    }
    pushFileChunk(state, found.path, name);
    return 1;
}

/// No C++ object lives here: the chunk may raise.
int doFile(lua_State* state) {
    lua_settop(state, 1);
    lua_pushcfunction(state, guarded<pushDofileChunk>);
    lua_insert(state, 1);
    lua_call(state, 1, 1);
    lua_call(state, 0, LUA_MULTRET);
    return lua_gettop(state);
}

/// loadfile(name [, mode [, env]]): the function, or nil and what is wrong.
int loadFile(lua_State* state) {
    const std::string name = textArgument(state, "loadfile");
    const bool hasEnvironment = lua_gettop(state) >= 3;
    const Resolved found = findFile(state, name);
    if (found.kind == Resolved::Kind::kOutside) {
        throw SceneError("loadfile: " + outsideMessage(name));
    }
    try {
        if (found.kind == Resolved::Kind::kMissing) {
            throw SceneError("cannot open " + quoted(name));
        }
        pushFileChunk(state, found.path, name);
    } catch (const SceneError& error) {
        lua_settop(state, 3);
        lua_pushnil(state);
        pushText(state, error.what());
        return 2;
    }
    if (hasEnvironment) {
        lua_pushvalue(state, 3);
        lua_setupvalue(state, -2, 1);
    }
    return 1;
}

/// load, for text only. No C++ object lives here, since the wrapped function raises.
int load(lua_State* state) {
    if (lua_gettop(state) < 3) lua_settop(state, 3);
    const char* mode = luaL_optstring(state, 3, "bt");
    if (std::strchr(mode, 't') != nullptr) {
        lua_pushliteral(state, "t");
    } else {
        lua_pushliteral(state, "");
    }
    lua_replace(state, 3);
    return callWrapped(state);
}

}  // namespace

void openSafeLoading(lua_State* state) {
    const StackGuard guard(state);
    const bool trust = hostOf(state).cage.trust();
    lua_pushglobaltable(state);
    pushField(state, -1, "require");
    assignFunction(state, -2, "require", guarded<require>, 1);
    assignFunction(state, -1, "dofile", doFile);
    assignFunction(state, -1, "loadfile", guarded<loadFile>);
    if (!trust) wrapFunction(state, -1, "load", load);
    pushLibrary(state, "package");
    std::string path = kModulePath;
    if (trust && pushField(state, -1, "path")) {
        path += ";" + toText(state, -1).value_or("");
        lua_pop(state, 1);
    }
    pushText(state, path);
    assignField(state, -2, "path");
}

}  // namespace rt
