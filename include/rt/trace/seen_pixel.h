// Where photons would add to a pixel.
#pragma once

#include "rt/core/vec.h"
#include "rt/trace/photon_map.h"

#include <vector>

namespace rt {

/// A point that a sample of a pixel shows, and how much it counts in the sample's value.
struct SeenPoint {
    PhotonReceiver point;
    Color weight{0.0};
    double footprint = 0.0;  ///< side of a pixel, across the view, at its distance
};

/// What samples of a pixel show without photons, and where photons would add to it.
struct SeenPixel {
    Color value{0.0};  ///< mean of the samples
    /// Of all samples, their weights sharing the mean, but for those that hardly count.
    std::vector<SeenPoint> points;
};

}  // namespace rt
