#include "caustic_error.h"

#include "adaptive_parts.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {
namespace {

constexpr std::size_t kScales = 3;
constexpr std::array<double, kScales> kSquaredScales{0.25, 1.0, 4.0};

/// Pixels that one thread takes at a time.
constexpr std::size_t kTogether = 64;

/// A radius half as large changes at least a quarter as much as the one before (even ground), and
/// at most so much: a fold of light, which grows like one over the root of the distance, is sharper
/// than a step, 1 / sqrt 2, only as far as values above 1 count.
constexpr double kLeastStep = 0.25;
constexpr double kMostStep = 0.8;

/// Steps at edges do not all lie in one place: the bias at a straight edge is 2.152 |D(r/2, r)|
/// under this kernel, where s is 1 / sqrt 2 and 1 / (1 - s) is 3.414. In between, by a line.
constexpr double kApart = 0.81;

/// Half the radius has at least so many times the variance; where pixels meet next to no photons
/// any more, their scatter says less.
constexpr double kNoiseByHalving = 4.0;

/// What the photons of each group show of a pixel, for each scale.
using GroupLight = std::array<std::vector<Color>, kScales>;

void add(const SeenPoint& seen, const PhotonMap& map, double groups, GroupLight& light) {
    map.forEachNear(seen.point.position, 2.0 * map.radius, [&](const Photon& photon, double d2) {
        const PhotonMap::Kernel& kernel = map.kernels[photon.pass];
        const double part = d2 * kernel.inverseSquare;
        if (part >= kSquaredScales.back()) return;
        const Color brought = seen.weight * broughtBy(photon, seen.point) * (kernel.peak * groups);
        for (std::size_t k = 0; k < kScales; ++k) {
            if (part >= kSquaredScales[k]) continue;
            light[k][photon.group] +=
                brought * ((1.0 - part / kSquaredScales[k]) / kSquaredScales[k]);
        }
    });
}

Color meanOf(const std::vector<Color>& groups) {
    Color sum(0.0);
    for (const Color& c : groups) sum += c;
    return sum / static_cast<double>(groups.size());
}

double noiseOf(const Color& base, const std::vector<Color>& groups, const Color& mean) {
    const double fewer = std::sqrt(static_cast<double>(groups.size()) - 1.0);
    const Color value = clipped(base + mean);
    double sum = 0.0;
    for (const Color& c : groups) {
        sum += meanSquare(clipped(base + mean + (c - mean) / fewer) - value);
    }
    return sum / static_cast<double>(groups.size());
}

/// The share of a change from a to b that clipping leaves, by channel.
Color shown(const Color& a, const Color& b) {
    const Color after = clipped(b) - clipped(a);
    Color share(1.0);
    for (int i = 0; i < 3; ++i) {
        if (a[i] != b[i]) share[i] = after[i] / (b[i] - a[i]);
    }
    return share;
}

double stepOf(const Color& share, const std::vector<Color>& narrow,
              const std::vector<Color>& wide) {
    Color sum(0.0);
    double squares = 0.0;
    for (std::size_t g = 0; g < narrow.size(); ++g) {
        const Color d = share * (wide[g] - narrow[g]);
        sum += d;
        squares += meanSquare(d);
    }
    const auto groups = static_cast<double>(narrow.size());
    return (meanSquare(sum) - squares) / (groups * (groups - 1.0));
}

struct Sums {
    std::array<double, kScales> noise{};
    std::array<double, 2> step{};
};

Sums sumsOf(const SeenPixel& pixel, const PhotonMap& map, std::uint32_t groups) {
    GroupLight light;
    for (std::vector<Color>& scale : light) scale.assign(groups, Color(0.0));
    for (const SeenPoint& point : pixel.points) add(point, map, groups, light);
    Sums sums;
    std::array<Color, kScales> means{};
    for (std::size_t k = 0; k < kScales; ++k) {
        means[k] = meanOf(light[k]);
        sums.noise[k] = noiseOf(pixel.value, light[k], means[k]);
    }
    for (std::size_t k = 0; k + 1 < kScales; ++k) {
        const Color share = shown(pixel.value + means[k], pixel.value + means[k + 1]);
        sums.step[k] = stepOf(share, light[k], light[k + 1]);
    }
    return sums;
}

}  // namespace

CausticError causticError(const std::vector<SeenPixel>& pixels, const PhotonMap& map,
                          std::uint32_t groups, int threads, const std::atomic<bool>* cancel) {
    CausticError error;
    if (map.isEmpty() || pixels.empty()) return error;
    const std::size_t count = (pixels.size() + kTogether - 1) / kTogether;
    std::vector<Sums> parts(count);
    forEachIndex(count, threads, [&](std::size_t part, int) {
        if (cancel && cancel->load(std::memory_order_relaxed)) return;
        const std::size_t end = std::min((part + 1) * kTogether, pixels.size());
        for (std::size_t i = part * kTogether; i < end; ++i) {
            const Sums sums = sumsOf(pixels[i], map, groups);
            for (std::size_t k = 0; k < kScales; ++k) parts[part].noise[k] += sums.noise[k];
            for (std::size_t k = 0; k + 1 < kScales; ++k) parts[part].step[k] += sums.step[k];
        }
    });
    Sums all;
    for (const Sums& part : parts) {
        for (std::size_t k = 0; k < kScales; ++k) all.noise[k] += part.noise[k];
        for (std::size_t k = 0; k + 1 < kScales; ++k) all.step[k] += part.step[k];
    }
    const auto mean = [&](double sum) { return sum / static_cast<double>(pixels.size()); };
    for (std::size_t k = kScales; k-- > 0;) {
        error.noise[k] = mean(all.noise[k]);
        if (k + 1 < kScales) {
            error.noise[k] = std::max(error.noise[k], kNoiseByHalving * error.noise[k + 1]);
        }
    }
    const double narrow = std::sqrt(std::max(mean(all.step[0]), 0.0));
    const double wide = std::sqrt(std::max(mean(all.step[1]), 0.0));
    const double ratio = wide > 0.0 ? narrow / wide : kMostStep;
    const double s = std::clamp(ratio, kLeastStep, kMostStep);
    const double apart = 1.0 - kApart * (s - kLeastStep);
    const double once = apart * std::max(narrow / (1.0 - s), wide / (1.0 / s - 1.0));
    error.bias = {s * once * s * once, once * once, (once + wide) * (once + wide)};
    return error;
}

}  // namespace rt
