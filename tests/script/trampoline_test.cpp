#include "script/trampoline.h"

#include "caged_script.h"

#include <doctest/doctest.h>

#include <new>

using namespace rt;
using namespace rt::test;

namespace {

/// Counts the objects of its kind that are alive.
struct Tracked {
    static inline int alive = 0;
    Tracked() { ++alive; }
    Tracked(const Tracked&) { ++alive; }
    ~Tracked() { --alive; }
    std::vector<std::string> bulk{std::string(1000, 'x')};
};

int throwScene(lua_State*) {
    const Tracked tracked;
    throw SceneError("radius must be > 0");
}
int throwLimit(lua_State*) {
    const Tracked tracked;
    throw LimitError("too many nodes (--max-nodes)");
}
int throwLocated(lua_State* state) {
    const Tracked tracked;
    throw SceneError("here", callerLocation(state));
}
int throwMemory(lua_State*) {
    const Tracked tracked;
    throw std::bad_alloc();
}
int throwStandard(lua_State*) {
    const Tracked tracked;
    throw std::logic_error("index 3 of 2");
}
int throwAnything(lua_State*) {
    const Tracked tracked;
    throw 7;
}
/// Fails in Lua, with C++ objects on both sides of the call.
int callArgument(lua_State* state) {
    const Tracked tracked;
    lua_settop(state, 1);
    protectedCall(state, 0, 1);
    const Tracked another;
    return 1;
}
/// Survives a failure of Lua.
int failureText(lua_State* state) {
    lua_settop(state, 1);
    try {
        protectedCall(state, 0, 0);
    } catch (const LuaFailure&) {
        const std::string text = failureMessage(state);
        pushText(state, text);
        lua_pushinteger(state, lua_gettop(state));
        return 2;
    }
    return 0;
}
/// Takes much more than the cap while an object is alive; then keeps it, or not.
int hoard(lua_State* state) {
    const Tracked tracked;
    const bool keep = lua_toboolean(state, 1) != 0;
    lua_newtable(state);
    for (int i = 1; i <= 200; ++i) {
        lua_pushlstring(state, std::string(100000, 'x').c_str(), 100000);
        lua_rawseti(state, -2, i);
    }
    return keep ? 1 : 0;
}
/// Raises from C, which it may as long as it has no object: the border must recover.
int raiseRaw(lua_State* state) {
    return luaL_error(state, "raw");
}
int pushLongText(lua_State* state) {
    const Tracked tracked;
    pushText(state, std::string(20000000, 'x'));
    return 1;
}
int fillStack(lua_State* state) {
    const Tracked tracked;
    while (true) {
        ensureStack(state, 1);
        lua_pushinteger(state, 1);
    }
}

template <int (*F)(lua_State*)>
void define(LuaState& state, const char* name) {
    state.protect([name](lua_State* inner) {
        lua_pushglobaltable(inner);
        assignFunction(inner, -1, name, guarded<F>);
    });
}

Outcome runWithCallbacks(const std::string& text, const LuaLimits& limits = {}) {
    return outcomeOf({}, limits, [&](LuaState& state) {
        define<throwScene>(state, "throwScene");
        define<throwLimit>(state, "throwLimit");
        define<throwLocated>(state, "throwLocated");
        define<throwMemory>(state, "throwMemory");
        define<throwStandard>(state, "throwStandard");
        define<throwAnything>(state, "throwAnything");
        define<callArgument>(state, "callArgument");
        define<failureText>(state, "failureText");
        define<hoard>(state, "hoard");
        define<raiseRaw>(state, "raiseRaw");
        define<pushLongText>(state, "pushLongText");
        define<fillStack>(state, "fillStack");
        state.runText(text, "scene.lua");
    });
}

TEST_CASE(
    "What a callback throws reaches the outside with its exit code and line, and no object "
    "survives it") {
    const struct {
        const char* script;
        int code;
        const char* message;
    } rows[] = {
        {"\nthrowScene()", 1, "scene.lua:2: radius must be > 0"},
        {"\nthrowLimit()", 4, "scene.lua:2: too many nodes (--max-nodes)"},
        {"\n\nthrowLocated()", 1, "scene.lua:3: here"},
        {"throwMemory()", 4,
         "scene.lua:1: not enough memory: the script needs more than 2048 MB "
         "(--script-memory)"},
        {"throwStandard()", 5, "scene.lua:1: internal error: index 3 of 2"},
        {"throwAnything()", 5, "scene.lua:1: internal error: unknown exception"},
        {"callArgument(throwLimit)", 4, "scene.lua:1: too many nodes (--max-nodes)"},
        {"callArgument(function() throwScene() end)", 1, "scene.lua:1: radius must be > 0"},
        {"callArgument(function() error({}) end)", 1, "scene.lua:1: error object is a table value"},
        {"\ncoroutine.wrap(function()\n throwLimit() end)()", 4,
         "scene.lua:2: scene.lua:3: too many nodes (--max-nodes)"},
        {"pcall(throwLimit) error('mine')", 1, "scene.lua:1: mine"},
        {"local ok, e = pcall(throwLimit) error(e, 0)", 4,
         "scene.lua:1: too many nodes (--max-nodes)"},
        {"local ok, e = pcall(throwLimit)\nerror('again: ' .. e)", 4,
         "scene.lua:2: again: scene.lua:1: too many nodes (--max-nodes)"},
        {"fillStack()", 1, "scene.lua:1: stack overflow"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runWithCallbacks(row.script);
        CHECK(outcome.code == row.code);
        CHECK(outcome.message == row.message);
        CHECK(Tracked::alive == 0);
    }
}

TEST_CASE("pcall in a script sees what a callback threw as a string with the line") {
    const Outcome outcome = runWithCallbacks(
        "tell(pcall(throwScene))\n"
        "tell(pcall(throwLimit))\n"
        "tell(type(select(2, pcall(throwStandard))))\n");
    CHECK(outcome.code == 0);
    CHECK(outcome.told ==
          "false scene.lua:1: radius must be > 0\n"
          "false scene.lua:2: too many nodes (--max-nodes)\n"
          "string\n");
    CHECK(Tracked::alive == 0);
}

TEST_CASE("An error value passes through C++ frames unchanged") {
    const Outcome outcome = runWithCallbacks(
        "local e = {}\n"
        "local ok, got = pcall(callArgument, function() error(e) end)\n"
        "tell(ok, got == e)\n"
        "tell(pcall(callArgument, function() error() end))\n"
        "tell(failureText(function() error('caught', 0) end))\n");
    CHECK(outcome.told == "false true\nfalse nil\ncaught 1\n");
}

TEST_CASE("A callback may overdraw the memory cap, and is called to account when it returns") {
    LuaLimits limits;
    limits.memory = 4 << 20;
    CHECK(runWithCallbacks("hoard(false) tell(#string.rep('x', 1000000))", limits).told ==
          "1000000\n");
    const Outcome kept = runWithCallbacks("\nlocal t = hoard(true) tell(#t)", limits);
    CHECK(kept.code == 4);
    CHECK(kept.message ==
          "scene.lua:2: not enough memory: the script needs more than 4 MB (--script-memory)");
    CHECK(kept.told.empty());
    const Outcome caught =
        runWithCallbacks("tell((pcall(hoard, true))) tell(#string.rep('x', 1000000))", limits);
    CHECK(caught.told == "false\n1000000\n");
    CHECK(runWithCallbacks("pushLongText()", limits).code == 4);
    CHECK(Tracked::alive == 0);
}

TEST_CASE("The memory cap holds in Lua code that a callback calls") {
    LuaLimits limits;
    limits.memory = 4 << 20;
    const char* const bomb = "function() local t = {} while true do t[#t + 1] = {} end end";
    const Outcome outcome = runWithCallbacks(std::string("callArgument(") + bomb + ")", limits);
    CHECK(outcome.code == 4);
    CHECK(Tracked::alive == 0);
}

TEST_CASE("The memory cap holds again after a callback that raised from C") {
    LuaLimits limits;
    limits.memory = 4 << 20;
    const Outcome outcome = runWithCallbacks(
        "pcall(raiseRaw) tell('raised') local t = {} while true do t[#t + 1] = {} end", limits);
    CHECK(outcome.told == "raised\n");
    CHECK(outcome.code == 4);
}

TEST_CASE("A failing run shows the stack down to the callback") {
    const Outcome outcome =
        runWithCallbacks("local function f()\n throwScene()\nend\ncallArgument(f)");
    CHECK(outcome.message == "scene.lua:2: radius must be > 0");
    CHECK(outcome.traceback.find("in function 'throwScene'") != std::string::npos);
    CHECK(outcome.traceback.find("scene.lua:4: in main chunk") != std::string::npos);
}

TEST_CASE("protect runs outside of scripts, too, and throws what its body threw") {
    LuaState state;
    CHECK_THROWS_AS(state.protect([](lua_State*) { throw LimitError("x"); }), LimitError);
    CHECK_THROWS_AS(state.protect([](lua_State*) { throw OutputError("x"); }), OutputError);
    CHECK_THROWS_AS(state.protect([](lua_State* inner) { luaL_error(inner, "x"); }), SceneError);
    CHECK(lua_gettop(state.get()) == 0);
}

}  // namespace
