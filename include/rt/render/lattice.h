// The corners of an area's pixels, each looked through once. Where the four corners of a pixel see
// the same surfaces, and nothing but smooth shading between them, the pixel needs no samples of its
// own: neighbours share their corners, so an even area costs one probe a pixel.
#pragma once

#include "rt/core/zeroed_array.h"
#include "rt/render/tiles.h"
#include "rt/trace/probe.h"
#include "rt/trace/trace_kernel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// Row-major probes of the corners of `area`; corner (x, y) is the upper left one of pixel (x, y).
struct Lattice {
    explicit Lattice(const Tile& area)
        : corners{area.x0, area.y0, area.x1 + 1, area.y1 + 1},
          probes(static_cast<std::size_t>(corners.width()) *
                 static_cast<std::size_t>(corners.height())) {}

    std::size_t stride() const { return static_cast<std::size_t>(corners.width()); }
    std::size_t offset(int x, int y) const { return corners.offset(x, y); }

    Tile corners;
    ZeroedArray<Probe> probes;
    int spacing = 1;  ///< pixels from one corner to the next
};

/// Of each pixel of an area the squared bias that is left, or kUntold.
using ToldPixels = std::vector<float>;
inline constexpr float kUntold = -1.0F;

}  // namespace rt
