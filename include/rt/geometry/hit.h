// What a ray meets on one primitive.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"

namespace rt {

/// The nearest crossing of a ray with a primitive, as cheap as traversal needs it.
struct PrimitiveHit {
    double t = kInfinity;
    /// The point relative to the primitive's own anchor (a sphere's centre, a cone's apex ...), in
    /// object units: far more exact than origin + t direction when the ray comes from far away.
    /// On a triangle: its barycentric weights.
    Vec3 local{0.0};
    /// Which piece of the surface: a face, a cap, a triangle of a mesh.
    Index part = 0;
    /// Which of the solids that a combined one is made of; `local` and `part` are of that.
    Index leaf = 0;
};

/// How much of a SurfacePoint is wanted. Texture coordinates and their derivatives cost angles, and
/// images alone use them.
enum class SurfaceDetail { kShape, kParametrised };

/// All that shading wants to know of a crossing, in object space.
struct SurfacePoint {
    Vec3 point{0.0};
    /// Bound on the distance between `point` and the true surface, in object units.
    double error = 0.0;
    /// Outward unit normals: of the surface itself, and interpolated (the same on solids).
    Vec3 normal{0.0};
    Vec3 shadingNormal{0.0};
    /// Where shadow rays start: `point`, but on a smooth mesh lifted onto the rounded surface that
    /// its normals pretend (Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II, 2021, ch.
    /// 4).
    Vec3 shadowOrigin{0.0};
    /// Of kParametrised: texture coordinates, and the derivatives of the point by u and v, 0 where
    /// the surface has no parametrisation.
    Vec2 uv{0.0};
    Vec3 dpdu{0.0};
    Vec3 dpdv{0.0};
};

}  // namespace rt
