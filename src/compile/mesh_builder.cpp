#include "mesh_builder.h"

#include "rt/compile/mesh_normals.h"
#include "rt/compile/mesh_topology.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <utility>

namespace rt {
namespace {

// Corners are numbered in an Index.
constexpr std::size_t kMostTriangles = kGeometricNormal / 3;

constexpr TriangleMesh::Corners kNoCorners = {kNone, kNone, kNone};

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void setCorners(std::vector<TriangleMesh::Corners>& all, std::size_t triangle,
                const TriangleMesh::Corners& corners) {
    if (all.empty() && corners == kNoCorners) return;
    // The faces before the first that has one have none.
    all.resize(triangle, kNoCorners);
    all.push_back(corners);
}

/// Keeps the triangles for which `keep` holds, in all of the mesh's arrays by triangle.
template <typename Keep>
std::size_t keepTriangles(TriangleMesh& mesh, Keep keep) {
    std::size_t kept = 0;
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        if (!keep(t)) continue;
        mesh.triangles[kept] = mesh.triangles[t];
        if (!mesh.uvCorners.empty()) mesh.uvCorners[kept] = mesh.uvCorners[t];
        if (!mesh.normalCorners.empty()) mesh.normalCorners[kept] = mesh.normalCorners[t];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (!mesh.uvCorners.empty()) mesh.uvCorners.resize(kept);
    if (!mesh.normalCorners.empty()) mesh.normalCorners.resize(kept);
    return count - kept;
}

std::vector<Vec3> faceNormalsOf(const TriangleMesh& mesh, int threads) {
    constexpr std::size_t kChunk = std::size_t{1} << 14;
    const std::size_t count = mesh.triangles.size();
    std::vector<Vec3> normals(count);
    forEachIndex((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, int) {
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t t = chunk * kChunk; t < end; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            normals[t] = unitFaceNormal(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
        }
    });
    return normals;
}

}  // namespace

void MeshBuilder::addTriangle(const PolygonCorner& a, const PolygonCorner& b,
                              const PolygonCorner& c) {
    const std::size_t triangle = triangles_.size();
    triangles_.push_back({a.position, b.position, c.position});
    setCorners(uvCorners_, triangle, {a.uv, b.uv, c.uv});
    setCorners(normalCorners_, triangle, {a.normal, b.normal, c.normal});
}

void MeshBuilder::addFace(std::span<const PolygonCorner> face, const SourceLocation& where) {
    if (face.size() - 2 > kMostTriangles - triangles_.size()) {
        throw LimitError("a mesh may have " + std::to_string(kMostTriangles) + " triangles at most",
                         where);
    }
    if (face.size() == 3) {
        addTriangle(face[0], face[1], face[2]);
        return;
    }
    outline_.clear();
    for (const PolygonCorner& corner : face) outline_.push_back(positions[corner.position]);
    for (const auto& [a, b, c] : triangulate_(outline_)) addTriangle(face[a], face[b], face[c]);
}

TriangleMesh MeshBuilder::release() {
    TriangleMesh mesh;
    mesh.positions = std::exchange(positions, {});
    mesh.triangles = std::exchange(triangles_, {});
    mesh.normals = std::exchange(normals, {});
    mesh.normalCorners = std::exchange(normalCorners_, {});
    mesh.uvs = std::exchange(uvs, {});
    mesh.uvCorners = std::exchange(uvCorners_, {});
    if (mesh.normalCorners.empty()) mesh.normals = {};
    if (mesh.uvCorners.empty()) mesh.uvs = {};
    return mesh;
}

void MeshBuilder::normalizeGiven(TriangleMesh& mesh, const SourceLocation& where,
                                 Diagnostics& diagnostics) {
    std::vector<bool> lacksLength(mesh.normals.size(), false);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        mesh.normals[i] = normalizedOrZero(mesh.normals[i]);
        lacksLength[i] = mesh.normals[i] == Vec3(0.0);
    }
    std::size_t corners = 0;
    for (TriangleMesh::Corners& triangle : mesh.normalCorners) {
        for (Index& corner : triangle) {
            if (corner == kNone || !lacksLength[corner]) continue;
            corner = kGeometricNormal;
            ++corners;
        }
    }
    if (corners == 0) return;
    diagnostics.warn("mesh-normals", where,
                     counted(corners, "corner has", "corners have") +
                         " a normal of length zero; the face's own is used there");
}

void MeshBuilder::shape(TriangleMesh& mesh, const MeshOptions& options) const {
    std::vector<Index> merged = mergeEqualPositions(mesh.positions);
    keepTriangles(mesh, [&](std::size_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        return merged[a] != merged[b] && merged[b] != merged[c] && merged[c] != merged[a];
    });
    const std::vector<Vec3> faceNormals = faceNormalsOf(mesh, options.threads);
    std::vector<bool> onBorder(mesh.triangles.size());
    {
        const MeshTopology topology(mesh.triangles, std::move(merged));
        mesh.closed = topology.isClosed(mesh.triangles);
        if (!mesh.closed) onBorder = topology.onBorder(mesh.triangles);
        smoothNormals(mesh, topology, faceNormals, options.smoothAngleDegrees, options.threads);
    }
    Index kept = 0;
    keepTriangles(mesh, [&](std::size_t t) {
        if (faceNormals[t] == Vec3(0.0)) return false;
        if (onBorder[t]) mesh.border.push_back(kept);
        ++kept;
        return true;
    });
}

TriangleMesh MeshBuilder::finish(const MeshOptions& options, const SourceLocation& where,
                                 Diagnostics& diagnostics) {
    TriangleMesh mesh = release();
    if (skippedFaces_ > 0) {
        diagnostics.warn("mesh-faces", where,
                         counted(skippedFaces_, "face has", "faces have") +
                             " fewer than 3 corners and " + (skippedFaces_ == 1 ? "is" : "are") +
                             " skipped");
        skippedFaces_ = 0;
    }
    const std::size_t all = mesh.triangles.size();
    normalizeGiven(mesh, where, diagnostics);
    shape(mesh, options);
    const std::size_t dropped = all - mesh.triangles.size();
    if (dropped > 0) {
        diagnostics.warn(
            "mesh-degenerate", where,
            counted(dropped, "triangle has no area and is", "triangles have no area and are") +
                " dropped");
    }
    if (mesh.triangles.empty()) {
        diagnostics.warn("mesh-empty", where, "the mesh has no faces and is skipped");
        return {};
    }
    return mesh;
}

}  // namespace rt
