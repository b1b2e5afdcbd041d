// Meshes from OBJ files and from tables of polygons.
//
// OBJ (Wavefront, Advanced Visualizer Manual, appendix B1): `v`, `vt`, `vn` and `f` with every form
// of index (1, 1/2, 1//3, 1/2/3, negative ones counting back from the last), `\` continuations,
// comments, and lines that end in LF, CR LF or CR. A face may name vertices that follow it.
// Everything else is ignored with one warning for the file. Numbers are correctly rounded, with a
// point whatever the locale.
//
// Polygons of any length become triangles (triangulate.h). Triangles without area are dropped with
// one counted warning, after their edges have been counted for `closed`: a zero-area triangle that
// joins three vertices of one line opens no hole.
//
// Normals: as given (normalised), or of length zero (geometric, one counted warning); corners
// without one get the normal of mesh_normals.h.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/core/vec.h"
#include "rt/geometry/triangle_mesh.h"

#include <cstdint>
#include <span>
#include <string>

namespace rt {

struct MeshOptions {
    /// Faces within this angle of one another are shaded as one surface: 0 flat .. 180 all round.
    double smoothAngleDegrees = 40.0;
    /// Most bytes that loading may need, estimated from the size of the file.
    std::uint64_t memoryLimit = std::uint64_t{8} << 30;
    /// The mesh is the same for any number.
    int threads = 1;
};

/// The mesh in an OBJ file; one without faces is empty, with a warning. SceneError with the file's
/// path and line for what is not an OBJ or names what it lacks; LimitError, before anything is
/// allocated, for a file that would need more than the limit.
TriangleMesh loadObj(const std::string& path, const MeshOptions& options, Diagnostics& diagnostics);

/// The mesh of polygons whose corners, 0-based, follow one another in `corners`, faceSizes[k] of
/// them for face k. Faces of one or two corners are skipped with one counted warning. SceneError at
/// `where` for a corner out of range, sizes that do not add up, or a vertex that is not finite.
TriangleMesh meshFromPolygons(std::span<const Vec3> vertices, std::span<const Index> corners,
                              std::span<const Index> faceSizes, const MeshOptions& options,
                              const SourceLocation& where, Diagnostics& diagnostics);

}  // namespace rt
