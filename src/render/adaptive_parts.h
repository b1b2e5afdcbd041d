// What the parts of Adaptive share.
#pragma once

#include "rt/core/vec.h"
#include "rt/render/tiles.h"

#include <algorithm>

namespace rt {

/// As image files hold it.
inline Color clipped(const Color& color) {
    return glm::clamp(color, 0.0, 1.0);
}

/// Mean over the channels.
inline double meanSquare(const Color& color) {
    return glm::dot(color, color) / 3.0;
}

/// Calls use(x, y) for a place and its up to eight neighbours, row by row.
template <class Use>
void forNeighbourhood(const Tile& area, int x, int y, Use&& use) {
    for (int v = std::max(y - 1, area.y0); v < std::min(y + 2, area.y1); ++v) {
        for (int u = std::max(x - 1, area.x0); u < std::min(x + 2, area.x1); ++u) use(u, v);
    }
}

}  // namespace rt
