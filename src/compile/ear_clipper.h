// Ear clipping of a polygon in the plane.
#pragma once

#include "point_tree.h"
#include "rt/core/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// Cuts a polygon that runs counter-clockwise into size - 2 triangles. The reflex corners, which
/// alone can lie in an ear, are kept in a tree; work beyond some hundred steps for each corner,
/// which only polygons that cross themselves need, ends in cutting without looking.
class EarClipper {
  public:
    /// `polygon` must outlive the clipper.
    explicit EarClipper(std::span<const Vec2> polygon);
    void clip(std::vector<std::array<Index, 3>>& triangles);

  private:
    double turnAt(Index i) const;
    bool isEar(Index i);
    void cut(Index i);
    void settle(Index i);
    std::vector<Index> reflexCorners();

    std::span<const Vec2> points_;
    std::vector<Index> previous_;
    std::vector<Index> next_;
    std::vector<bool> reflex_;  ///< not turning left, and still there
    PointTree reflexTree_;
    std::uint64_t looks_ = 0;
};

}  // namespace rt
