#include "lua_access.h"

#include "script_host.h"

#include <array>
#include <cinttypes>
#include <cstdio>

namespace rt {
namespace {

/// The numbers of built-in functions, in the order in which they were first shown.
std::size_t builtinId(lua_State* state, lua_CFunction function) {
    auto& ids = hostOf(state).builtinIds;
    return ids.try_emplace(function, ids.size() + 1).first->second;
}

/// The raw field `name` of the value's metatable, if it is a string.
std::optional<std::string> metaText(lua_State* state, int index, const char* name) {
    ensureStack(state, 2);
    const StackGuard guard(state);
    if (lua_getmetatable(state, index) == 0) return std::nullopt;
    lua_pushstring(state, name);
    if (lua_rawget(state, -2) != LUA_TSTRING) return std::nullopt;
    return toText(state, -1);
}

std::string numberText(lua_State* state, int index) {
    std::array<char, 64> text{};
    if (lua_isinteger(state, index) != 0) {
        std::snprintf(text.data(), text.size(), LUA_INTEGER_FMT, lua_tointeger(state, index));
        return text.data();
    }
    std::snprintf(text.data(), text.size(), LUA_NUMBER_FMT, lua_tonumber(state, index));
    std::string out = text.data();
    // As Lua does: a float that looks like an integer gets a ".0"; inf and nan do not.
    if (out.find_first_not_of("-0123456789") == std::string::npos) out += ".0";
    return out;
}

}  // namespace

void ensureStack(lua_State* state, int slots) {
    if (lua_checkstack(state, slots) == 0) throw SceneError("stack overflow");
}

std::optional<double> toNumber(lua_State* state, int index) {
    int isNumber = 0;
    const double value = lua_tonumberx(state, index, &isNumber);
    if (isNumber == 0) return std::nullopt;
    return value;
}

std::optional<lua_Integer> toInteger(lua_State* state, int index) {
    int isInteger = 0;
    const lua_Integer value = lua_tointegerx(state, index, &isInteger);
    if (isInteger == 0) return std::nullopt;
    return value;
}

std::optional<std::string> toText(lua_State* state, int index) {
    if (lua_type(state, index) == LUA_TNUMBER) return numberText(state, index);
    if (lua_type(state, index) != LUA_TSTRING) return std::nullopt;
    std::size_t length = 0;
    const char* text = lua_tolstring(state, index, &length);
    return std::string(text, length);
}

std::string typeNameOf(lua_State* state, int index) {
    const int type = lua_type(state, index);
    if (type == LUA_TTABLE || type == LUA_TUSERDATA) {
        if (auto name = metaText(state, index, "__name")) return *name;
    }
    return lua_typename(state, type);
}

std::string displayText(lua_State* state, int index) {
    switch (lua_type(state, index)) {
        case LUA_TNONE:
        case LUA_TNIL:
            return "nil";
        case LUA_TBOOLEAN:
            return lua_toboolean(state, index) != 0 ? "true" : "false";
        case LUA_TNUMBER:
        case LUA_TSTRING:
            return *toText(state, index);
        default:
            break;
    }
    std::string kind = typeNameOf(state, index);
    std::uint64_t id = objectSerial(state, index);
    if (id == 0) {
        kind += ": builtin";
        id = builtinId(state, lua_tocfunction(state, index));
    }
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), ": 0x%08" PRIx64, id);
    return kind + number.data();
}

void pushText(lua_State* state, std::string_view text) {
    ensureStack(state, 1);
    const ScriptHost& host = hostOf(state);
    const MemoryBudget& memory = host.memory;
    // A finaliser of a script might raise.
    if (!memory.hasRoomFor(text.size()) && !host.mayFinalise) lua_gc(state, LUA_GCCOLLECT, 0);
    if (!memory.hasRoomFor(text.size())) throw LimitError(memory.message());
    lua_pushlstring(state, text.data(), text.size());
}

bool pushField(lua_State* state, int table, std::string_view name) {
    table = lua_absindex(state, table);
    pushText(state, name);
    return lua_rawget(state, table) != LUA_TNIL;
}

void assignField(lua_State* state, int table, std::string_view name) {
    table = lua_absindex(state, table);
    pushText(state, name);
    lua_insert(state, -2);
    lua_rawset(state, table);
}

void assignFunction(lua_State* state, int table, std::string_view name, lua_CFunction function,
                    int upvalues) {
    table = lua_absindex(state, table);
    ensureStack(state, 2);
    lua_pushcclosure(state, function, upvalues);
    assignField(state, table, name);
}

std::uint64_t objectSerial(lua_State* state, int index) {
    const char* address = static_cast<const char*>(lua_topointer(state, index));
    switch (lua_type(state, index)) {
        case LUA_TTABLE:
            return MemoryBudget::serialOf(address);
        case LUA_TTHREAD:
            return MemoryBudget::serialOf(address - LUA_EXTRASPACE);
        case LUA_TUSERDATA:
            return MemoryBudget::serialOf(address - hostOf(state).userdataOffset);
        case LUA_TFUNCTION: {
            // A C function without upvalues is no object: its address is that of the code.
            const lua_CFunction code = lua_tocfunction(state, index);
            if (code != nullptr && reinterpret_cast<const void*>(code) == address) return 0;
            return MemoryBudget::serialOf(address);
        }
        default:
            return 0;
    }
}

}  // namespace rt
