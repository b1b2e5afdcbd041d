#include "rt/output/image_writer.h"

#include "rt/core/error.h"
#include "rt/core/text.h"
#include "rt/core/version.h"
#include "rt/output/atomic_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "encoders.h"

namespace rt {
namespace {

constexpr std::int64_t kMostInt = 0x7fffffff;

// A PNG's pixels lie in one chunk of at most 2^31 - 1 bytes; deflate may add this much to what it
// cannot compress, a stored block's 5 bytes for every 16383, and the filter bytes.
constexpr std::int64_t kMostPngBytes = kMostInt - kMostInt / 1024;

// TIFF's offsets have 32 bits; the header and the directory need some of them.
constexpr std::int64_t kMostTiffBytes = 0xffffffffll - 0xfffff;

std::string lowerCase(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

std::string extensionOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    const std::size_t slash = path.rfind('/');
    const std::size_t nameStart = slash == std::string::npos ? 0 : slash + 1;
    if (dot == std::string::npos || dot < nameStart) return "";
    return lowerCase(path.substr(dot));
}

std::string knownExtensions() {
    std::string all;
    for (const ImageFormat& format : imageFormats()) {
        all += (all.empty() ? "" : ", ") + std::string(format.extension);
    }
    return all;
}

void requireFinite(const PixelImage& image) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Color& p = image.pixels[i];
        if (std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b)) continue;
        const auto width = static_cast<std::size_t>(image.width);
        throw std::logic_error("pixel " + std::to_string(i % width) + "," +
                               std::to_string(i / width) + " of a finished image is not finite: " +
                               shortest(p.r) + " " + shortest(p.g) + " " + shortest(p.b));
    }
}

}  // namespace

const std::vector<ImageFormat>& imageFormats() {
    static const std::vector<ImageFormat> table = {
        {".png", "8 or 16 bits", false, kMostPngBytes, kMostInt, false, encodePng},
        {".exr", "the values as 32-bit floats", true, INT64_MAX, kMostInt, true, encodeExr},
        {".hdr", "the values with a shared exponent, 8 bits", true, INT64_MAX, kMostInt, true,
         encodeHdr},
        {".tif", "8 or 16 bits", false, kMostTiffBytes, kMostInt, true, encodeTiff},
        {".tiff", "8 or 16 bits", false, kMostTiffBytes, kMostInt, true, encodeTiff},
        {".pfm", "the values as 32-bit floats", true, INT64_MAX, kMostInt, false, encodePfm},
    };
    return table;
}

const ImageFormat& imageFormatOf(const std::string& path) {
    const std::string extension = extensionOf(path);
    const std::vector<ImageFormat>& formats = imageFormats();
    const auto found = std::find_if(formats.begin(), formats.end(), [&](const ImageFormat& format) {
        return format.extension == extension;
    });
    if (found != formats.end()) return *found;
    if (isStream(path)) return formats.front();
    const std::string reason =
        extension.empty() ? "has no extension" : "has the unknown extension " + extension;
    throw OutputError(path + ": the name of the image " + reason +
                      "; available: " + knownExtensions());
}

bool holdsFloats(const std::string& path) {
    return imageFormatOf(path).floats;
}

void checkImageOutput(const std::string& path, int width, int height,
                      const ImageSettings& settings) {
    const ImageFormat& format = imageFormatOf(path);
    const std::int64_t perChannel = format.floats ? 4 : settings.bits / 8;
    const double bytes = 3.0 * static_cast<double>(perChannel) * width * height;
    if (width > format.mostLength || height > format.mostLength ||
        bytes > static_cast<double>(format.mostBytes)) {
        throw OutputError(path + ": " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels are more than a " + format.extension +
                          " file can hold; use .exr or --crop");
    }
    if (format.throughPlugin) requirePlugin();
    checkWritable(path);
}

std::vector<std::pair<std::string, std::string>> metadataEntries(const ImageMetadata& metadata) {
    std::vector<std::pair<std::string, std::string>> entries = {
        {"Software", std::string(kProgramName) + " " + kProgramVersion},
        {"Scene", metadata.scene},
        {"Seed", std::to_string(metadata.seed)},
        {"Samples per pixel", shortest(metadata.samplesPerPixel)},
    };
    if (metadata.error) entries.emplace_back("Estimated RMSE", shortest(*metadata.error));
    return entries;
}

std::vector<std::uint8_t> encodeImage(const ImageFormat& format, const PixelImage& image,
                                      const ImageSettings& settings,
                                      const ImageMetadata& metadata) {
    requireFinite(image);
    return format.encode(image, settings, metadata);
}

std::string writeImage(const std::string& path, const PixelImage& image,
                       const ImageSettings& settings, const ImageMetadata& metadata) {
    return writeFile(path, encodeImage(imageFormatOf(path), image, settings, metadata));
}

std::string numberedName(const std::string& pattern, std::int64_t number) {
    std::string name;
    for (std::size_t i = 0; i < pattern.size();) {
        std::size_t run = 0;
        while (i + run < pattern.size() && pattern[i + run] == '#') ++run;
        const std::string digits = std::to_string(number);
        if (run > digits.size()) name.append(run - digits.size(), '0');
        name += run > 0 ? digits : std::string(1, pattern[i]);
        i += std::max<std::size_t>(run, 1);
    }
    return name;
}

}  // namespace rt
