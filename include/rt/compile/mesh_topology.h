// Which triangles meet where, once vertices at equal positions count as one.
#pragma once

#include "rt/core/vec.h"
#include "rt/geometry/triangle_mesh.h"

#include <span>
#include <vector>

namespace rt {

/// For every position, the lowest index of a position equal to it (-0 equals 0).
std::vector<Index> mergeEqualPositions(std::span<const Vec3> positions);

/// The corners of a mesh by merged vertex. Corner 3 t + k is corner k of triangle t; the corners of
/// a vertex are in ascending order.
class MeshTopology {
  public:
    /// Fewer than 2^32 corners; no triangle may have two of them at one merged vertex.
    MeshTopology(std::span<const TriangleMesh::Corners> triangles, std::vector<Index> merged);

    std::size_t vertexCount() const { return merged_.size(); }
    /// Empty for a vertex that another one stands for.
    std::span<const Index> cornersAt(Index vertex) const {
        return {corners_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
    }
    Index merged(Index vertex) const { return merged_[vertex]; }

    /// Whether every edge belongs to exactly two triangles.
    bool isClosed(std::span<const TriangleMesh::Corners> triangles) const;
    /// For each triangle, whether it has an edge that belongs to no other.
    std::vector<bool> onBorder(std::span<const TriangleMesh::Corners> triangles) const;

  private:
    struct Edge {
        Index end;
        Index triangle;
    };

    /// The edges whose lower end is this vertex, each once for each of its triangles, in the order
    /// of their other ends.
    void findEdges(std::span<const TriangleMesh::Corners> triangles, Index vertex,
                   std::vector<Edge>& edges) const;

    std::vector<Index> merged_;
    std::vector<Index> first_;
    std::vector<Index> corners_;
};

}  // namespace rt
