// Numbers and texts one after the other, as files of the program's own hold them: little endian,
// floats by IEEE 754, a text after its length of 4 bytes.
#pragma once

#include "rt/core/vec.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rt {

class PackedWriter {
  public:
    template <class Unsigned>
    void number(Unsigned value) {
        static_assert(std::is_unsigned_v<Unsigned>);
        for (std::size_t i = 0; i < sizeof(value); ++i) {
            bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        }
    }
    void word(int value) { number(static_cast<std::uint32_t>(value)); }
    void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void text(const std::string& value) {
        number(static_cast<std::uint32_t>(value.size()));
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }
    void color(const Color& value) {
        for (int c = 0; c < 3; ++c) real(value[c]);
    }
    /// Without their length.
    void raw(std::span<const std::uint8_t> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    std::vector<std::uint8_t>& bytes() { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
};

/// Less is there than was to be read, or what cannot be.
struct DamagedBytes {};

/// Takes what a PackedWriter put, in the same order; throws DamagedBytes where there is less.
class PackedReader {
  public:
    explicit PackedReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    template <class Unsigned>
    Unsigned number() {
        Unsigned value = 0;
        const auto from = raw(sizeof(value));
        for (std::size_t i = 0; i < sizeof(value); ++i) {
            value |= static_cast<Unsigned>(static_cast<Unsigned>(from[i]) << (8 * i));
        }
        return value;
    }
    int word() { return static_cast<int>(number<std::uint32_t>()); }
    double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
    float single() { return std::bit_cast<float>(number<std::uint32_t>()); }
    std::string text() {
        const auto from = raw(number<std::uint32_t>());
        return {from.begin(), from.end()};
    }
    Color color() {
        Color value;
        for (int c = 0; c < 3; ++c) value[c] = real();
        return value;
    }
    std::span<const std::uint8_t> raw(std::size_t count) {
        if (count > left_.size()) throw DamagedBytes{};
        const auto taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }
    std::size_t left() const { return left_.size(); }

  private:
    std::span<const std::uint8_t> left_;
};

}  // namespace rt
