// What a render has so far, for those who watch it refine.
#pragma once

#include "rt/render/film.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rt {

/// Row-major over `area`, in coordinates of the whole image.
struct RenderSnapshot {
    Tile area;
    std::vector<glm::vec3> means;         ///< image values; of pixels without samples a guess, or 0
    std::vector<std::uint32_t> samples;   ///< 1 for pixels that are what their corners are
    std::vector<float> errors;            ///< estimated RMSE of each mean; empty where unknown
    std::optional<double> errorEstimate;  ///< RMSE of the image
};

/// The film's part of it.
RenderSnapshot snapshotOf(const Film& film);

}  // namespace rt
