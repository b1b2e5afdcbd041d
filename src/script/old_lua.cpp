// What Lua 5.0 and 5.1 had, for the scenes of their time. No C++ object lives in the callbacks,
// since they raise.
#include "lua_access.h"
#include "sandbox_parts.h"

namespace rt {
namespace {

int getLength(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_pushinteger(state, luaL_len(state, 1));
    return 1;
}

/// A table's length cannot be set any more; old scripts only announce what they fill in.
int setLength(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 1);
    return 1;
}

/// foreach(t, f): f(key, value) in the order of pairs, until it returns something. Upvalue: pairs.
int forEach(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_settop(state, 2);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);  // iterator 3, its state 4, key 5
    while (true) {
        lua_pushvalue(state, 3);
        lua_pushvalue(state, 4);
        lua_pushvalue(state, 5);
        lua_call(state, 2, 2);
        if (lua_isnil(state, 6)) return 0;
        lua_pushvalue(state, 6);
        lua_replace(state, 5);
        lua_pushvalue(state, 2);
        lua_insert(state, 6);
        lua_call(state, 2, 1);
        if (!lua_isnil(state, -1)) return 1;
        lua_settop(state, 5);
    }
}

/// foreachi(t, f): f(index, value) for 1..#t, until it returns something.
int forEachIndex(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_checktype(state, 2, LUA_TFUNCTION);
    const lua_Integer length = luaL_len(state, 1);
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_pushvalue(state, 2);
        lua_pushinteger(state, i);
        lua_geti(state, 1, i);
        lua_call(state, 2, 1);
        if (!lua_isnil(state, -1)) return 1;
        lua_pop(state, 1);
    }
    return 0;
}

/// The largest positive numeric key, 0 if there is none.
int maxNumber(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_Number most = 0;
    for (lua_pushnil(state); lua_next(state, 1) != 0;) {
        lua_pop(state, 1);
        if (lua_type(state, -1) != LUA_TNUMBER) continue;
        const lua_Number key = lua_tonumber(state, -1);
        if (key > most) most = key;
    }
    lua_pushnumber(state, most);
    const lua_Integer whole = lua_tointeger(state, -1);
    if (static_cast<lua_Number>(whole) == most) lua_pushinteger(state, whole);
    return 1;
}

/// to[newName] = from[name]
void alias(lua_State* state, const char* from, const char* name, const char* to,
           const char* newName) {
    const StackGuard guard(state);
    pushLibrary(state, to);
    pushLibrary(state, from);
    pushField(state, -1, name);
    assignField(state, -3, newName);
}

}  // namespace

void openOldLua(lua_State* state) {
    const StackGuard guard(state);
    alias(state, "table", "unpack", "_G", "unpack");
    alias(state, "_G", "load", "_G", "loadstring");
    alias(state, "string", "gmatch", "string", "gfind");
    alias(state, "math", "fmod", "math", "mod");
    pushLibrary(state, "table");
    assignFunction(state, -1, "getn", getLength);
    assignFunction(state, -1, "setn", setLength);
    assignFunction(state, -1, "foreachi", forEachIndex);
    assignFunction(state, -1, "maxn", maxNumber);
    pushLibrary(state, "pairs");
    assignFunction(state, -2, "foreach", forEach, 1);
}

}  // namespace rt
