// Whether adaptive pictures are as near to the truth as they say.
#pragma once

#include "optics_shot.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace rt::test {

/// Over all channels of values clipped to [0, 1], as --error means it.
inline double clippedRmse(const Picture& a, const Picture& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Color off = glm::clamp(a.pixels[i], 0.0, 1.0) - glm::clamp(b.pixels[i], 0.0, 1.0);
        squares += glm::dot(off, off) / 3.0;
    }
    return std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

/// Against the slow truth of so many samples a pixel, for so many seeds. With a seed of its own the
/// truth shares no photon.
inline void checkErrorIsKept(const Shot& shot, int samples, std::initializer_list<double> errors,
                             double truthSeed = 0.0, int seeds = 1) {
    PictureSettings truth;
    truth.options.reference = true;
    truth.options.spp = samples;
    truth.options.seed = truthSeed;
    const Picture right = renderScript(shot.script(), truth);
    for (const double error : errors) {
        CAPTURE(shot.body);
        CAPTURE(error);
        for (int seed = 0; seed < seeds; ++seed) {
            CAPTURE(seed);
            PictureSettings adaptive;
            adaptive.options.error = error;
            adaptive.options.seed = seed;
            const Picture found = renderScript(shot.script(), adaptive);
            CHECK(found.converged);
            CHECK(clippedRmse(found, right) < 1.2 * error);
        }
    }
}

}  // namespace rt::test
