// Points of the plane that may be removed, searched by triangle.
#pragma once

#include "rt/core/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// Twice the signed area of a, b, c: positive if they turn left. Its sign is right unless the
/// triangle is thinner than the rounding of the differences of its corners.
double orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// A k-d tree over some of `points`, with the number of points that are left in each node.
class PointTree {
  public:
    /// `points` must outlive the tree.
    PointTree(std::span<const Vec2> points, std::vector<Index> members);

    /// Takes a member out; no harm if it is none.
    void remove(Index point);
    /// Whether a member lies in the closed triangle, which turns left, other than at its corners.
    bool anyIn(const std::array<Vec2, 3>& triangle);

    /// Nodes and points looked at so far.
    std::uint64_t steps() const { return steps_; }

  private:
    struct Node {
        Vec2 min{0.0};
        Vec2 max{0.0};
        Index left = 0;  ///< members that have not been removed
    };

    static constexpr Index kLeafSize = 4;

    void build(std::size_t node, Index begin, Index end);
    bool search(std::size_t node, Index begin, Index end, const std::array<Vec2, 3>& triangle);
    bool mayOverlap(const Node& node, const std::array<Vec2, 3>& triangle) const;
    bool contains(const std::array<Vec2, 3>& triangle, const Vec2& p) const;

    std::span<const Vec2> points_;
    std::vector<Index> members_;  ///< by place in the tree; kNone once removed
    std::vector<Index> place_;    ///< by point; kNone if not a member
    std::vector<Node> nodes_;     ///< children of i: 2 i + 1 and 2 i + 2
    std::uint64_t steps_ = 0;
};

}  // namespace rt
