// Finished pixels, on their way into a file.
#pragma once

#include "rt/core/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

/// Floats beside an image, of the same pixels, their channels side by side; infinity is allowed.
struct ImagePlane {
    std::string name;                   ///< "normal"
    std::vector<std::string> channels;  ///< one to three: "X", "Y", "Z"
    std::vector<float> values;
};

/// Image values in rows from left to right, the top row first: 0 is black, 1 is full, more is
/// allowed. Every value must be finite.
struct PixelImage {
    int width = 0;
    int height = 0;
    std::vector<Color> pixels;
    std::vector<ImagePlane> planes = {};

    const Color& at(int x, int y) const { return pixels[indexOf(x, y)]; }
    Color& at(int x, int y) { return pixels[indexOf(x, y)]; }

    std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

}  // namespace rt
