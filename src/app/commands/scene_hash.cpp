#include "scene_hash.h"

#include "rt/core/error.h"
#include "rt/core/input_file.h"
#include "rt/core/text.h"
#include "rt/core/version.h"

#include <algorithm>
#include <optional>

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

std::vector<Trait> traitsOf(const Options& options, const RenderOptions& merged,
                            const ScriptResult& script, std::size_t render, std::int64_t frame) {
    if (script.scene.name == "-") {
        throw SceneError(
            "a scene from standard input cannot be told from others later; put it "
            "into a file");
    }
    Fingerprint files;
    for (const std::uint64_t hash : hashesOf(script.filesRead)) files.add(hash);
    Fingerprint arguments;
    for (const std::string& argument : options.scriptArguments) arguments.add(argument);
    const FrameRange frames = options.frames.value_or(FrameRange{});
    const ImageSize size = options.size.value_or(ImageSize{});
    std::vector<Trait> traits{
        {"the program's version", kProgramVersion},
        {"the scene's files", std::to_string(files.value())},
        {"the script's arguments", std::to_string(arguments.value())},
        {"the frame", std::to_string(frame)},
        {"--frames", std::to_string(frames.first) + "-" + std::to_string(frames.last)},
        {"--size", std::to_string(size.width) + "x" + std::to_string(size.height)},
        {"--legacy-transforms", options.legacyTransforms ? "true" : "false"},
        {"the number of the render", std::to_string(render)}};
    for (const auto& [name, value] : options.parameters) traits.push_back({"-D " + name, value});
    for (const OptionRow& row : optionTable()) {
        const std::optional<OptionValue> value = row.load(merged);
        traits.push_back({"--" + std::string(row.name), value ? textOf(*value) : ""});
    }
    return traits;
}

std::vector<Trait> partTraitsOf(const Options& options) {
    const Crop crop = options.crop.value_or(Crop{});
    std::string corners;
    for (const int number : {crop.x0, crop.y0, crop.x1, crop.y1}) {
        corners += (corners.empty() ? "" : ",") + std::to_string(number);
    }
    const Shard shard = options.shard.value_or(Shard{});
    return {{"--crop", options.crop ? corners : ""},
            {"--shard", std::to_string(shard.index) + "/" + std::to_string(shard.count)}};
}

std::uint64_t sceneHash(const std::vector<Trait>& traits) {
    Fingerprint all;
    for (const Trait& trait : traits) all.add(trait.name).add(trait.value);
    return all.value();
}

}  // namespace rt
