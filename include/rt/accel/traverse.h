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
    /// `leaves` points to what leaves number, `leafStride` bytes each: fetched ahead of its use.
    LeafWalk(const WideTree& tree, const BoxRay& ray, const void* leaves, std::size_t leafStride)
        : nodes_(tree.nodes()),
          leaves_(static_cast<const char*>(leaves)),
          leafStride_(leafStride),
          boxes_(ray) {}

    /// Calls leaf(ChildRef, tauMax) for the leaves met in [tauMin, tauMax], near ones first, until
    /// it returns true. It may lower tauMax. The walk begins at `start`.
    template <class Leaf>
    [[gnu::always_inline]] void run(float tauMin, float tauMax, Leaf&& leaf,
                                    ChildRef start = ChildRef::node(0)) {
        WaitingChild* top = stack_;
        std::uint32_t current = start.bits();
        for (;;) {
            const ChildRef child = ChildRef::fromBits(current);
            if (child.isLeaf()) {
                if (leaf(child, tauMax)) return;
            } else {
                const WideNode& node = nodes_[child.nodeIndex()];
                const int met = boxes_.meet(node, tauMin, tauMax, top, current);
                if (met > 0) {
                    for (int i = 1; i < met; ++i) fetch((top++)->child);
                    continue;
                }
            }
            do {
                if (top == stack_) return;
                --top;
            } while (!(top->entry <= tauMax));
            current = top->child;
        }
    }

  private:
    /// Every level leaves at most seven siblings behind, and the last one writes eight.
    static constexpr int kStackSize = (kTreeWidth - 1) * (WideTree::kMaxDepth + 1) + kTreeWidth;

    /// Starts to load the lines of a child that will be looked at soon.
    void fetch(std::uint32_t bits) const {
        const ChildRef child = ChildRef::fromBits(bits);
        const char* at = child.isLeaf() ? leaves_ + child.first() * leafStride_
                                        : reinterpret_cast<const char*>(nodes_ + child.nodeIndex());
        __builtin_prefetch(at);
        __builtin_prefetch(at + 64);
        __builtin_prefetch(at + 128);
        __builtin_prefetch(at + 192);
    }

    const WideNode* nodes_;
    const char* leaves_;
    std::size_t leafStride_;
    BoxTester boxes_;
    WaitingChild stack_[kStackSize];
};

/// Calls test(item, Interval now) -> double for the items whose boxes meet the ray, roughly near to
/// far, with the range that is left; it returns the range's new max (`now.max` to keep it).
template <class LeafTest>
void traverseClosest(const WideTree& tree, const Ray& ray, Interval range, LeafTest&& test) {
    BoxRay boxRay;
    if (tree.isEmpty() || !BoxRay::make(tree.frame(), ray, boxRay)) return;
    LeafWalk walk(tree, boxRay, tree.items(), sizeof(Index));
    walk.run(boxRay.tau.below(range.min), boxRay.tau.above(range.max),
             [&](ChildRef leaf, float& tauMax) {
                 for (std::uint32_t k = 0; k < leaf.count(); ++k) {
                     const double newMax = test(tree.item(leaf.first() + k), range);
                     if (newMax < range.max) {
                         range.max = newMax;
                         tauMax = boxRay.tau.above(newMax);
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
    LeafWalk walk(tree, boxRay, tree.items(), sizeof(Index));
    bool stopped = false;
    walk.run(boxRay.tau.below(range.min), boxRay.tau.above(range.max), [&](ChildRef leaf, float&) {
        for (std::uint32_t k = 0; k < leaf.count() && !stopped; ++k) {
            stopped = test(tree.item(leaf.first() + k));
        }
        return stopped;
    });
    return stopped;
}

}  // namespace rt
