#include "normal_tree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace rt {
namespace {

constexpr std::size_t kLeafSize = 8;

/// The corner of [min, max] where the dot product with n is largest.
Vec3 furthestAlong(const Vec3& n, const Vec3& min, const Vec3& max) {
    return {n.x < 0.0 ? min.x : max.x, n.y < 0.0 ? min.y : max.y, n.z < 0.0 ? min.z : max.z};
}

}  // namespace

void NormalSum::add(const WeightedNormal& share) {
    if (count == 0) first = share.normal;
    allEqual = allEqual && share.normal == first;
    vector += share.weight * share.normal;
    weight += share.weight;
    ++count;
}

void NormalSum::add(const NormalSum& other) {
    if (count == 0) first = other.first;
    allEqual = allEqual && other.allEqual && other.first == first;
    vector += other.vector;
    weight += other.weight;
    count += other.count;
}

void NormalTree::fit(Node& node) const {
    node.min = node.max = shares_[node.begin].normal;
    for (std::size_t i = node.begin; i < node.end; ++i) {
        node.min = glm::min(node.min, shares_[i].normal);
        node.max = glm::max(node.max, shares_[i].normal);
        node.sum.add(shares_[i]);
    }
}

void NormalTree::build(std::span<const WeightedNormal> shares) {
    shares_.assign(shares.begin(), shares.end());
    nodes_.clear();
    nodes_.push_back({{}, {}, {}, 0, shares_.size(), 0});
    fit(nodes_[0]);
    // Children are appended, so this walks the whole tree.
    for (std::size_t i = 0; i < nodes_.size(); ++i) split(i);
}

void NormalTree::split(std::size_t index) {
    const Node parent = nodes_[index];
    const Vec3 extent = parent.max - parent.min;
    if (parent.end - parent.begin <= kLeafSize || extent == Vec3(0.0)) return;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const std::size_t middle = parent.begin + (parent.end - parent.begin) / 2;
    const auto at = [&](std::size_t i) { return shares_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(parent.begin), at(middle), at(parent.end),
                     [axis](const WeightedNormal& a, const WeightedNormal& b) {
                         return a.normal[axis] < b.normal[axis];
                     });
    nodes_[index].left = nodes_.size();
    for (const auto& [begin, end] :
         {std::pair(parent.begin, middle), std::pair(middle, parent.end)}) {
        Node child{{}, {}, {}, begin, end, 0};
        fit(child);
        nodes_.push_back(child);
    }
}

NormalSum NormalTree::sumWithin(const Vec3& n, double cosLimit) const {
    NormalSum sum;
    collect(nodes_[0], n, cosLimit, sum);
    return sum;
}

void NormalTree::collect(const Node& node, const Vec3& n, double cosLimit, NormalSum& sum) const {
    if (glm::dot(n, furthestAlong(n, node.min, node.max)) < cosLimit) return;
    if (glm::dot(n, furthestAlong(-n, node.min, node.max)) >= cosLimit) {
        sum.add(node.sum);
    } else if (node.left != 0) {
        collect(nodes_[node.left], n, cosLimit, sum);
        collect(nodes_[node.left + 1], n, cosLimit, sum);
    } else {
        for (std::size_t i = node.begin; i < node.end; ++i) {
            if (glm::dot(n, shares_[i].normal) >= cosLimit) sum.add(shares_[i]);
        }
    }
}

}  // namespace rt
