// Heights over a square -> a mesh.
//
// Height (i, j) of m by n stands at x = i / (m - 1), z = j / (n - 1), so that the first row lies
// along z = 0. A cell between four heights is two triangles, parted along the diagonal whose ends
// differ less in height. Vertex normals are those of the differences of the neighbours' heights (at
// a border, of the heights there); u = x and v = 1 - z, as on gr.quad.
//
// With a base four walls go down to y = base, and a bottom closes them.
//
// Memory: 64 bytes a height and 72 a cell, and the tree beside it.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/geometry/triangle_mesh.h"
#include "rt/image/image.h"
#include "rt/scene/scene_desc.h"

#include <cstddef>
#include <optional>

namespace rt {

/// As many heights as make a mesh of less than 2^26 triangles, walls included.
inline constexpr std::size_t kMostHeights = std::size_t{1} << 24;

struct HeightFieldOptions {
    std::optional<double> base;
    bool smooth = true;
};

/// Grey of an image: 0 .. 1 for 8 and 16 bits, values as they are for floats; of colours the mean.
HeightGrid gridOf(const Image& image);

/// LimitError at `where` beyond kMostHeights, SceneError for less than 2 by 2 heights and for a
/// base that does not lie below all of them.
TriangleMesh heightFieldMesh(const HeightGrid& grid, const HeightFieldOptions& options,
                             const SourceLocation& where);

}  // namespace rt
