// What the pixels of an area have gathered.
#pragma once

#include "rt/core/zeroed_array.h"
#include "rt/render/tiles.h"
#include "rt/trace/trace_kernel.h"

#include <cstddef>
#include <vector>

namespace rt {

/// Row-major pixels of `area`, in coordinates of the whole image.
struct Film {
    explicit Film(const Tile& filmArea)
        : area(filmArea),
          pixels(static_cast<std::size_t>(filmArea.width()) *
                 static_cast<std::size_t>(filmArea.height())) {}

    PixelState& at(int x, int y) { return pixels[offset(x, y)]; }
    const PixelState& at(int x, int y) const { return pixels[offset(x, y)]; }

    Tile area;
    ZeroedArray<PixelState> pixels;

    std::size_t offset(int x, int y) const { return area.offset(x, y); }
};

}  // namespace rt
