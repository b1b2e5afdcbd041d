// Reading and writing Lua values where no Lua error may be raised. None of these functions calls
// a metamethod or converts a value in place; where they fail they throw C++ exceptions.
#pragma once

#include "trampoline.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt {

/// Room for `slots` more values; throws SceneError "stack overflow".
void ensureStack(lua_State* state, int slots);

/// A number, or a string that reads as one ("3", "0x10"), as Lua's arithmetic takes them.
std::optional<double> toNumber(lua_State* state, int index);
/// An integer, or a number or a string with an integral value.
std::optional<lua_Integer> toInteger(lua_State* state, int index);
/// A string, or a number written as Lua writes it.
std::optional<std::string> toText(lua_State* state, int index);

/// "number", "nil", "no value", or for a userdata or table the `__name` of its metatable.
std::string typeNameOf(lua_State* state, int index);

/// What `tostring` shows without metamethods: strings as they are, "table: 0x0000001a".
std::string displayText(lua_State* state, int index);

/// The number of a table, function, userdata or coroutine among those of its type, in the order of
/// creation; 0 for built-in functions and everything else.
std::uint64_t objectSerial(lua_State* state, int index);

/// Pushes a string; throws LimitError when it would pass the memory cap.
void pushText(lua_State* state, std::string_view text);

/// Pushes table[name] without metamethods; false where it is nil (which is pushed all the same).
bool pushField(lua_State* state, int table, std::string_view name);
/// table[name] = the value on top, without metamethods; pops it.
void assignField(lua_State* state, int table, std::string_view name);

/// Pushes `function` as a closure over the `upvalues` values on top and stores it as table[name].
void assignFunction(lua_State* state, int table, std::string_view name, lua_CFunction function,
                    int upvalues = 0);

/// Restores the height of the stack when it dies.
class StackGuard {
  public:
    explicit StackGuard(lua_State* state) : state_(state), top_(lua_gettop(state)) {}
    ~StackGuard() { lua_settop(state_, top_); }
    StackGuard(const StackGuard&) = delete;
    StackGuard& operator=(const StackGuard&) = delete;

  private:
    lua_State* state_;
    int top_;
};

}  // namespace rt
