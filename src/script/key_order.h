// The order of table keys that pairs and next keep.
#pragma once

#include <lua.hpp>

#include <cstdint>
#include <string_view>

namespace rt {

/// A key with what orders it: numbers by value, then strings by bytes, false, true, and then
/// objects by type and by the time of their creation. Valid while the key is alive in Lua.
struct OrderedKey {
    int rank = 0;
    long double number = 0.0L;  ///< holds every lua_Integer and every lua_Number exactly
    std::string_view text;
    std::uint64_t serial = 0;  ///< of an object; the address of what has none
    lua_Integer slot = 0;      ///< where the caller keeps the key
};

OrderedKey orderedKey(lua_State* state, int index);
bool operator<(const OrderedKey& a, const OrderedKey& b);

/// Pushes the keys of the table at `table` as a list: [0] is n, where 1..n are keys; [1], [2], ...
/// the keys but for those, in order. Costs O(k log k) for k keys but 1..n.
void pushKeyOrder(lua_State* state, int table);

/// Pushes the first key in order, nil for an empty table. Costs O(keys), O(1) if 1 is a key.
void pushFirstKey(lua_State* state, int table);

}  // namespace rt
