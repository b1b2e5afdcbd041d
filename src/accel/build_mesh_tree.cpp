#include "build_presplit.h"
#include "build_wide_tree.h"
#include "rt/accel/mesh_tree.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {
namespace {

constexpr std::size_t kMostTriangles = std::size_t{1} << 26;
constexpr std::size_t kChunk = std::size_t{1} << 14;

/// A block tests eight triangles at the price of one, but more than six seldom share eight corners.
constexpr std::uint32_t kLeafTriangles = 6;

template <class Run>
void forEachChunk(std::size_t count, int threads, Run&& run) {
    forEachIndex((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, int) {
        run(chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
    });
}

Bounds boundsOf(const TriangleMesh& mesh, std::size_t triangle) {
    Bounds box;
    for (const Index corner : mesh.triangles[triangle]) box.unite(mesh.positions[corner]);
    return box;
}

Bounds boundsOf(const TriangleMesh& mesh, int threads) {
    const std::size_t count = mesh.triangles.size();
    std::vector<Bounds> parts((count + kChunk - 1) / kChunk);
    forEachChunk(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) parts[begin / kChunk].unite(boundsOf(mesh, i));
    });
    Bounds all;
    for (const Bounds& part : parts) all.unite(part);
    return all;
}

/// Fills a block with triangles until their corners are too many.
class BlockFiller {
  public:
    explicit BlockFiller(TriangleBlock& block) : block_(block) { block_ = {}; }

    /// False where the triangle does not fit; the block is then unchanged. Pieces of a triangle
    /// that the block holds already need no room.
    bool add(const TriangleMesh& mesh, Index triangle) {
        if (std::find(block_.id, block_.id + block_.count, triangle) != block_.id + block_.count) {
            return true;
        }
        if (block_.count == TriangleBlock::kSize) return false;
        int places[3];
        const int before = corners_;
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = place(mesh.positions[mesh.triangles[triangle][k]]);
            if (places[k] < 0) {
                corners_ = before;
                return false;
            }
        }
        const std::size_t at = block_.count++;
        for (int k = 0; k < 3; ++k) block_.triangle[k][at] = static_cast<std::uint8_t>(places[k]);
        block_.id[at] = triangle;
        return true;
    }

    /// Unused corners repeat the first, so that they bring no values of their own.
    void finish() {
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = corners_; i < TriangleBlock::kSize; ++i) {
                block_.corner[axis][i] = block_.corner[axis][0];
            }
        }
    }

  private:
    int place(const Vec3& position) {
        for (int i = 0; i < corners_; ++i) {
            if (block_.corner[0][i] == position.x && block_.corner[1][i] == position.y &&
                block_.corner[2][i] == position.z) {
                return i;
            }
        }
        if (corners_ == TriangleBlock::kSize) return -1;
        for (int axis = 0; axis < 3; ++axis) block_.corner[axis][corners_] = position[axis];
        return corners_++;
    }

    TriangleBlock& block_;
    int corners_ = 0;
};

}  // namespace

/// Turns the leaves of a tree over triangles into blocks.
class MeshTreeBuilder {
  public:
    MeshTreeBuilder(const TriangleMesh& mesh, int threads) : mesh_(mesh), threads_(threads) {}

    MeshTree build() {
        const Bounds bounds = boundsOf(mesh_, threads_);
        const TreeFrame frame = frameFor(bounds);
        RefArray refs = triangleRefs(mesh_, frame, threads_);
        const std::size_t count = refs.count;
        const BuildCosts costs{1.0f, 1.0f, kLeafTriangles};
        WideTreeBuilder builder(std::move(refs.refs), count, {costs, kLeafTriangles, threads_});
        MeshTree result;
        result.tree_ = builder.build(frame, bounds);
        result.blocks_ = makeBlocks(result.tree_);
        return result;
    }

  private:
    /// Counts the blocks, then fills them in place.
    LargeArray<TriangleBlock> makeBlocks(WideTree& tree) {
        LargeArray<WideNode>& nodes = WideTreeBuilder::nodesOf(tree);
        const LargeArray<Index>& items = WideTreeBuilder::itemsOf(tree);
        std::vector<std::size_t> first((nodes.size() + kChunk - 1) / kChunk + 1, 0);
        forEachChunk(nodes.size(), threads_, [&](std::size_t begin, std::size_t end) {
            std::size_t blocks = 0;
            for (std::size_t i = begin; i < end; ++i) {
                forEachLeaf(nodes[i], [&](std::uint32_t, ChildRef leaf) {
                    blocks += blocksOf(items.data() + leaf.first(), leaf.count());
                });
            }
            first[begin / kChunk + 1] = blocks;
        });
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        LargeArray<TriangleBlock> blocks(first.back());
        forEachChunk(nodes.size(), threads_, [&](std::size_t begin, std::size_t end) {
            TriangleBlock* next = blocks.data() + first[begin / kChunk];
            for (std::size_t i = begin; i < end; ++i) {
                forEachLeaf(nodes[i], [&](std::uint32_t& child, ChildRef leaf) {
                    TriangleBlock* const start = next;
                    next = fillBlocks(items.data() + leaf.first(), leaf.count(), next);
                    child = ChildRef::leaf(static_cast<std::uint32_t>(start - blocks.data()),
                                           static_cast<std::uint32_t>(next - start))
                                .bits();
                });
            }
        });
        WideTreeBuilder::itemsOf(tree) = {};
        return blocks;
    }

    template <class Visit>
    static void forEachLeaf(WideNode& node, Visit&& visit) {
        for (int lane = 0; lane < kTreeWidth; ++lane) {
            const ChildRef child = ChildRef::fromBits(node.child[lane]);
            const bool isUsed = node.plane[0][lane] <= node.plane[1][lane];
            if (isUsed && child.isLeaf()) visit(node.child[lane], child);
        }
    }

    /// Few corners are certain to fit one block; otherwise, filling tells.
    std::size_t blocksOf(const Index* items, std::uint32_t count) const {
        Index corners[TriangleBlock::kSize];
        std::size_t found = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const Index corner : mesh_.triangles[items[i]]) {
                if (std::find(corners, corners + found, corner) != corners + found) continue;
                if (found == TriangleBlock::kSize) {
                    TriangleBlock blocks[ChildRef::kMaxCount];
                    return static_cast<std::size_t>(fillBlocks(items, count, blocks) - blocks);
                }
                corners[found++] = corner;
            }
        }
        return 1;
    }

    TriangleBlock* fillBlocks(const Index* items, std::uint32_t count, TriangleBlock* to) const {
        for (std::uint32_t next = 0; next < count; ++to) {
            BlockFiller filler(*to);
            while (next < count && filler.add(mesh_, items[next])) ++next;
            filler.finish();
        }
        return to;
    }

    const TriangleMesh& mesh_;
    int threads_;
};

MeshTree MeshTree::build(const TriangleMesh& mesh, int threads) {
    if (mesh.triangles.size() > kMostTriangles) {
        throw std::length_error("a mesh holds at most 2^26 triangles, not " +
                                std::to_string(mesh.triangles.size()));
    }
    return MeshTreeBuilder(mesh, threads).build();
}

}  // namespace rt
