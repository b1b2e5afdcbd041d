#include "rt/accel/mesh_tree.h"

#include "block_test.h"
#include "rt/accel/traverse.h"
#include "rt/geometry/triangle.h"

#include <algorithm>

namespace rt {
namespace {

/// Calls visit(block) for the blocks that the ray may meet in `range`, near ones first, until it
/// returns true. `range.max` may be lowered by it.
template <class Visit>
void visitBlocks(const WideTree& tree, const LargeArray<TriangleBlock>& blocks, const Ray& ray,
                 Interval& range, Visit&& visit) {
    BoxRay boxRay;
    if (tree.isEmpty() || !BoxRay::make(tree.frame(), ray, boxRay)) return;
    LeafWalk walk(tree, boxRay, blocks.data(), sizeof(TriangleBlock));
    walk.run(
        boxRay.tau.below(range.min), boxRay.tau.above(range.max),
        [&](ChildRef leaf, float& tauMax) __attribute__((always_inline)) {
            const double before = range.max;
            for (std::uint32_t k = 0; k < leaf.count(); ++k) {
                if (visit(blocks[leaf.first() + k])) return true;
            }
            if (range.max < before) tauMax = boxRay.tau.above(range.max);
            return false;
        });
}

}  // namespace

bool MeshTree::closestHit(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    const TriangleRay triangleRay(ray);
    const BlockTester tester(triangleRay);
    NearestInBlocks nearest(range);
    visitBlocks(tree_, blocks_, ray, range, [&](const TriangleBlock& block) {
        tester.nearest(block, range, nearest);
        return false;
    });
    return nearest.take(hit);
}

bool MeshTree::anyHit(const Ray& ray, Interval range) const {
    const TriangleRay triangleRay(ray);
    const BlockTester tester(triangleRay);
    bool found = false;
    visitBlocks(tree_, blocks_, ray, range, [&](const TriangleBlock& block) {
        found = tester.any(block, range);
        return found;
    });
    return found;
}

void MeshTree::allHits(const Ray& ray, Interval range, std::vector<PrimitiveHit>& hits) const {
    const TriangleRay triangleRay(ray);
    hits.clear();
    visitBlocks(tree_, blocks_, ray, range, [&](const TriangleBlock& block) {
        for (std::size_t i = 0; i < block.count; ++i) {
            PrimitiveHit hit;
            if (!intersectTriangle(triangleRay, cornerOf(block, 0, i), cornerOf(block, 1, i),
                                   cornerOf(block, 2, i), range, hit)) {
                continue;
            }
            hit.part = block.id[i];
            hits.push_back(hit);
        }
        return false;
    });
    const auto order = [](const PrimitiveHit& a, const PrimitiveHit& b) {
        return a.t != b.t ? a.t < b.t : a.part < b.part;
    };
    const auto same = [](const PrimitiveHit& a, const PrimitiveHit& b) { return a.part == b.part; };
    std::sort(hits.begin(), hits.end(), order);
    hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
}

}  // namespace rt
