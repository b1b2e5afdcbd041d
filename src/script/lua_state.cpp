#include "lua_state.h"

#include "lua_access.h"
#include "sandbox.h"
#include "script_failure.h"
#include "script_host.h"
#include "script_text.h"

#include <stdio_ext.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>

namespace rt {
namespace {

/// Instructions between two looks at the clock: some ten microseconds.
constexpr int kInstructionsPerLook = 1000;

/// Three years: more is no limit, and clocks could not count it.
constexpr double kForever = 1e8;

/// Time is over: raises, and from here on at every instruction, so that no pcall outlives it.
void onCount(lua_State* state, lua_Debug*) {
    TimeLimit& time = hostOf(state).time;
    if (!time.expired) {
        if (std::chrono::steady_clock::now() < time.deadline) return;
        time.expired = true;
        try {
            time.where = callerLocation(state);
        } catch (const std::bad_alloc&) {
            time.where.line = 0;
        }
    }
    lua_sethook(state, onCount, LUA_MASKCOUNT, 1);
    lua_pushstring(state, time.message.c_str());
    lua_error(state);
}

std::string secondsText(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", seconds);
    return text;
}

void startClock(ScriptHost& host) {
    const LuaLimits& limits = host.limits;
    host.time.message =
        "time limit: the script took more than " + secondsText(limits.seconds) + " (--script-time)";
    host.time.deadline = std::chrono::steady_clock::now() +
                         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                             std::chrono::duration<double>(limits.seconds));
    lua_sethook(host.state, onCount, LUA_MASKCOUNT, kInstructionsPerLook);
    host.watchdog = std::make_unique<Watchdog>(limits.seconds + limits.graceSeconds,
                                               "error: " + host.time.message + "\n");
}

/// Where the payload of a userdata lies in its block: the first one is created here, by hand.
int measureUserdata(lua_State* state) {
    ScriptHost& host = hostOf(state);
    void* budget = nullptr;
    const lua_Alloc allocator = lua_getallocf(state, &budget);
    struct Spy {
        MemoryBudget* memory;
        void* block;
        static void* allocate(void* spy, void* old, std::size_t oldSize, std::size_t newSize) {
            Spy& self = *static_cast<Spy*>(spy);
            const bool isUserdata = old == nullptr && oldSize == LUA_TUSERDATA;
            void* block = MemoryBudget::allocate(self.memory, old, oldSize, newSize);
            if (isUserdata) self.block = block;
            return block;
        }
    } spy{&host.memory, nullptr};
    lua_setallocf(state, Spy::allocate, &spy);
    const void* payload = lua_newuserdata(state, 1);
    lua_setallocf(state, allocator, budget);
    host.userdataOffset = static_cast<const char*>(payload) - static_cast<const char*>(spy.block);
    lua_pop(state, 1);
    return 0;
}

/// Keeps SIGPIPE from the thread while scripts print; a write to a closed pipe then just fails.
class PipeSignalBlock {
  public:
    PipeSignalBlock() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        wasPending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~PipeSignalBlock() {
        const timespec now{};
        if (!wasPending_) sigtimedwait(&pipe_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    PipeSignalBlock(const PipeSignalBlock&) = delete;
    PipeSignalBlock& operator=(const PipeSignalBlock&) = delete;

  private:
    sigset_t pipe_;
    sigset_t before_;
    bool wasPending_ = false;
};

/// An error outside of every protected call is a fault of this program, but for lack of memory.
int panic(lua_State* state) {
    const char* const text = lua_type(state, -1) == LUA_TSTRING ? lua_tostring(state, -1) : "";
    if (std::strcmp(text, "not enough memory") == 0) {
        endProcess(ExitCode::kLimit, "error: the system has no memory left for the script\n");
    }
    endProcess(ExitCode::kInternal, "error: internal error: unprotected error in Lua\n");
}

int runBody(lua_State* state) {
    const auto* body =
        static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(state, 1));
    lua_settop(state, 0);
    (*body)(state);
    return 0;
}

}  // namespace

ScriptHost& hostOf(lua_State* state) {
    return **static_cast<ScriptHost**>(lua_getextraspace(state));
}

ScriptHost& hostOf(LuaState& state) {
    return *state.host_;
}

void* contextOf(lua_State* state) {
    return hostOf(state).context;
}

LuaState::LuaState(const LuaLimits& limits) : host_(std::make_unique<ScriptHost>(limits)) {
    host_->state = lua_newstate(MemoryBudget::allocate, &host_->memory);
    if (host_->state == nullptr) throw LimitError(host_->memory.message());
    *static_cast<ScriptHost**>(lua_getextraspace(host_->state)) = host_.get();
    host_->memory.watch(host_->state);
    lua_atpanic(host_->state, panic);
    try {
        lua_pushcfunction(host_->state, guarded<measureUserdata>);
        callFromOutside(host_->state, 0, 0);
        if (limits.seconds > 0.0 && limits.seconds < kForever) startClock(*host_);
    } catch (...) {
        lua_close(host_->state);
        throw;
    }
}

LuaState::~LuaState() {
    // Letting go of much memory takes time that is not the script's; its finalisers are.
    if (!host_->mayFinalise) host_->watchdog.reset();
    host_->memory.watch(nullptr);
    lua_close(host_->state);
}

lua_State* LuaState::get() const {
    return host_->state;
}

void LuaState::setContext(void* context) {
    host_->context = context;
}

const std::string& LuaState::traceback() const {
    return host_->failure.traceback;
}

void LuaState::protect(const std::function<void(lua_State*)>& body) {
    lua_State* state = host_->state;
    ensureStack(state, 4);
    lua_pushcfunction(state, guarded<runBody>);
    lua_pushlightuserdata(state, const_cast<std::function<void(lua_State*)>*>(&body));
    callFromOutside(state, 1, 0);
}

void LuaState::runFile(const std::string& path, const std::vector<std::string>& arguments) {
    const bool isStdin = path == "-";
    const std::string text =
        isStdin ? readStdin(kMostScriptBytes) : readRegularFile(path, path, kMostScriptBytes);
    if (!isStdin) noteFileRead(host_->state, resolvedPath(path));
    runText(text, isStdin ? "stdin" : path, arguments);
}

void LuaState::runText(const std::string& text, const std::string& name,
                       const std::vector<std::string>& arguments) {
    lua_State* state = host_->state;
    const PipeSignalBlock block;
    const StackGuard guard(state);
    protect([&](lua_State* inner) {
        ensureStack(inner, static_cast<int>(arguments.size()) + 4);
        loadChunk(inner, text, name);
        for (const std::string& argument : arguments) pushText(inner, argument);
        protectedCall(inner, static_cast<int>(arguments.size()), 0);
    });
    // What cannot be written now must not be tried again when the process ends.
    if (std::fflush(host_->output) != 0) __fpurge(host_->output);
    if (host_->time.expired) throw LimitError(host_->time.message, host_->time.where);
}

}  // namespace rt
