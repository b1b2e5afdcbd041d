#include "script_failure.h"

#include "lua_access.h"
#include "script_host.h"

#include "rt/core/diagnostics.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace rt {
namespace {

constexpr std::string_view kNoMemory = "not enough memory";
constexpr std::size_t kMostOfMessage = 4096;

/// The part of an error text that can matter to a message, which is much shorter.
std::string startOfText(lua_State* state, int index) {
    constexpr std::size_t kMost = std::size_t{64} << 10;
    std::size_t length = 0;
    const char* text = lua_tolstring(state, index, &length);
    return std::string(text, std::min(length, kMost));
}

/// A chunk name as Lua shows it in messages: at most LUA_IDSIZE - 1 bytes, cut at the front.
std::string shownName(const std::string& chunk) {
    if (chunk.size() < LUA_IDSIZE) return chunk;
    const std::string dots = "...";
    return dots + chunk.substr(chunk.size() - (LUA_IDSIZE - 1 - dots.size()));
}

bool startsWithLine(std::string_view text, std::string_view name) {
    if (!text.starts_with(name) || text.size() < name.size() + 2) return false;
    return text[name.size()] == ':' && text[name.size() + 1] >= '0' && text[name.size() + 1] <= '9';
}

/// The stack as text; level 0 is the handler.
std::string tracebackOf(lua_State* state) {
    if (lua_checkstack(state, LUA_MINSTACK) == 0) return "";
    const StackGuard guard(state);
    luaL_traceback(state, state, nullptr, 1);
    return toText(state, -1).value_or("");
}

/// Whether the text is that of the last C++ exception, perhaps with something put in front.
bool comesFromHost(const ScriptHost& host, const std::string& raised) {
    return !host.raisedText.empty() && raised.find(host.raisedText) != std::string::npos;
}

ExitCode codeOf(const ScriptHost& host, const std::string& raised) {
    if (comesFromHost(host, raised)) return host.raisedCode;
    const bool memory = host.memory.hasRefused() && raised.find(kNoMemory) != std::string::npos;
    return memory ? ExitCode::kLimit : ExitCode::kScene;
}

/// The location of a refusal, with the file's name in full.
SourceLocation refusalLine(const ScriptHost& host) {
    SourceLocation where = host.memory.refusalLine();
    for (const std::string& chunk : host.chunks) {
        if (shownName(chunk) == where.file) where.file = chunk;
    }
    return where;
}

/// The message: Lua's own words on memory name neither the limit nor, always, the line.
std::string messageFor(lua_State* state, const std::string& raised, ExitCode code) {
    const ScriptHost& host = hostOf(state);
    if (code == ExitCode::kLimit && !comesFromHost(host, raised)) {
        return refusalLine(host).prefix() + host.memory.message();
    }
    return located(state, raised);
}

RunFailure failureOf(lua_State* state, const std::string& raised) {
    const ExitCode code = codeOf(hostOf(state), raised);
    const std::string text = messageFor(state, raised, code);
    const bool isNamed = std::ranges::any_of(hostOf(state).chunks, [&](const std::string& chunk) {
        return text.starts_with(chunk + ":");
    });
    return {true, raised, code, text, "", !isNamed && callerLocation(state).file.empty()};
}

int noteFailureSafely(lua_State* state) {
    ScriptHost& host = hostOf(state);
    const std::string raised = describeError(state, 1);
    lua_settop(state, 1);
    if (host.failure.known && host.failure.raised == raised) return 1;
    RunFailure failure = failureOf(state, raised);
    failure.traceback = printable(tracebackOf(state));
    host.failure = std::move(failure);
    return 1;
}

/// Takes "scene.lua:12: ", the line of a loaded file, from the front of a message.
SourceLocation takeLocation(const ScriptHost& host, std::string& text) {
    for (const std::string& chunk : host.chunks) {
        if (!startsWithLine(text, chunk)) continue;
        const char* const digits = text.c_str() + chunk.size() + 1;
        char* end = nullptr;
        const long line = std::strtol(digits, &end, 10);
        if (std::strncmp(end, ": ", 2) != 0 || line > std::numeric_limits<int>::max()) continue;
        text.erase(0, static_cast<std::size_t>(end + 2 - text.c_str()));
        return {printable(chunk), static_cast<int>(line)};
    }
    return {};
}

/// `unknownLine` is where a failure that names no line happened.
[[noreturn]] void throwFailure(const ScriptHost& host, const SourceLocation& unknownLine) {
    if (host.time.expired) throw LimitError(host.time.message, host.time.where);
    std::string text = host.failure.text;
    SourceLocation where = takeLocation(host, text);
    if (where.file.empty()) where = unknownLine;
    text = printable(text, kMostOfMessage - std::min(kMostOfMessage, where.prefix().size()));
    switch (host.failure.code) {
        case ExitCode::kScene:
            throw SceneError(text, where);
        case ExitCode::kLimit:
            throw LimitError(text, where);
        case ExitCode::kOutput:
            throw OutputError(text);
        default:
            throw Error(host.failure.code, where, text);
    }
}

}  // namespace

std::string located(lua_State* state, const std::string& text) {
    const ScriptHost& host = hostOf(state);
    for (const std::string& chunk : host.chunks) {
        if (startsWithLine(text, chunk)) return text;
        const std::string shown = shownName(chunk);
        if (startsWithLine(text, shown)) return chunk + text.substr(shown.size());
    }
    const SourceLocation caller = callerLocation(state);
    // Chunks that a script names itself.
    const bool isHere = !caller.file.empty() && startsWithLine(text, caller.file);
    if (isHere || text.starts_with("[string \"")) return text;
    return caller.prefix() + text;
}

std::string describeError(lua_State* state, int index) {
    const int type = lua_type(state, index);
    if (type == LUA_TSTRING) return startOfText(state, index);
    if (auto number = toText(state, index)) return *number;
    ensureStack(state, 3);
    const StackGuard guard(state);
    lua_pushvalue(state, index);
    if (lua_getmetatable(state, -1) != 0) {
        pushField(state, -1, "__tostring");
        lua_replace(state, -2);
        lua_insert(state, -2);
        MemoryBudget& memory = hostOf(state).memory;
        const bool suspended = memory.isSuspended();
        memory.suspend(false);
        const int status = lua_pcall(state, 1, 1, 0);
        memory.suspend(suspended);
        if (status == LUA_OK && lua_type(state, -1) == LUA_TSTRING) {
            return startOfText(state, -1);
        }
    }
    return std::string("error object is a ") + lua_typename(state, type) + " value";
}

int noteFailure(lua_State* state) {
    // An error of the handler would call the handler: what it overdraws must not be one.
    const int results = detail::runGuarded(state, noteFailureSafely, detail::Overdraft::kLeave);
    return results >= 0 ? results : 1;
}

void callFromOutside(lua_State* state, int arguments, int results) {
    ScriptHost& host = hostOf(state);
    host.failure = {};
    host.raisedText.clear();
    host.memory.forgetRefusal();
    ensureStack(state, 4);
    const int function = lua_gettop(state) - arguments;
    lua_pushcfunction(state, noteFailure);
    lua_insert(state, function);
    const int status = lua_pcall(state, arguments, results, function);
    lua_remove(state, function);
    if (status == LUA_OK) return;
    SourceLocation unknownLine;
    if (!host.failure.known) {
        // Lua calls no handler when memory or the C stack is at its end.
        const std::string raised = toText(state, -1).value_or("error in error handling");
        host.failure = failureOf(state, raised);
    }
    // Where the stack had no line (it was unwound already), the script's name at least.
    if (host.failure.hasNoLine && !host.chunks.empty()) {
        unknownLine.file = printable(host.chunks.front());
    }
    lua_pop(state, 1);
    throwFailure(host, unknownLine);
}

}  // namespace rt
