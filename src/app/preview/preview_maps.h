// Snapshots as pictures.
#pragma once

#include "rt/output/image_writer.h"
#include "rt/render/snapshot.h"

#include <cstdint>
#include <vector>

namespace rt {

/// PNG files of 8 bits. The image as its file would hold it.
std::vector<std::uint8_t> picturePng(const RenderSnapshot& snapshot, const ImageSettings& settings);
/// log(1 + samples), the most of all white.
std::vector<std::uint8_t> samplesPng(const RenderSnapshot& snapshot);
/// The root of the estimated RMSE, the largest white; all black where it is unknown.
std::vector<std::uint8_t> errorPng(const RenderSnapshot& snapshot);

std::uint32_t mostSamples(const RenderSnapshot& snapshot);
/// 0 where it is unknown.
float largestError(const RenderSnapshot& snapshot);

}  // namespace rt
