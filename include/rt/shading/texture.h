// Colours from images.
//
// The truth of a texture is bilinear at full resolution: with texel (i, j) counted from the top
// left and its centre at half integers,
//
//     x = w u - 1/2,   y = h (1 - v) - 1/2,   i = floor x,   f = x - i,   j = floor y,   g = y - j,
//     c = lerp(lerp(c_ij, c_(i+1)j, f), lerp(c_i(j+1), c_(i+1)(j+1), f), g),
//
// indices modulo w and h (or clamped, with `heldEdges`), so that the image repeats outside [0,1]; v
// = 0 is the bottom of the image, or with `flipV` its top (then y = h v - 1/2). A uv that is not
// finite reads as 0.
#pragma once

#include "rt/core/vec.h"
#include "rt/image/image.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rt {

struct TextureSettings {
    bool flipV = false;      ///< v = 0 at the top of the image
    bool srgb = false;       ///< 8 and 16 bits hold sRGB values, to be made linear
    bool prefilter = false;  ///< build the pyramid for `filtered`: 4 bytes a texel of the image
    bool heldEdges = false;  ///< each tile ends at its border, and does not blend with the next
};

/// A parallelogram of uv space, of which a uv that is looked up is one point.
struct TextureFootprint {
    Vec2 across{0.0};
    Vec2 down{0.0};
    Vec2 phase{0.5};  ///< where the uv lies in it, 0 .. 1 along each side
};

class Texture {
  public:
    explicit Texture(Image image, const TextureSettings& settings = {});

    int width() const { return image_.width; }
    int height() const { return image_.height; }
    int channels() const { return image_.channels; }
    bool flipsV() const { return settings_.flipV; }

    /// The value at uv: code / 255 or / 65535, linear from sRGB if so set, or the float itself.
    /// Grey in all three channels of an image that has one.
    Color bilinear(const Vec2& uv) const;

    /// The same without any decoding, in units of an 8-bit code: 0 .. 255.
    Color bilinearCodes(const Vec2& uv) const;

    /// Slope of the first channel, as a value, by u and by v: central differences at the texels,
    /// bilinear between them, and so continuous.
    Vec2 gradient(const Vec2& uv) const;

    /// The mean over a footprint, from taps in it: of the full resolution, or where it is many
    /// texels wide of a pyramid of area means (Williams, "Pyramidal Parametrics", SIGGRAPH 1983)
    /// whose texels are small beside it. The footprint's cells have one tap each, `phase` deciding
    /// where: for a phase that is uniform each tap is uniform in its cell, and without a pyramid
    /// the expectation is exactly the mean. The first tap is the uv itself where there is but one:
    /// for a footprint of no more than a texel, of more than numbers hold, or of NaN.
    Color filtered(const Vec2& uv, const TextureFootprint& footprint) const;

    /// No look-up gives more than this in any channel.
    double largestValue() const;

  private:
    /// Area means of the image, in w x h texels; rows from the top.
    struct Level {
        int width;
        int height;
        std::vector<std::array<float, 3>> texels;
    };

    Vec2 onImage(const Vec2& uv) const;
    void buildPyramid();
    Color atLevel(std::size_t level, const Vec2& uv) const;
    std::size_t levelFor(const Vec2& a, const Vec2& b) const;

    Image image_;
    TextureSettings settings_;
    std::vector<double> linear_;  ///< by code; empty unless sRGB
    std::vector<Level> levels_;   ///< half the sides each, the first half of the image's
};

}  // namespace rt
