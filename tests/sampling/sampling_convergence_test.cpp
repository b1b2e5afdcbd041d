// What the samplers are for: unbiased means whose error falls faster than that of random numbers.
#include <doctest/doctest.h>

#include "rt/sampling/sampler.h"
#include "rt/sampling/warp.h"

#include <cmath>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr std::uint64_t kSeed = 20260204;

struct Numbers {
    Vec2 pixel;
    Vec2 lens;
    Vec2 light;
};

/// A function of a sample's numbers and its mean over the unit cube.
struct Integrand {
    std::string name;
    double (*value)(const Numbers&);
    double mean;
};

double wave(double x) {
    return std::sin(3.141592653589793 * x);
}
constexpr double kWaveMean = 2.0 / 3.141592653589793;

double smoothPixel(const Numbers& u) {
    return wave(u.pixel.x) * wave(u.pixel.y) + u.pixel.x;
}
double edgePixel(const Numbers& u) {
    return u.pixel.x + 0.37 * u.pixel.y < 0.71 ? 1.0 : 0.0;
}
double discLight(const Numbers& u) {
    const Vec2 d = concentricDisc(u.light);
    return d.x + 0.3 * d.y < 0.0 ? 1.0 : 0.0;
}
double smoothLens(const Numbers& u) {
    return wave(u.lens.x) * wave(u.lens.y);
}
/// Defocus: an edge that moves with the lens.
double edgePixelLens(const Numbers& u) {
    return u.pixel.x + 0.3 * u.pixel.y + 0.5 * u.lens.x + 0.2 * u.lens.y < 1.0 ? 1.0 : 0.0;
}
double smoothSix(const Numbers& u) {
    return (0.5 + u.pixel.x * u.pixel.y) * (0.5 + u.lens.x * u.lens.y) *
           (0.5 + u.light.x * u.light.y);
}

const std::vector<Integrand>& integrands() {
    // edgePixel: x < 0.71 - 0.37 y. edgePixelLens: x + 0.3 y + 0.5 a + 0.2 b is symmetric about 1.
    static const std::vector<Integrand> all = {
        {"smooth pixel", smoothPixel, kWaveMean * kWaveMean + 0.5},
        {"edge in the pixel", edgePixel, 0.71 - 0.37 / 2},
        {"smooth lens", smoothLens, kWaveMean * kWaveMean},
        {"edge in the light", discLight, 0.5},
        {"edge over pixel and lens", edgePixelLens, 0.5},
        {"smooth in all six", smoothSix, 0.75 * 0.75 * 0.75},
    };
    return all;
}

double estimate(Sampler& sampler, const Integrand& f, int pixel, int samples) {
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        sampler.start(pixel, 0, i);
        sum += f.value({sampler.pixel().offset + 0.5, sampler.lens(), sampler.light(1, 0)});
    }
    return sum / samples;
}

/// Root of the mean square error over many pixels.
double rmse(SamplerKind kind, const Integrand& f, int samples) {
    constexpr int kPixels = 200;
    Sampler sampler({kind, FilterKind::kBox, kSeed, samples});
    double sum = 0.0;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        const double error = estimate(sampler, f, pixel, samples) - f.mean;
        sum += error * error;
    }
    return std::sqrt(sum / kPixels);
}

/// Exponent of an error: the least-squares slope of log RMSE over log samples, 16 .. 1024.
template <class Rmse>
double slopeOf(Rmse rmseWith) {
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    int n = 0;
    for (int samples = 16; samples <= 1024; samples *= 2, ++n) {
        const double x = std::log(samples);
        const double y = std::log(rmseWith(samples));
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double slope(SamplerKind kind, const Integrand& f) {
    return slopeOf([&](int samples) { return rmse(kind, f, samples); });
}

/// An image, and the mean of it under a filter about each of many pixels.
struct FilteredImage {
    std::string name;
    double (*value)(double x, double y);
};

double waves(double x, double y) {
    return 0.5 + 0.25 * std::sin(2.0 * x + 0.3) + 0.25 * std::cos(1.5 * y - x);
}
double slantedEdge(double x, double y) {
    return x + 0.37 * y < 0.21 ? 1.0 : 0.0;
}
double constant(double, double) {
    return 0.5;
}

/// The filtered value about (x, 0), by the midpoint rule.
double filteredTruth(const PixelFilter& filter, const FilteredImage& image, double x) {
    constexpr int kSteps = 700;
    const double step = 2.0 * filter.radius() / kSteps;
    std::vector<double> weights;
    for (int i = 0; i < kSteps; ++i) {
        weights.push_back(step * filter.value((i + 0.5) * step - filter.radius()));
    }
    double truth = 0.0;
    for (int j = 0; j < kSteps; ++j) {
        double row = 0.0;
        const double v = (j + 0.5) * step - filter.radius();
        for (int i = 0; i < kSteps; ++i) {
            const double u = (i + 0.5) * step - filter.radius();
            row += weights[static_cast<std::size_t>(i)] * image.value(x + u, v);
        }
        truth += weights[static_cast<std::size_t>(j)] * row;
    }
    return truth;
}

}  // namespace

TEST_CASE("errors fall as fast as the theory of each sampler says") {
    // Upper bounds on the exponent: joint, jitter, random. Scrambled nets reach -1.5 on smooth
    // integrands and -0.75 at edges in two dimensions (Owen 1997; Mitchell 1996), jitter -1 and
    // -0.75 in two dimensions, random numbers -0.5.
    struct Row {
        std::size_t integrand;
        double joint;
        double jitter;
    };
    const Row rows[] = {{0, -1.3, -0.9},   {1, -0.65, -0.65}, {2, -1.1, -0.9},
                        {3, -0.65, -0.65}, {4, -0.55, -0.45}, {5, -1.0, -0.45}};
    for (const Row& row : rows) {
        const Integrand& f = integrands()[row.integrand];
        CAPTURE(f.name);
        const double joint = slope(SamplerKind::kJoint, f);
        const double jitter = slope(SamplerKind::kJitter, f);
        const double random = slope(SamplerKind::kRandom, f);
        MESSAGE(f.name << ": joint " << joint << ", jitter " << jitter << ", random " << random
                       << "; RMSE with 64: " << rmse(SamplerKind::kJoint, f, 64) << ", "
                       << rmse(SamplerKind::kJitter, f, 64) << ", "
                       << rmse(SamplerKind::kRandom, f, 64));
        CHECK(joint < row.joint);
        CHECK(jitter < row.jitter);
        CHECK(random < -0.4);
        CHECK(random > -0.6);
    }
}

TEST_CASE("joint points beat jitter and random numbers wherever several variables matter") {
    for (const std::size_t i : {4u, 5u}) {
        const Integrand& f = integrands()[i];
        CAPTURE(f.name);
        const double joint = rmse(SamplerKind::kJoint, f, 64);
        CHECK(joint < 0.8 * rmse(SamplerKind::kJitter, f, 64));
        CHECK(joint < 0.5 * rmse(SamplerKind::kRandom, f, 64));
    }
}

TEST_CASE("means over 32 scrambles show no bias, by Student's t") {
    constexpr int kScrambles = 32;
    for (const SamplerKind kind :
         {SamplerKind::kJoint, SamplerKind::kJitter, SamplerKind::kRandom}) {
        for (const Integrand& f : integrands()) {
            for (const int samples : {1, 7, 16}) {
                Sampler sampler({kind, FilterKind::kBox, kSeed + 1, samples});
                double sum = 0.0;
                double squares = 0.0;
                for (int i = 0; i < kScrambles; ++i) {
                    const double error = estimate(sampler, f, i, samples) - f.mean;
                    sum += error;
                    squares += error * error;
                }
                const double mean = sum / kScrambles;
                const double variance = (squares - sum * mean) / (kScrambles - 1);
                const double t = mean / std::sqrt(variance / kScrambles);
                CAPTURE(f.name);
                CAPTURE(samples);
                // 54 tests with 31 degrees of freedom: 4.2 is passed by chance once in 90 runs.
                CHECK(std::fabs(t) < 4.2);
            }
        }
    }
}

TEST_CASE("a thousand pixels with few samples average to the truth, with every filter") {
    // An image that varies across pixels; the filtered truth comes from the filter's own integral.
    const auto image = [](double x, double y) {
        return 1.0 + 0.5 * std::sin(2.0 * x) * std::cos(y);
    };
    for (const FilterKind kind : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell,
                                  FilterKind::kBlackmanHarris}) {
        const PixelFilter& filter = PixelFilter::of(kind);
        constexpr int kSteps = 400;
        const double step = 2.0 * filter.radius() / kSteps;
        double truth = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const double x = -filter.radius() + (i + 0.5) * step;
                const double y = -filter.radius() + (j + 0.5) * step;
                truth += filter.value(x) * filter.value(y) * image(x + 0.3, y) * step * step;
            }
        }
        constexpr int kPixels = 1000;
        constexpr int kSamples = 8;
        Sampler sampler({SamplerKind::kJoint, kind, kSeed, kSamples});
        double sum = 0.0;
        double squares = 0.0;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            double value = 0.0;
            for (int i = 0; i < kSamples; ++i) {
                sampler.start(pixel, 1, i);
                const FilterSample s = sampler.pixel();
                value += s.weight * image(s.offset.x + 0.3, s.offset.y) / kSamples;
            }
            sum += value - truth;
            squares += (value - truth) * (value - truth);
        }
        const double deviation = std::sqrt(squares / kPixels / kPixels);
        CAPTURE(static_cast<int>(kind));
        CHECK(std::fabs(sum / kPixels) < 4.0 * deviation + 1e-5);
        CHECK(deviation < 0.01);
    }
}

TEST_CASE("errors under each filter fall as fast as those of its points") {
    const FilteredImage images[] = {
        {"constant", constant}, {"waves", waves}, {"slanted edge", slantedEdge}};
    const char* names[] = {"box", "gaussian", "mitchell", "blackman-harris"};
    for (const FilterKind kind : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell,
                                  FilterKind::kBlackmanHarris}) {
        const PixelFilter& filter = PixelFilter::of(kind);
        for (const FilteredImage& image : images) {
            constexpr int kPixels = 60;
            std::vector<double> truths;
            for (int pixel = 0; pixel < kPixels; ++pixel) {
                truths.push_back(filteredTruth(filter, image, 0.03 * (pixel - 30)));
            }
            const auto rmseWith = [&](int samples) {
                Sampler sampler({SamplerKind::kJoint, kind, kSeed, samples});
                double squares = 0.0;
                for (int pixel = 0; pixel < kPixels; ++pixel) {
                    double sum = 0.0;
                    for (int i = 0; i < samples; ++i) {
                        sampler.start(pixel, 2, i);
                        const FilterSample s = sampler.pixel();
                        sum += s.weight * image.value(0.03 * (pixel - 30) + s.offset.x, s.offset.y);
                    }
                    const double error = sum / samples - truths[static_cast<std::size_t>(pixel)];
                    squares += error * error;
                }
                return std::sqrt(squares / kPixels);
            };
            const double at64 = rmseWith(64);
            const std::string name = names[static_cast<int>(kind)];
            CAPTURE(name);
            CAPTURE(image.name);
            if (image.value == constant) {
                MESSAGE(name << ", " << image.name << ": RMSE with 64: " << at64);
                CHECK(at64 < 1e-6);
                continue;
            }
            const double exponent = slopeOf(rmseWith);
            MESSAGE(name << ", " << image.name << ": exponent " << exponent
                         << ", RMSE with 64: " << at64);
            CHECK(exponent < (image.value == waves ? -1.0 : -0.65));
        }
    }
}
