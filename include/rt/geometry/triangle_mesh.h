// Triangle meshes as data: positions, and per-corner normals and texture coordinates.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/vec.h"

#include <array>
#include <vector>

namespace rt {

/// Two-sided triangles; the geometric normal of (a, b, c) is (b - a) x (c - a), normalised.
/// Every index is in range and every value finite; degenerate triangles have been dropped.
struct TriangleMesh {
    using Corners = std::array<Index, 3>;

    std::vector<Vec3> positions;
    std::vector<Corners> triangles;

    /// Unit normals and the corners that use them; `normalCorners` is empty for a mesh that is flat
    /// throughout, and kNone in a corner means the triangle's geometric normal there.
    std::vector<Vec3> normals;
    std::vector<Corners> normalCorners;

    /// Texture coordinates, v upwards; `uvCorners` is empty where there are none, kNone means
    /// (0,0).
    std::vector<Vec2> uvs;
    std::vector<Corners> uvCorners;

    /// Every edge belongs to exactly two triangles (after merging equal positions): the mesh
    /// bounds a solid. Otherwise it is a sheet.
    bool closed = false;
    /// Of a mesh that is not closed: the triangles with a side that belongs to no other.
    std::vector<Index> border;

    Bounds bounds() const;
};

}  // namespace rt
