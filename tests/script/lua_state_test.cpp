#include "script/lua_state.h"

#include "caged_script.h"

#include <sys/mman.h>

#include <doctest/doctest.h>

#include <chrono>

using namespace rt;
using namespace rt::test;

namespace {

constexpr std::size_t kMega = std::size_t{1} << 20;

LuaLimits memoryLimit(std::size_t bytes) {
    LuaLimits limits;
    limits.memory = bytes;
    return limits;
}

LuaLimits timeLimit(double seconds, double grace) {
    LuaLimits limits;
    limits.seconds = seconds;
    limits.graceSeconds = grace;
    return limits;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_CASE("Scripts that cannot be loaded are refused by name and line") {
    const CageFolder folder;
    const struct {
        std::string text, message;
    } rows[] = {
        {"x = 1\nlocal = 2", ":2: <name> expected near '='"},
        {"x = (1", "near <eof>"},
        {"\x1bLua\x53", ": binary chunks are refused"},
        {"\xef\xbb\xbf\x1bLua", ": binary chunks are refused"},
        {"#!/bin/lua\n\x1bLua", "near '<\\27>'"},
        {std::string("x = 1\0\0", 7), ":1: "},
        {"\xff\xfe\x01", ":1: "},
        {"local x = " + std::string(1 << 20, '('), "C levels (limit is 200)"},
        {"goto nowhere", "no visible label"},
        {"x = '" + std::string(1, '\x07') + "\n'", "unfinished string"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.message);
        folder.write("bad.lua", row.text);
        const Outcome outcome = runFileIn(folder, "bad.lua");
        CHECK(outcome.code == 1);
        CHECK(outcome.message.starts_with(folder.file("bad.lua") + ":"));
        CHECK(contains(outcome.message, row.message));
        CHECK(outcome.message.size() <= 4096);
    }
}

TEST_CASE("Big scripts load or fail within the limits") {
    std::string locals;
    for (int i = 0; i < 300; ++i) locals += "local a" + std::to_string(i) + "\n";
    CHECK(contains(runCaged(locals).message, "too many local variables"));
    std::string constants = "local t = {";
    for (int i = 0; i < 300000; ++i) constants += std::to_string(i) + ".5,";
    CHECK(runCaged(constants + "} tell(#t)").told == "300000\n");
    const Outcome tooBig = runCaged(constants + "}", memoryLimit(2 * kMega));
    CHECK(tooBig.code == 4);
    CHECK(tooBig.message ==
          "scene.lua: not enough memory: the script needs more than 2 MB (--script-memory)");
    const CageFolder folder;
    folder.write("big.lua", std::string(LuaState::kMostScriptBytes + 1, ' '));
    const Outcome outcome = runFileIn(folder, "big.lua");
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.message, "too large"));
}

TEST_CASE("A byte order mark, CRLF and a first line for the shell leave the line numbers right") {
    const CageFolder folder;
    for (const char* text : {"\xef\xbb\xbf\nlocal x = nil\nx()", "a = 1\r\nb = 2\r\nb()\r\n",
                             "#!/usr/bin/lua\n\nnope()", "\xef\xbb\xbf#!lua\r\n\r\nnope()"}) {
        CAPTURE(text);
        folder.write("odd.lua", text);
        const Outcome outcome = runFileIn(folder, "odd.lua");
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.message, "odd.lua:3: attempt to call a "));
    }
    for (const char* text : {"", "-- only a comment", "#!lua", "\xef\xbb\xbf"}) {
        folder.write("odd.lua", text);
        CHECK(runFileIn(folder, "odd.lua").code == 0);
    }
}

TEST_CASE("A script runs from stdin, and its chunk is called so") {
    const auto runStdin = [](const std::string& text) {
        int ends[2];
        if (pipe(ends) != 0) return std::string("pipe");
        if (write(ends[1], text.data(), text.size()) < 0) return std::string("write");
        close(ends[1]);
        dup2(ends[0], STDIN_FILENO);
        close(ends[0]);
        return outcomeOf({}, {}, [](LuaState& state) { state.runFile("-"); }).message;
    };
    const int saved = dup(STDIN_FILENO);
    CHECK(runStdin("x = 1") == "");
    CHECK(runStdin("\nx()") == "stdin:2: attempt to call a nil value (global 'x')");
    dup2(saved, STDIN_FILENO);
    close(saved);
}

TEST_CASE("Only regular files run as scripts") {
    const CageFolder folder;
    REQUIRE(mkfifo(folder.file("pipe.lua").c_str(), 0600) == 0);
    folder.write("sub/x.lua", "");
    for (const std::string& path :
         {folder.file("pipe.lua"), folder.file("sub"), folder.file("none.lua"),
          std::string("/dev/zero"), std::string("/proc/self/mem"), std::string("/proc/self/maps"),
          std::string(5000, 'x')}) {
        CAPTURE(path);
        const Outcome outcome = outcomeOf({}, {}, [&](LuaState& state) { state.runFile(path); });
        CHECK(outcome.code == 1);
        CHECK(outcome.message.starts_with(path.substr(0, 100)));
        if (path.starts_with("/proc")) CHECK(contains(outcome.message, "only regular files"));
    }
}

TEST_CASE("Errors at run time carry file and line, whatever the error value is") {
    const struct {
        const char* script;
        const char* message;
    } rows[] = {
        {"\n\nlocal x\nx.y = 1", "scene.lua:4: attempt to index a nil value (local 'x')"},
        {"print(1 + nil)", "scene.lua:1: attempt to perform arithmetic on a nil value"},
        {"nope()", "scene.lua:1: attempt to call a nil value (global 'nope')"},
        {"\nerror({})", "scene.lua:2: error object is a table value"},
        {"\nerror(nil)", "scene.lua:2: error object is a nil value"},
        {"\nerror()", "scene.lua:2: error object is a nil value"},
        {"error(print)", "scene.lua:1: error object is a function value"},
        {"error(true)", "scene.lua:1: error object is a boolean value"},
        {"error(12.5)", "scene.lua:1: 12.5"},
        {"error('plain', 0)", "scene.lua:1: plain"},
        {"error(setmetatable({}, {__tostring = function() return 'mine' end}))",
         "scene.lua:1: mine"},
        {"error(setmetatable({}, {__tostring = function() error('no') end}))",
         "scene.lua:1: error object is a table value"},
        {"error(setmetatable({}, {__tostring = function() return {} end}))",
         "scene.lua:1: error object is a table value"},
        {"local function f() return f() + 1 end f()", "scene.lua:1: stack overflow"},
        {"local function f() return (('x'):gsub('x', f)) end f()", "C stack overflow"},
        {"local function f() coroutine.wrap(f)() end f()", "C stack overflow"},
        {"local function f() local s = ('x'):rep(9000) .. 'y' collectgarbage()"
         " return (('x'):gsub('x', f)) end f()",
         "error in __gc metamethod (C stack overflow)"},
        {"local t = setmetatable({}, {}) getmetatable(t).__index = t return t.x", "loop"},
        {"table.unpack({}, 1, 1e7)", "too many results to unpack"},
        {"string.format('%1000d', 1)", "invalid format (width or precision too long)"},
        {"table.sort({1, 2, 3, 4, 5, 6}, function() return true end)",
         "scene.lua:1: invalid order function for sorting"},
        {"table.sort({1, 'x'})", "attempt to compare"},
        {"string.rep('x', 1 << 62, 'y')", "resulting string too large"},
        {"assert(false)", "scene.lua:1: assertion failed!"},
        {"load('x = = 1')() ", "attempt to call a nil value"},
        {"load('\\n\\nerror(\"x\")', '@scene.lua')()", "scene.lua:3: x"},
        {"load('error(\"x\")', '=scene.lua:made')()", "scene.lua:made:1: x"},
        {"error(load('error(1, 1)', '=other'))", "scene.lua:1: error object is a function value"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runCaged(row.script);
        CHECK(outcome.code == 1);
        CAPTURE(outcome.message);
        CHECK(contains(outcome.message, row.message));
        CHECK(outcome.message.starts_with("scene.lua:"));
    }
}

TEST_CASE("A chunk that a script names itself is named once") {
    CHECK(runCaged("load('\\nerror(\"x\")', '=made')()").message == "made:2: x");
    CHECK(runCaged("load('x()', 'x = 1')()").message.starts_with("[string \"x = 1\"]:1: "));
}

TEST_CASE("A returned value is ignored") {
    for (const char* script : {"return 1", "return nil, {}, 'x'", "return error"}) {
        CHECK(runCaged(script).code == 0);
    }
}

TEST_CASE("The traceback names every function on the way") {
    const Outcome outcome = runCaged(
        "local function inner() error('x') end\nlocal function outer()\ninner()\nend\n"
        "outer()");
    CHECK(outcome.message == "scene.lua:1: x");
    for (const char* part : {"stack traceback:", "scene.lua:1: in ", "scene.lua:3: in ",
                             "scene.lua:5: in main chunk"}) {
        CHECK(contains(outcome.traceback, part));
    }
}

TEST_CASE("Long names are given in full, though Lua shortens them") {
    const CageFolder folder;
    const std::string name = std::string(80, 'd') + "/" + std::string(80, 'f') + ".lua";
    folder.write(name, "\nerror('x')");
    CHECK(runFileIn(folder, name).message == folder.file(name) + ":2: x");
    folder.write(name, "\nlocal = 1");
    CHECK(runFileIn(folder, name).message.starts_with(folder.file(name) + ":2: <name> expected"));
}

TEST_CASE("What a user sees begins with the line, however the error was raised") {
    const CageFolder folder;
    folder.write("scene.lua", "\nerror('x')");
    CHECK(runFileIn(folder, "scene.lua").shown == folder.file("scene.lua") + ":2: error: x");
    CHECK(runCaged("x = = 1").shown.starts_with("scene.lua:1: error: unexpected symbol"));
    CHECK(runCaged("\n\nos.exit()").shown.starts_with("scene.lua:3: error: os.exit is not"));
    CHECK(runCaged("error('x', 0)").shown.ends_with("error: x"));
    CHECK(runCaged("error('other.lua:7: x', 0)").shown.ends_with("error: other.lua:7: x"));
}

TEST_CASE("Messages are printable and short") {
    const Outcome escape = runCaged("error('\\27[31mred\\0\\255')");
    CHECK(escape.message == "scene.lua:1: \\x1b[31mred\\x00\\xff");
    const Outcome huge = runCaged("error(('x'):rep(1 << 27))");
    CHECK(huge.code == 1);
    CHECK(huge.message.size() == 4096);
}

TEST_CASE("Memory bombs end at the cap, with the line where they met it") {
    const char* const rows[] = {
        "\nstring.rep('x', 1 << 30)",
        "\nlocal t = {} while true do t[#t + 1] = {} end",
        "\nlocal s = 'x' while true do s = s .. s end",
        "\nlocal t = {} for i = 1, 5000 do t[i] = ('x'):rep(1000) end while true do t[1] = "
        "table.concat(t) end",
        "\nlocal t = {} while true do t = {t} end",
        "\nlocal t = {} for i = 1, math.huge do t[i] = function() return i end end",
        "\nlocal t = {} for i = 1, math.huge do t[i] = coroutine.create(print) end",
        "\nlocal s = ('x'):rep(1000000) s:gsub('x', s)",
        "\nlocal t = {} for i = 1, math.huge do t['k' .. i] = i end",
        "\nlocal s = '(' while true do s = s .. s load(s) end",
        "\nlocal s = string.format('%s', ('x'):rep(30000000)) .. ('y'):rep(30000000)",
        "\ntable.unpack(setmetatable({}, {__index = function() return ('x'):rep(1000) .. "
        "math.random() end}), 1, 900000)",
    };
    for (const char* script : rows) {
        CAPTURE(script);
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = runCaged(script, memoryLimit(32 * kMega));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        CHECK(outcome.code == 4);
        CHECK(outcome.message ==
              "scene.lua:2: not enough memory: the script needs more than 32 MB (--script-memory)");
        CHECK(took.count() < 20.0);
    }
}

TEST_CASE("A script may survive its memory bomb, and then has the memory again") {
    const Outcome outcome = runCaged(
        "tell((pcall(string.rep, 'x', 1 << 30)))\n"
        "tell((pcall(function() local t = {} while true do t[#t + 1] = {} end end)))\n"
        "tell(#string.rep('x', 1 << 23))\nerror('end')",
        memoryLimit(32 * kMega));
    CHECK(outcome.told == "false\nfalse\n8388608\n");
    CHECK(outcome.code == 1);
    CHECK(outcome.message == "scene.lua:4: end");
}

TEST_CASE("A cap too small for Lua itself is a limit error") {
    for (const std::size_t bytes : {0, 100, 3000, 10000, 20000}) {
        CAPTURE(bytes);
        const Outcome outcome = runCaged("", memoryLimit(bytes));
        CHECK(outcome.code == 4);
        CHECK(contains(outcome.message, "--script-memory"));
    }
}

TEST_CASE("With every cap a script ends well or at the limit") {
    const std::string script =
        "local t = {} for k, v in pairs({a = 1, b = 2, [print] = 3}) do t[#t + 1] = tostring(k) "
        "end\n"
        "table.sort(t) tell(table.concat(t, ' '), io.open('nope'), pcall(require, 'nope'))\n"
        "tell(string.format('%s', {}), select('#', unpack(t)), pcall(error, {}))";
    int done = 0;
    for (std::size_t bytes = 20000; bytes < 60000; bytes += 97) {
        const Outcome outcome = runCaged(script, memoryLimit(bytes));
        CAPTURE(bytes);
        CAPTURE(outcome.message);
        CHECK((outcome.code == 0 || outcome.code == 4));
        done += outcome.code == 0 ? 1 : 0;
    }
    CHECK(done > 0);
}

TEST_CASE("Loops end at the time limit, whatever the script does to go on") {
    const char* const rows[] = {
        "\nwhile true do end",
        "\nlocal function loop() while true do end end while true do pcall(loop) end",
        "\nlocal function loop() while true do end end while true do xpcall(loop, tostring) end",
        "\ncoroutine.wrap(function() while true do end end)()",
        "\ncoroutine.resume(coroutine.create(function() while true do end end))",
        "\nwhile true do coroutine.resume(coroutine.create(function() while true do end end)) end",
        "\nsetmetatable(_G, {__index = function(t, k) while true do end end}) tell(nope)",
        "\ntell(tostring(setmetatable({}, {__tostring = function() while true do end end})))",
        "\ntable.sort({3, 2, 1}, function() while true do end end)",
        "\n;('x'):rep(10):gsub('x', function() while true do end end)",
        "\nfor k in pairs(setmetatable({}, {__pairs = function() while true do end end})) do end",
        "\nload(function() while true do end end)",
        "\nerror(setmetatable({}, {__tostring = function() while true do end end}))",
        "\nlocal function f() local ok = pcall(f) while true do end end f()",
        "\n::again:: goto again",
    };
    for (const char* script : rows) {
        CAPTURE(script);
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = runCaged(script, timeLimit(0.05, 30.0));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        CHECK(outcome.code == 4);
        CHECK(outcome.message ==
              "scene.lua:2: time limit: the script took more than 0.05 s "
              "(--script-time)");
        CHECK(took.count() < 10.0);
    }
}

TEST_CASE("A script within its time is left alone, and the limit may be huge") {
    for (const double seconds : {0.0, 30.0, 1e9, 1e300}) {
        CHECK(runCaged("for i = 1, 100000 do end tell('done')", timeLimit(seconds, 1.0)).told ==
              "done\n");
    }
}

TEST_CASE("What no hook can stop is stopped by the watchdog, which ends the process with code 4") {
    const struct {
        const char* script;
        bool trust;
    } rows[] = {
        {"string.find(('a'):rep(3000), ('a-'):rep(20) .. 'b')", false},
        {"xpcall(function() while true do end end, function() while true do end end)", false},
        {"setmetatable({}, {__gc = function() while true do end end}) collectgarbage()", true},
        {"setmetatable({}, {__gc = function() while true do end end})", true},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const ChildEnd end = inChild([&] {
            SandboxSettings settings;
            settings.trust = row.trust;
            runCaged(row.script, timeLimit(0.05, 0.1), settings);
            return 77;
        });
        CHECK(end.signal == 0);
        CHECK(end.exitCode == 4);
        CHECK(end.errors ==
              "error: time limit: the script took more than 0.05 s (--script-time)\n");
    }
}

TEST_CASE("A closed stdout neither kills nor holds up a script") {
    for (const char* script :
         {"for i = 1, 200000 do print('line', i) end",
          "for i = 1, 200000 do io.write('line') end io.stdout:write('x') io.stdout:flush()"}) {
        CAPTURE(script);
        const ChildEnd end = inChild([&] {
            int ends[2];
            if (pipe(ends) != 0) return 70;
            close(ends[0]);
            dup2(ends[1], STDOUT_FILENO);
            signal(SIGPIPE, SIG_DFL);
            const Outcome outcome = runCaged(script);
            if (std::fflush(stdout) != 0) return 71;
            return outcome.code;
        });
        CHECK(end.signal == 0);
        CHECK(end.exitCode == 0);
    }
    const ChildEnd closed = inChild([] {
        close(STDOUT_FILENO);
        return runCaged("for i = 1, 100000 do print(i) end").code;
    });
    CHECK(closed.exitCode == 0);
}

TEST_CASE("SIGPIPE is as it was when a script has ended") {
    const ChildEnd end = inChild([] {
        signal(SIGPIPE, SIG_DFL);
        runCaged("tell(1)");
        raise(SIGPIPE);
        return 0;
    });
    CHECK(end.signal == SIGPIPE);
}

TEST_CASE("print goes to stdout, or to stderr where stdout carries the image") {
    const auto linesOn = [](bool toStderr) {
        return inChild([&] {
            dup2(memfd_create("stdout", 0), STDOUT_FILENO);
            SandboxSettings settings;
            settings.printToStderr = toStderr;
            runCaged(
                "print('a', nil, 1) io.write('b\\n') io.stdout:write('c\\n') "
                "io.output():write('d\\n')",
                {}, settings);
            return 0;
        });
    };
    CHECK(linesOn(false).errors.empty());
    CHECK(linesOn(true).errors == "a\tnil\t1\nb\nc\nd\n");
}

TEST_CASE("A script gets its arguments") {
    const Outcome outcome = outcomeOf({}, {}, [](LuaState& state) {
        state.runText("tell(select('#', ...), ...)", "scene.lua", {"a", "", "b c"});
    });
    CHECK(outcome.told == "3 a  b c\n");
}

}  // namespace
