// Arrays that are zero until they are written to: what is never touched takes neither memory nor
// time.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace rt {

/// `count` elements of a plain type whose default has all bits 0. Throws std::bad_alloc.
template <class T>
class ZeroedArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    using value_type = T;

    ZeroedArray() = default;
    explicit ZeroedArray(std::size_t count)
        : data_(static_cast<T*>(std::calloc(count, sizeof(T)))), size_(count) {
        if (count > 0 && !data_) throw std::bad_alloc();
    }

    std::size_t size() const { return size_; }
    T* begin() { return data_.get(); }
    T* end() { return data_.get() + size_; }
    const T* begin() const { return data_.get(); }
    const T* end() const { return data_.get() + size_; }
    T& operator[](std::size_t i) { return data_.get()[i]; }
    const T& operator[](std::size_t i) const { return data_.get()[i]; }

  private:
    struct Free {
        void operator()(T* memory) const noexcept { std::free(memory); }
    };
    std::unique_ptr<T, Free> data_;
    std::size_t size_ = 0;
};

}  // namespace rt
