#include "trampoline.h"

#include "lua_access.h"
#include "script_failure.h"
#include "script_host.h"

#include <exception>
#include <new>

namespace rt {
namespace {

/// Key of the registry slot in which the value of a LuaFailure waits.
const char kFailureSlot = 0;

/// Leaves the text of an error on the stack, and its exit code with the host.
int pushRaised(lua_State* state, ExitCode code, const char* what) noexcept {
    lua_settop(state, 0);
    try {
        ScriptHost& host = hostOf(state);
        host.raisedText = located(state, what);
        host.raisedCode = code;
        lua_pushlstring(state, host.raisedText.data(), host.raisedText.size());
    } catch (...) {
        lua_pushstring(state, "not enough memory");
    }
    return -1;
}

int pushMemoryError(lua_State* state) noexcept {
    try {
        return pushRaised(state, ExitCode::kLimit, hostOf(state).memory.message().c_str());
    } catch (...) {
        return pushRaised(state, ExitCode::kLimit, "not enough memory");
    }
}

int pushInternal(lua_State* state, const char* what) noexcept {
    try {
        return pushRaised(state, ExitCode::kInternal,
                          ("internal error: " + std::string(what)).c_str());
    } catch (...) {
        return pushRaised(state, ExitCode::kInternal, "internal error");
    }
}

int pushFailure(lua_State* state) noexcept {
    lua_settop(state, 0);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kFailureSlot);
    return -1;
}

/// Calls, and turns what was thrown into a value on the stack; nothing of C++ is left then.
int callAndCatch(lua_State* state, int (*function)(lua_State*)) noexcept {
    try {
        return function(state);
    } catch (const LuaFailure&) {
        return pushFailure(state);
    } catch (const Error& error) {
        return pushRaised(state, error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return pushMemoryError(state);
    } catch (const std::exception& error) {
        return pushInternal(state, error.what());
    } catch (...) {
        return pushInternal(state, "unknown exception");
    }
}

/// Whether the memory that a callback took beyond the cap is still in use when it returns.
bool staysOverdrawn(lua_State* state, int results) {
    const MemoryBudget& memory = hostOf(state).memory;
    if (!memory.isOverdrawn()) return false;
    if (results < lua_gettop(state)) {
        lua_rotate(state, 1, results);
        lua_settop(state, results);
    }
    lua_gc(state, LUA_GCCOLLECT, 0);
    return memory.isOverdrawn();
}

/// While script finalisers exist, no collection may run among C++ objects.
bool pauseCollector(lua_State* state, const ScriptHost& host) {
    if (!host.mayFinalise || lua_gc(state, LUA_GCISRUNNING, 0) == 0) return false;
    lua_gc(state, LUA_GCSTOP, 0);
    return true;
}

}  // namespace

int detail::runGuarded(lua_State* state, int (*function)(lua_State*),
                       Overdraft overdraft) noexcept {
    ScriptHost& host = hostOf(state);
    // A finaliser runs inside the allocation of another callback (with the collector off), whose
    // suspension must outlive it. Any other callback starts from Lua code: a suspension found
    // there was left behind by an error that jumped, and ends here.
    const bool inFinaliser = host.memory.isSuspended() && lua_gc(state, LUA_GCISRUNNING, 0) == 0;
    const bool paused = pauseCollector(state, host);
    host.memory.suspend(true);
    const int results = callAndCatch(state, function);
    if (paused) lua_gc(state, LUA_GCRESTART, 0);
    if (inFinaliser) return results;
    const bool raises =
        overdraft == Overdraft::kRaise && results >= 0 && staysOverdrawn(state, results);
    const int ended = raises ? pushMemoryError(state) : results;
    host.memory.suspend(false);
    return ended;
}

void protectedCall(lua_State* state, int arguments, int results) {
    ScriptHost& host = hostOf(state);
    const bool suspended = host.memory.isSuspended();
    const int function = lua_gettop(state) - arguments;
    ensureStack(state, 1);
    lua_pushcfunction(state, noteFailure);
    lua_insert(state, function);
    host.memory.suspend(false);
    const int status = lua_pcall(state, arguments, results, function);
    host.memory.suspend(suspended);
    lua_remove(state, function);
    if (status == LUA_OK) return;
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kFailureSlot);
    throw LuaFailure();
}

std::string failureMessage(lua_State* state) {
    ensureStack(state, 1);
    const StackGuard guard(state);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kFailureSlot);
    return describeError(state, -1);
}

SourceLocation callerLocation(lua_State* state) {
    lua_Debug frame{};
    for (int level = 0; lua_getstack(state, level, &frame) != 0; ++level) {
        lua_getinfo(state, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        const bool named = *frame.source == '@' || *frame.source == '=';
        return {named ? frame.source + 1 : frame.short_src, frame.currentline};
    }
    return {};
}

}  // namespace rt
