#include "script/key_order.h"

#include "caged_script.h"

#include "script/portable_random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>

using namespace rt;
using namespace rt::test;

namespace {

TEST_CASE("pairs and next go 1..n, numbers, strings, booleans, then objects by age") {
    const std::string table =
        "local t1, t2, f1, f2 = {}, {}, function() return 1 end, function() return 2 end\n"
        "local names = {[t1] = 't1', [t2] = 't2', [f1] = 'f1', [f2] = 'f2'}\n"
        "local t = {[f2] = 0, [t2] = 0, [true] = 0, ['\\255'] = 0, b = 0, [4] = 0, [2.5] = 0, "
        "[-1] = 0, [f1] = 0, [t1] = 0, [false] = 0, a = 0, [''] = 0, ['a\\0b'] = 0, [0] = 0, "
        "[math.huge] = 0, [-math.huge] = 0, [1 << 53] = 0, [(1 << 53) + 1] = 0, [2^53 + 2] = 0, "
        "[math.maxinteger] = 0, [2^63] = 0, [math.mininteger] = 0, [1e300] = 0, "
        "'x', 'y'}\n"
        "local function show(k) local s = names[k] or k return s == '' and 'empty' or s == "
        "'\\255' and 'ff' or s == 'a\\0b' and 'a0b' or s end\n";
    const std::string order =
        "1\n2\n-inf\n-9223372036854775808\n-1\n0\n2.5\n4\n9007199254740992\n9007199254740993\n"
        "9007199254740994\n9223372036854775807\n9.2233720368548e+18\n1e+300\ninf\n"
        "empty\na\na0b\nb\nff\nfalse\ntrue\nt1\nt2\nf1\nf2\n";
    CHECK(runCaged(table + "for k in pairs(t) do tell(show(k)) end").told == order);
    CHECK(runCaged(table + "for k in next, t do tell(show(k)) end").told == order);
    CHECK(runCaged(table + "table.foreach(t, function(k) tell(show(k)) end)").told == order);
    CHECK(runCaged(table + "local k = next(t) while k ~= nil do tell(show(k)) k = next(t, k) end")
              .told == order);
    CHECK(runCaged(table + "local f, s, k = pairs(t) while true do k = f(s, k) if k == nil then "
                           "break end tell(show(k)) end")
              .told == order);
}

TEST_CASE("The order depends neither on how the table was filled nor on the run") {
    const char* const script =
        "local keys = {} for i = 1, 200 do keys[i] = i % 3 == 0 and i or i % 3 == 1 and 's' .. i "
        "or i + 0.5 end\n"
        "local objects = {} for i = 1, 30 do objects[i] = {} end\n"
        "local function fill(step) local t = {} for i = 0, 199 do t[keys[(i * step) % 200 + 1]] = "
        "i end for i = 0, 29 do t[objects[(i * step) % 30 + 1]] = i end return t end\n"
        "local place = {} for i = 1, 30 do place[objects[i]] = 'o' .. i end\n"
        "for _, step in ipairs{1, 7, 131} do local s = {} for k in pairs(fill(step)) do s[#s + 1] "
        "= tostring(place[k] or k) end tell(table.concat(s, ' ')) end";
    const std::string first = runCaged(script).told;
    const std::size_t line = first.find('\n') + 1;
    CHECK(line > 1000);
    CHECK(first.substr(0, line) == first.substr(line, line));
    CHECK(first.substr(0, line) == first.substr(2 * line));
    for (int run = 0; run < 5; ++run) CHECK(runCaged(script).told == first);
}

TEST_CASE("A loop may assign to its fields, clear them, and stop") {
    const struct {
        const char* script;
        const char* told;
    } rows[] = {
        {"for k, v in pairs(t) do t[k] = v * 10 end", "10 20 30 40 50\n"},
        {"for k, v in pairs(t) do t[k] = nil end", "nil nil nil nil nil\n"},
        {"for k, v in next, t do t[k] = nil end", "nil nil nil nil nil\n"},
        {"for k, v in next, t do t[k] = nil collectgarbage() end", "nil nil nil nil nil\n"},
        {"for k, v in pairs(t) do t.a = nil t[2] = nil if k == 'a' or k == 2 then seen = true end "
         "end t.b = seen",
         "1 nil 3 nil nil\n"},
        {"for k, v in next, t do t.a = nil t[2] = nil if k == 'a' or k == 2 then seen = true end "
         "end t.b = seen",
         "1 nil 3 nil nil\n"},
        {"for k, v in pairs(t) do t.b = nil t.b = 7 end", "1 2 3 4 7\n"},
        {"for k, v in next, t do t[k] = nil if next(t) == nil then t.a = 'last' break end end",
         "nil nil nil last nil\n"},
        {"for k in pairs(t) do for j in pairs(t) do t[j] = t[j] + 1 end end", "6 7 8 9 10\n"},
        {"for k in next, t do for j in next, t do t[j] = t[j] + 1 end end", "6 7 8 9 10\n"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome =
            runCaged("local seen; local t = {1, 2, 3, a = 4, b = 5} " + std::string(row.script) +
                     " tell(t[1], t[2], t[3], t.a, t.b)");
        CHECK(outcome.told == row.told);
        CHECK(outcome.message.empty());
    }
}

TEST_CASE("A walk that starts anew sees the keys that came since") {
    CHECK(runCaged("local t = {b = 1} for k in next, t do end t.a = 2 t.c = 3 "
                   "for k in next, t do tell(k) end")
              .told == "a\nb\nc\n");
    CHECK(runCaged("local t = {} tell(next(t)) t.x = 1 tell(next(t)) t[1] = 2 tell(next(t)) "
                   "tell(next(t, 'absent'))")
              .told == "nil\nx 1\n1 2\nx 1\n");
}

TEST_CASE("next goes on from a key that came since the walk began") {
    CHECK(runCaged("local t = {b = 1, d = 2} next(t, 'b') t.c = 3 t.cc = 4 tell(next(t, 'c'))")
              .told == "cc 4\n");
}

TEST_CASE("The iterator of pairs works with keys and tables of other walks") {
    CHECK(runCaged("local f, s = pairs({10, 20, x = 30}) tell(f(s)) tell(f(s, 2)) tell(f(s, 'x')) "
                   "tell(f(s)) tell(f({y = 1})) tell(f({5, z = 6}, 1))")
              .told == "1 10\nx 30\nnil\n1 10\ny 1\nz 6\n");
}

TEST_CASE("pairs honours __pairs and ignores __index; wrong arguments are errors") {
    CHECK(
        runCaged("local m = setmetatable({}, {__pairs = function(t) return function(_, k) if not "
                 "k then return 1, 'one' end end, t, nil end}) for k, v in pairs(m) do tell(k, v) "
                 "end")
            .told == "1 one\n");
    CHECK(runCaged("for k in pairs(setmetatable({x = 1}, {__index = {y = 2}})) do tell(k) end")
              .told == "x\n");
    CHECK(runCaged("for k in pairs(io.stdout) do end").code == 1);
    for (const char* call : {"pairs()", "pairs(nil)", "pairs(1)", "next()", "next(nil)",
                             "next('x')", "for k in next, nil do end"}) {
        CAPTURE(call);
        const Outcome outcome = runCaged(call);
        CHECK(outcome.code == 1);
        CHECK(outcome.message.starts_with("scene.lua:1: bad argument #1 to '"));
    }
}

TEST_CASE("Walking a big table takes far less than quadratic time") {
    const struct {
        const char* name;
        const char* script;
    } rows[] = {
        {"pairs", "for k in pairs(t) do n = n + 1 end"},
        {"pairs, clearing", "for k in pairs(t) do n = n + 1 t[k] = nil end"},
        {"next", "for k in next, t do n = n + 1 end"},
        {"next, clearing", "for k in next, t do n = n + 1 t[k] = nil end"},
        {"next, two walks at once",
         "local a, b = next(t), next(t) while a do n = n + 1 a = next(t, a) b = next(t, b) end"},
        {"foreach", "table.foreach(t, function() n = n + 1 end)"},
    };
    for (const char* key : {"'k' .. i", "-i", "{}"}) {
        for (const auto& row : rows) {
            CAPTURE(row.name);
            CAPTURE(key);
            const auto start = std::chrono::steady_clock::now();
            const Outcome outcome =
                runCaged("local t, n = {}, 0 for i = 1, 100000 do t[" + std::string(key) +
                         "] = true end " + row.script + " tell(n)");
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
            CHECK(outcome.told == "100000\n");
            CHECK(took.count() < 20.0);
        }
    }
}

TEST_CASE("The orders that next keeps do not keep tables alive") {
    LuaLimits limits;
    limits.memory = std::size_t{8} << 20;
    const Outcome outcome = runCaged(
        "for i = 1, 20000 do local t = {a = 1, b = 2} t.self = t for k in next, t do end end "
        "tell('done')",
        limits);
    CHECK(outcome.told == "done\n");
}

TEST_CASE("Keys compare as a strict total order") {
    LuaState state;
    state.protect([](lua_State* inner) {
        std::mt19937 random(11);
        ensureStack(inner, 60);
        for (int i = 0; i < 10; ++i) {
            lua_pushinteger(inner, static_cast<lua_Integer>(random() % 5) - 2);
            lua_pushnumber(inner, static_cast<double>(random() % 5) - 2.5);
            pushText(inner, std::string(random() % 3, static_cast<char>(random())));
            lua_pushboolean(inner, i % 2);
            lua_newtable(inner);
        }
        const int count = lua_gettop(inner);
        for (int a = 1; a <= count; ++a) {
            for (int b = 1; b <= count; ++b) {
                const OrderedKey left = orderedKey(inner, a);
                const OrderedKey right = orderedKey(inner, b);
                const bool equal = lua_rawequal(inner, a, b) != 0;
                CHECK(static_cast<int>(left < right) + static_cast<int>(right < left) +
                          static_cast<int>(equal) ==
                      1);
                for (int c = 1; c <= count; ++c) {
                    const OrderedKey third = orderedKey(inner, c);
                    if (left < right && right < third && !(left < third)) FAIL("not transitive");
                }
            }
        }
    });
}

TEST_CASE("Objects show the same numbers in every run, by any way to text") {
    const char* const script =
        "local a, b, f, c = {}, {}, function() end, coroutine.create(print)\n"
        "tell(tostring(a), tostring(b), tostring(f), tostring(c), tostring(print))\n"
        "tell(string.format('%s|%5s|%-3d|%%|%q|%s', a, 1, 2, 'q', f), tostring(io.stdout))\n"
        "tell(tostring(setmetatable({}, {__name = 'mine'})))\n"
        "tell(tostring(setmetatable({}, {__tostring = function() return 'shown' end})))\n"
        "tell(select(2, pcall(error, a)) == a, tostring(a) ~= tostring(b))";
    const Outcome first = runCaged(script);
    CHECK(first.message.empty());
    for (int run = 0; run < 5; ++run) CHECK(runCaged(script).told == first.told);
    CHECK(first.told.find("table: 0x000000") == 0);
    CHECK(first.told.find("mine: 0x000000") != std::string::npos);
    CHECK(first.told.find("\nshown\n") != std::string::npos);
    CHECK(first.told.find("\ntrue true\n") != std::string::npos);
    CHECK(first.told.find("|    1|2  |%|\"q\"|function: 0x000000") != std::string::npos);
    CHECK(runCaged("local t = {} tell(tostring(t) == string.format('%s', t))").told == "true\n");
}

TEST_CASE("string.format and tostring are else those of Lua") {
    const struct {
        const char* script;
        const char* message;
    } rows[] = {
        {"string.format('%d', {})", "bad argument #2 to 'format' (number expected, got table)"},
        {"string.format('%s')", "bad argument #2 to 'format' (no value)"},
        {"string.format('%y', 1)", "invalid option '%y' to 'format'"},
        {"string.format('%')", "bad argument #2 to 'format' (no value)"},
        {"string.format('%', 1)", "invalid option '%<\\0>' to 'format'"},
        {"string.format()", "bad argument #1 to 'format' (string expected, got no value)"},
        {"tostring()", "bad argument #1 to 'tostring' (value expected)"},
        {"tostring(setmetatable({}, {__tostring = function() return {} end}))",
         "'__tostring' must return a string"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        CHECK(runCaged(row.script).message == "scene.lua:1: " + std::string(row.message));
    }
    CHECK(runCaged("tell(tostring(1), tostring(1.0), tostring(-0.0), tostring(1e100), "
                   "tostring(2^63), tostring('s'), tostring(nil), tostring(true))")
              .told == "1 1.0 -0.0 1e+100 9.2233720368548e+18 s nil true\n");
}

TEST_CASE("math.random is random() of the GNU C library, seeded as Lua does") {
    for (const unsigned seed : {1U, 0U, 42U, 0x80000000U, 0xffffffffU, 123456789U}) {
        CAPTURE(seed);
        PortableRandom random;
        random.seed(seed);
        srandom(seed);
        for (int i = 0; i < 1000; ++i) {
            REQUIRE(random.next() == static_cast<std::uint32_t>(::random()));
        }
    }
    srandom(1);
    const double expected = static_cast<double>(::random()) / 2147483648.0;
    const Outcome outcome = runCaged(
        "tell(string.format('%.17g', math.random())) tell(math.random(10), math.random(-3, 3))");
    CHECK(std::strtod(outcome.told.c_str(), nullptr) == expected);
    CHECK(outcome.told.ends_with("\n4 2\n"));
}

TEST_CASE("math.random keeps to its intervals") {
    CHECK(runCaged("local low, high = 9, 0 for i = 1, 10000 do local r = math.random(3, 7) low = "
                   "math.min(low, r) high = math.max(high, r) end tell(low, high)")
              .told == "3 7\n");
    CHECK(
        runCaged("for i = 1, 10000 do local r = math.random() assert(0 <= r and r < 1) end").code ==
        0);
    CHECK(runCaged("for i = 1, 1000 do local r = math.random(0, math.maxinteger) assert(r >= 0) "
                   "math.random(math.mininteger, -1) end")
              .message.empty());
    CHECK(runCaged("math.randomseed(5) local a = math.random(1000) math.randomseed(5) "
                   "tell(a == math.random(1000), math.random(1) == 1)")
              .told == "true true\n");
    for (const char* seed : {"0/0", "1/0", "-1e300", "1e300", "math.mininteger", "-7.5"}) {
        CHECK(runCaged("math.randomseed(" + std::string(seed) + ") math.random()").code == 0);
    }
    const struct {
        const char* script;
        const char* message;
    } rows[] = {
        {"math.random(0)", "bad argument #1 to 'random' (interval is empty)"},
        {"math.random(5, 4)", "bad argument #2 to 'random' (interval is empty)"},
        {"math.random(math.mininteger, 1)", "bad argument #2 to 'random' (interval too large)"},
        {"math.random(2.5)", "bad argument #1 to 'random' (number has no integer representation)"},
        {"math.random(1, 2, 3)", "wrong number of arguments"},
        {"math.random({})", "bad argument #1 to 'random' (number expected, got table)"},
        {"math.randomseed()", "bad argument #1 to 'randomseed' (number expected, got no value)"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        CHECK(runCaged(row.script).message == "scene.lua:1: " + std::string(row.message));
    }
}

TEST_CASE("table.sort sorts, keeps the order of equals, and survives every comparison") {
    std::mt19937 random(3);
    for (const int length : {0, 1, 2, 3, 4, 5, 7, 8, 9, 31, 33, 1000}) {
        CAPTURE(length);
        std::vector<int> numbers;
        std::string list;
        for (int i = 0; i < length; ++i) {
            numbers.push_back(static_cast<int>(random() % 50));
            list += std::to_string(numbers.back()) + ",";
        }
        std::sort(numbers.begin(), numbers.end());
        std::string sorted;
        for (const int number : numbers) sorted += std::to_string(number) + ",";
        CHECK(runCaged("local t = {" + list +
                       "} table.sort(t) tell(table.concat(t, ',') .. (#t > 0 and ',' or ''))")
                  .told == sorted + "\n");
    }
    CHECK(runCaged("local t = {} for i = 1, 500 do t[i] = {i % 7, i} end table.sort(t, function(a, "
                   "b) return a[1] > b[1] end) for i = 2, 500 do local a, b = t[i - 1], t[i] "
                   "assert(a[1] > b[1] or a[1] == b[1] and a[2] < b[2]) end")
              .message.empty());
    CHECK(
        runCaged("local t = {} for i = 1, 300 do t[i] = i end table.sort(t, function() return "
                 "math.random() < 0.5 end) local s = 0 for i = 1, 300 do s = s + t[i] end tell(s)")
            .told == "45150\n");
    CHECK(runCaged("local t = {3, 1, 2} table.sort(t, function(a, b) return a <= b end) "
                   "tell(t[1], t[2], t[3])")
              .told == "1 2 3\n");
    CHECK(runCaged("table.sort({1, 2, 'x'})").message ==
          "scene.lua:1: attempt to compare string with number");
    CHECK(runCaged("table.sort(1)").code == 1);
    CHECK(runCaged("table.sort({}, 1)").code == 1);
}

}  // namespace
