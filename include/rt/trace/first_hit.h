// What a pixel's centre shows: the geometry behind it, free of noise.
#pragma once

#include "rt/core/vec.h"

#include <cstdint>

namespace rt {

/// The first surface on the ray through the image point (x + 1/2, y + 1/2) and the centre of the
/// lens: one ray, always the same, for of a depth or a number a mean over the pixel would be no
/// surface's. Lengths are in units of the world. All is 0 where nothing is hit, but the depth.
struct FirstHit {
    /// (P - eye) . v for the point P and the unit view direction v: what a z-buffer holds. Infinity
    /// where nothing is hit.
    double depth = kInfinity;
    Vec3 position{0.0};  ///< P, in the world
    /// The unit normal that shades, in the world: interpolated and bump-mapped, and turned towards
    /// the viewer.
    Vec3 normal{0.0};
    /// The diffuse colour, of a texture its mean over the pixel (at full resolution, bilinear, with
    /// --reference).
    Color albedo{0.0};
    Vec2 uv{0.0};  ///< texture coordinates
    /// The object's place in the scene graph, from 1 on: a node before its children, these in
    /// order.
    std::uint32_t object = 0;
};

}  // namespace rt
