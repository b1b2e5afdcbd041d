#include "option_values.h"

#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/core/text.h"

#include <cmath>
#include <limits>
#include <set>

namespace rt {
namespace {

constexpr int kMostSide = 0x7fffffff;
constexpr std::size_t kLeastScriptMemory = std::size_t{1} << 20;

/// The parts of a text between separators; "a,,b" has three.
std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

/// Whole numbers within the range, as many as there are parts; empty if any is not.
std::vector<std::int64_t> wholes(const std::vector<std::string>& parts, std::int64_t min,
                                 std::int64_t max) {
    std::vector<std::int64_t> values;
    for (const std::string& part : parts) {
        const auto value = wholeNumber<std::int64_t>(part);
        if (!value || *value < min || *value > max) return {};
        values.push_back(*value);
    }
    return values;
}

OptionValue sharedValue(const OptionRow& row, const std::string& text) {
    switch (row.kind) {
        case OptionRow::Kind::kFlag:
            if (text == "true" || text == "false") return text == "true";
            return text;
        case OptionRow::Kind::kInteger:
            if (const auto value = wholeNumber<std::int64_t>(text)) {
                return static_cast<double>(*value);
            }
            return text;
        case OptionRow::Kind::kNumber:
            if (const auto value = wholeNumber<double>(text)) return *value;
            return text;
        case OptionRow::Kind::kChoice:
            break;
    }
    return text;
}

}  // namespace

void refuseValue(const std::string& flag, const std::string& text, const std::string& right) {
    throw UsageError(flag + " " + printable(text, 200) + ": " + right);
}

std::int64_t wholeIn(const std::string& flag, const std::string& text, std::int64_t min,
                     std::int64_t max) {
    const auto value = wholeNumber<std::int64_t>(text);
    if (value && *value >= min && *value <= max) return *value;
    refuseValue(flag, text,
                "must be a whole number in " + std::to_string(min) + " .. " + std::to_string(max));
}

double numberFrom(const std::string& flag, const std::string& text, double min) {
    const auto value = wholeNumber<double>(text);
    if (value && *value >= min && std::isfinite(*value)) return *value;
    refuseValue(flag, text, "must be a number >= " + shortest(min));
}

std::size_t bytesFrom(const std::string& flag, const std::string& text) {
    const std::string suffixes = "KMG";
    const std::size_t power = text.empty() ? std::string::npos : suffixes.find(text.back());
    const bool suffixed = power != std::string::npos;
    const auto count =
        wholeNumber<std::uint64_t>(suffixed ? text.substr(0, text.size() - 1) : text);
    const std::size_t shift = suffixed ? 10 * (power + 1) : 0;
    if (count && *count <= std::numeric_limits<std::size_t>::max() >> shift) {
        const std::size_t bytes = static_cast<std::size_t>(*count) << shift;
        if (bytes >= kLeastScriptMemory) return bytes;
    }
    refuseValue(flag, text, "must be a whole number of bytes >= 1M, such as 512M or 2G");
}

ImageSize sizeFrom(const std::string& flag, const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    const std::vector<std::int64_t> sides = wholes(parts, 1, kMostSide);
    if (sides.size() != 2) refuseValue(flag, text, "must be WxH in whole pixels, such as 640x480");
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

Crop cropFrom(const std::string& flag, const std::string& text) {
    const std::vector<std::int64_t> ends = wholes(split(text, ','), -kMostSide, kMostSide);
    if (ends.size() != 4) {
        refuseValue(flag, text, "must be x0,y0,x1,y1 in whole pixels, such as 0,0,320,240");
    }
    if (ends[0] >= ends[2] || ends[1] >= ends[3]) {
        refuseValue(flag, text, "is empty; it needs x0 < x1 and y0 < y1");
    }
    return {static_cast<int>(ends[0]), static_cast<int>(ends[1]), static_cast<int>(ends[2]),
            static_cast<int>(ends[3])};
}

PixelPlace pixelFrom(const std::string& flag, const std::string& text) {
    const std::vector<std::int64_t> numbers = wholes(split(text, ','), 0, kMostSide);
    if (numbers.size() != 2) {
        refuseValue(flag, text,
                    "must be x,y in whole pixels from the upper left corner, such as 0,0");
    }
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

FrameRange framesFrom(const std::string& flag, const std::string& text) {
    constexpr std::int64_t kMostFrame = std::int64_t{1} << 53;
    std::vector<std::int64_t> ends = wholes(split(text, '-'), 0, kMostFrame);
    if (ends.size() == 1) ends.push_back(ends[0]);
    if (ends.size() != 2 || ends[0] > ends[1]) {
        refuseValue(flag, text, "must be A-B with whole numbers 0 <= A <= B, such as 1-100");
    }
    if (ends[1] - ends[0] >= kMostFrames) {
        throw LimitError(flag + " " + text + ": more than " + std::to_string(kMostFrames) +
                         " frames in one run; ask for them in parts");
    }
    return {ends[0], ends[1]};
}

Shard shardFrom(const std::string& flag, const std::string& text) {
    const std::vector<std::int64_t> parts = wholes(split(text, '/'), 1, kMostShards);
    if (parts.size() != 2 || parts[0] > parts[1]) {
        refuseValue(flag, text,
                    "must be i/n with whole numbers 1 <= i <= n <= " + std::to_string(kMostShards));
    }
    return {static_cast<int>(parts[0]), static_cast<int>(parts[1])};
}

std::vector<Aov> aovsFrom(const std::string& flag, const std::string& text) {
    std::set<Aov> aovs;
    for (const std::string& name : split(text, ',')) {
        aovs.insert(static_cast<Aov>(wordFrom(flag, name, aovNames())));
    }
    return {aovs.begin(), aovs.end()};
}

std::pair<std::string, std::string> parameterFrom(const std::string& flag,
                                                  const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) refuseValue(flag, text, "must be name=value");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::size_t wordFrom(const std::string& flag, const std::string& text,
                     const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == text) return i;
    }
    const std::string nearest = nearestName(text, words);
    refuseValue(flag, text,
                "must be one of " + joined(words) +
                    (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

void storeShared(const OptionRow& row, const std::string& text, RenderOptions& options) {
    const OptionValue value = sharedValue(row, text);
    const std::string right = checkOption(row, value);
    if (!right.empty()) refuseValue("--" + std::string(row.name), text, right);
    row.store(options, value);
}

}  // namespace rt
