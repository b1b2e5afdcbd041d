// The unit square in n cells of equal area, for any n >= 1: about sqrt(n) rows, whose heights are
// in proportion to the number of their cells.
#pragma once

#include "rt/core/vec.h"
#include "rt/sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rt {

class Strata {
  public:
    explicit Strata(int count)
        : count_(static_cast<std::uint64_t>(std::max(count, 1))),
          rows_(static_cast<std::uint64_t>(
              std::floor(std::sqrt(static_cast<double>(count_)) + 0.5))) {}

    /// The point (u, v) of the unit square, carried into a cell.
    Vec2 inCell(std::uint64_t cell, const Vec2& point) const {
        const std::uint64_t row = ((cell + 1) * rows_ - 1) / count_;
        const std::uint64_t begin = row * count_ / rows_;
        const std::uint64_t end = (row + 1) * count_ / rows_;
        const auto cells = static_cast<double>(end - begin);
        return {(static_cast<double>(cell - begin) + point.x) / cells,
                (static_cast<double>(begin) + point.y * cells) / static_cast<double>(count_)};
    }

    /// The middle of cell index modulo n.
    Vec2 middle(std::uint32_t index) const { return inCell(index % count_, Vec2(0.5)); }

    /// A random point of a random cell, such that each run of n indices, from a multiple of n on,
    /// takes every cell once.
    Vec2 jittered(std::uint32_t index, std::uint64_t key) const {
        const std::uint64_t passKey = subKey(key, index / count_);
        const auto place = static_cast<std::uint32_t>(index % count_);
        const std::uint64_t bits = subKey(passKey, place);
        const std::uint32_t cell = permuted(place, static_cast<std::uint32_t>(count_), passKey);
        return inCell(cell, {toUnit(bits), toUnit(mixBits(bits))});
    }

  private:
    std::uint64_t count_;
    std::uint64_t rows_;
};

}  // namespace rt
