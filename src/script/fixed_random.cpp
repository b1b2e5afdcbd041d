// math.random: the numbers of Lua 5.3 on Linux with the seed that no script has set.
#include "lua_access.h"
#include "sandbox_parts.h"
#include "script_host.h"

#include <cmath>

namespace rt {
namespace {

/// random() is a float in [0,1), random(m) an integer in [1,m], random(l,m) in [l,m].
/// No C++ object lives here, since wrong arguments raise.
int random(lua_State* state) {
    const double fraction =
        static_cast<double>(hostOf(state).random.next()) * (1.0 / (PortableRandom::kMost + 1.0));
    lua_Integer low = 1;
    lua_Integer high = 0;
    switch (lua_gettop(state)) {
        case 0:
            lua_pushnumber(state, fraction);
            return 1;
        case 1:
            high = luaL_checkinteger(state, 1);
            break;
        case 2:
            low = luaL_checkinteger(state, 1);
            high = luaL_checkinteger(state, 2);
            break;
        default:
            return luaL_error(state, "wrong number of arguments");
    }
    luaL_argcheck(state, low <= high, lua_gettop(state), "interval is empty");
    luaL_argcheck(state, low >= 0 || high <= LUA_MAXINTEGER + low, lua_gettop(state),
                  "interval too large");
    const double offset = fraction * (static_cast<double>(high - low) + 1.0);
    // The widest intervals round up to 2^63, which is no integer.
    const bool fits = offset < static_cast<double>(LUA_MAXINTEGER);
    lua_pushinteger(state, fits ? low + static_cast<lua_Integer>(offset) : high);
    return 1;
}

int randomSeed(lua_State* state) {
    const double value = luaL_checknumber(state, 1);
    const bool fits = std::fabs(value) < static_cast<double>(LUA_MAXINTEGER);
    const lua_Integer seed = fits ? static_cast<lua_Integer>(value) : 0;
    PortableRandom& random = hostOf(state).random;
    random.seed(static_cast<std::uint32_t>(static_cast<lua_Unsigned>(seed)));
    random.next();
    return 0;
}

}  // namespace

void openFixedRandom(lua_State* state) {
    const StackGuard guard(state);
    pushLibrary(state, "math");
    assignFunction(state, -1, "random", random);
    assignFunction(state, -1, "randomseed", randomSeed);
}

}  // namespace rt
