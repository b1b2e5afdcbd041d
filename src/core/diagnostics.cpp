#include "rt/core/diagnostics.h"

#include <cstdint>
#include <string_view>

namespace rt {
namespace {

/// The length of the well-formed UTF-8 sequence at the start of `text`, 0 if there is none
/// (The Unicode Standard 15.0, 2022, table 3-7).
std::size_t sequenceLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
    };
    const auto within = [](std::uint8_t value, int low, int high) {
        return low <= value && value <= high;
    };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return 1;
    if (within(lead, 0xc2, 0xdf)) return within(byte(1), 0x80, 0xbf) ? 2 : 0;
    const bool tail2 = within(byte(2), 0x80, 0xbf);
    if (within(lead, 0xe0, 0xef)) {
        const int low = lead == 0xe0 ? 0xa0 : 0x80;
        const int high = lead == 0xed ? 0x9f : 0xbf;
        return within(byte(1), low, high) && tail2 ? 3 : 0;
    }
    if (within(lead, 0xf0, 0xf4)) {
        const int low = lead == 0xf0 ? 0x90 : 0x80;
        const int high = lead == 0xf4 ? 0x8f : 0xbf;
        return within(byte(1), low, high) && tail2 && within(byte(3), 0x80, 0xbf) ? 4 : 0;
    }
    return 0;
}

/// C0 and C1 controls, which a terminal would obey; line breaks and tabs may stay.
bool isControl(std::string_view sequence) {
    const auto first = static_cast<std::uint8_t>(sequence[0]);
    if (sequence.size() == 1)
        return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f;
    return first == 0xc2 && static_cast<std::uint8_t>(sequence[1]) < 0xa0;
}

std::string escaped(std::string_view bytes) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string out;
    for (const char c : bytes) {
        const auto byte = static_cast<std::uint8_t>(c);
        out += "\\x";
        out += kDigits[byte >> 4];
        out += kDigits[byte & 15];
    }
    return out;
}

}  // namespace

void Diagnostics::warn(const std::string& kind, const SourceLocation& where,
                       const std::string& message) {
    ++total_;
    if (++countByKind_[kind] <= kShownPerKind) shown_.push_back({where, printable(message), kind});
}

std::string printable(const std::string& text, std::size_t most) {
    static constexpr std::string_view kEllipsis = "...";
    std::string out;
    std::size_t lastFit = 0;  // how much of `out` leaves room for the ellipsis
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t length = sequenceLength(rest);
        const std::string_view piece = rest.substr(0, length == 0 ? 1 : length);
        out += length == 0 || isControl(piece) ? escaped(piece) : std::string(piece);
        if (out.size() > most) {
            out.resize(lastFit);
            return out.append(kEllipsis.substr(0, most - lastFit));
        }
        if (out.size() + kEllipsis.size() <= most) lastFit = out.size();
        rest.remove_prefix(piece.size());
    }
    return out;
}

}  // namespace rt
