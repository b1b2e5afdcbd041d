// Numbers as text, whatever the locale, and lists of words.
#pragma once

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The shortest text that reads back as the same number.
inline std::string shortest(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), end.ptr);
}

/// With so many digits after the point.
inline std::string fixed(double value, int digits) {
    std::array<char, 512> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, digits);
    return std::string(text.data(), end.ptr);
}

/// The number that `text` is, from its first character to its last; nothing for "10x", " 1", "",
/// "0x10" or what does not fit the type.
template <class Number>
std::optional<Number> wholeNumber(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// "a, b, c".
inline std::string joined(const std::vector<std::string>& words,
                          const std::string& separator = ", ") {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
    return text;
}

}  // namespace rt
