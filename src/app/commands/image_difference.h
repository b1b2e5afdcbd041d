// How far two images are apart, in numbers.
#pragma once

#include "rt/output/pixel_image.h"

#include <string>

namespace rt {

/// An image for comparison, and what its file held.
struct ComparedImage {
    PixelImage image;
    bool floats = false;
    int channels = 3;   ///< in the file: 1 or 3
    double step = 0.0;  ///< between neighbouring values of the file's integers; 0 for floats
};

/// Reads an image of any kind that this program reads or writes, its values as they are: integers
/// are scaled to [0,1], grey becomes three equal channels. Throws SceneError.
ComparedImage loadForComparison(const std::string& path);

/// Differences of all channels of all pixels.
struct ImageDifference {
    double rmse = 0.0;
    double meanAbsolute = 0.0;
    double maxAbsolute = 0.0;
    int maxX = 0;  ///< the first pixel that has it
    int maxY = 0;
    double shareOver = 0.0;  ///< of pixels with a channel that differs by more than 4/255
};

/// Both of the same size. A value that is not a number makes the errors NaN.
ImageDifference differenceOf(const PixelImage& a, const PixelImage& b);

/// Values clamped to [0,1]; NaN stays.
void clampValues(PixelImage& image);

/// True if a value is NaN or infinite.
bool hasNonFinite(const PixelImage& image);

}  // namespace rt
