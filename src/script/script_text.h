// From files to chunks.
#pragma once

#include <lua.hpp>

#include <cstddef>
#include <string>

namespace rt {

/// All of stdin; throws SceneError for more than `most` bytes.
std::string readStdin(std::size_t most);

/// The path without links and dots, or as given if there is none.
std::string resolvedPath(const std::string& path);

/// A name that a script gave, for messages: 'name', printable and not too long.
std::string quoted(const std::string& name);

/// Loads text as a chunk, in a callback, and leaves the function on the stack. Binary chunks are
/// refused without trust; a byte order mark and a first line with '#' are skipped. `name` is the
/// file as messages show it.
void loadChunk(lua_State* state, const std::string& text, const std::string& name);

}  // namespace rt
