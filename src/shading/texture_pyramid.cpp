#include "rt/shading/texture.h"
#include "texel_cell.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

// A footprint spans at least so many texels of its level, so that the texels' own extent adds
// little to it, and is probed at no more points a side than kMostProbes.
constexpr double kTexelsAcross = 4.0;
constexpr double kMostProbes = 64.0;

double length(const Vec2& v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// One side of a pyramid's level: which old texels a new one covers, and how much of each.
struct Halving {
    explicit Halving(int size) : from(size), to(std::max(1, size / 2)) {}

    std::int64_t first(std::int64_t k) const { return k * from / to; }
    std::int64_t end(std::int64_t k) const { return ((k + 1) * from + to - 1) / to; }
    /// Overlap of texel i with the new texel k, as a part of the latter.
    double weight(std::int64_t i, std::int64_t k) const {
        const std::int64_t overlap =
            std::min((i + 1) * to, (k + 1) * from) - std::max(i * to, k * from);
        return static_cast<double>(overlap) / static_cast<double>(from);
    }

    std::int64_t from;
    std::int64_t to;
};

std::vector<Color> halvedRows(const std::vector<Color>& texels, const Halving& columns) {
    std::vector<Color> halved;
    for (auto row = texels.begin(); row != texels.end(); row += columns.from) {
        for (std::int64_t k = 0; k < columns.to; ++k) {
            Color sum(0.0);
            for (std::int64_t i = columns.first(k); i < columns.end(k); ++i) {
                sum += columns.weight(i, k) * row[i];
            }
            halved.push_back(sum);
        }
    }
    return halved;
}

std::vector<Color> halvedColumns(const std::vector<Color>& texels, std::int64_t width,
                                 const Halving& rows) {
    std::vector<Color> halved;
    for (std::int64_t k = 0; k < rows.to; ++k) {
        for (std::int64_t x = 0; x < width; ++x) {
            Color sum(0.0);
            for (std::int64_t j = rows.first(k); j < rows.end(k); ++j) {
                sum += rows.weight(j, k) * texels[static_cast<std::size_t>(j * width + x)];
            }
            halved.push_back(sum);
        }
    }
    return halved;
}

}  // namespace

/// The image's own texels, decoded.
std::vector<Color> Texture::decodedTexels() const {
    std::vector<Color> texels;
    for (int y = 0; y < image_.height; ++y) {
        for (int x = 0; x < image_.width; ++x) {
            const double down = (y + 0.5) / image_.height;
            texels.push_back(
                bilinear({(x + 0.5) / image_.width, settings_.flipV ? down : 1.0 - down}));
        }
    }
    return texels;
}

void Texture::buildPyramid() {
    int width = image_.width;
    int height = image_.height;
    std::vector<Color> texels = decodedTexels();
    while (width > 1 || height > 1) {
        const Halving columns(width);
        const Halving rows(height);
        texels = halvedColumns(halvedRows(texels, columns), columns.to, rows);
        width = static_cast<int>(columns.to);
        height = static_cast<int>(rows.to);
        levels_.push_back({width, height, texels});
    }
}

/// 0 is the image, k the k-th level. `a` and `b` are the footprint's sides in texels.
std::size_t Texture::levelFor(const Vec2& a, const Vec2& b) const {
    const double longer = std::max(length(a), length(b));
    const double across = longer > 0.0 ? std::fabs(a.x * b.y - a.y * b.x) / longer : 0.0;
    std::size_t level = 0;
    double texel = 1.0;
    while (level < levels_.size() &&
           (across >= 2.0 * kTexelsAcross * texel || !(longer <= kMostProbes * texel))) {
        ++level;
        texel *= 2.0;
    }
    return level;
}

Color Texture::atLevel(std::size_t number, const Vec2& uv) const {
    if (number == 0) return bilinear(uv);
    const Level& level = levels_[number - 1];
    const TexelCell cell(onImage(uv), level.width, level.height);
    const auto texel = [&](std::size_t column, std::size_t row) {
        return level.texels[row * static_cast<std::size_t>(level.width) + column];
    };
    const Color upperLeft = texel(cell.left, cell.upper);
    const Color upperRight = texel(cell.right, cell.upper);
    const Color lowerLeft = texel(cell.left, cell.lower);
    const Color lowerRight = texel(cell.right, cell.lower);
    const auto channel = [&](int c) {
        return cell.blend(upperLeft[c], upperRight[c], lowerLeft[c], lowerRight[c]);
    };
    return {channel(0), channel(1), channel(2)};
}

Color Texture::filtered(const Vec2& uv, const Vec2& duvdx, const Vec2& duvdy) const {
    const Vec2 size(image_.width, image_.height);
    const Vec2 a = duvdx * size;
    const Vec2 b = duvdy * size;
    const std::size_t level = levelFor(a, b);
    const double texel = std::ldexp(1.0, static_cast<int>(level));
    const auto probes = [&](const Vec2& side) {
        const double wanted = std::ceil(length(side) / texel);
        return wanted > 1.0 ? static_cast<int>(std::min(wanted, kMostProbes)) : 1;
    };
    const int countA = probes(a);
    const int countB = probes(b);
    Color sum(0.0);
    for (int j = 0; j < countB; ++j) {
        for (int i = 0; i < countA; ++i) {
            const double s = (i + 0.5) / countA - 0.5;
            const double t = (j + 0.5) / countB - 0.5;
            sum += atLevel(level, uv + s * duvdx + t * duvdy);
        }
    }
    return sum / static_cast<double>(countA * countB);
}

}  // namespace rt
