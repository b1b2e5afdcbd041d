// A list that needs no memory of its own while it is short.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace rt {

/// Of plain values; `few` of them lie on the stack, uninitialised until they are pushed.
template <class Value, std::size_t few>
class SmallList {
    static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

  public:
    SmallList() = default;
    SmallList(const SmallList&) = delete;
    SmallList& operator=(const SmallList&) = delete;

    std::size_t size() const { return size_; }
    Value* begin() { return data_; }
    Value* end() { return data_ + size_; }
    Value& operator[](std::size_t i) { return data_[i]; }
    const Value& operator[](std::size_t i) const { return data_[i]; }

    void push(const Value& value) {
        if (size_ == capacity_) reserve(2 * capacity_);
        std::construct_at(data_ + size_++, value);
    }
    void assign(std::span<const Value> values) {
        if (values.size() > capacity_) reserve(values.size());
        std::uninitialized_copy(values.begin(), values.end(), data_);
        size_ = values.size();
    }
    /// Forgets all but the first `size`.
    void shorten(std::size_t size) { size_ = size; }

  private:
    [[gnu::noinline, gnu::cold]] void reserve(std::size_t capacity) {
        std::vector<Value> more(capacity);
        std::copy(data_, data_ + size_, more.data());
        many_ = std::move(more);
        data_ = many_.data();
        capacity_ = many_.size();
    }

    alignas(Value) std::byte few_[few * sizeof(Value)];
    std::vector<Value> many_;
    Value* data_ = reinterpret_cast<Value*>(few_);
    std::size_t size_ = 0;
    std::size_t capacity_ = few;
};

}  // namespace rt
