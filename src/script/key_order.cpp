#include "key_order.h"

#include "lua_access.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace rt {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64, "must hold every integer key");

/// The largest n for which 1..n are keys.
lua_Integer sequenceLength(lua_State* state, int table) {
    lua_Integer length = 0;
    while (lua_rawgeti(state, table, length + 1) != LUA_TNIL) {
        lua_pop(state, 1);
        ++length;
    }
    lua_pop(state, 1);
    return length;
}

bool isInSequence(lua_State* state, int index, lua_Integer length) {
    if (lua_isinteger(state, index) == 0) return false;
    const lua_Integer key = lua_tointeger(state, index);
    return 1 <= key && key <= length;
}

/// Appends the keys that are not 1..length to the list on top, in the table's own order.
std::vector<OrderedKey> collectKeys(lua_State* state, int table, lua_Integer length) {
    const int list = lua_gettop(state);
    std::vector<OrderedKey> keys;
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        if (isInSequence(state, -2, length)) continue;
        keys.push_back(orderedKey(state, -2));
        keys.back().slot = static_cast<lua_Integer>(keys.size());
        lua_pushvalue(state, -2);
        lua_rawseti(state, list, keys.back().slot);
    }
    return keys;
}

}  // namespace

OrderedKey orderedKey(lua_State* state, int index) {
    OrderedKey key;
    switch (lua_type(state, index)) {
        case LUA_TNUMBER:
            key.number = lua_isinteger(state, index) != 0
                             ? static_cast<long double>(lua_tointeger(state, index))
                             : static_cast<long double>(lua_tonumber(state, index));
            break;
        case LUA_TSTRING: {
            std::size_t length = 0;
            const char* text = lua_tolstring(state, index, &length);
            key.rank = 1;
            key.text = std::string_view(text, length);
            break;
        }
        case LUA_TBOOLEAN:
            key.rank = lua_toboolean(state, index) != 0 ? 3 : 2;
            break;
        default:
            key.rank = 4 + lua_type(state, index);
            key.serial = objectSerial(state, index);
            // Built-in functions keep their distances; so their addresses order them.
            if (key.serial == 0) {
                key.rank += LUA_NUMTAGS;
                key.serial = reinterpret_cast<std::uintptr_t>(lua_topointer(state, index));
            }
    }
    return key;
}

bool operator<(const OrderedKey& a, const OrderedKey& b) {
    return std::tie(a.rank, a.number, a.text, a.serial) <
           std::tie(b.rank, b.number, b.text, b.serial);
}

void pushKeyOrder(lua_State* state, int table) {
    table = lua_absindex(state, table);
    ensureStack(state, 5);
    const lua_Integer length = sequenceLength(state, table);
    lua_newtable(state);
    std::vector<OrderedKey> keys = collectKeys(state, table, length);
    std::sort(keys.begin(), keys.end());
    const int unsorted = lua_gettop(state);
    lua_createtable(state, static_cast<int>(keys.size()), 1);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        lua_rawgeti(state, unsorted, keys[i].slot);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_pushinteger(state, length);
    lua_rawseti(state, -2, 0);
    lua_remove(state, unsorted);
}

void pushFirstKey(lua_State* state, int table) {
    table = lua_absindex(state, table);
    ensureStack(state, 5);
    lua_pushinteger(state, 1);
    if (lua_rawgeti(state, table, 1) != LUA_TNIL) {
        lua_pop(state, 1);
        return;
    }
    lua_pop(state, 2);
    lua_pushnil(state);
    const int best = lua_gettop(state);
    for (lua_pushnil(state); lua_next(state, table) != 0;) {
        lua_pop(state, 1);
        if (lua_isnil(state, best) || orderedKey(state, -1) < orderedKey(state, best)) {
            lua_pushvalue(state, -1);
            lua_replace(state, best);
        }
    }
}

}  // namespace rt
