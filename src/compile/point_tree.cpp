#include "point_tree.h"

#include "rt/core/numeric.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {

double orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 e = b - a;
    const Vec2 f = c - a;
    const double left = e.x * f.y;
    const double right = e.y * f.x;
    const double plain = left - right;
    if (std::fabs(plain) > kPlainOrientationError * (std::fabs(left) + std::fabs(right)))
        return plain;
    return differenceOfProducts(e.x, f.y, e.y, f.x);
}

PointTree::PointTree(std::span<const Vec2> points, std::vector<Index> members)
    : points_(points), members_(std::move(members)), place_(points.size(), kNone) {
    if (members_.empty()) return;
    build(0, 0, static_cast<Index>(members_.size()));
    for (Index i = 0; i < static_cast<Index>(members_.size()); ++i) place_[members_[i]] = i;
}

void PointTree::build(std::size_t node, Index begin, Index end) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    Vec2 min = points_[members_[begin]];
    Vec2 max = min;
    for (Index i = begin; i < end; ++i) {
        min = glm::min(min, points_[members_[i]]);
        max = glm::max(max, points_[members_[i]]);
    }
    nodes_[node] = {min, max, end - begin};
    if (end - begin <= kLeafSize) return;
    const int axis = max.x - min.x >= max.y - min.y ? 0 : 1;
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(members_.begin() + begin, members_.begin() + middle, members_.begin() + end,
                     [&](Index a, Index b) { return points_[a][axis] < points_[b][axis]; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
}

void PointTree::remove(Index point) {
    const Index place = place_[point];
    if (place == kNone) return;
    place_[point] = kNone;
    members_[place] = kNone;
    std::size_t node = 0;
    Index begin = 0;
    Index end = static_cast<Index>(members_.size());
    --nodes_[0].left;
    while (end - begin > kLeafSize) {
        const Index middle = begin + (end - begin) / 2;
        const bool lower = place < middle;
        node = 2 * node + (lower ? 1 : 2);
        (lower ? end : begin) = middle;
        --nodes_[node].left;
    }
}

bool PointTree::anyIn(const std::array<Vec2, 3>& triangle) {
    return !nodes_.empty() && search(0, 0, static_cast<Index>(members_.size()), triangle);
}

/// False only if the node's box lies to the right of one of the triangle's sides, or beside the
/// triangle's own box.
bool PointTree::mayOverlap(const Node& node, const std::array<Vec2, 3>& triangle) const {
    const auto& [a, b, c] = triangle;
    const Vec2 min = glm::min(glm::min(a, b), c);
    const Vec2 max = glm::max(glm::max(a, b), c);
    if (node.max.x < min.x || node.min.x > max.x || node.max.y < min.y || node.min.y > max.y) {
        return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& from = triangle[k];
        const Vec2& to = triangle[(k + 1) % 3];
        // The corner of the box that is furthest to the left of the side.
        const Vec2 corner(to.y < from.y ? node.max.x : node.min.x,
                          to.x > from.x ? node.max.y : node.min.y);
        if (orientation(from, to, corner) < 0.0) return false;
    }
    return true;
}

bool PointTree::contains(const std::array<Vec2, 3>& triangle, const Vec2& p) const {
    const auto& [a, b, c] = triangle;
    if (p == a || p == b || p == c) return false;
    return orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 &&
           orientation(c, a, p) >= 0.0;
}

bool PointTree::search(std::size_t node, Index begin, Index end,
                       const std::array<Vec2, 3>& triangle) {
    ++steps_;
    if (nodes_[node].left == 0 || !mayOverlap(nodes_[node], triangle)) return false;
    if (end - begin <= kLeafSize) {
        steps_ += end - begin;
        return std::any_of(members_.begin() + begin, members_.begin() + end, [&](Index member) {
            return member != kNone && contains(triangle, points_[member]);
        });
    }
    const Index middle = begin + (end - begin) / 2;
    return search(2 * node + 1, begin, middle, triangle) ||
           search(2 * node + 2, middle, end, triangle);
}

}  // namespace rt
