#include "checkpoint.h"

#include "output_names.h"
#include "rt/core/diagnostics.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rt {
namespace {

constexpr std::string_view kMagic = "RTCHECK1\n";
constexpr std::string_view kAnyMagic = "RTCHECK";
constexpr std::size_t kChecksumBytes = 8;

bool startsWith(std::span<const std::uint8_t> bytes, std::string_view start) {
    return bytes.size() >= start.size() &&
           std::equal(start.begin(), start.end(), bytes.begin(),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

std::vector<Trait> readTraits(PackedReader& from) {
    std::vector<Trait> traits;
    for (auto left = from.number<std::uint32_t>(); left > 0; --left) {
        Trait& trait = traits.emplace_back();
        trait.name = from.text();
        trait.value = from.text();
    }
    return traits;
}

const std::string* valueOf(const std::vector<Trait>& traits, const std::string& name) {
    const auto found = std::find_if(traits.begin(), traits.end(),
                                    [&](const Trait& trait) { return trait.name == name; });
    return found == traits.end() ? nullptr : &found->value;
}

std::string shownValue(const std::string* value) {
    return value && !value->empty() ? printable(*value, 100) : "not set";
}

/// Numbers that stand for something else mean nothing to anybody.
bool isShown(const std::string& name) {
    return name.starts_with("-") || name == "the frame" || name == "the program's version";
}

/// The first trait that differs, in words; "" where none does.
std::string differenceOf(const std::vector<Trait>& saved, const std::vector<Trait>& now) {
    for (const std::vector<Trait>* side : {&now, &saved}) {
        for (const auto& [name, unused] : *side) {
            const std::string* before = valueOf(saved, name);
            const std::string* after = valueOf(now, name);
            if (before && after && *before == *after) continue;
            if (!isShown(name)) return name + " are not the same";
            return name + " was " + shownValue(before) + ", and is " + shownValue(after);
        }
    }
    return "";
}

CheckpointVerdict useless(const std::string& why) {
    return {CheckpointVerdict::Kind::kUseless, why};
}

}  // namespace

std::vector<std::uint8_t> encodeCheckpoint(const std::vector<Trait>& traits, const RenderLog& log) {
    PackedWriter to;
    to.bytes().assign(kMagic.begin(), kMagic.end());
    to.word(static_cast<int>(traits.size()));
    for (const Trait& trait : traits) {
        to.text(trait.name);
        to.text(trait.value);
    }
    log.write(to);
    to.number(Fingerprint().add(to.bytes()).value());
    return std::move(to.bytes());
}

bool isCheckpoint(std::span<const std::uint8_t> bytes) {
    return startsWith(bytes, kAnyMagic);
}

CheckpointVerdict decodeCheckpoint(std::span<const std::uint8_t> bytes,
                                   const std::vector<Trait>& traits, RenderLog& log) {
    if (!isCheckpoint(bytes)) return useless("is not a checkpoint");
    if (!startsWith(bytes, kMagic)) return useless("is of another version of this program");
    const CheckpointVerdict damaged = useless("is damaged");
    if (bytes.size() < kMagic.size() + kChecksumBytes) return damaged;
    const auto body = bytes.first(bytes.size() - kChecksumBytes);
    try {
        PackedReader sum(bytes.last(kChecksumBytes));
        if (sum.number<std::uint64_t>() != Fingerprint().add(body).value()) return damaged;
        PackedReader from(body.subspan(kMagic.size()));
        const std::vector<Trait> saved = readTraits(from);
        const std::string difference = differenceOf(saved, traits);
        if (!difference.empty()) {
            const bool isOld = difference.starts_with("the program's version");
            return {isOld ? CheckpointVerdict::Kind::kUseless : CheckpointVerdict::Kind::kOther,
                    "is of another " + std::string(isOld ? "version: " : "picture: ") + difference};
        }
        log.read(from);
        return {};
    } catch (const DamagedBytes&) {
        return damaged;
    }
}

std::string checkpointName(const std::string& output) {
    return splitExtension(output).first + ".checkpoint";
}

}  // namespace rt
