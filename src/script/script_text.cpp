#include "script_text.h"

#include "cage.h"
#include "script_failure.h"
#include "script_host.h"

#include "rt/core/diagnostics.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace rt {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The Lua text in a file. The end of a skipped first line stays, so that lines keep their numbers.
std::string_view chunkText(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (text.starts_with('#'))
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    return text;
}

void noteChunk(ScriptHost& host, const std::string& name) {
    auto& chunks = host.chunks;
    if (std::find(chunks.begin(), chunks.end(), name) == chunks.end()) chunks.push_back(name);
}

}  // namespace

std::string readStdin(std::size_t most) {
    return readAll(0, "stdin", most);
}

std::string resolvedPath(const std::string& path) {
    char* resolved = ::realpath(path.c_str(), nullptr);
    if (resolved == nullptr) return path;
    const std::string result = resolved;
    std::free(resolved);
    return result;
}

std::string quoted(const std::string& name) {
    constexpr std::size_t kMost = 256;
    return "'" + printable(name, kMost) + "'";
}

void loadChunk(lua_State* state, const std::string& text, const std::string& name) {
    const std::string_view code = chunkText(text);
    ScriptHost& host = hostOf(state);
    if (code.starts_with(LUA_SIGNATURE[0]) && !host.cage.trust()) {
        throw SceneError("binary chunks are refused (see --trust)", {name, 0});
    }
    noteChunk(host, name);
    const std::string chunkName = "@" + name;
    const bool suspended = host.memory.isSuspended();
    host.memory.suspend(false);
    const int status = luaL_loadbufferx(state, code.data(), code.size(), chunkName.c_str(),
                                        host.cage.trust() ? "bt" : "t");
    host.memory.suspend(suspended);
    if (status == LUA_OK) return;
    const std::string message = describeError(state, -1);
    lua_pop(state, 1);
    if (status == LUA_ERRMEM) throw LimitError(host.memory.message(), {name, 0});
    throw SceneError(located(state, message));
}

}  // namespace rt
