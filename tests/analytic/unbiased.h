// Whether pictures meet their equation in the mean, and not only within the noise of one picture.
#pragma once

#include "optics_shot.h"
#include "support/student.h"

#include <cmath>
#include <string>
#include <vector>

namespace rt::test {

/// A scene and what an equation gives for the mean of its pixels, in red.
struct Estimate {
    std::string name;
    Shot shot;
    double expected = 0.0;
    RenderOptions options{};
    std::string folder{};  ///< of files that the script names
};

inline double meanRed(const Picture& picture) {
    double sum = 0.0;
    for (const Color& pixel : picture.pixels) sum += pixel.x;
    return sum / static_cast<double>(picture.pixels.size());
}

/// The point that a one-pixel shot sees, in 4 x 4 pixels, each with samples of its own.
inline Shot repeated(Shot shot) {
    shot.width = shot.height = 4;
    return shot;
}

inline constexpr int kSeeds = 32;
/// All t-tests of this folder together give a false alarm in one of a thousand sets of seeds. The
/// seeds are fixed, so a test that passes goes on passing.
inline constexpr double kFalseAlarm = 1e-3;
inline constexpr int kMostTests = 200;
/// Errors of rounding, which the mean of any number of samples keeps.
inline constexpr double kEquationRounding = 1e-9;
/// What a picture of 4096 samples may be off.
inline constexpr double kAt4096 = 1e-3;

inline double meanOf(const Estimate& estimate, int seed, int spp) {
    PictureSettings settings;
    settings.options = estimate.options;
    settings.options.seed = seed;
    settings.options.spp = spp;
    settings.options.cutoff = 0.0;
    settings.folder = estimate.folder;
    return meanRed(renderScript(estimate.shot.script(), settings));
}

/// Over 32 seeds the mean agrees with the equation in a two-sided t-test, which would see a bias of
/// `resolution`.
inline void checkMean(const Estimate& estimate, int spp = 1024, double resolution = 1e-3) {
    static const double limit = studentQuantile(kFalseAlarm / kMostTests, kSeeds - 1);
    std::vector<double> values;
    for (int seed = 1; seed <= kSeeds; ++seed) values.push_back(meanOf(estimate, seed, spp));
    const SampleMean found = sampleMean(values);
    CAPTURE(estimate.name);
    CAPTURE(estimate.expected);
    CAPTURE(found.mean);
    CAPTURE(found.standardError);
    CHECK(limit * found.standardError < resolution);
    CHECK(std::fabs(found.mean - estimate.expected) <
          limit * found.standardError + kEquationRounding);
}

/// The same, and one picture of 4096 samples meets the equation to 1e-3.
inline void checkUnbiased(const Estimate& estimate, int spp = 1024, double resolution = 1e-3) {
    checkMean(estimate, spp, resolution);
    CAPTURE(estimate.name);
    CAPTURE(estimate.expected);
    CHECK(std::fabs(meanOf(estimate, 0, 4096) - estimate.expected) < kAt4096);
}

}  // namespace rt::test
