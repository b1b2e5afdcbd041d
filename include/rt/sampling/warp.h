// Maps of the unit square onto the shapes that are sampled; each keeps areas in proportion, so
// uniform points stay uniform, and keeps neighbours together, so well-spread points stay so.
#pragma once

#include "rt/core/vec.h"

namespace rt {

/// The unit disc. With (a, b) = 2u - 1: radius r = a, angle pi/4 b/a where |a| > |b|, and
/// r = b, angle pi/2 - pi/4 a/b elsewhere
/// (Shirley and Chiu, A Low Distortion Map Between Disk and Square, J. Graphics Tools 2(3), 1997).
Vec2 concentricDisc(const Vec2& u);

/// Two unit vectors that make a right-handed orthonormal system with the unit vector that was given
/// (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017).
struct Basis {
    Vec3 tangent;
    Vec3 bitangent;
};
Basis orthonormalBasis(const Vec3& normal);

/// A unit direction, uniform in solid angle, in the cone of half-angle A about a unit axis;
/// oneMinusCos = 1 - cos A in [0, 2]. With the disc point d: 1 - cos t = |d|^2 (1 - cos A) and
/// sin t = |d| sqrt((1 - cos A)(2 - |d|^2 (1 - cos A))), which loses nothing in the tiniest cone.
Vec3 coneDirection(const Vec3& axis, double oneMinusCos, const Vec2& u);

}  // namespace rt
