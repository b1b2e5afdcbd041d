// What an object may be, each alternative in its own space.
#pragma once

#include "rt/accel/mesh_tree.h"
#include "rt/geometry/box.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/disc.h"
#include "rt/geometry/frustum.h"
#include "rt/geometry/hemisphere.h"
#include "rt/geometry/plane.h"
#include "rt/geometry/quadric.h"
#include "rt/geometry/rectangle.h"
#include "rt/geometry/sphere.h"
#include "rt/geometry/torus.h"
#include "rt/geometry/triangle_mesh.h"

#include <memory>
#include <variant>

namespace rt {

/// A mesh with its tree, held once however often it is placed.
struct MeshShape {
    TriangleMesh mesh;
    MeshTree tree;
};

/// Solids combined to one (rt/trace/csg_shape.h).
struct CsgShape;

using Shape =
    std::variant<Sphere, Box, Cylinder, Cone, Torus, std::shared_ptr<const MeshShape>, Disc,
                 Rectangle, Plane, Hemisphere, Frustum, std::shared_ptr<const CsgShape>, Quadric>;

/// In the shape's own space.
Bounds boundsOf(const Shape& shape);

/// What its form is; a mesh is taken for not convex.
SolidKind kindOf(const Shape& shape);
/// "sphere", for people.
const char* nameOf(const Shape& shape);

}  // namespace rt
