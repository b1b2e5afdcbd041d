// From Lua error values to messages and exceptions.
#pragma once

#include <lua.hpp>

#include <string>

namespace rt {

/// `text` with the line of the nearest Lua function in front, unless it starts with a line of a
/// loaded file already. Names that Lua has shortened are given in full.
std::string located(lua_State* state, const std::string& text);

/// An error value as text: error({}) gives "error object is a table value".
std::string describeError(lua_State* state, int index);

/// Message handler for lua_pcall: notes message, exit code and stack; passes the value on.
int noteFailure(lua_State* state);

/// lua_pcall for code outside of every callback. On an error throws the exception that fits.
void callFromOutside(lua_State* state, int arguments, int results);

}  // namespace rt
