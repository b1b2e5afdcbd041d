// The parts that openSandbox puts together. Each is called once, as part of a callback, when the
// standard libraries are open.
#pragma once

#include <lua.hpp>

namespace rt {

/// pairs and next in an order that depends on the keys alone.
void openFixedOrder(lua_State* state);
/// table.sort without the clock that Lua's own mixes in.
void openFixedSort(lua_State* state);
/// math.random and math.randomseed with a generator of our own.
void openFixedRandom(lua_State* state);
/// tostring, print and string.format that show serial numbers in place of addresses.
void openStableText(lua_State* state);
/// require, dofile, loadfile and load: text only, from the scene's folder.
void openSafeLoading(lua_State* state);
/// io: reading only, from the scene's folder.
void openSafeIo(lua_State* state, bool printToStderr);
/// os, debug, package, setmetatable and string.dump without what leaves the process.
void openSafeBase(lua_State* state);
/// Names that scripts of Lua 5.0 and 5.1 use.
void openOldLua(lua_State* state);

/// table[name] = a function that raises "label is not available in the sandbox (see --trust)".
void refuseFunction(lua_State* state, int table, const char* name, const char* label);

/// Pushes the global library table `name`.
void pushLibrary(lua_State* state, const char* name);

/// Replaces table[name] by `function`, whose first upvalue is what was there.
void wrapFunction(lua_State* state, int table, const char* name, lua_CFunction function);

/// Runs the wrapped function in the place of its wrapper: with the same arguments and name.
int callWrapped(lua_State* state);

}  // namespace rt
