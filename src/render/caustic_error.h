// How far the light of photons is off, as pixels see it: their noise and their bias apart.
//
// Both are means over pixels spread evenly over the picture, of which some samples were followed
// once to where photons would add to them (SeenPixel). There the light of each group of photons is
// known for three radii, half, once and twice what is asked about. With c_g(r) of G groups, C(r)
// their mean, and values clipped to [0, 1] as an image file holds them:
//
//   noise   the scatter of the groups: E |C - E C|^2 = sum |c_g - C|^2 / (G (G - 1)), and at least
//           four times that of twice the radius, for a kernel that meets no photon scatters not
//   bias    what a step of the radius changes, without noise: by products of different groups,
//           |D(r/2, r)|^2 = sum over g != h of d_g d_h / (G (G - 1)), d_g = c_g(r) - c_g(r/2).
//           Where the next steps would change s times as much each, s = |D(r/2, r)| / |D(r, 2r)|,
//           all of them together change at most |D(r/2, r)| / (1 - s). On even ground the bias is
//           in proportion to r^2, s = 1/4, and this is Richardson's extrapolation. At a straight
//           edge s is 1 / sqrt 2, and the bias 0.63 of that bound; in between it is taken to lie on
//           the line.
#pragma once

#include "rt/trace/photon_map.h"
#include "rt/trace/seen_pixel.h"
#include "rt/trace/trace_kernel.h"

#include <array>
#include <atomic>
#include <vector>

namespace rt {

/// Squared errors for half, once and twice the map's radii; mean over channels and pixels.
struct CausticError {
    std::array<double, 3> noise{};
    std::array<double, 3> bias{};

    double at(std::size_t scale) const { return noise[scale] + bias[scale]; }
};

/// The map's cells are wide enough for twice its radii.
CausticError causticError(const std::vector<SeenPixel>& pixels, const PhotonMap& map,
                          std::uint32_t groups, int threads, const std::atomic<bool>* cancel);

}  // namespace rt
