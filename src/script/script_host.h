// What belongs to one Lua state but lives in C++: reachable from every callback and coroutine.
#pragma once

#include "cage.h"
#include "lua_state.h"
#include "memory_budget.h"
#include "portable_random.h"
#include "watchdog.h"

#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace rt {

/// How a run ended: filled while the stack still stands.
struct RunFailure {
    bool known = false;
    std::string raised;  ///< the error value as text
    ExitCode code = ExitCode::kScene;
    std::string text;  ///< the message: with the script line
    std::string traceback;
    bool hasNoLine = false;  ///< no Lua function was running (any more), and the text names no file
};

struct TimeLimit {
    std::chrono::steady_clock::time_point deadline;
    std::string message;  ///< prepared, since the hook that raises it may not throw
    bool expired = false;
    SourceLocation where;  ///< the script line at that moment
};

struct ScriptHost {
    explicit ScriptHost(const LuaLimits& given) : limits(given), memory(given.memory) {}

    LuaLimits limits;
    MemoryBudget memory;
    lua_State* state = nullptr;
    void* context = nullptr;

    TimeLimit time;
    std::unique_ptr<Watchdog> watchdog;

    RunFailure failure;
    std::string raisedText;  ///< the last error that came from C++, and its exit code
    ExitCode raisedCode = ExitCode::kScene;
    std::vector<std::string>
        chunks;  ///< names of the files that were loaded, as messages show them

    Cage cage;
    bool mayFinalise = false;  ///< the script has given an object a finaliser
    std::string shownFolder;   ///< of the scene, as messages show it; empty or ending in a slash
    std::FILE* output = stdout;
    PortableRandom random;
    std::map<lua_CFunction, std::size_t> builtinIds;
    std::ptrdiff_t userdataOffset = 0;  ///< from the block of a userdata to its payload
    std::vector<std::string> loading;   ///< the modules that are being required, outermost first
    std::vector<std::string> filesRead;
    std::set<std::string> filesSeen;
    std::set<std::string> filesAbsent;
};

/// The host of a state, from any of its coroutines.
ScriptHost& hostOf(lua_State* state);
ScriptHost& hostOf(LuaState& state);

}  // namespace rt
