// Polygons in, a finished TriangleMesh out.
#pragma once

#include "rt/compile/mesh_file.h"
#include "rt/core/diagnostics.h"
#include "rt/geometry/triangle_mesh.h"
#include "triangulate.h"

#include <span>
#include <vector>

namespace rt {

/// A polygon's corner, as indices into the builder's arrays; kNone = not given.
struct PolygonCorner {
    Index position = kNone;
    Index uv = kNone;
    Index normal = kNone;
};

/// Appends to the arrays of one mesh. Indices must be in range when addFace is called.
class MeshBuilder {
  public:
    std::vector<Vec3> positions;
    std::vector<Vec2> uvs;
    std::vector<Vec3> normals;  ///< of any length

    /// Triangulates a face. SceneError at `where` for more triangles than a mesh can hold.
    void addFace(std::span<const PolygonCorner> face, const SourceLocation& where);
    /// Counted, for the warning in finish: a face of one or two corners.
    void skipFace() { ++skippedFaces_; }

    /// Merges, drops, smooths, closes; leaves the builder empty.
    TriangleMesh finish(const MeshOptions& options, const SourceLocation& where,
                        Diagnostics& diagnostics);

  private:
    void addTriangle(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c);
    TriangleMesh release();
    void normalizeGiven(TriangleMesh& mesh, const SourceLocation& where, Diagnostics& diagnostics);
    void shape(TriangleMesh& mesh, const MeshOptions& options) const;

    std::vector<TriangleMesh::Corners> triangles_;
    std::vector<TriangleMesh::Corners> uvCorners_;      ///< empty until a face has one
    std::vector<TriangleMesh::Corners> normalCorners_;  ///< empty until a face has one
    std::size_t skippedFaces_ = 0;
    std::vector<Vec3> outline_;
    Triangulator triangulate_;
};

}  // namespace rt
