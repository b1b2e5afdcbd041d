// Builds photon maps.
#pragma once

#include "rt/trace/photon_map.h"

#include <vector>

namespace rt {

/// r_i of passes 0 .. passes - 1, the first of them `first`: r_{i+1}^2 = r_i^2 (i + 2/3) / (i + 1),
/// counted from 1. The variance of the mean then falls as N^(-2/3) with the number of passes, and
/// its squared bias alike (Knaus and Zwicker 2011, section 4).
std::vector<double> shrinkingRadii(double first, std::uint32_t passes);

/// Puts the photons into buckets for looks within `reach`, and gives their passes these radii.
/// `localBound` is the largest share of irradiance that any surface shows.
void build(PhotonMap& map, const std::vector<double>& radii, double reach, double localBound);

}  // namespace rt
