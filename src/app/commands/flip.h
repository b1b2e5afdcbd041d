// How different two images look when one alternates between them.
//
// P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. D. Fairchild, FLIP: A
// Difference Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020;
// the variant for images of low dynamic range. Colours are filtered by the eye's contrast
// sensitivity and compared in a space of perceived distance; where edges or points differ, the
// difference is raised:
//     difference = colour ^ (1 - feature),    colour and feature in [0,1].
#pragma once

#include "rt/output/pixel_image.h"

#include <vector>

namespace rt {

/// The paper's viewer: 0.7 m away from a monitor 0.7 m wide with 3840 pixels a row.
inline constexpr double kFlipPixelsPerDegree = 3840.0 * 3.14159265358979323846 / 180.0;

/// The difference at each pixel, in [0,1], in the order of the images' pixels. Values are sRGB,
/// clamped to [0,1]; both images have the same size, and no value is NaN.
std::vector<double> flipMap(const PixelImage& first, const PixelImage& second,
                            double pixelsPerDegree = kFlipPixelsPerDegree);

/// The mean of that map.
double meanFlip(const PixelImage& first, const PixelImage& second,
                double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace rt
