// What a script may do: Lua's libraries, cut down to the scene's folder and to what gives the same
// result in every run. Documentation/scripting_cage.md is the description for users.
#pragma once

#include "cage.h"
#include "lua_state.h"

#include <set>
#include <string>
#include <vector>

namespace rt {

struct SandboxSettings {
    std::string sceneFolder = ".";  ///< what io.open, require, dofile and loadfile see
    bool trust = false;             ///< everything standard; fixed orders and seeds stay
    bool printToStderr = false;     ///< print, io.write and io.stdout write to stderr
};

/// Opens the libraries. Once for each state, before it runs anything.
void openSandbox(LuaState& state, const SandboxSettings& settings);

/// The folder of a script file, as SandboxSettings wants it; "-" gives the current folder.
std::string sceneFolderOf(const std::string& scriptPath);

/// The files that scripts read so far: the script, modules, io.open; resolved, each once.
const std::vector<std::string>& filesRead(lua_State* state);
/// Adds to filesRead: for assets.
void noteFileRead(lua_State* state, const std::string& resolvedPath);

/// The files that were looked for below the scene's folder and are not there.
const std::set<std::string>& filesAbsent(lua_State* state);
/// Cage::find, which remembers what is missing.
Resolved findFile(lua_State* state, const std::string& path);

}  // namespace rt
