// The decoders behind loadImage.
#pragma once

#include "rt/core/input_file.h"
#include "rt/image/image.h"
#include "rt/image/oiio_library.h"

#include <cstdint>
#include <span>
#include <string>

namespace rt {

/// Whether an image of these sides is allowed: SceneError for no pixels, LimitError for too many.
void checkSize(std::uint64_t width, std::uint64_t height, const std::string& path,
               const ImageLimits& limits);

/// Decodes a PNG. Grey stays grey, palettes become colours, fewer than 8 bits become 8.
Image readPng(std::span<const std::uint8_t> bytes, const std::string& path,
              const ImageLimits& limits);

/// Reads a file as `format`, a name of OpenImageIO's; SceneError with the library's problem if it
/// has one.
Image readThroughOiio(const std::string& path, const char* format, const ImageLimits& limits,
                      const OiioLibrary& library);

}  // namespace rt
