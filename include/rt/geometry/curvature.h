// How the shading normal turns along a surface: the derivative of the unit normal, in object space,
// for a step `along` of the point in the tangent plane. 0 on what is flat; not finite where there
// is none (an apex, the axis of a spindle).
//
//     sphere      dn = dp / r, the part of dp along the normal left out, as everywhere
//     cylinder    dn = dp_t / r, dp_t the part of dp around the axis
//     cone        dn = cos a dp_t / rho, rho the distance to the axis, a half the apex' angle
//     frustum     the same, a half its sides' angle
//     hemisphere  as the sphere, and as what is flat
//     torus       dn = dp_m / r + n_rho dp_t / rho, dp_m the part along the tube's circle (-dp_m on
//                 the lemon, whose normal points to the centre)
//     quadric     dn = (A dp - (n . A dp) n) / |A p + b|, n along A p + b
//     triangle    n = s / |s|, s = sum of b_k n_k: dn = (ds - (n . ds) n) / |s|, with the db of dp
//
// Igehy, Tracing Ray Differentials, SIGGRAPH 1999, section 3.2.
#pragma once

#include "rt/geometry/box.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/disc.h"
#include "rt/geometry/frustum.h"
#include "rt/geometry/hemisphere.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/plane.h"
#include "rt/geometry/quadric.h"
#include "rt/geometry/rectangle.h"
#include "rt/geometry/sphere.h"
#include "rt/geometry/torus.h"
#include "rt/geometry/triangle_mesh.h"

namespace rt {

Vec3 normalChange(const Sphere& sphere, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Box& box, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Cylinder& cylinder, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Cone& cone, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Quadric& quadric, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Hemisphere& hemisphere, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const Frustum& frustum, const PrimitiveHit& hit, const Vec3& along);
inline Vec3 normalChange(const Disc&, const PrimitiveHit&, const Vec3&) {
    return Vec3(0.0);
}
inline Vec3 normalChange(const Rectangle&, const PrimitiveHit&, const Vec3&) {
    return Vec3(0.0);
}
inline Vec3 normalChange(const Plane&, const PrimitiveHit&, const Vec3&) {
    return Vec3(0.0);
}
Vec3 normalChange(const Torus& torus, const PrimitiveHit& hit, const Vec3& along);
Vec3 normalChange(const TriangleMesh& mesh, const PrimitiveHit& hit, const Vec3& along);

}  // namespace rt
