// pairs and next over the order of key_order.h.
//
// pairs takes the order once, when the loop starts: O(k log k) for k keys outside of 1..n, and
// O(n) for those; each step is O(1). Keys that the loop clears are left out, keys that it adds are
// not seen. next without pairs keeps the order of the table it walks until the walk starts anew.
#include "key_order.h"
#include "lua_access.h"
#include "sandbox_parts.h"

namespace rt {
namespace {

/// Key of the registry table, weak in its keys, from tables to the orders that next has taken.
const char kOrders = 0;
/// Where an order remembers the position of the last step.
constexpr lua_Integer kLastStep = -1;

/// Pushes the key at a position: 1..n, then the other keys; nil behind the last.
void pushKeyAt(lua_State* state, int order, lua_Integer length, lua_Integer position) {
    if (position <= length) {
        lua_pushinteger(state, position);
    } else {
        lua_rawgeti(state, order, position - length);
    }
}

lua_Integer integerAt(lua_State* state, int table, lua_Integer index) {
    lua_rawgeti(state, table, index);
    const lua_Integer value = lua_tointeger(state, -1);
    lua_pop(state, 1);
    return value;
}

bool isKeyAt(lua_State* state, int order, lua_Integer length, lua_Integer position, int key) {
    if (position < 1) return false;
    pushKeyAt(state, order, length, position);
    const bool same = lua_rawequal(state, -1, key) != 0;
    lua_pop(state, 1);
    return same;
}

/// The position of a key, or of the last one before it where it is not in the order.
lua_Integer positionOf(lua_State* state, int order, lua_Integer length, int key) {
    if (lua_isinteger(state, key) != 0) {
        const lua_Integer number = lua_tointeger(state, key);
        if (1 <= number && number <= length) return number;
    }
    const OrderedKey wanted = orderedKey(state, key);
    lua_Integer low = 0;
    lua_Integer high = static_cast<lua_Integer>(lua_rawlen(state, order));
    while (low < high) {
        const lua_Integer middle = low + (high - low + 1) / 2;
        lua_rawgeti(state, order, middle);
        const bool after = wanted < orderedKey(state, -1);
        lua_pop(state, 1);
        if (after) {
            high = middle - 1;
        } else {
            low = middle;
        }
    }
    return length + low;
}

/// Pushes key and value of the first key behind `position` whose value is not nil; then gives its
/// position. Pushes one nil and gives 0 where there is none.
lua_Integer pushStep(lua_State* state, int table, int order, lua_Integer length,
                     lua_Integer position) {
    while (true) {
        pushKeyAt(state, order, length, ++position);
        if (lua_isnil(state, -1)) return 0;
        lua_pushvalue(state, -1);
        if (lua_rawget(state, table) != LUA_TNIL) return position;
        lua_pop(state, 2);
    }
}

/// Pushes the order of the table at 1, taken anew where `fresh`.
void pushCachedOrder(lua_State* state, bool fresh) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kOrders);
    lua_pushvalue(state, 1);
    if (lua_rawget(state, -2) == LUA_TNIL || fresh) {
        lua_pop(state, 1);
        pushKeyOrder(state, 1);
        lua_pushvalue(state, 1);
        lua_pushvalue(state, -2);
        lua_rawset(state, -4);
    }
    lua_remove(state, -2);
}

/// Starts a walk: the order of the one before may miss keys.
int firstStep(lua_State* state) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kOrders);
    lua_pushvalue(state, 1);
    lua_pushnil(state);
    lua_rawset(state, -3);
    pushFirstKey(state, 1);
    if (lua_isnil(state, -1)) return 1;
    lua_pushvalue(state, -1);
    lua_rawget(state, 1);
    return 2;
}

int next(lua_State* state) {
    if (lua_type(state, 1) != LUA_TTABLE) {
        throw SceneError("bad argument #1 to 'next' (table expected, got " + typeNameOf(state, 1) +
                         ")");
    }
    lua_settop(state, 2);
    if (lua_isnil(state, 2)) return firstStep(state);
    pushCachedOrder(state, false);
    lua_Integer length = integerAt(state, 3, 0);
    lua_Integer position = integerAt(state, 3, kLastStep);
    if (!isKeyAt(state, 3, length, position, 2)) {
        position = positionOf(state, 3, length, 2);
        if (!isKeyAt(state, 3, length, position, 2)) {
            lua_settop(state, 2);
            pushCachedOrder(state, true);
            length = integerAt(state, 3, 0);
            position = positionOf(state, 3, length, 2);
        }
    }
    position = pushStep(state, 1, 3, length, position);
    if (position == 0) return 1;
    lua_pushinteger(state, position);
    lua_rawseti(state, 3, kLastStep);
    return 2;
}

enum Upvalue { kTable = 1, kOrder, kLength, kPosition };

/// The iterator of pairs. A call with another table or key than its own goes to next.
/// No C++ object lives here, since it may be called with anything.
int step(lua_State* state) {
    lua_settop(state, 2);
    const int order = lua_upvalueindex(kOrder);
    const lua_Integer length = lua_tointeger(state, lua_upvalueindex(kLength));
    lua_Integer position = lua_tointeger(state, lua_upvalueindex(kPosition));
    const bool ownTable = lua_rawequal(state, 1, lua_upvalueindex(kTable)) != 0;
    const bool ownKey =
        position == 0 ? lua_isnil(state, 2) : isKeyAt(state, order, length, position, 2);
    if (!ownTable || !ownKey) {
        lua_pushcfunction(state, guarded<next>);
        lua_insert(state, 1);
        lua_call(state, 2, LUA_MULTRET);
        return lua_gettop(state);
    }
    position = pushStep(state, 1, order, length, position);
    if (position == 0) return 1;
    lua_pushinteger(state, position);
    lua_replace(state, lua_upvalueindex(kPosition));
    return 2;
}

int pushOrder(lua_State* state) {
    pushKeyOrder(state, 1);
    return 1;
}

/// No C++ object lives here, since __pairs may raise.
int pairs(lua_State* state) {
    luaL_checkany(state, 1);
    if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(state, 1);
        lua_call(state, 1, 3);
        return 3;
    }
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_pushvalue(state, 1);
    lua_pushcfunction(state, guarded<pushOrder>);
    lua_pushvalue(state, 1);
    lua_call(state, 1, 1);
    lua_rawgeti(state, -1, 0);
    lua_pushinteger(state, 0);
    lua_pushcclosure(state, step, 4);
    lua_pushvalue(state, 1);
    lua_pushnil(state);
    return 3;
}

}  // namespace

void openFixedOrder(lua_State* state) {
    const StackGuard guard(state);
    lua_newtable(state);
    lua_newtable(state);
    pushText(state, "k");
    assignField(state, -2, "__mode");
    lua_setmetatable(state, -2);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kOrders);
    lua_pushglobaltable(state);
    assignFunction(state, -1, "pairs", pairs);
    assignFunction(state, -1, "next", guarded<next>);
}

}  // namespace rt
