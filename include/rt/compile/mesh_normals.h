// Normals of a mesh that brings none.
//
// At corner c of triangle t, with unit normals n_s of the faces s that meet at c's (merged) vertex
// and a_s the angle of face s there:
//
//     n(c) = normalise( sum of a_s n_s over the faces s with n_s . n_t >= cos(smoothAngle) ),
//
// so that the result does not depend on how a surface was cut into triangles (Thuermer, Wuethrich,
// "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1), 1998).
#pragma once

#include "rt/compile/mesh_topology.h"
#include "rt/core/vec.h"
#include "rt/geometry/triangle_mesh.h"

#include <span>

namespace rt {

/// (b - a) x (c - a), normalised, or 0 if the triangle has no area, or none that is certain in
/// spite of the rounding of its sides; right at every scale.
Vec3 unitFaceNormal(const Vec3& a, const Vec3& b, const Vec3& c);

/// v / |v| at every scale, or 0 for the zero vector.
Vec3 normalizedOrZero(const Vec3& v);

/// Mark in `normalCorners` before smoothNormals: this corner takes the geometric normal.
inline constexpr Index kGeometricNormal = kNone - 1;

/// Gives every corner that is kNone in `mesh.normalCorners` (all of them, if that is empty) the
/// normal above; corners of one vertex share equal ones. A corner whose normal is its face's own
/// stays kNone, as do those whose sum cancels. `faceNormals` are those of the mesh's triangles, 0
/// for one without area; `smoothAngleDegrees` is in 0 .. 180. Leaves kNone for kGeometricNormal,
/// and `normalCorners` empty if nothing but kNone would be in it.
void smoothNormals(TriangleMesh& mesh, const MeshTopology& topology,
                   std::span<const Vec3> faceNormals, double smoothAngleDegrees, int threads);

}  // namespace rt
