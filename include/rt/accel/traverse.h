// Walks a WideTree along a ray, near boxes first.
//
// Boxes never lose a hit that a primitive's own test finds, provided that the point at the found t
// lies within 2^-47 of the ray's origin distance (or of the coordinates at hand) of the primitive's
// Bounds. -0.0, zero and denormal components of the direction are as good as any; a direction of
// zero, or one that is not finite, meets nothing.
#pragma once

#include "rt/accel/box_ray.h"
#include "rt/accel/box_test.h"
#include "rt/accel/wide_tree.h"
#include "rt/core/ray.h"

#include <bit>
#include <cstdint>

namespace rt {

/// Depth-first walk over the leaves that a ray meets, with the stack that it needs.
class LeafWalk {
  public:
    LeafWalk(const WideTree& tree, const BoxRay& ray) : nodes_(tree.nodes()), boxes_(ray) {}

    /// Calls leaf(ChildRef, tauMax) for the leaves met in [tauMin, tauMax], near ones first, until
    /// it returns true. It may lower tauMax.
    template <class Leaf>
    void run(float tauMin, float tauMax, Leaf&& leaf) {
        std::uint32_t current = ChildRef::node(0).bits();
        for (;;) {
            const ChildRef child = ChildRef::fromBits(current);
            if (child.isLeaf()) {
                if (leaf(child, tauMax)) return;
            } else if (descend(nodes_[child.nodeIndex()], tauMin, tauMax, current)) {
                continue;
            }
            do {
                if (size_ == 0) return;
                --size_;
            } while (!(stack_[size_].entry <= tauMax));
            current = stack_[size_].child;
        }
    }

  private:
    struct Entry {
        float entry;
        std::uint32_t child;
    };
    /// Every level leaves at most seven siblings behind.
    static constexpr int kStackSize = (kTreeWidth - 1) * (WideTree::kMaxDepth + 1) + 1;

    /// Puts the children that the ray meets on the stack, far ones first, and the nearest into
    /// `nearest`; false where there is none.
    bool descend(const WideNode& node, float tauMin, float tauMax, std::uint32_t& nearest) {
        alignas(32) float entry[kTreeWidth];
        unsigned mask = boxes_.meet(node, tauMin, tauMax, entry);
        if (mask == 0) return false;
        const int base = size_;
        for (; mask != 0; mask &= mask - 1) {
            const int lane = std::countr_zero(mask);
            const Entry added{entry[lane], node.child[lane]};
            int place = size_++;
            for (; place > base && stack_[place - 1].entry < added.entry; --place) {
                stack_[place] = stack_[place - 1];
            }
            stack_[place] = added;
        }
        nearest = stack_[--size_].child;
        return true;
    }

    const WideNode* nodes_;
    BoxTester boxes_;
    int size_ = 0;
    Entry stack_[kStackSize];
};

/// Calls test(item, Interval now) -> double for the items whose boxes meet the ray, roughly near to
/// far, with the range that is left; it returns the range's new max (`now.max` to keep it).
template <class LeafTest>
void traverseClosest(const WideTree& tree, const Ray& ray, Interval range, LeafTest&& test) {
    BoxRay boxRay;
    if (tree.isEmpty() || !BoxRay::make(tree.frame(), ray, boxRay)) return;
    LeafWalk walk(tree, boxRay);
    walk.run(boxRay.tauBelow(range.min), boxRay.tauAbove(range.max),
             [&](ChildRef leaf, float& tauMax) {
                 for (std::uint32_t k = 0; k < leaf.count(); ++k) {
                     const double newMax = test(tree.item(leaf.first() + k), range);
                     if (newMax < range.max) {
                         range.max = newMax;
                         tauMax = boxRay.tauAbove(newMax);
                     }
                 }
                 return false;
             });
}

/// Calls test(item) -> bool for the items whose boxes meet the ray in `range`, until it returns
/// true; returns whether it did. With a test that is always false: visits every such item, once.
template <class LeafTest>
bool traverseAny(const WideTree& tree, const Ray& ray, Interval range, LeafTest&& test) {
    BoxRay boxRay;
    if (tree.isEmpty() || !BoxRay::make(tree.frame(), ray, boxRay)) return false;
    LeafWalk walk(tree, boxRay);
    bool stopped = false;
    walk.run(boxRay.tauBelow(range.min), boxRay.tauAbove(range.max), [&](ChildRef leaf, float&) {
        for (std::uint32_t k = 0; k < leaf.count() && !stopped; ++k) {
            stopped = test(tree.item(leaf.first() + k));
        }
        return stopped;
    });
    return stopped;
}

}  // namespace rt
