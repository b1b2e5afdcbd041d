// Bump maps: normals changed by an image.
//
// Three channels: a normal map. Codes c of 0 .. 255 stand for max(-1, (c - 128) / 127), so that
// (128, 128, 255) is (0, 0, 1), exactly straight; with N the surface's own normal and
//
//     T = normalise(dpdu - (N . dpdu) N),   B = +- N x T,
//
// the sign that turns B towards dpdv, the normal is normalise(x T + y B + z N). Red leans towards
// the image's right, green towards its top, mirrored coordinates or not.
//
// One channel: a height map h(u, v) over the surface, white kHeightOfWhite sides of the image above
// black. With H = kHeightOfWhite sqrt|dpdu x dpdv| h, in object units, the normal is
//
//     normalise(N - (H_u (dpdv x N) + H_v (N x dpdu)) / (N . (dpdu x dpdv)))
//
// (Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978): the gradient of H along the surface.
#pragma once

#include "rt/core/vec.h"
#include "rt/geometry/hit.h"
#include "rt/shading/texture.h"

namespace rt {

inline constexpr double kHeightOfWhite = 1.0 / 32.0;

/// The tangent-space normal, not normalised, of a map's codes (0 .. 255).
Vec3 decodedNormal(const Color& codes);

/// The unit shading normal of `surface` under the map; its own, to the bit, where the map is
/// straight or level, and where the surface has no parametrisation.
Vec3 bumpedNormal(const Texture& map, const SurfacePoint& surface);

}  // namespace rt
