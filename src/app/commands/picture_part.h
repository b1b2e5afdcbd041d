// A shard of a picture as a file: all that the picture's bytes need in any format.
//
// Numbers are little endian, floats are IEEE 754; u4 and u8 are unsigned of 4 and 8 bytes, f4 and
// f8 floats; a text is its length (u4) and its bytes.
//
//   "RTPART2\n"
//   u8 scene hash, u8 seed, u4 width, u4 height of the image
//   u4 x 4    x0 y0 x1 y1 of the area that all shards together render
//   u4 index, u4 count of the shard
//   u4 bits, u4 1 for --transfer srgb
//   u4 1 for --error, then f8 samples per pixel, u4 1 where an error is known, f8 it
//   f8        the squared error that photons leave
//   text      the scene's name
//   u4        number of planes; of each a text for its name, u4 channels, a text for each
//   tiles     of the area, row by row, those that the shard owns: f8 sum of the bounds of what was
//             cut, u8 camera rays; of each pixel f8 x 6 sum and half of the sum, u8 samples; of
//             each plane f4 values
//   u8        FNV-1a of all bytes before
#pragma once

#include "rt/output/image_writer.h"
#include "rt/render/tiles.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

struct PartTile {
    Tile tile;
    double cutBound = 0.0;
    std::uint64_t cameraRays = 0;
    std::vector<PixelState> pixels;
    std::vector<std::vector<float>> planes;  ///< the values of each
};

struct PicturePart {
    std::uint64_t sceneHash = 0;
    std::uint64_t seed = 0;
    int width = 0;
    int height = 0;
    Tile area;
    Shard shard;
    ImageSettings settings;
    /// Towards an error target, a pixel's samples were chosen by the whole picture, of which these
    /// are then known.
    bool planned = false;
    double samplesPerPixel = 0.0;
    std::optional<double> error;
    double causticError = 0.0;  ///< squared, that photons leave
    std::string scene;
    std::vector<ImagePlane> planes;  ///< without values
    std::vector<PartTile> tiles;
};

std::vector<std::uint8_t> encodePart(const PicturePart& part);

/// Throws SceneError with the path for bytes that are no part, of another version, or damaged.
PicturePart decodePart(const std::vector<std::uint8_t>& bytes, const std::string& path);

/// "x.2-of-4.part" beside "x.png"; a name that ends in ".part" is left as it is.
std::string partName(const std::string& output, const Shard& shard);

}  // namespace rt
