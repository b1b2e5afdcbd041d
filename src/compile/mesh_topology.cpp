#include "rt/compile/mesh_topology.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace rt {
namespace {

/// Adding 0 turns -0 into 0, so that equal numbers have equal bits.
std::uint64_t bitsOf(double x) {
    return std::bit_cast<std::uint64_t>(x + 0.0);
}

// Finaliser of Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014.
std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t hashOf(const Vec3& p) {
    return mix(bitsOf(p.x) + mix(bitsOf(p.y) + mix(bitsOf(p.z) + 0x9e3779b97f4a7c15u)));
}

}  // namespace

std::vector<Index> mergeEqualPositions(std::span<const Vec3> positions) {
    // At most half full, so that probes stay short.
    const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
    std::vector<Index> table(mask + 1, kNone);
    std::vector<Index> merged(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hashOf(positions[i]) & mask;
        while (table[slot] != kNone && positions[table[slot]] != positions[i]) {
            slot = (slot + 1) & mask;
        }
        if (table[slot] == kNone) table[slot] = static_cast<Index>(i);
        merged[i] = table[slot];
    }
    return merged;
}

MeshTopology::MeshTopology(std::span<const TriangleMesh::Corners> triangles,
                           std::vector<Index> merged)
    : merged_(std::move(merged)), first_(merged_.size() + 1, 0), corners_(3 * triangles.size()) {
    for (const TriangleMesh::Corners& triangle : triangles) {
        for (Index vertex : triangle) ++first_[merged_[vertex] + 1];
    }
    for (std::size_t v = 0; v < merged_.size(); ++v) first_[v + 1] += first_[v];
    // Filling moves each start to the next vertex's; shifting by one afterwards undoes that.
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            corners_[first_[merged_[triangles[t][k]]]++] = static_cast<Index>(3 * t + k);
        }
    }
    for (std::size_t v = merged_.size(); v > 0; --v) first_[v] = first_[v - 1];
    first_[0] = 0;
}

void MeshTopology::findEdges(std::span<const TriangleMesh::Corners> triangles, Index vertex,
                             std::vector<Edge>& edges) const {
    edges.clear();
    for (const Index corner : cornersAt(vertex)) {
        const TriangleMesh::Corners& triangle = triangles[corner / 3];
        for (Index k = 1; k < 3; ++k) {
            const Index end = merged_[triangle[(corner + k) % 3]];
            if (end > vertex) edges.push_back({end, corner / 3});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.end < b.end; });
}

bool MeshTopology::isClosed(std::span<const TriangleMesh::Corners> triangles) const {
    if (triangles.empty()) return false;
    std::vector<Edge> edges;
    for (std::size_t v = 0; v < merged_.size(); ++v) {
        findEdges(triangles, static_cast<Index>(v), edges);
        if (edges.size() % 2 != 0) return false;
        for (std::size_t i = 0; i < edges.size(); i += 2) {
            if (edges[i].end != edges[i + 1].end) return false;
            if (i > 0 && edges[i].end == edges[i - 1].end) return false;
        }
    }
    return true;
}

std::vector<bool> MeshTopology::onBorder(std::span<const TriangleMesh::Corners> triangles) const {
    std::vector<bool> border(triangles.size());
    std::vector<Edge> edges;
    for (std::size_t v = 0; v < merged_.size(); ++v) {
        findEdges(triangles, static_cast<Index>(v), edges);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const bool shared = (i > 0 && edges[i - 1].end == edges[i].end) ||
                                (i + 1 < edges.size() && edges[i + 1].end == edges[i].end);
            if (!shared) border[edges[i].triangle] = true;
        }
    }
    return border;
}

}  // namespace rt
