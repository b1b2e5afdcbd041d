#include "image_difference.h"

#include "rt/core/error.h"
#include "rt/core/input_file.h"
#include "rt/core/numeric.h"
#include "rt/core/text.h"
#include "rt/image/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

namespace rt {
namespace {

constexpr std::string_view kPfmMagic = "PF\n";

/// Reads the words of a PFM's header one after another.
class PfmHeader {
  public:
    explicit PfmHeader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

    std::string word() {
        std::string text;
        while (position_ < bytes_.size() && !isBlank(bytes_[position_])) {
            text += static_cast<char>(bytes_[position_++]);
        }
        ++position_;
        return text;
    }
    std::size_t position() const { return position_; }

  private:
    static bool isBlank(std::uint8_t c) { return c == ' ' || c == '\n'; }

    const std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

/// The float maps that this program writes: three channels, little endian, bottom row first.
PixelImage readPfm(const std::vector<std::uint8_t>& bytes, const std::string& path) {
    PfmHeader header(bytes);
    header.word();
    const auto width = wholeNumber<int>(header.word());
    const auto height = wholeNumber<int>(header.word());
    const auto scale = wholeNumber<double>(header.word());
    if (!width || !height || !scale || *width < 1 || *height < 1 || !(*scale < 0.0)) {
        throw SceneError("not a little-endian PFM file", {path, 0});
    }
    const auto pixels = static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
    if (bytes.size() - std::min(header.position(), bytes.size()) != pixels * 3 * sizeof(float)) {
        throw SceneError("the PFM file is not as long as its header says", {path, 0});
    }
    PixelImage image{*width, *height, std::vector<Color>(pixels)};
    const std::uint8_t* next = bytes.data() + header.position();
    for (int y = *height - 1; y >= 0; --y) {
        for (int x = 0; x < *width; ++x) {
            for (int c = 0; c < 3; ++c, next += 4) {
                const std::uint32_t word = next[0] | (std::uint32_t{next[1]} << 8) |
                                           (std::uint32_t{next[2]} << 16) |
                                           (std::uint32_t{next[3]} << 24);
                image.at(x, y)[c] = std::bit_cast<float>(word);
            }
        }
    }
    return image;
}

/// The step between neighbouring values of integers that stand for 0 .. 1; 0 for floats.
template <class Sample>
constexpr double stepOf(const std::vector<Sample>&) {
    if constexpr (!std::is_integral_v<Sample>) return 0.0;
    return 1.0 / static_cast<double>(std::numeric_limits<Sample>::max());
}

PixelImage pixelsOf(const Image& image) {
    const auto count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    PixelImage result{image.width, image.height, std::vector<Color>(count)};
    const auto channels = static_cast<std::size_t>(image.channels);
    std::visit(
        [&](const auto& samples) {
            using Sample = typename std::decay_t<decltype(samples)>::value_type;
            constexpr double kFull = std::is_integral_v<Sample>
                                         ? static_cast<double>(std::numeric_limits<Sample>::max())
                                         : 1.0;
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const Sample sample = samples[i * channels + (channels == 1 ? 0 : c)];
                    result.pixels[i][static_cast<int>(c)] = static_cast<double>(sample) / kFull;
                }
            }
        },
        image.samples);
    return result;
}

}  // namespace

ComparedImage loadForComparison(const std::string& path) {
    InputFile file(path);
    std::array<char, kPfmMagic.size()> start{};
    const std::size_t got = file.read(start.data(), start.size());
    if (std::string_view(start.data(), got) == kPfmMagic) {
        return {readPfm(InputFile(path).readAll(), path), true, 3, 0.0};
    }
    ImageLimits limits;
    limits.maxPixels = std::numeric_limits<std::int32_t>::max();
    limits.keepAllValues = true;
    Diagnostics passedOver;
    const Image image = loadImage(path, limits, passedOver);
    const double step =
        std::visit([](const auto& samples) { return stepOf(samples); }, image.samples);
    return {pixelsOf(image), step == 0.0, image.channels, step};
}

ImageDifference differenceOf(const PixelImage& a, const PixelImage& b) {
    // Bytes that are 4 apart must not count: three roundings of numbers up to 1 lie between.
    constexpr double kOver = 4.0 / 255.0 + gamma(4);
    ImageDifference difference;
    double squares = 0.0;
    double absolutes = 0.0;
    std::size_t over = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        double largest = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double error = std::fabs(a.pixels[i][c] - b.pixels[i][c]);
            squares += error * error;
            absolutes += error;
            largest = std::max(largest, error);
        }
        if (largest > kOver) ++over;
        if (largest > difference.maxAbsolute) {
            difference.maxAbsolute = largest;
            difference.maxX = static_cast<int>(i % static_cast<std::size_t>(a.width));
            difference.maxY = static_cast<int>(i / static_cast<std::size_t>(a.width));
        }
    }
    const double channels = 3.0 * static_cast<double>(a.pixels.size());
    difference.rmse = std::sqrt(squares / channels);
    difference.meanAbsolute = absolutes / channels;
    difference.shareOver = static_cast<double>(over) / static_cast<double>(a.pixels.size());
    return difference;
}

void clampValues(PixelImage& image) {
    for (Color& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) pixel[c] = std::clamp(pixel[c], 0.0, 1.0);
    }
}

bool hasNonFinite(const PixelImage& image) {
    return std::any_of(image.pixels.begin(), image.pixels.end(), [](const Color& p) {
        return !std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b);
    });
}

}  // namespace rt
