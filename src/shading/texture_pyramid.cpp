#include "rt/core/ray.h"
#include "rt/shading/texture.h"
#include "texel_cell.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

// A footprint spans at least so many texels of its level on its narrow side, so that the texels'
// own extent adds little to it.
constexpr double kTexelsAcross = 8.0;
// A side has one tap for so many texels of its level, but at most kMostTaps.
constexpr double kTexelsToATap = 2.0;
constexpr double kMostTaps = 16.0;

// The plastic number's inverse and its square: the taps' places in their cells follow the sequence
// of these steps, which spreads them (Roberts, The Unreasonable Effectiveness of Quasirandom
// Sequences, 2018), lest taps at even distances meet a pattern's own.
constexpr double kStepAcross = 0.75487766624669276;
constexpr double kStepDown = 0.56984029099805327;

double length(const Vec2& v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

double fraction(double x) {
    return x - std::floor(x);
}

int tapsAlong(double texels) {
    const double wanted = std::ceil(texels / kTexelsToATap);
    return wanted > 1.0 ? static_cast<int>(std::min(wanted, kMostTaps)) : 1;
}

/// One side of a pyramid's level: which old texels a new one covers, and how much of each.
struct Halving {
    explicit Halving(int size) : from(size), to(std::max(1, size / 2)) {}

    int first(int k) const { return static_cast<int>(std::int64_t{k} * from / to); }
    int end(int k) const { return static_cast<int>((std::int64_t{k + 1} * from + to - 1) / to); }
    /// Overlap of texel i with the new texel k, as a part of the latter.
    double weight(int i, int k) const {
        const std::int64_t overlap =
            std::min(std::int64_t{i + 1} * to, std::int64_t{k + 1} * from) -
            std::max(std::int64_t{i} * to, std::int64_t{k} * from);
        return static_cast<double>(overlap) / static_cast<double>(from);
    }

    int from;
    int to;
};

/// The row of means k, of `texel(column, row)`.
template <class Texel>
std::vector<Color> halvedRow(const Halving& columns, const Halving& rows, int k, Texel texel) {
    std::vector<Color> means(static_cast<std::size_t>(columns.to), Color(0.0));
    for (int row = rows.first(k); row < rows.end(k); ++row) {
        const double down = rows.weight(row, k);
        for (int column = 0; column < columns.to; ++column) {
            Color sum(0.0);
            for (int i = columns.first(column); i < columns.end(column); ++i) {
                sum += columns.weight(i, column) * texel(i, row);
            }
            means[static_cast<std::size_t>(column)] += down * sum;
        }
    }
    return means;
}

}  // namespace

void Texture::buildPyramid() {
    const auto add = [this](int width, int height, auto texel) {
        const Halving columns(width);
        const Halving rows(height);
        Level level{columns.to, rows.to, {}};
        level.texels.reserve(static_cast<std::size_t>(columns.to) *
                             static_cast<std::size_t>(rows.to));
        for (int k = 0; k < rows.to; ++k) {
            for (const Color& c : halvedRow(columns, rows, k, texel)) {
                level.texels.push_back(
                    {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)});
            }
        }
        levels_.push_back(std::move(level));
    };
    if (image_.width == 1 && image_.height == 1) return;
    add(image_.width, image_.height, [this](int column, int row) {
        const double down = (row + 0.5) / image_.height;
        return bilinear({(column + 0.5) / image_.width, settings_.flipV ? down : 1.0 - down});
    });
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level last = levels_.back();
        add(last.width, last.height, [&last](int column, int row) {
            const auto& texel =
                last.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(last.width) +
                            static_cast<std::size_t>(column)];
            return Color(texel[0], texel[1], texel[2]);
        });
    }
}

/// 0 is the image, k the k-th level. `a` and `b` are the footprint's sides in texels.
std::size_t Texture::levelFor(const Vec2& a, const Vec2& b) const {
    const double longer = std::max(length(a), length(b));
    const double across = longer > 0.0 ? std::fabs(a.x * b.y - a.y * b.x) / longer : 0.0;
    std::size_t level = 0;
    for (double texel = 2.0; level < levels_.size() && across >= kTexelsAcross * texel;
         texel *= 2.0) {
        ++level;
    }
    return level;
}

Color Texture::atLevel(std::size_t number, const Vec2& uv) const {
    if (number == 0) return bilinear(uv);
    const Level& level = levels_[number - 1];
    const TexelCell cell(onImage(uv), level.width, level.height, settings_.heldEdges);
    const auto texel = [&](std::size_t column, std::size_t row) {
        return level.texels[row * static_cast<std::size_t>(level.width) + column];
    };
    const std::array<float, 3> upperLeft = texel(cell.left, cell.upper);
    const std::array<float, 3> upperRight = texel(cell.right, cell.upper);
    const std::array<float, 3> lowerLeft = texel(cell.left, cell.lower);
    const std::array<float, 3> lowerRight = texel(cell.right, cell.lower);
    const auto channel = [&](std::size_t c) {
        return cell.blend(upperLeft[c], upperRight[c], lowerLeft[c], lowerRight[c]);
    };
    return {channel(0), channel(1), channel(2)};
}

Color Texture::filtered(const Vec2& uv, const TextureFootprint& footprint) const {
    const Vec2 size(image_.width, image_.height);
    const Vec2 a = footprint.across * size;
    const Vec2 b = footprint.down * size;
    if (!(glm::dot(a, a) + glm::dot(b, b) < kInfinity)) return bilinear(uv);
    const std::size_t level = levelFor(a, b);
    const double texel = std::ldexp(1.0, static_cast<int>(level));
    const int across = tapsAlong(length(a) / texel);
    const int down = tapsAlong(length(b) / texel);
    if (across * down == 1) return atLevel(level, uv);
    Color sum(0.0);
    Vec2 place = footprint.phase;
    for (int j = 0; j < down; ++j) {
        for (int i = 0; i < across; ++i) {
            const double s = (i + place.x) / across - footprint.phase.x;
            const double t = (j + place.y) / down - footprint.phase.y;
            sum += atLevel(level, uv + s * footprint.across + t * footprint.down);
            place = {fraction(place.x + kStepAcross), fraction(place.y + kStepDown)};
        }
    }
    return sum / static_cast<double>(across * down);
}

}  // namespace rt
