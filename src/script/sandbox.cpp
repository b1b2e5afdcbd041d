#include "sandbox.h"

#include "lua_access.h"
#include "sandbox_parts.h"
#include "script_host.h"
#include "script_text.h"

#include <string>

namespace rt {
namespace {

/// Raises; the upvalue is the name to show. No C++ object lives here.
int refuse(lua_State* state) {
    return luaL_error(state, "%s is not available in the sandbox (see --trust)",
                      lua_tostring(state, lua_upvalueindex(1)));
}

int openLibraries(lua_State* state) {
    luaL_openlibs(state);
    return 0;
}

}  // namespace

void refuseFunction(lua_State* state, int table, const char* name, const char* label) {
    table = lua_absindex(state, table);
    pushText(state, label);
    assignFunction(state, table, name, refuse, 1);
}

void pushLibrary(lua_State* state, const char* name) {
    ensureStack(state, 3);
    lua_pushglobaltable(state);
    pushField(state, -1, name);
    lua_remove(state, -2);
}

void wrapFunction(lua_State* state, int table, const char* name, lua_CFunction function) {
    table = lua_absindex(state, table);
    pushField(state, table, name);
    assignFunction(state, table, name, function, 1);
}

int callWrapped(lua_State* state) {
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

void openSandbox(LuaState& state, const SandboxSettings& settings) {
    ScriptHost& host = hostOf(state);
    host.cage = Cage(settings.sceneFolder, settings.trust);
    host.shownFolder = settings.sceneFolder == "." ? "" : settings.sceneFolder + "/";
    host.output = settings.printToStderr ? stderr : stdout;
    state.protect([&](lua_State* inner) {
        lua_pushcfunction(inner, openLibraries);
        protectedCall(inner, 0, 0);
        openFixedOrder(inner);
        openFixedSort(inner);
        openFixedRandom(inner);
        openStableText(inner);
        openSafeLoading(inner);
        openSafeIo(inner, settings.printToStderr);
        openSafeBase(inner);
        openOldLua(inner);
    });
}

std::string sceneFolderOf(const std::string& scriptPath) {
    const std::size_t slash = scriptPath.find_last_of('/');
    if (scriptPath == "-" || slash == std::string::npos) return ".";
    return slash == 0 ? "/" : scriptPath.substr(0, slash);
}

const std::vector<std::string>& filesRead(lua_State* state) {
    return hostOf(state).filesRead;
}

void noteFileRead(lua_State* state, const std::string& resolvedPath) {
    ScriptHost& host = hostOf(state);
    if (host.filesSeen.insert(resolvedPath).second) host.filesRead.push_back(resolvedPath);
}

const std::set<std::string>& filesAbsent(lua_State* state) {
    return hostOf(state).filesAbsent;
}

Resolved findFile(lua_State* state, const std::string& path) {
    ScriptHost& host = hostOf(state);
    const Resolved found = host.cage.find(path);
    if (found.kind == Resolved::Kind::kMissing && !path.empty() &&
        path.find('\0') == std::string::npos) {
        const bool absolute = path.starts_with('/');
        host.filesAbsent.insert(absolute ? path : host.cage.folder() + "/" + path);
    }
    return found;
}

}  // namespace rt
