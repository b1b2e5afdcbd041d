#include "rt/math/portable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "encoders.h"

namespace rt {
namespace {

// The two branches of the curve meet here (IEC 61966-2-1:1999).
constexpr double kLinearEnd = 0.0031308;

double linearFromSrgb(double encoded) {
    if (encoded <= 12.92 * kLinearEnd) return encoded / 12.92;
    return portable::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The byte of a linear value in [0,1] without a power for each: bytes change at 255 thresholds,
/// and a table says with which byte the search for them begins.
class SrgbBytes {
  public:
    SrgbBytes() {
        for (std::size_t k = 0; k < thresholds_.size(); ++k) {
            thresholds_[k] = linearFromSrgb((static_cast<double>(k) + 0.5) / 255.0);
        }
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            const double start = static_cast<double>(i) / kBuckets;
            const auto above = std::upper_bound(thresholds_.begin(), thresholds_.end(), start);
            firsts_[i] = static_cast<std::uint8_t>(above - thresholds_.begin());
        }
    }

    std::uint8_t operator()(double value) const {
        std::size_t byte = firsts_[static_cast<std::size_t>(value * kBuckets)];
        while (byte < thresholds_.size() && value >= thresholds_[byte]) ++byte;
        return static_cast<std::uint8_t>(byte);
    }

  private:
    // The curve is steepest at 0, where 255 * 12.92 bytes a unit are one or two in a bucket.
    static constexpr int kBuckets = 2048;

    std::array<double, 255> thresholds_{};
    std::array<std::uint8_t, kBuckets + 1> firsts_{};
};

double clamped(double value) {
    return std::min(std::max(value, 0.0), 1.0);
}

/// The nearest integer to a value >= 0, halves upwards; exact, for the difference is.
template <class Integer>
Integer rounded(double value) {
    const auto whole = static_cast<unsigned>(value);
    return static_cast<Integer>(whole + (value - whole >= 0.5 ? 1u : 0u));
}

template <class Number, class Convert>
std::vector<Number> channels(const PixelImage& image, Convert convert) {
    std::vector<Number> all(image.pixels.size() * 3);
    Number* next = all.data();
    for (const Color& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) *next++ = convert(pixel[c]);
    }
    return all;
}

}  // namespace

double srgbFromLinear(double linear) {
    if (linear <= kLinearEnd) return 12.92 * linear;
    return 1.055 * portable::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<std::uint8_t> quantized8(const PixelImage& image, Transfer transfer) {
    if (transfer == Transfer::kSrgb) {
        static const SrgbBytes bytes;
        return channels<std::uint8_t>(image, [](double v) { return bytes(clamped(v)); });
    }
    return channels<std::uint8_t>(
        image, [](double v) { return rounded<std::uint8_t>(255.0 * clamped(v)); });
}

std::vector<std::uint16_t> quantized16(const PixelImage& image, Transfer transfer) {
    const bool srgb = transfer == Transfer::kSrgb;
    return channels<std::uint16_t>(image, [srgb](double v) {
        const double inRange = clamped(v);
        return rounded<std::uint16_t>(65535.0 * (srgb ? srgbFromLinear(inRange) : inRange));
    });
}

std::vector<float> asFloats(const PixelImage& image) {
    const double kMost = std::numeric_limits<float>::max();
    return channels<float>(
        image, [kMost](double v) { return static_cast<float>(std::clamp(v, -kMost, kMost)); });
}

}  // namespace rt
