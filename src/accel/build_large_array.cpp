#include "rt/accel/large_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace rt {

void* allocateLarge(std::size_t bytes) {
    constexpr std::size_t kCacheLine = 64;
    constexpr std::size_t kHugePage = std::size_t{2} << 20;
    const std::size_t alignment = bytes >= kHugePage ? kHugePage : kCacheLine;
    const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (memory == nullptr) throw std::bad_alloc();
    // Only advice: where it is not taken, the array works as well, more slowly.
    if (alignment == kHugePage) (void)madvise(memory, rounded, MADV_HUGEPAGE);
    return memory;
}

void freeLarge(void* memory) noexcept {
    std::free(memory);
}

}  // namespace rt
