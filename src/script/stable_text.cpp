// Objects as text: by serial number, since an address is different in every run.
#include "lua_access.h"
#include "sandbox_parts.h"
#include "script_host.h"

#include <cstdio>
#include <cstring>

namespace rt {
namespace {

int pushDisplayText(lua_State* state) {
    pushText(state, displayText(state, 1));
    return 1;
}

/// Whether luaL_tolstring would show an address.
bool showsAddress(lua_State* state, int index) {
    switch (lua_type(state, index)) {
        case LUA_TTABLE:
        case LUA_TFUNCTION:
        case LUA_TUSERDATA:
        case LUA_TLIGHTUSERDATA:
        case LUA_TTHREAD:
            break;
        default:
            return false;
    }
    if (luaL_getmetafield(state, index, "__tostring") == LUA_TNIL) return true;
    lua_pop(state, 1);
    return false;
}

/// Pushes the text of a value, with its __tostring. No C++ object lives here, since that raises.
void pushToString(lua_State* state, int index) {
    index = lua_absindex(state, index);
    if (!showsAddress(state, index)) {
        luaL_tolstring(state, index, nullptr);
        return;
    }
    lua_pushcfunction(state, guarded<pushDisplayText>);
    lua_pushvalue(state, index);
    lua_call(state, 1, 1);
}

int toString(lua_State* state) {
    luaL_checkany(state, 1);
    pushToString(state, 1);
    return 1;
}

/// Writes its arguments, by tabs; a stream that is closed at its other end is left alone.
int print(lua_State* state) {
    const int count = lua_gettop(state);
    std::FILE* output = hostOf(state).output;
    for (int i = 1; i <= count; ++i) {
        pushToString(state, i);
        std::size_t length = 0;
        const char* text = lua_tolstring(state, -1, &length);
        if (std::ferror(output) != 0) return 0;
        if (i > 1) std::fputc('\t', output);
        std::fwrite(text, 1, length, output);
        lua_pop(state, 1);
    }
    if (std::ferror(output) == 0) std::fputc('\n', output);
    return 0;
}

/// string.format, given text in place of the objects that its %s meet. No C++ object lives here.
int format(lua_State* state) {
    std::size_t length = 0;
    const char* at = luaL_checklstring(state, 1, &length);
    const char* end = at + length;
    const int last = lua_gettop(state);
    for (int argument = 1; at < end; ++at) {
        if (*at != '%') continue;
        ++at;
        if (at < end && *at == '%') continue;
        while (at < end && std::strchr("-+ #0123456789.", *at) != nullptr) ++at;
        ++argument;
        if (at >= end || *at != 's' || argument > last) continue;
        if (!showsAddress(state, argument)) continue;
        pushToString(state, argument);
        lua_replace(state, argument);
    }
    return callWrapped(state);
}

}  // namespace

void openStableText(lua_State* state) {
    const StackGuard guard(state);
    lua_pushglobaltable(state);
    assignFunction(state, -1, "tostring", toString);
    assignFunction(state, -1, "print", print);
    pushLibrary(state, "string");
    wrapFunction(state, -1, "format", format);
}

}  // namespace rt
