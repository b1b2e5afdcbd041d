// The encoders behind the table of image formats, and what they share.
#pragma once

#include "rt/output/image_writer.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rt {

std::vector<std::uint8_t> encodePng(const PixelImage& image, const ImageSettings& settings,
                                    const ImageMetadata& metadata);
std::vector<std::uint8_t> encodePfm(const PixelImage& image, const ImageSettings& settings,
                                    const ImageMetadata& metadata);
/// A plane of rows of `width` pixels; of two channels, the third of the file is 0.
std::vector<std::uint8_t> encodePfm(const ImagePlane& plane, int width);
std::vector<std::uint8_t> encodeExr(const PixelImage& image, const ImageSettings& settings,
                                    const ImageMetadata& metadata);
std::vector<std::uint8_t> encodeHdr(const PixelImage& image, const ImageSettings& settings,
                                    const ImageMetadata& metadata);
std::vector<std::uint8_t> encodeTiff(const PixelImage& image, const ImageSettings& settings,
                                     const ImageMetadata& metadata);

/// Throws OutputError, naming what is missing, if images cannot go through OpenImageIO.
void requirePlugin();

/// Keyword and text of everything that a file says about itself, in a fixed order.
std::vector<std::pair<std::string, std::string>> metadataEntries(const ImageMetadata& metadata);

/// round(full * clamp(value)) for each channel, after the transfer curve; full is 255 or 65535.
std::vector<std::uint8_t> quantized8(const PixelImage& image, Transfer transfer);
std::vector<std::uint16_t> quantized16(const PixelImage& image, Transfer transfer);

/// The channels as floats; values beyond the range of float become its ends.
std::vector<float> asFloats(const PixelImage& image);

}  // namespace rt
