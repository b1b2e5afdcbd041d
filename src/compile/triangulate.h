// Polygons to triangles.
//
// A polygon is seen along its Newell normal (Sutherland, Sproull, Schumacker, "A Characterization
// of Ten Hidden-Surface Algorithms", 1974), with the coordinate of its largest component left out.
// If the fan of corner 0 turns one way throughout, that is the triangulation: true for every convex
// polygon without straight corners. Else ears are cut off (Meisters, "Polygons Have Ears", 1975),
// with the reflex corners in a tree.
//
// Every polygon of n corners gives n - 2 triangles with its own orientation, some without area
// where corners coincide or lie in line. A polygon that crosses itself is covered in some defined
// way.
#pragma once

#include "rt/core/vec.h"

#include <array>
#include <span>
#include <vector>

namespace rt {

/// Keeps its scratch memory from one polygon to the next.
class Triangulator {
  public:
    using Triangles = std::vector<std::array<Index, 3>>;

    /// Triples of positions in `polygon`, which has at least 3 corners, all finite. The result
    /// lives until the next call.
    const Triangles& operator()(std::span<const Vec3> polygon);

  private:
    void centre(std::span<const Vec3> polygon);
    void flatten();
    bool isFanOfLeftTurns() const;

    std::vector<Vec3> offsets_;  ///< from the first corner, in units of the polygon's size
    std::vector<Vec2> points_;   ///< counter-clockwise in the plane that the polygon faces most
    Triangles triangles_;
};

}  // namespace rt
