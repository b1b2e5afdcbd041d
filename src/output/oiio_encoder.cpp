#include "rt/core/error.h"
#include "rt/image/oiio_library.h"

#include <array>
#include <memory>

#include "encoders.h"

namespace rt {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

std::vector<std::uint8_t> encode(const char* format, const PixelImage& image, int storage,
                                 void* samples, const Entries& metadata) {
    const OiioLibrary& library = oiioLibrary();
    if (!library) throw OutputError(library.problem);
    std::vector<RtOiioEntry> entries;
    for (const auto& [keyword, text] : metadata) entries.push_back({keyword.c_str(), text.c_str()});
    const RtOiioImage raw{image.width, image.height, 3, storage, samples};
    void* bytes = nullptr;
    std::size_t count = 0;
    std::array<char, 1024> words{};
    const int status = library.write(format, &raw, entries.data(), entries.size(), &bytes, &count,
                                     words.data(), words.size());
    const std::unique_ptr<void, RtOiioFree*> owner(bytes, library.free);
    if (status != kRtOiioDone) {
        throw OutputError(std::string("the image cannot be encoded: ") + words.data());
    }
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    return {first, first + count};
}

/// TIFF has a fixed list of tags: what is not among them goes into its description.
Entries tiffEntries(const ImageMetadata& metadata) {
    Entries entries;
    std::string description;
    for (const auto& [keyword, text] : metadataEntries(metadata)) {
        if (keyword == "Software") {
            entries.emplace_back(keyword, text);
        } else {
            description += (description.empty() ? "" : "; ") + keyword + ": " + text;
        }
    }
    entries.emplace_back("ImageDescription", description);
    return entries;
}

std::vector<std::uint8_t> encodeFloats(const char* format, const PixelImage& image,
                                       const ImageMetadata& metadata) {
    std::vector<float> values = asFloats(image);
    return encode(format, image, kRtOiioFloat, values.data(), metadataEntries(metadata));
}

}  // namespace

void requirePlugin() {
    const OiioLibrary& library = oiioLibrary();
    if (!library) throw OutputError(library.problem);
}

std::vector<std::uint8_t> encodeExr(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata& metadata) {
    return encodeFloats("openexr", image, metadata);
}

std::vector<std::uint8_t> encodeHdr(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata& metadata) {
    return encodeFloats("hdr", image, metadata);
}

std::vector<std::uint8_t> encodeTiff(const PixelImage& image, const ImageSettings& settings,
                                     const ImageMetadata& metadata) {
    const Entries entries = tiffEntries(metadata);
    if (settings.bits == 16) {
        std::vector<std::uint16_t> values = quantized16(image, settings.transfer);
        return encode("tiff", image, kRtOiioU16, values.data(), entries);
    }
    std::vector<std::uint8_t> values = quantized8(image, settings.transfer);
    return encode("tiff", image, kRtOiioU8, values.data(), entries);
}

}  // namespace rt
