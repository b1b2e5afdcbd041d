#include "image_readers.h"

#include <array>
#include <memory>

namespace rt {
namespace {

template <typename Sample>
std::vector<Sample> copied(const RtOiioImage& image) {
    const Sample* const first = static_cast<const Sample*>(image.samples);
    const std::size_t count = static_cast<std::size_t>(image.width) *
                              static_cast<std::size_t>(image.height) *
                              static_cast<std::size_t>(image.channels);
    return std::vector<Sample>(first, first + count);
}

}  // namespace

Image readThroughOiio(const std::string& path, const char* format, const ImageLimits& limits,
                      const OiioLibrary& library) {
    if (!library) throw SceneError(library.problem, {path, 0});

    RtOiioImage raw{};
    std::array<char, 1024> words{};
    const int status =
        library.read(path.c_str(), format, limits.maxPixels, &raw, words.data(), words.size());
    const std::unique_ptr<void, RtOiioFree*> owner(raw.samples, library.free);
    if (status == kRtOiioTooLarge) {
        checkSize(static_cast<std::uint64_t>(raw.width), static_cast<std::uint64_t>(raw.height),
                  path, limits);
    }
    if (status != kRtOiioDone) {
        throw SceneError("cannot be read: " + printable(words.data(), words.size()), {path, 0});
    }
    Image image{raw.width, raw.height, raw.channels, {}};
    if (raw.storage == kRtOiioU8) image.samples = copied<std::uint8_t>(raw);
    if (raw.storage == kRtOiioU16) image.samples = copied<std::uint16_t>(raw);
    if (raw.storage == kRtOiioFloat) image.samples = copied<float>(raw);
    return image;
}

}  // namespace rt
