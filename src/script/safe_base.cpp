// The libraries that need names taken out: os, debug, package, string and setmetatable.
#include "lua_access.h"
#include "sandbox_parts.h"
#include "script_host.h"

#include <string>

namespace rt {
namespace {

/// setmetatable, but for finalisers: they run where no time limit reaches them. No C++ object
/// lives here, since the wrapped function raises.
int setMetatable(lua_State* state) {
    if (lua_type(state, 2) == LUA_TTABLE) {
        lua_pushliteral(state, "__gc");
        const bool finalises = lua_rawget(state, 2) != LUA_TNIL;
        lua_pop(state, 1);
        ScriptHost& host = hostOf(state);
        if (finalises && !host.cage.trust()) {
            return luaL_error(state, "__gc is not available in the sandbox (see --trust)");
        }
        host.mayFinalise = host.mayFinalise || finalises;
    }
    return callWrapped(state);
}

/// pcall or xpcall. What a failure for want of memory has let go must be collected here: the
/// buffers of Lua's string functions give up without a try. No C++ object lives here.
int callAndCollect(lua_State* state) {
    const int results = callWrapped(state);
    if (hostOf(state).memory.takeCollectionDue()) lua_gc(state, LUA_GCCOLLECT, 0);
    return results;
}

void refuseFunctions(lua_State* state, const char* library,
                     std::initializer_list<const char*> names) {
    const StackGuard guard(state);
    pushLibrary(state, library);
    for (const char* name : names) {
        refuseFunction(state, -1, name, (std::string(library) + "." + name).c_str());
    }
}

}  // namespace

void openSafeBase(lua_State* state) {
    const StackGuard guard(state);
    lua_pushglobaltable(state);
    wrapFunction(state, -1, "setmetatable", setMetatable);
    wrapFunction(state, -1, "pcall", callAndCollect);
    wrapFunction(state, -1, "xpcall", callAndCollect);
    if (hostOf(state).cage.trust()) {
        pushLibrary(state, "debug");
        wrapFunction(state, -1, "setmetatable", setMetatable);
        return;
    }
    refuseFunctions(state, "os",
                    {"execute", "exit", "getenv", "remove", "rename", "setlocale", "tmpname"});
    refuseFunctions(state, "debug",
                    {"debug", "gethook", "getinfo", "getlocal", "getmetatable", "getregistry",
                     "getupvalue", "getuservalue", "sethook", "setlocal", "setmetatable",
                     "setupvalue", "setuservalue", "upvalueid", "upvaluejoin"});
    refuseFunctions(state, "package", {"loadlib", "searchpath"});
    refuseFunctions(state, "string", {"dump"});
    pushLibrary(state, "package");
    for (const char* name : {"searchers", "loaders"}) {
        lua_pushnil(state);
        assignField(state, -2, name);
    }
    pushText(state, "");
    assignField(state, -2, "cpath");
}

}  // namespace rt
