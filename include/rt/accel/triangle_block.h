// Leaves of a mesh tree: up to eight triangles over up to eight corners that they share.
#pragma once

#include "rt/core/vec.h"

#include <cstdint>

namespace rt {

/// Corner positions are the mesh's own doubles, so that a block and a single triangle give the same
/// bits. Unused triangles name corner 0 three times: they have no area and are missed.
struct alignas(64) TriangleBlock {
    static constexpr int kSize = 8;

    double corner[3][kSize];          ///< x, y, z of each corner
    std::uint8_t triangle[3][kSize];  ///< first, second, third corner of each triangle
    Index id[kSize];                  ///< the triangle's number in the mesh
    std::uint64_t count;              ///< triangles in use
};
static_assert(sizeof(TriangleBlock) == 256);

}  // namespace rt
