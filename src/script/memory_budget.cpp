#include "memory_budget.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace rt {
namespace {

/// Enough for the strings and tables that one callback builds before it returns.
constexpr std::size_t kReserve = std::size_t{256} << 10;

bool isNumbered(int kind) {
    return kind == LUA_TTABLE || kind == LUA_TFUNCTION || kind == LUA_TUSERDATA ||
           kind == LUA_TTHREAD;
}

/// The last bytes of a block hold the serial number: found from the address alone, out of the way
/// of Lua, and `free` needs to know nothing about it.
char* serialIn(void* block) {
    return static_cast<char*>(block) + malloc_usable_size(block) - sizeof(std::uint64_t);
}

std::string humanBytes(std::size_t bytes) {
    const std::size_t mega = std::size_t{1} << 20;
    if (bytes % mega == 0) return std::to_string(bytes / mega) + " MB";
    return std::to_string(bytes) + " bytes";
}

}  // namespace

void endProcess(ExitCode code, const char* message) noexcept {
    const std::size_t length = std::strlen(message);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message, length);
    ::_exit(static_cast<int>(code));
}

MemoryBudget::MemoryBudget(std::size_t limit) : limit_(limit), reserve_(std::malloc(kReserve)) {}

MemoryBudget::~MemoryBudget() {
    std::free(reserve_);
}

std::string MemoryBudget::message() const {
    return "not enough memory: the script needs more than " + humanBytes(limit_) +
           " (--script-memory)";
}

void* MemoryBudget::allocate(void* budget, void* block, std::size_t oldSize,
                             std::size_t newSize) noexcept {
    MemoryBudget& self = *static_cast<MemoryBudget*>(budget);
    const int kind = block == nullptr ? static_cast<int>(oldSize) : LUA_TNIL;
    if (block == nullptr) oldSize = 0;
    if (newSize == 0) {
        std::free(block);
        self.used_ -= oldSize;
        return nullptr;
    }
    const bool tooMuch = newSize > oldSize && !self.hasRoomFor(newSize - oldSize);
    void* grown = tooMuch && !self.suspended_ ? nullptr : self.grow(block, newSize, kind);
    // Lua takes it that a block can always shrink.
    if (grown == nullptr && block != nullptr && newSize <= oldSize) grown = block;
    if (grown == nullptr) {
        self.refuse();
        return nullptr;
    }
    self.used_ = self.used_ - oldSize + newSize;
    return grown;
}

void* MemoryBudget::grow(void* block, std::size_t newSize, int kind) noexcept {
    const std::size_t extra = isNumbered(kind) ? sizeof(std::uint64_t) : 0;
    void* grown = std::realloc(block, newSize + extra);
    if (grown == nullptr && suspended_) {
        std::free(reserve_);
        reserve_ = nullptr;
        grown = std::realloc(block, newSize + extra);
        if (grown == nullptr) {
            endProcess(ExitCode::kLimit, "error: the system has no memory left for the script\n");
        }
    }
    if (grown != nullptr && extra > 0) {
        const std::uint64_t serial = ++serials_[static_cast<std::size_t>(kind)];
        std::memcpy(serialIn(grown), &serial, sizeof serial);
    }
    return grown;
}

void MemoryBudget::refuse() noexcept {
    refused_ = true;
    collectionDue_ = true;
    refusalLine_ = 0;
    refusalChunk_[0] = '\0';
    lua_Debug frame{};
    for (int level = 0; watched_ != nullptr && lua_getstack(watched_, level, &frame) != 0;
         ++level) {
        lua_getinfo(watched_, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        std::copy(std::begin(frame.short_src), std::end(frame.short_src), refusalChunk_.begin());
        refusalLine_ = frame.currentline;
        return;
    }
}

std::uint64_t MemoryBudget::serialOf(const void* block) {
    std::uint64_t serial = 0;
    std::memcpy(&serial, serialIn(const_cast<void*>(block)), sizeof serial);
    return serial;
}

}  // namespace rt
