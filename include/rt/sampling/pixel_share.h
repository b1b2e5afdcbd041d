// The part of its pixel that a sample stands for: what lies in it may be averaged beforehand.
//
// The pixel's square is cut into 2^m cells, 2^floor(m/2) across and 2^ceil(m/2) down, and the
// sample stands for the cell that it lies in. A sample that is uniform in the square is uniform in
// its cell, so the mean over cells has the expectation of the mean over samples, whatever m:
// nothing leaks over the pixel's border. Of points that are a (0, m, 2)-net, as the joint sampler's
// are from index 2^m to 2^(m+1) - 1, each cell has exactly one: they tile the pixel.
#pragma once

#include "rt/core/vec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rt {

struct PixelShare {
    Vec2 size{1.0};   ///< of the cell, in pixels
    Vec2 phase{0.5};  ///< the sample's place in it, 0 .. 1
};

/// The cell of sample number `index` at `point` of the unit square: of 2^m <= max(index, least)
/// cells. With `least` = n all of n samples have cells of about their share, with 1 the first ones
/// have larger ones.
inline PixelShare pixelShare(std::uint32_t index, std::uint32_t least, const Vec2& point) {
    const int m = static_cast<int>(std::bit_width(std::max({index, least, std::uint32_t{1}}))) - 1;
    const Vec2 cells(static_cast<double>(1u << (m / 2)), static_cast<double>(1u << ((m + 1) / 2)));
    const Vec2 place = point * cells;
    return {1.0 / cells, Vec2(place.x - std::floor(place.x), place.y - std::floor(place.y))};
}

}  // namespace rt
