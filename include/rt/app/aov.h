// --aov: what can be had beside the picture, one value or vector for each pixel ("arbitrary output
// variables").
//
//   depth     Z        (P - eye) . v, in units of the world; infinity where nothing is hit
//   normal    X Y Z    the unit shading normal, in the world, turned towards the viewer
//   albedo    R G B    the diffuse colour
//   position  X Y Z    P, in the world
//   id        X        the object's place in the scene graph, from 1 on; 0 where nothing is hit
//   uv        U V      texture coordinates
//   samples   Y        samples spent in the pixel; 1 where its corners tell its value
//   error     Y        estimated standard error of the pixel's mean, clipped to [0, 1] (of float
//                      files too): the root of the mean over the channels of the squared error.
//                      Infinity where nothing is known, as of single samples.
//
// P is the first surface on one ray, through the pixel's centre and the centre of the lens: see
// rt/trace/first_hit.h. The first six are exact, and have no noise whatever the samples.
//
//   mean(samples) = spp_mean,     sqrt(mean(error^2)) + cut_error_bound = error_estimate
//
// with the names of --stats, as long as the whole image is rendered.
#pragma once

#include "rt/output/pixel_image.h"
#include "rt/render/film.h"
#include "rt/trace/first_hit.h"

#include <string>
#include <vector>

namespace rt {

enum class Aov { kDepth, kNormal, kAlbedo, kPosition, kId, kUv, kSamples, kError };

/// In the order of the enumerators.
const std::vector<std::string>& aovNames();

std::vector<std::string> namesOf(const std::vector<Aov>& aovs);

/// Whether it is one of those that a FirstHit tells.
bool isFirstHit(Aov aov);

/// What planes are made of. `hits` are of the pixels of `area`, where a FirstHit is asked for;
/// `squaredErrors` of the film's, empty where they are not known.
struct AovSource {
    const Film& film;
    const std::vector<double>& squaredErrors;
    const std::vector<FirstHit>& hits;
};

/// One plane for each of `aovs`, of the pixels of `area`, which lies in the film's.
std::vector<ImagePlane> planesOf(const std::vector<Aov>& aovs, const AovSource& source,
                                 const Tile& area);

}  // namespace rt
