#include "image_readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace rt {
namespace {

using namespace std::string_view_literals;

struct Format {
    std::string_view name;
    const char* reader;  ///< OpenImageIO's name; null for lodepng
    std::array<std::string_view, 3> extensions;
    std::array<std::string_view, 4> magic;  ///< what such files begin with
};

// TGA has no magic bytes, and is known by its shape.
constexpr std::array<Format, 7> kFormats = {{
    {"PNG", nullptr, {".png"}, {"\x89PNG\r\n\x1a\n"}},
    {"JPEG", "jpeg", {".jpg", ".jpeg", ".jpe"}, {"\xff\xd8\xff"}},
    {"EXR", "openexr", {".exr"}, {"\x76\x2f\x31\x01"}},
    {"HDR", "hdr", {".hdr", ".rgbe", ".pic"}, {"#?RADIANCE", "#?RGBE"}},
    {"TIFF", "tiff", {".tif", ".tiff"}, {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}},
    {"BMP", "bmp", {".bmp"}, {"BM"}},
    {"TGA", "targa", {".tga"}, {}},
}};

/// Truevision TGA File Format Specification 2.0, 1991: the fields of its header that have few
/// possible values.
bool looksLikeTga(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < 18) return false;
    const std::uint8_t kind = bytes[2];
    const std::uint8_t bits = bytes[16];
    const bool kindKnown = (1 <= kind && kind <= 3) || (9 <= kind && kind <= 11);
    const bool bitsKnown = bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32;
    const bool sized = (bytes[12] | bytes[13]) != 0 && (bytes[14] | bytes[15]) != 0;
    return bytes[1] <= 1 && kindKnown && bitsKnown && sized;
}

const Format* formatOf(std::span<const std::uint8_t> bytes) {
    const std::string_view start(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const Format& format : kFormats) {
        for (const std::string_view magic : format.magic) {
            if (!magic.empty() && start.substr(0, magic.size()) == magic) return &format;
        }
    }
    return looksLikeTga(bytes) ? &kFormats.back() : nullptr;
}

std::string extensionOf(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string extension = path.substr(dot);
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

void warnOfExtension(const Format& format, const std::string& path, Diagnostics& diagnostics) {
    const std::string extension = extensionOf(path);
    const auto& own = format.extensions;
    if (extension.empty() || std::find(own.begin(), own.end(), extension) != own.end()) return;
    diagnostics.warn("image-extension", {path, 0},
                     "the file is a " + std::string(format.name) + ", whatever its name says");
}

void cleanFloats(Image& image, const std::string& path, Diagnostics& diagnostics) {
    std::vector<float>* const samples = std::get_if<std::vector<float>>(&image.samples);
    if (samples == nullptr) return;
    std::size_t bad = 0;
    for (float& sample : *samples) {
        if (sample >= 0.0f && sample <= std::numeric_limits<float>::max()) continue;
        sample = 0.0f;
        ++bad;
    }
    if (bad == 0) return;
    diagnostics.warn("image-values", {path, 0},
                     std::to_string(bad) + (bad == 1 ? " value is" : " values are") +
                         " negative or not finite, and taken as 0");
}

}  // namespace

void checkSize(std::uint64_t width, std::uint64_t height, const std::string& path,
               const ImageLimits& limits) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width == 0 || height == 0)
        throw SceneError("the image has no pixels (" + size + ")", {path, 0});
    if (width <= INT32_MAX && height <= INT32_MAX && width * height <= limits.maxPixels) return;
    throw LimitError("the image has " + size + " pixels; " + limits.option + " allows " +
                         std::to_string(limits.maxPixels),
                     {path, 0});
}

Image loadImage(const std::string& path, const ImageLimits& limits, Diagnostics& diagnostics) {
    InputFile file(path);
    std::array<std::uint8_t, 64> start{};
    const std::size_t got = file.read(start.data(), start.size());
    const Format* const format = formatOf({start.data(), got});
    if (format == nullptr) {
        throw SceneError(
            "not an image of a kind that is read here: PNG, JPEG, EXR, HDR, TIFF, TGA "
            "or BMP",
            {path, 0});
    }
    warnOfExtension(*format, path, diagnostics);
    if (format->reader == nullptr) return readPng(InputFile(path).readAll(), path, limits);
    Image image = readThroughOiio(path, format->reader, limits, oiioLibrary());
    if (!limits.keepAllValues) cleanFloats(image, path, diagnostics);
    return image;
}

}  // namespace rt
