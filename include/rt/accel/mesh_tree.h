// The tree of one triangle mesh: nearest hit, any hit, all hits.
//
// What it answers depends on the triangles alone, not on the tree, the number of threads or the
// instruction set: the triangle test is that of geometry/triangle.h to the bit, the boxes never
// lose a hit, and of several triangles hit at the same t the one with the lowest number wins.
#pragma once

#include "rt/accel/triangle_block.h"
#include "rt/accel/wide_tree.h"
#include "rt/core/ray.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/triangle_mesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace rt {

class MeshTree {
  public:
    MeshTree() = default;
    /// Throws std::length_error for a mesh beyond 2^26 triangles.
    static MeshTree build(const TriangleMesh& mesh, int threads);

    /// The nearest hit in `range`; `hit.part` is the triangle, `hit.local` its barycentric weights.
    [[nodiscard]] bool closestHit(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    [[nodiscard]] bool anyHit(const Ray& ray, Interval range) const;

    /// The same for many rays, to the bit: ray i in ranges[i] gets hits[i], whose part is kNone
    /// where nothing is hit. Rays that start and go alike in runs of 16 (pixels of a 4 x 4 square,
    /// their shadow rays to one light) share their walk; others take up to a fifth longer than
    /// alone.
    void closestHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                     std::span<PrimitiveHit> hits) const;
    /// met[i]: whether ray i hits anything in ranges[i].
    void anyHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                 std::span<bool> met) const;

    /// Every triangle hit in `range`, by t, then by triangle.
    void allHits(const Ray& ray, Interval range, std::vector<PrimitiveHit>& hits) const;

    Bounds bounds() const { return tree_.bounds(); }
    /// Memory of nodes and leaves.
    std::size_t bytes() const { return tree_.bytes() + blocks_.bytes(); }
    const WideTree& tree() const { return tree_; }

  private:
    friend class MeshTreeBuilder;

    WideTree tree_;  ///< its leaves are runs of `blocks_`
    LargeArray<TriangleBlock> blocks_;
};

}  // namespace rt
