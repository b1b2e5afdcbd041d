// A Lua state that dies with its owner, with a cap on memory and a limit on time.
#pragma once

#include "trampoline.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rt {

struct LuaLimits {
    std::size_t memory = std::size_t{2} << 30;  ///< bytes that Lua may hold
    double seconds = 0.0;                       ///< from the construction of the state; 0 = none
    /// What a script that does not yield to the limit (a long C function, a finaliser) gets on top
    /// of `seconds`, before the process is ended with exit code 4.
    double graceSeconds = 1.0;
};

struct ScriptHost;

/// Owns one lua_State. Every member throws rt::Error, never a Lua error.
class LuaState {
  public:
    explicit LuaState(const LuaLimits& limits = {});
    ~LuaState();
    LuaState(const LuaState&) = delete;
    LuaState& operator=(const LuaState&) = delete;

    lua_State* get() const;

    /// Runs `body` as a guarded callback, so that it may use Lua by the rule of trampoline.h.
    void protect(const std::function<void(lua_State*)>& body);

    /// Runs a script file from top to bottom; "-" is stdin. Refuses bytecode, all but regular
    /// files, and files of more than kMostScriptBytes; takes a byte order mark, CRLF, and a
    /// first line that starts with '#'. The script gets `arguments` as its `...`.
    /// Throws SceneError "scene.lua:12: message", LimitError for memory and time, or what a
    /// callback threw, by its exit code.
    void runFile(const std::string& path, const std::vector<std::string>& arguments = {});

    /// The same for text; `name` is what messages call it.
    void runText(const std::string& text, const std::string& name,
                 const std::vector<std::string>& arguments = {});

    /// The stack of the last error that a run ended with: "stack traceback:\n\t...".
    const std::string& traceback() const;

    /// A pointer for the callbacks of this state: see contextOf.
    void setContext(void* context);

    static constexpr std::size_t kMostScriptBytes = std::size_t{64} << 20;

  private:
    friend ScriptHost& hostOf(LuaState& state);
    std::unique_ptr<ScriptHost> host_;
};

/// The pointer that was given to setContext, from any coroutine of that state.
void* contextOf(lua_State* state);

}  // namespace rt
