// table.sort: Lua's own takes a pivot from the clock for large tables, which shows where elements
// compare equal. A merge sort is stable and needs no choice.
#include "lua_access.h"
#include "sandbox_parts.h"

#include <algorithm>
#include <climits>

namespace rt {
namespace {

/// Whether element a of the list comes before element b: by the function at 2 or by "<".
bool comesBefore(lua_State* state, int list, lua_Integer a, lua_Integer b) {
    const bool byFunction = !lua_isnil(state, 2);
    if (byFunction) lua_pushvalue(state, 2);
    lua_rawgeti(state, list, a);
    lua_rawgeti(state, list, b);
    bool before;
    if (byFunction) {
        lua_call(state, 2, 1);
        before = lua_toboolean(state, -1) != 0;
        lua_pop(state, 1);
    } else {
        before = lua_compare(state, -2, -1, LUA_OPLT) != 0;
        lua_pop(state, 2);
    }
    return before;
}

/// A function that says yes both ways to every pair is none that sorts.
void checkOrder(lua_State* state, int list, lua_Integer length) {
    constexpr lua_Integer kPairs = 4;
    const lua_Integer pairs = std::min(kPairs, length - 1);
    for (lua_Integer i = 1; i <= pairs; ++i) {
        if (!comesBefore(state, list, i, i + 1)) return;
        if (!comesBefore(state, list, i + 1, i)) return;
    }
    if (pairs == kPairs) luaL_error(state, "invalid order function for sorting");
}

/// Merges the runs [low, middle) and [middle, high) of `from` into `to`.
void mergeRuns(lua_State* state, int from, int to, lua_Integer low, lua_Integer middle,
               lua_Integer high) {
    lua_Integer left = low;
    lua_Integer right = middle;
    for (lua_Integer out = low; out < high; ++out) {
        const bool takeRight =
            left >= middle || (right < high && comesBefore(state, from, right, left));
        lua_rawgeti(state, from, takeRight ? right++ : left++);
        lua_rawseti(state, to, out);
    }
}

/// No C++ object lives here, since comparisons raise.
int sort(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    const lua_Integer length = luaL_len(state, 1);
    luaL_argcheck(state, length < INT_MAX, 1, "array too big");
    if (!lua_isnoneornil(state, 2)) luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_settop(state, 2);
    if (length < 2) return 0;
    lua_createtable(state, static_cast<int>(length), 0);
    lua_createtable(state, static_cast<int>(length), 0);
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_geti(state, 1, i);
        lua_rawseti(state, 3, i);
    }
    checkOrder(state, 3, length);
    int from = 3;
    int to = 4;
    for (lua_Integer width = 1; width < length; width *= 2) {
        for (lua_Integer low = 1; low <= length; low += 2 * width) {
            mergeRuns(state, from, to, low, std::min(low + width, length + 1),
                      std::min(low + 2 * width, length + 1));
        }
        std::swap(from, to);
    }
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(state, from, i);
        lua_seti(state, 1, i);
    }
    return 0;
}

}  // namespace

void openFixedSort(lua_State* state) {
    const StackGuard guard(state);
    pushLibrary(state, "table");
    assignFunction(state, -1, "sort", sort);
}

}  // namespace rt
