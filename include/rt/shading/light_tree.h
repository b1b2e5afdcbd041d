// Many lights, of which a few are chosen at each point: those that may bring most of the light
// there are the likeliest.
//
// The lights are leaves of a binary tree over their places. A point gives each node an importance
//
//     P f / (c0 + c1 d + c2 d^2),   d = max(distance of the node's centre, its radius),
//
// with P the sum of the intensities below, c their means by intensity, and f between kLeastFacing
// and 1 for how much of the node's ball faces the surface; 0 where all of it lies below the
// surface's horizon. A point in [0, 1) goes down the tree by the shares of importance, and n evenly
// spaced points, all moved by one random number, choose n lights, each light as often as its share
// says to within one, and neighbours by turns. Each sum over the lights is then unbiased when each
// choice of probability p counts for 1 / (n p).
// Estevez and Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting, Proc. ACM
// Comput. Graph. Interact. Tech. 1(2), 2018; systematic sampling: Cochran, Sampling Techniques, 3rd
// edition, 1977, chapter 8.
#pragma once

#include "rt/core/vec.h"
#include "rt/shading/light.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// A light and what it counts for: n 's choices of it over its expected number.
struct ChosenLight {
    Index light = 0;
    double weight = 1.0;
};

class LightTree {
  public:
    /// As many lights can be chosen at a point.
    static constexpr int kMostChosen = 32;

    struct Choice {
        std::array<ChosenLight, kMostChosen> lights;
        int count = 0;
    };

    LightTree() = default;
    /// Over those that have a place: suns are always chosen, each by itself.
    explicit LightTree(std::span<const Light> lights);

    bool isEmpty() const { return nodes_.empty(); }
    /// Lights without a place.
    const std::vector<Index>& suns() const { return suns_; }

    /// `count` choices, at most kMostChosen, for a surface at `from`; those that fall on the same
    /// light are one. Both normals are unit, `shift` is in [0, 1).
    Choice choose(const Vec3& from, const Vec3& geometricNormal, const Vec3& normal, int count,
                  double shift) const;

  private:
    struct Node {
        Vec3 centre{0.0};
        double radius = 0.0;  ///< of a ball that holds all the lights below
        double power = 0.0;
        double c0 = 0.0, c1 = 0.0, c2 = 0.0;
        Index right = kNone;  ///< of an inner node, whose left child follows it
        Index light = kNone;  ///< of a leaf
    };

    struct Descent;

    Index build(std::span<const Light> lights, std::span<Index> items);
    double importance(const Node& node, const Vec3& from, const Vec3& geometricNormal,
                      const Vec3& normal) const;

    std::vector<Node> nodes_;  ///< the root first
    std::vector<Index> suns_;
};

}  // namespace rt
