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
    for (const ImagePlane& plane : image.planes) {
        for (const float value : plane.values) {
            if (!std::isnan(value)) continue;
            throw std::logic_error("a finished image has a value of " + plane.name +
                                   " that is no number");
        }
    }
}

}  // namespace

const std::vector<ImageFormat>& imageFormats() {
    static const std::vector<ImageFormat> table = {
        {".png", "8 or 16 bits", false, false, kMostPngBytes, kMostInt, false, encodePng},
        {".exr", "the values as 32-bit floats", true, true, INT64_MAX, kMostInt, true, encodeExr},
        {".hdr", "the values with a shared exponent, 8 bits", true, false, INT64_MAX, kMostInt,
         true, encodeHdr},
        {".tif", "8 or 16 bits", false, false, kMostTiffBytes, kMostInt, true, encodeTiff},
        {".tiff", "8 or 16 bits", false, false, kMostTiffBytes, kMostInt, true, encodeTiff},
        {".pfm", "the values as 32-bit floats", true, false, INT64_MAX, kMostInt, false, encodePfm},
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

std::vector<std::string> namesOf(const std::vector<ImagePlane>& planes) {
    std::vector<std::string> names;
    for (const ImagePlane& plane : planes) names.push_back(plane.name);
    return names;
}

std::vector<std::string> imageFiles(const std::string& path,
                                    const std::vector<std::string>& planes) {
    std::vector<std::string> files;
    if (!planes.empty() && isStream(path)) {
        throw UsageError(path + ": more images than one need a file with a name; give -o a name");
    }
    if (!imageFormatOf(path).layers) {
        const std::string stem = path.substr(0, path.size() - extensionOf(path).size());
        for (const std::string& plane : planes) files.push_back(stem + "." + plane + ".pfm");
    }
    files.push_back(path);
    return files;
}

void checkImageOutput(const std::string& path, int width, int height, const ImageSettings& settings,
                      const std::vector<std::string>& planes) {
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
    for (const std::string& file : imageFiles(path, planes)) checkWritable(file);
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
    const std::vector<std::uint8_t> bytes =
        encodeImage(imageFormatOf(path), image, settings, metadata);
    const std::vector<std::string> files = imageFiles(path, namesOf(image.planes));
    std::string warnings;
    const auto write = [&](const std::string& file, const std::vector<std::uint8_t>& content) {
        const std::string warning = writeFile(file, content);
        if (!warning.empty()) warnings += (warnings.empty() ? "" : "; ") + warning;
    };
    for (std::size_t i = 0; i + 1 < files.size(); ++i) {
        write(files[i], encodePfm(image.planes[i], image.width));
    }
    write(path, bytes);
    return warnings;
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
