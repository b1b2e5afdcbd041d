#include "scene_hash.h"

#include "rt/core/error.h"
#include "rt/core/input_file.h"
#include "rt/core/text.h"
#include "rt/core/version.h"

#include <algorithm>
#include <vector>

namespace rt {
namespace {

/// Sorted, so that folders' names do not matter.
std::vector<std::uint64_t> hashesOf(const std::vector<std::string>& files) {
    std::vector<std::uint64_t> hashes;
    for (const std::string& file : files) {
        hashes.push_back(Fingerprint().add(InputFile(file).readAll()).value());
    }
    std::sort(hashes.begin(), hashes.end());
    return hashes;
}

std::string textOf(const OptionValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* number = std::get_if<double>(&value)) return shortest(*number);
    return std::get<bool>(value) ? "true" : "false";
}

}  // namespace

void Fingerprint::mix(std::uint8_t byte) {
    value_ = (value_ ^ byte) * 0x100000001b3;
}

Fingerprint& Fingerprint::add(std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8) mix(static_cast<std::uint8_t>(number >> shift));
    return *this;
}

Fingerprint& Fingerprint::add(std::span<const std::uint8_t> bytes) {
    add(bytes.size());
    for (const std::uint8_t byte : bytes) mix(byte);
    return *this;
}

Fingerprint& Fingerprint::add(std::string_view text) {
    return add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::uint64_t sceneHash(const Options& options, const RenderOptions& merged,
                        const ScriptResult& script, std::size_t render, std::int64_t frame) {
    if (script.scene.name == "-") {
        throw SceneError(
            "a scene from standard input cannot be told from others later; put it "
            "into a file");
    }
    Fingerprint all;
    all.add(kProgramVersion);
    for (const std::uint64_t hash : hashesOf(script.filesRead)) all.add(hash);
    for (const std::string& argument : options.scriptArguments) all.add(argument);
    for (const auto& [name, value] : options.parameters) all.add(name).add(value);
    const FrameRange frames = options.frames.value_or(FrameRange{});
    for (const std::int64_t number : {frame, frames.first, frames.last}) {
        all.add(static_cast<std::uint64_t>(number));
    }
    const ImageSize size = options.size.value_or(ImageSize{});
    for (const int number : {size.width, size.height, options.legacyTransforms ? 1 : 0}) {
        all.add(static_cast<std::uint64_t>(number));
    }
    for (const OptionRow& row : optionTable()) {
        const std::optional<OptionValue> value = row.load(merged);
        all.add(row.name).add(value ? textOf(*value) : "");
    }
    all.add(render);
    return all.value();
}

}  // namespace rt
