// Image files: one table from a name's extension to its encoder. Equal images with equal metadata
// give equal bytes; no time is ever stored.
#pragma once

#include "rt/output/pixel_image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// How image values become the integers of a file. Files of floats hold the values as they are.
enum class Transfer {
    kRaw,   ///< round(full * clamp(value)), without a curve
    kSrgb,  ///< the same after the sRGB curve (IEC 61966-2-1), for linear values
};

struct ImageSettings {
    int bits = 8;  ///< 8 or 16, of a channel in files of integers
    Transfer transfer = Transfer::kRaw;
};

/// What a file says about its own making.
struct ImageMetadata {
    std::string scene;
    std::uint64_t seed = 0;
    double samplesPerPixel = 0.0;  ///< mean over the image
    std::optional<double> error;   ///< the estimated RMSE
};

/// Bytes of a file, or an OutputError.
using ImageEncoder = std::vector<std::uint8_t> (*)(const PixelImage&, const ImageSettings&,
                                                   const ImageMetadata&);

struct ImageFormat {
    const char* extension;  ///< ".png"
    const char* description;
    bool floats;              ///< holds the values, not integers
    bool layers;              ///< holds the planes of an image too
    std::int64_t mostBytes;   ///< of pixels: the format's own limit
    std::int64_t mostLength;  ///< of a side, in pixels
    bool throughPlugin;       ///< needs OpenImageIO
    ImageEncoder encode;
};

const std::vector<ImageFormat>& imageFormats();

/// By the extension, in either case; PNG for stdout, devices and pipes, whose names say nothing.
/// Throws OutputError with the list of what there is.
const ImageFormat& imageFormatOf(const std::string& path);

/// True for formats whose error is relative beyond 1 (float files) rather than clipped to [0,1].
bool holdsFloats(const std::string& path);

std::vector<std::string> namesOf(const std::vector<ImagePlane>& planes);

/// The files that an image with planes of these names is written to, `path` the last of them. A
/// format with layers holds the planes as layers; beside any other each has a file of its own,
/// "x.depth.pfm" for "x.png". Throws UsageError for planes beside a stream.
std::vector<std::string> imageFiles(const std::string& path,
                                    const std::vector<std::string>& planes);

/// Everything about an output that can be refused before rendering: its format, its size in
/// pixels, a missing plugin, a folder or a file that cannot be written. Throws OutputError.
void checkImageOutput(const std::string& path, int width, int height, const ImageSettings& settings,
                      const std::vector<std::string>& planes = {});

/// The bytes of a file. Throws std::logic_error if a value is not finite: that is for the caller
/// to find and report, never for a file to hide.
std::vector<std::uint8_t> encodeImage(const ImageFormat& format, const PixelImage& image,
                                      const ImageSettings& settings, const ImageMetadata& metadata);

/// Encodes and writes the files of `imageFiles`, each whole or not at all; returns a warning or "",
/// see writeFile.
std::string writeImage(const std::string& path, const PixelImage& image,
                       const ImageSettings& settings, const ImageMetadata& metadata);

/// `pattern` with each run of '#' replaced by `number`, padded with zeros to the run's length;
/// for the frames of an animation and the images of a script that renders several.
std::string numberedName(const std::string& pattern, std::int64_t number);

/// sRGB of a linear value in [0,1], the same on every processor.
double srgbFromLinear(double linear);

}  // namespace rt
