// The memory of a Lua state: an allocator with a cap, that also numbers what it creates.
#pragma once

#include <lua.hpp>

#include "rt/core/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace rt {

/// Writes the message to stderr and ends the process without running or flushing anything.
[[noreturn]] void endProcess(ExitCode code, const char* message) noexcept;

/// Counts the bytes that Lua holds and refuses to pass the cap, unless it is suspended: Lua cannot
/// report a refusal through C++ frames, so that border code overdraws and asks afterwards.
class MemoryBudget {
  public:
    explicit MemoryBudget(std::size_t limit);
    ~MemoryBudget();
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;

    /// The lua_Alloc; `budget` is a MemoryBudget.
    static void* allocate(void* budget, void* block, std::size_t oldSize,
                          std::size_t newSize) noexcept;

    void suspend(bool suspended) { suspended_ = suspended; }
    bool isSuspended() const { return suspended_; }

    bool isOverdrawn() const { return used_ > limit_; }
    bool hasRoomFor(std::size_t bytes) const { return bytes <= limit_ && used_ <= limit_ - bytes; }
    /// "not enough memory: the script needs more than 64 MB (--script-memory)".
    std::string message() const;

    /// Whether the cap was met since `forgetRefusal`, and the script line at that moment.
    bool hasRefused() const { return refused_; }
    void forgetRefusal() { refused_ = false; }
    SourceLocation refusalLine() const { return {refusalChunk_.data(), refusalLine_}; }
    /// Whether the cap was met since the last call of this.
    bool takeCollectionDue() { return std::exchange(collectionDue_, false); }
    /// The state to look for script lines in; null while there is none.
    void watch(lua_State* state) { watched_ = state; }

    /// Numbers tables, functions, userdata and coroutines in the order of their creation, each
    /// kind on its own: 1, 2, ... `block` is what the allocator returned for the object.
    static std::uint64_t serialOf(const void* block);

  private:
    void* grow(void* block, std::size_t newSize, int kind) noexcept;
    void refuse() noexcept;

    std::size_t limit_;
    std::size_t used_ = 0;
    bool suspended_ = false;
    bool refused_ = false;
    bool collectionDue_ = false;
    std::array<char, LUA_IDSIZE> refusalChunk_{};
    int refusalLine_ = 0;
    lua_State* watched_ = nullptr;
    std::array<std::uint64_t, LUA_NUMTAGS> serials_{};
    void* reserve_;  ///< given back to the system when it has nothing left for border code
};

}  // namespace rt
