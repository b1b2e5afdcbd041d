#include "rt/render/adaptive.h"

#include "adaptive_parts.h"
#include "price_list.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// What one doubling leaves of a squared error: between N^-1 and N^-1.5 of well-spread samples over
/// discontinuities (Mitchell, Consequences of Stratified Sampling in Graphics, SIGGRAPH 1996),
/// measured at 0.4.
constexpr double kLeftByDoubling = 0.4;

/// Share of the contrast to the neighbours that a pixel with one sample might be off.
constexpr double kContrastDoubt = 0.125;

/// What a further sample of the lights costs at a corner, and looking through it again, in samples
/// of a pixel.
constexpr double kLightPrice = 0.4;
constexpr double kLookPrice = 0.5;

/// The first samples of a pixel that was smooth, in those of others, and what they leave of the
/// squared error that it had: a few samples of the lights are no better than its corners.
constexpr std::uint32_t kMoreInstead = 4;
constexpr double kLeftBySampling = 0.25;

/// Passes aim a little below the squared target: more passes for the last of it cost more.
constexpr double kAim = 0.95;

/// Biases below this share of the target's square are left alone: all together they could not take
/// more of it.
constexpr double kSmallBias = 1.0 / 16;

std::uint32_t samplesInstead(const AdaptiveGoal& goal) {
    return std::min(kMoreInstead * goal.firstSamples, goal.maxSamples);
}

}  // namespace

/// A pixel or a corner that could get more samples.
struct Adaptive::Work {
    enum class Kind { kPixel, kCorner, kSmooth } kind;
    std::size_t place;
    double error;  ///< what it adds to the sum of the pixels' squared errors
    double doubt;  ///< the same, and what may have been missed
    double cost;   ///< of the next step
    int steps;     ///< how often it may double
    double left;   ///< of the error, by one step
};

Adaptive::Adaptive(Film& film, const Lattice* lattice, std::vector<bool> fine)
    : film_(film),
      lattice_(lattice),
      width_(static_cast<std::size_t>(film.area.width())),
      fine_(std::move(fine)),
      kind_(film.pixels.size(), Kind::kSampled),
      pixelEvidence_(film.pixels.size()),
      pixelError_(film.pixels.size()),
      classified_(lattice == nullptr) {
    if (lattice_) {
        smoothPixels_.emplace(*lattice_);
        bias_.resize(film.pixels.size());
        isBiased_.resize(film.pixels.size());
        wide_ = ZeroedArray<Wide>(film.pixels.size());
        variance_ = ZeroedArray<double>(lattice_->probes.size());
        cornerEvidence_ = ZeroedArray<Evidence>(lattice_->probes.size());
    }
    listPlaces();
}

void Adaptive::classify(double squaredBiasLimit, const ToldPixels& told) {
    if (!lattice_) return;
    openCorners(told);
    ++updates_;
    updateCorners();
    for (std::size_t pixel = 0; pixel < kind_.size(); ++pixel) {
        if (!told.empty() && told[pixel] >= 0.0F) {
            kind_[pixel] = Kind::kSmooth;
            pixelError_[pixel] = bias_[pixel] = static_cast<double>(told[pixel]);
            isBiased_[pixel] = 1;
        } else if (fine_.empty() || !fine_[pixel]) {
            classifyPixel(pixel, squaredBiasLimit);
        }
    }
    listPlaces();
    for (const std::size_t pixel : uncertainPixels_) lookAtWide(pixel);
    for (const std::size_t pixel : uncertainPixels_) chooseCorners(pixel);
    classified_ = true;
}

/// Reads the corners of pixels that are not told and of their neighbours: no others were looked
/// through.
void Adaptive::openCorners(const ToldPixels& told) {
    ++updates_;
    const Tile& corners = lattice_->corners;
    std::vector<std::size_t> near;
    std::size_t pixel = 0;
    for (int y = film_.area.y0; y < film_.area.y1; ++y) {
        for (int x = film_.area.x0; x < film_.area.x1; ++x, ++pixel) {
            if (!told.empty() && told[pixel] >= 0.0F) continue;
            for (int v = std::max(y - 1, corners.y0); v < std::min(y + 3, corners.y1); ++v) {
                for (int u = std::max(x - 1, corners.x0); u < std::min(x + 3, corners.x1); ++u) {
                    const std::size_t corner = lattice_->offset(u, v);
                    if (isFirstWorkOn(cornerEvidence_[corner])) near.push_back(corner);
                }
            }
        }
    }
    for (const std::size_t corner : near) smoothPixels_->readColor(corner);
    for (const std::size_t corner : near) {
        smoothPixels_->measure(corner);
        if (lattice_->probes[corner].has(kProbeUncertain)) uncertainCorners_.push_back(corner);
    }
}

void Adaptive::classifyPixel(std::size_t pixel, double squaredBiasLimit) {
    const std::size_t corner = cornerOf(pixel);
    const double noise = noiseAround(corner);
    const std::optional<SmoothPixel> found = smoothPixels_->find(corner, noise);
    if (!found) return;
    lookAtSmooth(pixel, *found, noise);
    if (found->isBiased && found->squaredBias > squaredBiasLimit) return;
    const bool uncertain = smoothPixels_->isUncertain(corner);
    kind_[pixel] = uncertain ? Kind::kUncertain : Kind::kSmooth;
    if (!uncertain) film_.pixels[pixel] = {asColor(found->value), Color(0.0), 1};
}

bool Adaptive::knowsError() const {
    return classified_ && std::all_of(sampled_.begin(), sampled_.end(), [&](std::size_t pixel) {
               return film_.pixels[pixel].samples >= 2;
           });
}

void Adaptive::listPlaces() {
    sampled_.clear();
    uncertainPixels_.clear();
    for (std::size_t pixel = 0; pixel < kind_.size(); ++pixel) {
        if (kind_[pixel] == Kind::kSampled) sampled_.push_back(pixel);
        if (kind_[pixel] == Kind::kUncertain) uncertainPixels_.push_back(pixel);
    }
}

/// What the contrast to the neighbours says that a sampled pixel might have missed.
double Adaptive::doubtOf(std::size_t pixel) const {
    const auto [x, y] = film_.area.placeOf(pixel);
    Color low(kInfinity);
    Color high(-kInfinity);
    forNeighbourhood(film_.area, x, y, [&](int u, int v) {
        const Color mean = clipped(film_.at(u, v).mean());
        low = glm::min(low, mean);
        high = glm::max(high, mean);
    });
    const auto samples = static_cast<double>(film_.pixels[pixel].samples);
    return kContrastDoubt * kContrastDoubt * meanSquare(high - low) /
           (samples * std::sqrt(samples));
}

/// What the variance of each corner adds to the sum of the pixels' squared errors.
std::vector<float> Adaptive::cornerWeights() const {
    std::vector<float> weights(variance_.size());
    const std::size_t stride = lattice_->stride();
    for (const std::size_t i : uncertainPixels_) {
        const std::size_t corner = cornerOf(i);
        if (wide_[i].isChosen) {
            // Noise may feign some of its bias, and more samples unmask it.
            const double excess = pixelError_[i] - bias_[i];
            const auto weight = static_cast<float>(excess / (256.0 * wide_[i].variance));
            for (std::size_t j = corner - stride - 1; j < corner + 3 * stride - 1; j += stride) {
                for (std::size_t k = j; k < j + 4; ++k) weights[k] += weight;
            }
        } else {
            for (const std::size_t j : {corner, corner + 1, corner + stride, corner + stride + 1}) {
                weights[j] += 1.0F / 16.0F;
            }
        }
    }
    return weights;
}

std::vector<Adaptive::Work> Adaptive::openWork(const AdaptiveGoal& goal) const {
    const auto stepsFrom = [&](std::uint64_t samples) {
        int steps = 0;
        for (std::uint64_t n = 2 * samples; n <= goal.maxSamples; n *= 2) ++steps;
        return steps;
    };
    std::vector<Work> work;
    for (const std::size_t i : sampled_) {
        const double error = pixelError_[i];
        // Those found wrong a moment ago have no samples yet, and get their first ones anyway.
        if (film_.pixels[i].samples < goal.firstSamples) continue;
        const int steps = stepsFrom(film_.pixels[i].samples);
        if (steps == 0) continue;
        work.push_back({Work::Kind::kPixel, i, error, error + doubtOf(i),
                        static_cast<double>(film_.pixels[i].samples), steps, kLeftByDoubling});
    }
    if (!lattice_) return work;
    const std::uint32_t converted = samplesInstead(goal);
    const double enough = kSmallBias * goal.squaredTarget;
    for (std::size_t i = 0; i < kind_.size(); ++i) {
        if (!isSmooth(i) || !isBiased_[i] || bias_[i] <= enough) continue;
        if (isSuspect(i)) continue;
        work.push_back({Work::Kind::kSmooth, i, pixelError_[i], pixelError_[i],
                        static_cast<double>(converted), 1 + stepsFrom(converted), kLeftBySampling});
    }
    for (const std::size_t i : suspects_) {
        if (!isSmooth(i)) continue;
        const double error = pixelError_[i] + static_cast<double>(suspicion_[i]);
        work.push_back({Work::Kind::kSmooth, i, error, error,
                        static_cast<double>(goal.firstSamples), 1 + stepsFrom(goal.firstSamples),
                        kLeftBySampling});
    }
    const std::vector<float> weights = cornerWeights();
    for (const std::size_t i : uncertainCorners_) {
        const double error = variance_[i] * static_cast<double>(weights[i]);
        if (!(error > 0.0)) continue;
        const auto samples = lattice_->probes[i].samples;
        work.push_back({Work::Kind::kCorner, i, error, error, kLightPrice * samples + kLookPrice,
                        stepsFrom(samples), kLeftByDoubling});
    }
    return work;
}

/// Whether a place would double three times: then two at once are safe, and save a pass.
bool Adaptive::worthTwo(const Work& item, double price) {
    const double twice = item.left * item.left / 4.0;
    return item.steps > 2 && PriceList::isAtLeast(item.doubt * twice / item.cost, price);
}

AdaptivePass Adaptive::standing() const {
    AdaptivePass pass;
    pass.pixels.resize(film_.pixels.size());
    for (const std::size_t i : sampled_) {
        pass.pixels[i] = static_cast<std::uint32_t>(film_.pixels[i].samples);
    }
    return pass;
}

AdaptivePass Adaptive::next(const AdaptiveGoal& goal) {
    squaredTarget_ = goal.squaredTarget;
    const std::vector<Work> work = openWork(goal);
    PriceList prices(squaredError_ * static_cast<double>(film_.pixels.size()));
    for (const Work& item : work) {
        double error = item.error;
        double doubt = item.doubt;
        double cost = item.cost;
        double left = item.left;
        for (int step = 0; step < item.steps; ++step) {
            prices.offer(doubt / cost, error * (1.0 - left));
            error *= left;
            doubt *= left;
            // The first samples of a pixel cost as much as twice as many.
            if (step > 0 || item.kind != Work::Kind::kSmooth) cost *= 2.0;
            left = kLeftByDoubling;
        }
    }
    const double price =
        prices.priceFor(kAim * goal.squaredTarget * static_cast<double>(film_.pixels.size()));

    AdaptivePass pass = standing();
    if (lattice_) {
        pass.corners.resize(lattice_->probes.size());
        for (const std::size_t i : uncertainCorners_) pass.corners[i] = lattice_->probes[i].samples;
    }
    bool sampledMore = false;
    for (const Work& item : work) {
        if (item.steps == 0 || !PriceList::isAtLeast(item.doubt / item.cost, price)) continue;
        std::uint32_t& end =
            item.kind == Work::Kind::kCorner ? pass.corners[item.place] : pass.pixels[item.place];
        const std::uint32_t before = end;
        if (item.kind == Work::Kind::kSmooth) {
            if (isSuspect(item.place)) spreading_.push_back({item.place, colorOf(item.place)});
            kind_[item.place] = Kind::kSampled;
            film_.pixels[item.place] = {};
            sampledMore = true;
            end = static_cast<std::uint32_t>(item.cost);
        } else {
            end *= worthTwo(item, price) ? 4 : 2;
        }
        pass.more += end - before;
    }
    if (sampledMore) listPlaces();
    for (const std::size_t i : sampled_) {
        if (pass.pixels[i] >= goal.firstSamples) continue;
        pass.more += goal.firstSamples - pass.pixels[i];
        pass.pixels[i] = goal.firstSamples;
    }
    return pass;
}

AdaptivePass Adaptive::first(std::uint32_t samples) const {
    AdaptivePass pass = standing();
    for (const std::size_t i : sampled_) pass.pixels[i] = samples;
    pass.more = sampled_.size() * samples;
    return pass;
}

AdaptivePass Adaptive::doubled(std::uint32_t most) const {
    AdaptivePass pass = standing();
    for (std::uint32_t& end : pass.pixels) {
        if (2 * end > most) continue;
        pass.more += end;
        end *= 2;
    }
    return pass;
}

std::optional<Color> Adaptive::meanSeenThroughCorners(std::size_t pixel) const {
    const std::size_t corner = cornerOf(pixel);
    const std::size_t below = corner + lattice_->stride();
    glm::vec3 sum(0.0F);
    int seen = 0;
    for (const std::size_t i : {corner, corner + 1, below, below + 1}) {
        if (lattice_->probes[i].samples == 0) continue;
        sum += lattice_->probes[i].mean();
        ++seen;
    }
    if (seen == 0) return std::nullopt;
    return Color(sum / static_cast<float>(seen));
}

void Adaptive::settleUnclassified(std::size_t pixel) {
    if (film_.pixels[pixel].samples > 0) return;
    const std::optional<Color> mean = meanSeenThroughCorners(pixel);
    if (mean) film_.pixels[pixel] = {*mean, Color(0.0), 1};
}

void Adaptive::settle() {
    if (!classified_) {
        for (std::size_t pixel = 0; pixel < kind_.size(); ++pixel) settleUnclassified(pixel);
    }
    for (const std::size_t pixel : uncertainPixels_) {
        film_.pixels[pixel] = {colorOf(pixel), Color(0.0), 1};
    }
}

}  // namespace rt
