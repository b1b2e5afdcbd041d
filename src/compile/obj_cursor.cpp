#include "obj_cursor.h"

#include "rt/core/diagnostics.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>

namespace rt {
namespace {

constexpr std::size_t kShownWord = 40;

/// Whether a decimal number that no double can hold is too small, not too large: the exponent of
/// its first digit that is not 0 is negative.
bool isTiny(const char* begin, const char* end) {
    std::int64_t exponent = -1;
    bool point = false;
    bool leading = true;
    const char* at = begin;
    for (; at < end && *at != 'e' && *at != 'E'; ++at) {
        if (*at == '.') {
            point = true;
        } else if (*at >= '0' && *at <= '9') {
            leading = leading && *at == '0';
            if (!point && !leading) ++exponent;
            if (point && leading) --exponent;
        }
    }
    if (at == end) return exponent < 0;
    const bool negative = at + 1 < end && at[1] == '-';
    // Longer than any mantissa that fits in memory, so that the sum cannot overflow.
    std::int64_t written = std::int64_t{1} << 60;
    std::from_chars(at + 1 + (at + 1 < end && (at[1] == '-' || at[1] == '+')), end, written);
    written = std::min(written, std::int64_t{1} << 60);
    return exponent + (negative ? -written : written) < 0;
}

}  // namespace

int ObjCursor::line() const {
    return static_cast<int>(std::min<std::int64_t>(line_, INT_MAX));
}

void ObjCursor::fail(const std::string& message) const {
    throw SceneError(message, where());
}

void ObjCursor::endLine() {
    ++line_;
    // The '\n' at the end may be none of the file's.
    at_ += *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n' ? 2 : 1;
}

void ObjCursor::skipBlanks() {
    while (true) {
        const char c = *at_;
        if (c == '\\' && isLineEnd(at_[1])) {
            ++at_;
            // At the end of the file the '\n' there stays, to end the line.
            if (at_ < end_) endLine();
        } else if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
            ++at_;
        } else {
            return;
        }
    }
}

void ObjCursor::nextLine(bool continued) {
    while (true) {
        while (!isLineEnd(*at_)) ++at_;
        const bool goesOn = continued && at_ < end_ && at_[-1] == '\\';
        endLine();
        if (!goesOn || at_ >= end_) return;
    }
}

std::string ObjCursor::word() const {
    const char* last = at_;
    while (!endsWord(*last)) ++last;
    return printable(std::string(at_, last), kShownWord);
}

double ObjCursor::number(const char* what) {
    skipBlanks();
    if (atEndOfStatement()) fail(std::string(what) + " is missing");
    const char* const begin = *at_ == '+' && at_[1] != '-' ? at_ + 1 : at_;
    double value = 0.0;
    auto [last, error] = std::from_chars(begin, end_, value);
    const bool tiny = error == std::errc::result_out_of_range && isTiny(begin, last);
    if (error == std::errc::result_out_of_range) value = tiny ? 0.0 : HUGE_VAL;
    if (error == std::errc::invalid_argument || !endsWord(*last)) {
        fail(std::string(what) + " must be a decimal number (got \"" + word() + "\")");
    }
    if (!std::isfinite(value)) {
        fail(std::string(what) + " must be finite (got \"" + word() + "\")");
    }
    at_ = last;
    return value;
}

std::int64_t ObjCursor::integer() {
    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(at_, end_, value);
    if (error == std::errc::result_out_of_range) fail("index out of range: \"" + word() + "\"");
    if (error != std::errc{} || !(endsWord(*last) || *last == '/')) {
        fail("an index must be a whole number (got \"" + word() + "\")");
    }
    at_ = last;
    return value;
}

}  // namespace rt
