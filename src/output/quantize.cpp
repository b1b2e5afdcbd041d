#include "rt/math/portable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "encoders.h"

namespace rt {
namespace {

// The two branches of the curve meet here (IEC 61966-2-1:1999).
constexpr double kLinearEnd = 0.0031308;

// Where sRGB integers change: entry k is the least linear value that rounds above k.
using Thresholds = std::array<double, 255>;

double linearFromSrgb(double encoded) {
    if (encoded <= 12.92 * kLinearEnd) return encoded / 12.92;
    return portable::pow((encoded + 0.055) / 1.055, 2.4);
}

/// One table instead of a power for each channel of each pixel.
const Thresholds& srgbThresholds() {
    static const Thresholds table = [] {
        Thresholds made{};
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k] = linearFromSrgb((static_cast<double>(k) + 0.5) / 255.0);
        }
        return made;
    }();
    return table;
}

std::uint8_t srgb8(double value) {
    const Thresholds& table = srgbThresholds();
    return static_cast<std::uint8_t>(std::upper_bound(table.begin(), table.end(), value) -
                                     table.begin());
}

double clamped(double value) {
    return std::min(std::max(value, 0.0), 1.0);
}

template <class Integer, class Convert>
std::vector<Integer> channels(const PixelImage& image, Convert convert) {
    std::vector<Integer> all;
    all.reserve(image.pixels.size() * 3);
    for (const Color& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) all.push_back(static_cast<Integer>(convert(pixel[c])));
    }
    return all;
}

}  // namespace

double srgbFromLinear(double linear) {
    if (linear <= kLinearEnd) return 12.92 * linear;
    return 1.055 * portable::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<std::uint8_t> quantized8(const PixelImage& image, Transfer transfer) {
    if (transfer == Transfer::kSrgb) return channels<std::uint8_t>(image, srgb8);
    return channels<std::uint8_t>(image, [](double v) { return std::round(255.0 * clamped(v)); });
}

std::vector<std::uint16_t> quantized16(const PixelImage& image, Transfer transfer) {
    const bool srgb = transfer == Transfer::kSrgb;
    return channels<std::uint16_t>(image, [srgb](double v) {
        const double inRange = clamped(v);
        return std::round(65535.0 * (srgb ? srgbFromLinear(inRange) : inRange));
    });
}

std::vector<float> asFloats(const PixelImage& image) {
    const double kMost = std::numeric_limits<float>::max();
    return channels<float>(image, [kMost](double v) { return std::clamp(v, -kMost, kMost); });
}

}  // namespace rt
