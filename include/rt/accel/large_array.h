// Fixed-size arrays for the tree: aligned to cache lines, and on huge pages where they are large,
// because rays through big trees spend their time on address translation.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace rt {

/// Aligned memory, advised to lie on huge pages from a few megabytes on. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory) noexcept;

/// `count` elements of a trivial type, not initialised. Copies share them.
template <class T>
class LargeArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    LargeArray() = default;
    explicit LargeArray(std::size_t count)
        : data_(count > 0 ? static_cast<T*>(allocateLarge(count * sizeof(T))) : nullptr, Free()),
          size_(count) {}

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return size_ * sizeof(T); }
    T& operator[](std::size_t i) { return data_.get()[i]; }
    const T& operator[](std::size_t i) const { return data_.get()[i]; }

  private:
    struct Free {
        void operator()(T* memory) const noexcept { freeLarge(memory); }
    };
    std::shared_ptr<T> data_;
    std::size_t size_ = 0;
};

}  // namespace rt
