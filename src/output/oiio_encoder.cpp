#include "rt/core/error.h"
#include "rt/image/oiio_library.h"

#include <array>
#include <memory>

#include "encoders.h"

namespace rt {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

std::vector<std::uint8_t> encode(const char* format, const PixelImage& image, int storage,
                                 void* samples, const Entries& metadata,
                                 const std::vector<std::string>& channels = {"R", "G", "B"}) {
    const OiioLibrary& library = oiioLibrary();
    if (!library) throw OutputError(library.problem);
    std::vector<RtOiioEntry> entries;
    for (const auto& [keyword, text] : metadata) entries.push_back({keyword.c_str(), text.c_str()});
    std::vector<const char*> names;
    for (const std::string& channel : channels) names.push_back(channel.c_str());
    const RtOiioImage raw{image.width, image.height, static_cast<int>(names.size()),
                          storage,     samples,      names.data()};
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

/// The channels of the image and of all its planes, side by side.
std::vector<float> withPlanes(const PixelImage& image, std::size_t channels) {
    const std::vector<float> colors = asFloats(image);
    std::vector<float> values(image.pixels.size() * channels);
    std::size_t first = 0;
    const auto place = [&](const std::vector<float>& from, std::size_t count) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            values[i / count * channels + first + i % count] = from[i];
        }
        first += count;
    };
    place(colors, 3);
    for (const ImagePlane& plane : image.planes) place(plane.values, plane.channels.size());
    return values;
}

}  // namespace

void requirePlugin() {
    const OiioLibrary& library = oiioLibrary();
    if (!library) throw OutputError(library.problem);
}

std::vector<std::uint8_t> encodeExr(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata& metadata) {
    std::vector<std::string> channels = {"R", "G", "B"};
    for (const ImagePlane& plane : image.planes) {
        for (const std::string& channel : plane.channels) {
            channels.push_back(plane.name + "." + channel);
        }
    }
    std::vector<float> values = withPlanes(image, channels.size());
    return encode("openexr", image, kRtOiioFloat, values.data(), metadataEntries(metadata),
                  channels);
}

std::vector<std::uint8_t> encodeHdr(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata& metadata) {
    std::vector<float> values = asFloats(image);
    return encode("hdr", image, kRtOiioFloat, values.data(), metadataEntries(metadata));
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
