#include <bit>

#include "encoders.h"

namespace rt {

// Portable float map (P. Debevec): "PF", the size, a scale whose sign says little endian, then
// floats from the bottom row to the top. It has no room for metadata.
std::vector<std::uint8_t> encodePfm(const PixelImage& image, const ImageSettings&,
                                    const ImageMetadata&) {
    const std::string header =
        "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    const std::vector<float> values = asFloats(image);
    const std::size_t rowLength = static_cast<std::size_t>(image.width) * 3;
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

}  // namespace rt
