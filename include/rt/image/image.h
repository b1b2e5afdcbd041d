// Images in memory, and the files they come from.
#pragma once

#include "rt/core/diagnostics.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace rt {

/// Rows from left to right, the top row first, the channels of a pixel side by side. Samples are
/// kept as the file has them: 8 or 16 bits stand for 0 .. 1, floats for themselves. Transparency is
/// dropped, so there is one channel (grey) or three (red, green, blue).
struct Image {
    using Samples =
        std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

    int width = 0;
    int height = 0;
    int channels = 0;
    Samples samples;
};

struct ImageLimits {
    std::uint64_t maxPixels = std::uint64_t{1} << 28;
    /// Named in the message when an image has more.
    std::string option = "--max-pixels";
    /// Keeps negative and non-finite samples, for whoever looks for them.
    bool keepAllValues = false;
};

/// Reads an image file. Its content says what it is: a name that says otherwise is a warning. PNG
/// goes through lodepng; JPEG, EXR, HDR, TIFF, TGA and BMP through OpenImageIO, which is loaded
/// when the first of them is met; nothing else is read. Samples of a float image that are negative
/// or not finite become 0, with one counted warning.
///
/// SceneError with the path for a file that cannot be read, is no image, or is damaged; LimitError,
/// before anything is decoded, for one of more pixels than the limit.
Image loadImage(const std::string& path, const ImageLimits& limits, Diagnostics& diagnostics);

}  // namespace rt
