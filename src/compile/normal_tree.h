// Sums of the unit normals near a given one, for vertices where very many faces meet.
#pragma once

#include "rt/core/vec.h"

#include <cstddef>
#include <span>
#include <vector>

namespace rt {

struct WeightedNormal {
    Vec3 normal;
    double weight;
};

/// A running sum of weight * normal.
struct NormalSum {
    Vec3 vector{0.0};
    double weight = 0.0;
    std::size_t count = 0;
    Vec3 first{0.0};
    bool allEqual = true;  ///< every normal so far is `first`

    void add(const WeightedNormal& share);
    void add(const NormalSum& other);
};

/// A k-d tree over normals with the sum of each node. Because rounded products and sums are
/// monotonic, the bounds of n . m over a node's box hold for the computed dot products too: a
/// normal is counted exactly if its own computed dot product says so.
class NormalTree {
  public:
    void build(std::span<const WeightedNormal> shares);
    /// Over the normals m with dot(n, m) >= cosLimit.
    NormalSum sumWithin(const Vec3& n, double cosLimit) const;

  private:
    struct Node {
        Vec3 min;
        Vec3 max;
        NormalSum sum;
        std::size_t begin;
        std::size_t end;
        std::size_t left;  ///< of the children left and left + 1; 0 for a leaf
    };

    void split(std::size_t node);
    void fit(Node& node) const;
    void collect(const Node& node, const Vec3& n, double cosLimit, NormalSum& sum) const;

    std::vector<WeightedNormal> shares_;
    std::vector<Node> nodes_;
};

}  // namespace rt
