// Memory for large arrays: aligned to cache lines, and on huge pages where there is much of it,
// because filling it and reading it here and there would spend its time on pages.
#pragma once

#include <cstddef>
#include <vector>

namespace rt {

/// Aligned memory, advised to lie on huge pages from a few megabytes on. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory) noexcept;

template <class T>
struct LargeAllocator {
    using value_type = T;

    LargeAllocator() = default;
    template <class Other>
    LargeAllocator(const LargeAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateLarge(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) noexcept { freeLarge(memory); }

    friend bool operator==(const LargeAllocator&, const LargeAllocator&) { return true; }
};

/// For as many values as there are pixels.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace rt
