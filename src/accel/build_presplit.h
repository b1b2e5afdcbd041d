// Splitting long, slanted triangles before the build, so that their boxes hold less empty space
// (Ganestam, Doggett, "SAH guided spatial split partitioning for fast BVH construction", 2016).
#pragma once

#include "build_box.h"
#include "rt/accel/large_array.h"
#include "rt/accel/wide_tree.h"
#include "rt/geometry/triangle_mesh.h"

#include <cstddef>

namespace rt {

struct RefArray {
    LargeArray<BoxRef> refs;
    std::size_t count = 0;
};

/// One ref for each triangle, with its box in the frame; or several, which together cover it, where
/// that makes the boxes much smaller as a whole.
RefArray triangleRefs(const TriangleMesh& mesh, const TreeFrame& frame, int threads);

}  // namespace rt
