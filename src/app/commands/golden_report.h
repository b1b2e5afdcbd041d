// The page that shows how pictures and their references differ.
#pragma once

#include "rt/output/pixel_image.h"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A picture and its reference, of the same size and of finite values.
struct GoldenPair {
    PixelImage picture;
    PixelImage reference;
};

/// One image of the report.
struct GoldenEntry {
    std::string name;     ///< of the image
    std::string scene;    ///< path of its script
    std::string verdict;  ///< a sentence
    bool passed = false;
    std::optional<PixelImage> alone;  ///< the picture, where it has nothing to be held against
    std::optional<GoldenPair> pair;   ///< where the two differ
};

/// Writes index.html and its pictures into `folder`: for each pair both, the difference made
/// brighter, and FLIP's map; numbers as `compare` gives them. Throws OutputError.
void writeGoldenReport(const std::string& folder, const std::vector<GoldenEntry>& entries);

}  // namespace rt
