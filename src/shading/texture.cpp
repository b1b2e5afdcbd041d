#include "rt/shading/texture.h"

#include "rt/math/portable.h"
#include "texel_cell.h"

#include <utility>

namespace rt {
namespace {

/// IEC 61966-2-1 (sRGB), 1999.
double linearFromSrgb(double value) {
    return value <= 0.04045 ? value / 12.92 : portable::pow((value + 0.055) / 1.055, 2.4);
}

std::vector<double> linearByCode(std::size_t codes) {
    std::vector<double> table(codes);
    for (std::size_t code = 0; code < codes; ++code) {
        table[code] = linearFromSrgb(static_cast<double>(code) / static_cast<double>(codes - 1));
    }
    return table;
}

/// The value of 1 in codes of each kind of sample.
double fullCode(const Image& image) {
    constexpr double kFull[] = {255.0, 65535.0, 1.0};
    return kFull[image.samples.index()];
}

/// Bilinear in what `decode` makes of each code.
template <typename Decode>
Color blend(const Image& image, const TexelCell& cell, Decode decode) {
    const auto read = [&](const auto& samples) {
        const std::size_t channels = static_cast<std::size_t>(image.channels);
        const std::size_t width = static_cast<std::size_t>(image.width);
        const auto texel = [&](std::size_t column, std::size_t row) {
            return samples.data() + (row * width + column) * channels;
        };
        const auto* const upperLeft = texel(cell.left, cell.upper);
        const auto* const upperRight = texel(cell.right, cell.upper);
        const auto* const lowerLeft = texel(cell.left, cell.lower);
        const auto* const lowerRight = texel(cell.right, cell.lower);
        const auto channel = [&](std::size_t c) {
            return cell.blend(decode(upperLeft[c]), decode(upperRight[c]), decode(lowerLeft[c]),
                              decode(lowerRight[c]));
        };
        return channels == 1 ? Color(channel(0)) : Color(channel(0), channel(1), channel(2));
    };
    return std::visit(read, image.samples);
}

Color blendCodes(const Image& image, const TexelCell& cell) {
    return blend(image, cell, [](auto code) { return static_cast<double>(code); });
}

}  // namespace

Texture::Texture(Image image, const TextureSettings& settings)
    : image_(std::move(image)), settings_(settings) {
    if (settings_.srgb && image_.samples.index() == 0) linear_ = linearByCode(256);
    if (settings_.srgb && image_.samples.index() == 1) linear_ = linearByCode(65536);
    if (settings_.prefilter) buildPyramid();
}

/// Parts of the image, from its top left, in [0,1].
Vec2 Texture::onImage(const Vec2& uv) const {
    const double v = repeated(uv.y);
    return {repeated(uv.x), settings_.flipV ? v : 1.0 - v};
}

Color Texture::bilinear(const Vec2& uv) const {
    const TexelCell cell(onImage(uv), image_.width, image_.height, settings_.heldEdges);
    if (linear_.empty()) return blendCodes(image_, cell) / fullCode(image_);
    return blend(image_, cell,
                 [this](auto code) { return linear_[static_cast<std::size_t>(code)]; });
}

Color Texture::bilinearCodes(const Vec2& uv) const {
    // 1 for 8 bits and 257 for 16: whole codes stay whole.
    const double codesPerCode = fullCode(image_) / 255.0;
    return blendCodes(image_, TexelCell(onImage(uv), image_.width, image_.height)) / codesPerCode;
}

Vec2 Texture::gradient(const Vec2& uv) const {
    const Vec2 at = onImage(uv);
    // A shift by one texel and back again is a central difference at each of the four texels.
    const auto shifted = [&](double columns, double rows) {
        const Vec2 moved(at.x + columns / image_.width, at.y + rows / image_.height);
        const TexelCell cell({repeated(moved.x), repeated(moved.y)}, image_.width, image_.height);
        return blendCodes(image_, cell).x / fullCode(image_);
    };
    const double byColumn = 0.5 * (shifted(1, 0) - shifted(-1, 0));
    const double byRow = 0.5 * (shifted(0, 1) - shifted(0, -1));
    return {byColumn * image_.width, (settings_.flipV ? byRow : -byRow) * image_.height};
}

}  // namespace rt
