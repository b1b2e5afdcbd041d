// Where the next samples go, and when there are enough: decided between passes, from the film
// alone, in a fixed order, so that neither threads nor tiles can change a byte.
#pragma once

#include "rt/render/film.h"

#include <cstdint>
#include <vector>

namespace rt {

/// Estimates of the squared error of each pixel's mean, averaged over the channels.
///
/// A pixel's samples are halves A and B of one well-spread sequence; ((A - B) / 2)^2, of the means
/// clipped to [0, 1], estimates the squared error of their mean, and is averaged over the pixel and
/// its neighbours, for one pixel's difference alone is a coin that often falls on 0.
std::vector<double> squaredErrors(const Film& film);

/// Root of the mean of `squaredErrors`: the estimated RMSE of the image.
double rootMean(const std::vector<double>& squaredErrors);

struct AdaptiveGoal {
    double squaredTarget = 0.0;  ///< of the image's mean squared error
    std::uint32_t firstSamples = 4;
    std::uint32_t maxSamples = 4096;
};

/// How many samples each pixel should have after the next pass: twice as many where that brings
/// most for its price. Pixels double one after another, most error a sample first, until the image
/// would meet the goal; those that would double at least once do so now, once. Beside its error, a
/// pixel counts as in doubt by the contrast to its neighbours, which catches what both halves have
/// missed. Equal to the present numbers when nothing is left to do.
std::vector<std::uint32_t> nextSamples(const Film& film, const std::vector<double>& squaredErrors,
                                       const AdaptiveGoal& goal);

}  // namespace rt
