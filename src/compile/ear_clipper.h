// Ear clipping of a polygon in the plane.
#pragma once

#include "rt/core/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// Twice the signed area of a, b, c: positive if they turn left. Its sign is right unless the
/// triangle is thinner than the rounding of the differences.
double orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Cuts a polygon that runs counter-clockwise into size - 2 triangles. The reflex corners, which
/// alone can lie in an ear, are kept in a grid; work beyond some thousand steps for each corner,
/// which only polygons that cross themselves need, ends in cutting without looking.
class EarClipper {
  public:
    explicit EarClipper(std::span<const Vec2> polygon);
    void clip(std::vector<std::array<Index, 3>>& triangles);

  private:
    struct Cells {
        int minX, minY, maxX, maxY;
    };

    double turnAt(Index i) const;
    bool isEar(Index i);
    bool cellBlocks(std::size_t cell, const std::array<Index, 3>& ear);
    bool blocks(Index reflex, const std::array<Index, 3>& ear) const;
    Index leastHarm(Index start) const;
    void cut(Index i);
    void buildGrid();
    Cells cellsOf(const Vec2& min, const Vec2& max) const;

    std::span<const Vec2> points_;
    std::vector<Index> previous_;
    std::vector<Index> next_;
    std::vector<std::uint8_t> reflex_;  ///< not turning left, and still there
    std::size_t reflexCount_ = 0;

    // The reflex corners of cell c are cellMembers_[cellFirst_[c] .. cellFirst_[c + 1]).
    int cellsPerSide_ = 1;
    Vec2 gridMin_{0.0};
    Vec2 cellsPerUnit_{0.0};
    std::vector<Index> cellFirst_;
    std::vector<Index> cellMembers_;
    std::size_t reflexAtBuild_ = 0;
    std::uint64_t steps_ = 0;
};

}  // namespace rt
