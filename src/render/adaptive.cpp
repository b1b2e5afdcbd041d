#include "rt/render/adaptive.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// What one doubling leaves of a pixel's squared error: between N^-1 and N^-1.5 of well-spread
/// samples over discontinuities (Mitchell, Consequences of Stratified Sampling in Graphics,
/// SIGGRAPH 1996), measured at 0.4.
constexpr double kLeftByDoubling = 0.4;

/// Share of the contrast to the neighbours that a pixel with one sample might be off.
constexpr double kContrastDoubt = 0.125;

double clip(double value) {
    return std::clamp(value, 0.0, 1.0);
}

double ownSquaredError(const PixelState& pixel) {
    const std::uint64_t first = pixel.samples / 2;
    const std::uint64_t second = pixel.samples - first;
    if (first == 0) return 0.0;
    double sum = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        const double a = pixel.half[channel] / static_cast<double>(first);
        const double b = (pixel.sum[channel] - pixel.half[channel]) / static_cast<double>(second);
        const double difference = 0.5 * (clip(a) - clip(b));
        sum += difference * difference;
    }
    return sum / 3.0;
}

/// Calls use(x, y) for a pixel and its up to eight neighbours, row by row.
template <class Use>
void forNeighbourhood(const Tile& area, int x, int y, Use&& use) {
    for (int v = std::max(y - 1, area.y0); v < std::min(y + 2, area.y1); ++v) {
        for (int u = std::max(x - 1, area.x0); u < std::min(x + 2, area.x1); ++u) use(u, v);
    }
}

/// Mean over the channels of the squared span of values in the neighbourhood.
double squaredContrast(const Film& film, int x, int y) {
    Color low(kInfinity);
    Color high(-kInfinity);
    forNeighbourhood(film.area, x, y, [&](int u, int v) {
        const Color mean = glm::clamp(film.at(u, v).mean(), 0.0, 1.0);
        low = glm::min(low, mean);
        high = glm::max(high, mean);
    });
    const Color span = high - low;
    return glm::dot(span, span) / 3.0;
}

/// A pixel as the plan sees it.
struct Candidate {
    double squaredError;
    double doubt;  ///< squaredError, and what the contrast adds
    double samples;
    double most;
};

/// Doubles every candidate while it gains more than `price` a sample; the image's mean squared
/// error after that, as predicted.
double meanAfter(const std::vector<Candidate>& candidates, double price) {
    double sum = 0.0;
    for (const Candidate& candidate : candidates) {
        double left = 1.0;
        double samples = candidate.samples;
        while (candidate.doubt * left > price * samples && 2.0 * samples <= candidate.most) {
            left *= kLeftByDoubling;
            samples *= 2.0;
        }
        sum += candidate.squaredError * left;
    }
    return sum / static_cast<double>(candidates.size());
}

/// The highest price, within a few per cent, at which the image would meet the target.
double priceFor(const std::vector<Candidate>& candidates, double squaredTarget) {
    double low = 1e-18;  // below any error that a double-precision image can show
    double high = 1.0;
    for (int step = 0; step < 40; ++step) {
        const double middle = std::sqrt(low * high);
        (meanAfter(candidates, middle) <= squaredTarget ? low : high) = middle;
    }
    return low;
}

}  // namespace

std::vector<double> squaredErrors(const Film& film) {
    std::vector<double> own(film.pixels.size());
    std::transform(film.pixels.begin(), film.pixels.end(), own.begin(), ownSquaredError);
    std::vector<double> pooled;
    pooled.reserve(own.size());
    for (int y = film.area.y0; y < film.area.y1; ++y) {
        for (int x = film.area.x0; x < film.area.x1; ++x) {
            double sum = 0.0;
            int count = 0;
            forNeighbourhood(film.area, x, y, [&](int u, int v) {
                sum += own[film.offset(u, v)];
                ++count;
            });
            pooled.push_back(sum / count);
        }
    }
    return pooled;
}

double rootMean(const std::vector<double>& squaredErrors) {
    double sum = 0.0;
    for (const double error : squaredErrors) sum += error;
    return squaredErrors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squaredErrors.size()));
}

std::vector<std::uint32_t> nextSamples(const Film& film, const std::vector<double>& squaredErrors,
                                       const AdaptiveGoal& goal) {
    std::vector<Candidate> candidates;
    candidates.reserve(film.pixels.size());
    for (int y = film.area.y0; y < film.area.y1; ++y) {
        for (int x = film.area.x0; x < film.area.x1; ++x) {
            const double error = squaredErrors[film.offset(x, y)];
            const auto samples = static_cast<double>(film.at(x, y).samples);
            const double doubt = error + kContrastDoubt * kContrastDoubt *
                                             squaredContrast(film, x, y) /
                                             (samples * std::sqrt(samples));
            candidates.push_back({error, doubt, samples, static_cast<double>(goal.maxSamples)});
        }
    }
    const double price = priceFor(candidates, goal.squaredTarget);
    std::vector<std::uint32_t> ends;
    ends.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        const bool worth = candidate.doubt > price * candidate.samples;
        const bool allowed = 2.0 * candidate.samples <= candidate.most;
        ends.push_back(static_cast<std::uint32_t>(candidate.samples * (worth && allowed ? 2 : 1)));
    }
    return ends;
}

}  // namespace rt
