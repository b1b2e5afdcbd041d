#include "gr_library.h"

#include "call_table.h"
#include "lua_access.h"
#include "object_types.h"

#include "rt/core/diagnostics.h"

#include <stdexcept>

namespace rt {

namespace {

SceneBuilder& builderOf(lua_State* L) {
    return *static_cast<SceneBuilder*>(contextOf(L));
}

struct PushResult {
    lua_State* L;

    int operator()(std::monostate) const { return 0; }
    int operator()(ObjectRef object) const {
        pushObject(L, object);
        return 1;
    }
    int operator()(bool value) const {
        lua_pushboolean(L, value ? 1 : 0);
        return 1;
    }
    int operator()(double value) const {
        lua_pushnumber(L, value);
        return 1;
    }
    int operator()(lua_Integer value) const {
        lua_pushinteger(L, value);
        return 1;
    }
    int operator()(const std::string& value) const {
        pushText(L, value);
        return 1;
    }
};

/// Every function of gr: its row is the closure's first upvalue.
int dispatch(lua_State* L) {
    const auto& row = *static_cast<const CallRow*>(lua_touserdata(L, lua_upvalueindex(1)));
    SceneBuilder& builder = builderOf(L);
    builder.enterCall(row.name, callerLocation(L));
    ensureStack(L, LUA_MINSTACK);
    try {
        return std::visit(PushResult{L}, runCall(row, Arguments(L, builder), builder));
    } catch (const std::invalid_argument& refused) {
        builder.fail(refused.what());
    }
}

int unknownName(lua_State* L) {
    const std::string name = printable(toText(L, 2).value_or(typeNameOf(L, 2)), 64);
    throw SceneError("gr has no function '" + name + "'" + didYouMean(name, callNames()),
                     callerLocation(L));
}

void lockLibrary(lua_State* L, int library) {
    lua_newtable(L);
    const int metatable = lua_gettop(L);
    assignFunction(L, metatable, "__index", guarded<unknownName>);
    pushText(L, "gr");
    assignField(L, metatable, "__metatable");
    lua_setmetatable(L, library);
}

void registerLibrary(lua_State* L) {
    lua_newtable(L);
    const int library = lua_gettop(L);
    for (const CallRow& row : callTable()) {
        lua_pushlightuserdata(L, const_cast<CallRow*>(&row));
        assignFunction(L, library, row.name, guarded<dispatch>, 1);
    }
    const ScriptSettings& settings = builderOf(L).settings();
    lua_pushinteger(L, settings.frame);
    assignField(L, library, "frame");
    lua_pushnumber(L, settings.time);
    assignField(L, library, "time");
    registerObjectTypes(L, library);
    lockLibrary(L, library);
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_pushvalue(L, library);
    assignField(L, lua_gettop(L) - 1, "gr");
}

}  // namespace

void openGr(LuaState& state, SceneBuilder& builder) {
    state.setContext(&builder);
    state.protect(registerLibrary);
}

}  // namespace rt
