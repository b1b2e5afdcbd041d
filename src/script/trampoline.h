// The one border between C++ and Lua, which is C and raises its errors with longjmp.
//
// A callback is `int f(lua_State*)`, registered as `guarded<f>`. It may throw anything; the border
// catches it, lets every C++ object die, and only then raises the Lua error.
//
// The rule inside a callback: while an object with a destructor is alive, nothing may raise a Lua
// error. What allocates does not raise there: the memory cap is suspended inside a callback and
// looked at again when it returns. What still raises, and is therefore forbidden, is
//   luaL_check*, luaL_opt*, luaL_arg*, luaL_error, lua_error, lua_call, lua_yield,
// and everything that may run a metamethod or reject its operand:
//   lua_gettable, lua_settable, lua_getfield, lua_setfield, lua_geti, lua_seti, lua_getglobal,
//   lua_setglobal, lua_arith, lua_compare, lua_concat (but for strings), lua_len, luaL_len,
//   luaL_tolstring, lua_rawset with a nil or NaN key, lua_next with a key that is not there.
// They may be used on tables without a metatable, as the registry is. Everything else (lua_push*,
// lua_newtable, lua_rawget*, lua_rawset*, lua_to*, luaL_ref, ...) is safe, given stack space:
// 20 slots at entry, more through ensureStack. Use lua_access.h for the rest.
#pragma once

#include <lua.hpp>

#include "rt/core/error.h"

#include <string>

namespace rt {

/// A Lua error on its way through C++ frames. The error value waits in the state; a callback that
/// lets the exception pass raises that value again, unchanged.
class LuaFailure {};

/// Calls the function that lies below its `arguments` on the stack, as lua_call does, with the
/// memory cap in force. Throws LuaFailure; the function and its arguments are popped either way.
void protectedCall(lua_State* state, int arguments, int results);

/// The error value of the last LuaFailure, as a message.
std::string failureMessage(lua_State* state);

/// The line of the nearest Lua function on the stack; empty outside of all of them.
SourceLocation callerLocation(lua_State* state);

namespace detail {
/// What becomes of memory beyond the cap when a callback returns.
enum class Overdraft { kRaise, kLeave };
/// Runs the callback; where it threw, the error value is on the stack and the result is negative.
int runGuarded(lua_State* state, int (*function)(lua_State*),
               Overdraft overdraft = Overdraft::kRaise) noexcept;
}  // namespace detail

/// The lua_CFunction of the callback F. What F throws becomes a Lua error: an rt::Error the string
/// "file:line: what()" (the line of the nearest Lua function, unless what() names a script line
/// already), whose exit code is found again when the string leaves the state; bad_alloc a
/// LimitError; anything else an internal error.
template <int (*F)(lua_State*)>
int guarded(lua_State* state) {
    const int results = detail::runGuarded(state, F);
    return results >= 0 ? results : lua_error(state);
}

}  // namespace rt
