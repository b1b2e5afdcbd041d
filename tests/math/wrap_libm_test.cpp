// Whether the linker options of src/math/wrap_libm.cpp are in force in this program: its own calls
// of the C library and those inside liblua5.3.a must give the portable bits. libm's own results
// differ from them somewhere among these arguments, so a missing option fails.
#include <doctest/doctest.h>

#include <lua5.3/lua.hpp>
#include <memory>

#include "portable_functions.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr std::uint64_t kSeed = 20260103;
constexpr int kArguments = 200000;

struct CloseState {
    void operator()(lua_State* state) const { lua_close(state); }
};

/// A Lua state whose global f is the given function of one or two numbers.
std::unique_ptr<lua_State, CloseState> luaFunction(const std::string& body) {
    std::unique_ptr<lua_State, CloseState> state(luaL_newstate());
    luaL_openlibs(state.get());
    REQUIRE(luaL_dostring(state.get(), ("function f(x, y) return " + body + " end").c_str()) == 0);
    return state;
}

double call(lua_State* state, double x, double y) {
    lua_getglobal(state, "f");
    lua_pushnumber(state, x);
    lua_pushnumber(state, y);
    REQUIRE(lua_pcall(state, 2, 1, 0) == 0);
    const double result = lua_tonumber(state, -1);
    lua_pop(state, 1);
    return result;
}

int differences(const std::string& body, const Range& first, const Range& second,
                double (*expected)(double, double)) {
    const auto state = luaFunction(body);
    SplitMix random(kSeed);
    int count = 0;
    for (int i = 0; i < kArguments; ++i) {
        const double x = first.draw(random);
        const double y = second.draw(random);
        count += call(state.get(), x, y) == expected(x, y) ? 0 : 1;
    }
    return count;
}

template <double (*Function)(double)>
double first(double x, double) {
    return Function(x);
}

struct Row {
    const char* body;
    Range x;
    Range y;
    double (*expected)(double, double);
};

}  // namespace

TEST_CASE("Lua's mathematics from its archive has the portable bits") {
    const Range unused{0, 1};
    const Row rows[] = {
        {"math.sin(x)", {-10, 10}, unused, first<portable::sin>},
        {"math.cos(x)", {-10, 10}, unused, first<portable::cos>},
        {"math.tan(x)", {-10, 10}, unused, first<portable::tan>},
        {"math.asin(x)", {-1, 1}, unused, first<portable::asin>},
        {"math.acos(x)", {-1, 1}, unused, first<portable::acos>},
        {"math.atan(x, y)", {-1, 1}, {-1, 1}, portable::atan2},
        {"math.exp(x)", {-10, 10}, unused, first<portable::exp>},
        {"math.log(x)", {0.5, 2}, unused, first<portable::log>},
        {"math.log(x, 2)", {0.5, 2}, unused, first<portable::log2>},
        {"math.log(x, 10)", {0.5, 2}, unused, first<portable::log10>},
        {"x ^ y", {0, 1}, {0, 100}, portable::pow},
    };
    for (const Row& row : rows) {
        CAPTURE(std::string(row.body));
        CHECK(differences(row.body, row.x, row.y, row.expected) == 0);
    }
}

TEST_CASE("calls of the C library in this program have the portable bits") {
    SplitMix random(kSeed);
    int count = 0;
    for (int i = 0; i < kArguments; ++i) {
        const double x = random.uniform(-3, 3);
        const double y = random.uniform(-3, 3);
        count += std::sin(x) == portable::sin(x) && std::cos(y) == portable::cos(y) ? 0 : 1;
        count += std::hypot(x, y) == portable::hypot(x, y) ? 0 : 1;
        count += std::cbrt(x) == portable::cbrt(x) ? 0 : 1;
        count += std::sinh(x) == portable::sinh(x) && std::cosh(x) == portable::cosh(x) ? 0 : 1;
        count += std::tanh(x) == portable::tanh(x) && std::exp2(x) == portable::exp2(x) ? 0 : 1;
        count += std::atan(x) == portable::atan(x) ? 0 : 1;
    }
    CHECK(count == 0);
}
