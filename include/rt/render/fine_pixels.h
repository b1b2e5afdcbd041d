// Pixels in which something may hide between the corners.
#pragma once

#include "rt/render/tiles.h"
#include "rt/trace/render_scene.h"

#include <vector>

namespace rt {

/// Row by row of `area`: the pixels that the box of an instance may cover that is less than some
/// pixels wide in the picture, in any direction, those in which an outline comes to a point, and
/// those of small triangles at the border of an open mesh. Corners alone could miss any of them.
std::vector<bool> finePixels(const RenderScene& scene, const Tile& area);

}  // namespace rt
