#include <bit>

#include "encoders.h"

namespace rt {
namespace {

/// Portable float map (P. Debevec): "PF" for three channels or "Pf" for one, the size, a scale
/// whose sign says little endian, then floats from the bottom row to the top. It has no room for
/// metadata.
std::vector<std::uint8_t> encode(const char* magic, const std::vector<float>& values, int width,
                                 std::size_t rowLength) {
    const std::string header = std::string(magic) + "\n" + std::to_string(width) + " " +
                               std::to_string(values.size() / rowLength) + "\n-1.0\n";
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    bytes.reserve(bytes.size() + values.size() * sizeof(float));
    for (std::size_t start = values.size(); start > 0; start -= rowLength) {
        for (std::size_t i = start - rowLength; i < start; ++i) {
            const auto word = std::bit_cast<std::uint32_t>(values[i]);
            for (int shift = 0; shift < 32; shift += 8) {
                bytes.push_back(static_cast<std::uint8_t>((word >> shift) & 0xff));
            }
        }
    }
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> encodePfm(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata&) {
    return encode("PF", asFloats(image), image.width, static_cast<std::size_t>(image.width) * 3);
}

std::vector<std::uint8_t> encodePfm(const ImagePlane& plane, int width) {
    const auto columns = static_cast<std::size_t>(width);
    const std::size_t channels = plane.channels.size();
    if (channels == 1) return encode("Pf", plane.values, width, columns);
    if (channels == 3) return encode("PF", plane.values, width, 3 * columns);
    std::vector<float> values;
    for (std::size_t i = 0; i < plane.values.size(); i += 2) {
        values.insert(values.end(), {plane.values[i], plane.values[i + 1], 0.0F});
    }
    return encode("PF", values, width, 3 * columns);
}

}  // namespace rt
