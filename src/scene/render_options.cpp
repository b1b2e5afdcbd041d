#include "rt/scene/render_options.h"

#include "rt/core/ray.h"
#include "rt/core/text.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <type_traits>

namespace rt {

namespace {

constexpr double kMostSamples = 1048576;           // 2^20 a pixel
constexpr double kMostDepth = 1000000;             // a path is walked, not recursed into
constexpr double kLargestSeed = 9007199254740992;  // 2^53: whole numbers beyond are not exact

template <auto Member>
using FieldOf =
    typename std::remove_reference_t<decltype(std::declval<RenderOptions&>().*Member)>::value_type;

template <auto Member>
void store(RenderOptions& options, const OptionValue& value) {
    using Field = FieldOf<Member>;
    if constexpr (std::is_same_v<Field, int>) {
        options.*Member = static_cast<int>(std::get<double>(value));
    } else {
        options.*Member = std::get<Field>(value);
    }
}

template <auto Member>
std::optional<OptionValue> load(const RenderOptions& options) {
    using Held = std::conditional_t<std::is_same_v<FieldOf<Member>, int>, double, FieldOf<Member>>;
    if (!(options.*Member)) return std::nullopt;
    return OptionValue(static_cast<Held>(*(options.*Member)));
}

void storeBits(RenderOptions& options, const OptionValue& value) {
    options.bits = std::get<std::string>(value) == "16" ? 16 : 8;
}

std::optional<OptionValue> loadBits(const RenderOptions& options) {
    if (!options.bits) return std::nullopt;
    return OptionValue(std::to_string(*options.bits));
}

template <auto Member>
OptionRow flag(const char* name, const char* help) {
    return {name, OptionRow::Kind::kFlag, "", help, 0, 0, false, {}, store<Member>, load<Member>};
}

template <auto Member>
OptionRow integer(const char* name, const char* valueName, const char* help, double min,
                  double max) {
    const auto kind = OptionRow::Kind::kInteger;
    return {name, kind, valueName, help, min, max, false, {}, store<Member>, load<Member>};
}

template <auto Member>
OptionRow number(const char* name, const char* valueName, const char* help, double min, double max,
                 bool minExcluded) {
    const auto kind = OptionRow::Kind::kNumber;
    return {name, kind, valueName, help, min, max, minExcluded, {}, store<Member>, load<Member>};
}

template <auto Member>
OptionRow choice(const char* name, const char* help, std::vector<std::string> choices) {
    const auto kind = OptionRow::Kind::kChoice;
    return {name, kind, "NAME", help, 0, 0, false, std::move(choices), store<Member>, load<Member>};
}

std::vector<OptionRow> makeTable() {
    using O = RenderOptions;
    return {
        integer<&O::spp>("spp", "N", "exactly N samples in every pixel", 1, kMostSamples),
        number<&O::error>("error", "E", "stop when the estimated RMSE of the image is at most E", 0,
                          1, true),
        number<&O::time>("time", "S", "stop after S seconds of rendering", 0, kInfinity, true),
        integer<&O::maxSpp>("max-spp", "N", "most samples a pixel for --error", 1, kMostSamples),
        flag<&O::reference>("reference", "the slow truth, without any shortcut"),
        flag<&O::caustics>("caustics", "light that glass bends and mirrors throw, by photons"),
        choice<&O::sampler>("sampler", "where samples lie in a pixel",
                            {"joint", "jitter", "grid", "random"}),
        choice<&O::filter>("filter", "how samples become pixels",
                           {"box", "gaussian", "mitchell", "blackman-harris"}),
        integer<&O::seed>("seed", "N", "another seed gives other noise", 0, kLargestSeed),
        integer<&O::maxDepth>("max-depth", "N", "nothing is spawned at this depth of a path", 0,
                              kMostDepth),
        number<&O::cutoff>("cutoff", "C", "cut what could bring at most C", 0, 1, false),
        number<&O::smoothAngle>("smooth-angle", "D",
                                "faces within D degrees are smoothed where a mesh has no normals",
                                0, 180, false),
        {"bits",
         OptionRow::Kind::kChoice,
         "N",
         "bits a channel in a PNG",
         0,
         0,
         false,
         {"8", "16"},
         storeBits,
         loadBits},
        choice<&O::transfer>("transfer", "curve between image values and PNG values",
                             {"raw", "srgb"}),
        flag<&O::flipV>("flip-v", "v = 0 at the top of images"),
    };
}

std::string text(double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << value;
    return out.str();
}

std::string rangeText(const OptionRow& row) {
    if (row.max < kInfinity && !row.minExcluded) {
        return "in " + text(row.min) + " .. " + text(row.max);
    }
    std::string range = (row.minExcluded ? "> " : ">= ") + text(row.min);
    if (row.max < kInfinity) range += " and <= " + text(row.max);
    return range;
}

bool inRange(const OptionRow& row, double value) {
    const bool aboveMin = row.minExcluded ? value > row.min : value >= row.min;
    return aboveMin && value <= row.max && std::isfinite(value);
}

}  // namespace

RenderOptions RenderOptions::over(const RenderOptions& weaker) const {
    RenderOptions merged = weaker;
    if (spp || error || time) {
        merged.spp.reset();
        merged.error.reset();
        merged.time.reset();
    }
    for (const OptionRow& row : optionTable()) {
        if (const auto value = row.load(*this)) row.store(merged, *value);
    }
    return merged;
}

const std::vector<OptionRow>& optionTable() {
    static const std::vector<OptionRow> table = makeTable();
    return table;
}

std::string scriptSpelling(const OptionRow& row) {
    std::string name = row.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string checkOption(const OptionRow& row, const OptionValue& value) {
    switch (row.kind) {
        case OptionRow::Kind::kFlag:
            return std::holds_alternative<bool>(value) ? "" : "must be true or false";
        case OptionRow::Kind::kChoice: {
            const auto* word = std::get_if<std::string>(&value);
            for (const std::string& known : row.choices) {
                if (word && *word == known) return "";
            }
            return "must be one of " + joined(row.choices);
        }
        case OptionRow::Kind::kInteger:
        case OptionRow::Kind::kNumber:
            break;
    }
    const bool whole = row.kind == OptionRow::Kind::kInteger;
    const auto* number = std::get_if<double>(&value);
    if (number && inRange(row, *number) && (!whole || std::floor(*number) == *number)) return "";
    return (whole ? "must be a whole number " : "must be a number ") + rangeText(row);
}

}  // namespace rt
