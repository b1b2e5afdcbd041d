// io for scripts: files of the scene's folder, for reading; the standard streams, for writing.
#include "lua_access.h"
#include "sandbox.h"
#include "sandbox_parts.h"
#include "script_host.h"
#include "script_text.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

namespace rt {
namespace {

/// Registry names of the default streams, fixed by Lua's io library.
const char* const kDefaultInput = "_IO_input";
const char* const kDefaultOutput = "_IO_output";

int closeStream(lua_State* state) {
    auto* stream = static_cast<luaL_Stream*>(luaL_checkudata(state, 1, LUA_FILEHANDLE));
    return luaL_fileresult(state, std::fclose(stream->f) == 0 ? 1 : 0, nullptr);
}

/// Pushes a stream that counts as closed until it is given a file.
luaL_Stream* pushClosedStream(lua_State* state) {
    auto* stream = static_cast<luaL_Stream*>(lua_newuserdata(state, sizeof(luaL_Stream)));
    stream->closef = nullptr;
    stream->f = nullptr;
    luaL_setmetatable(state, LUA_FILEHANDLE);
    return stream;
}

int pushMissing(lua_State* state, const std::string& message, int number) {
    lua_pushnil(state);
    pushText(state, message);
    lua_pushinteger(state, number);
    return 3;
}

/// io.open(name [, "r" or "rb"]): a stream, or nil and what is wrong within the folder. What leads
/// out of it is an error.
int open(lua_State* state) {
    lua_settop(state, 2);
    const auto name = toText(state, 1);
    if (!name)
        throw SceneError("bad argument #1 to 'open' (string expected, got " + typeNameOf(state, 1) +
                         ")");
    const std::string mode = toText(state, 2).value_or("r");
    if (mode != "r" && mode != "rb") {
        throw SceneError("io.open: mode " + quoted(mode) +
                         " is not available in the sandbox, only 'r' and 'rb' (see --trust)");
    }
    const Resolved found = findFile(state, *name);
    if (found.kind == Resolved::Kind::kOutside) {
        throw SceneError("io.open: " + quoted(*name) +
                         " is outside of the scene's folder (see --trust)");
    }
    if (found.kind == Resolved::Kind::kMissing) {
        return pushMissing(state, *name + ": No such file or directory", ENOENT);
    }
    luaL_Stream* stream = pushClosedStream(state);
    try {
        const int file = openRegularFile(found.path, *name);
        stream->f = ::fdopen(file, "r");
        if (stream->f == nullptr) ::close(file);
    } catch (const SceneError& error) {
        return pushMissing(state, error.what(), EACCES);
    }
    if (stream->f == nullptr) return pushMissing(state, *name + ": cannot be opened", ENOMEM);
    stream->closef = closeStream;
    noteFileRead(state, found.path);
    return 1;
}

/// Pushes the stream of the file named at 1, or raises. No C++ object lives here.
void pushOpened(lua_State* state) {
    lua_pushcfunction(state, guarded<open>);
    lua_pushvalue(state, 1);
    lua_call(state, 1, 2);
    if (lua_isnil(state, -2)) luaL_error(state, "%s", lua_tostring(state, -1));
    lua_pop(state, 1);
}

/// Upvalues: the iterator of the stream, the stream, its close. The end of the file closes it.
int nextLine(lua_State* state) {
    lua_settop(state, 0);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_call(state, 0, LUA_MULTRET);
    if (lua_gettop(state) > 0 && !lua_isnil(state, 1)) return lua_gettop(state);
    lua_pushvalue(state, lua_upvalueindex(3));
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_call(state, 1, 0);
    lua_pushnil(state);
    return 1;
}

/// io.lines([name, ...]). Upvalues: Lua's io.lines, and lines and close of streams.
int lines(lua_State* state) {
    if (lua_isnoneornil(state, 1)) return callWrapped(state);
    luaL_checkstring(state, 1);
    pushOpened(state);
    lua_pushvalue(state, -1);
    lua_replace(state, 1);
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_insert(state, 1);
    const int stream = lua_gettop(state);
    lua_insert(state, 1);
    lua_call(state, stream - 2, 1);  // the stream 1, its iterator 2
    lua_insert(state, 1);
    lua_pushvalue(state, lua_upvalueindex(3));
    lua_pushcclosure(state, nextLine, 3);
    return 1;
}

/// io.input([file or name]). Upvalue: Lua's io.input.
int input(lua_State* state) {
    if (lua_type(state, 1) == LUA_TSTRING) {
        lua_settop(state, 1);
        pushOpened(state);
        lua_replace(state, 1);
    }
    return callWrapped(state);
}

/// io.output([file]). Upvalue: Lua's io.output.
int output(lua_State* state) {
    if (lua_type(state, 1) == LUA_TSTRING) {
        return luaL_error(state,
                          "io.output to a file is not available in the sandbox "
                          "(see --trust)");
    }
    return callWrapped(state);
}

int streamText(lua_State* state) {
    auto* stream = static_cast<luaL_Stream*>(luaL_checkudata(state, 1, LUA_FILEHANDLE));
    if (stream->closef == nullptr) {
        lua_pushliteral(state, "file (closed)");
    } else {
        lua_pushfstring(state, "file (%d)", static_cast<int>(objectSerial(state, 1)));
    }
    return 1;
}

/// Gives streams methods that are not their metatable, which is locked.
void lockStreams(lua_State* state) {
    const StackGuard guard(state);
    luaL_getmetatable(state, LUA_FILEHANDLE);
    lua_newtable(state);
    for (const char* name : {"close", "flush", "lines", "read", "seek", "setvbuf", "write"}) {
        pushField(state, -2, name);
        assignField(state, -2, name);
    }
    assignField(state, -2, "__index");
    pushText(state, "locked");
    assignField(state, -2, "__metatable");
}

/// Wraps the functions of io that open files, for the sandbox.
void wrapOpeners(lua_State* state, int io) {
    luaL_getmetatable(state, LUA_FILEHANDLE);
    const int methods = lua_gettop(state);
    pushField(state, io, "lines");
    pushField(state, methods, "lines");
    pushField(state, methods, "close");
    assignFunction(state, io, "lines", lines, 3);
    lua_settop(state, io);
    assignFunction(state, io, "open", guarded<open>);
    wrapFunction(state, io, "input", input);
    wrapFunction(state, io, "output", output);
    refuseFunction(state, io, "popen", "io.popen");
    refuseFunction(state, io, "tmpfile", "io.tmpfile");
    lua_pushnil(state);
    assignField(state, io, "stdin");
    pushClosedStream(state);
    lua_setfield(state, LUA_REGISTRYINDEX, kDefaultInput);
}

/// With trust: notes the file, then does what Lua does.
int noteAndOpen(lua_State* state) {
    if (const auto name = toText(state, 1)) noteFileRead(state, resolvedPath(*name));
    return 0;
}

/// No C++ object lives here. Upvalue: the function of Lua's io.
int trustedOpen(lua_State* state) {
    const char* mode = lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : "r";
    if (lua_type(state, 1) == LUA_TSTRING && *mode == 'r') {
        lua_pushcfunction(state, guarded<noteAndOpen>);
        lua_pushvalue(state, 1);
        lua_call(state, 1, 0);
    }
    return callWrapped(state);
}

}  // namespace

void openSafeIo(lua_State* state, bool printToStderr) {
    const StackGuard guard(state);
    ensureStack(state, 10);
    luaL_getmetatable(state, LUA_FILEHANDLE);
    assignFunction(state, -1, "__tostring", streamText);
    lua_pop(state, 1);
    pushLibrary(state, "io");
    const int io = lua_gettop(state);
    if (printToStderr) {
        pushField(state, io, "stderr");
        lua_pushvalue(state, -1);
        assignField(state, io, "stdout");
        lua_setfield(state, LUA_REGISTRYINDEX, kDefaultOutput);
    }
    if (hostOf(state).cage.trust()) {
        for (const char* name : {"open", "lines", "input"}) {
            wrapFunction(state, io, name, trustedOpen);
        }
        return;
    }
    wrapOpeners(state, io);
    lockStreams(state);
}

}  // namespace rt
