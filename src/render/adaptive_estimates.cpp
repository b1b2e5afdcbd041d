// Adaptive's estimates of what pixels and corners are off by.
#include "adaptive_parts.h"
#include "rt/render/adaptive.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// (7/12)^2 in (1/2)^2: the bias of the wide mean in its step from the narrow one, in squares.
constexpr double kBiasInStep = 49.0 / 36;

/// ((A - B) / 2)^2, mean over the channels, of the halves `half` and `sum` - `half`.
template <class Sum>
double halvesApart(const Sum& sum, const Sum& half, std::uint64_t samples) {
    const std::uint64_t first = samples / 2;
    if (first == 0) return 0.0;
    const Color a = clipped(Color(half) / static_cast<double>(first));
    const Color b = clipped((Color(sum) - Color(half)) / static_cast<double>(samples - first));
    return 0.25 * meanSquare(a - b);
}

}  // namespace

/// True once for each place in each update.
bool Adaptive::isFirstWorkOn(Evidence& place) const {
    if (place.lastWork == updates_) return false;
    place.lastWork = updates_;
    return true;
}

/// Lists the changed corners, and brings variances up to date around them.
void Adaptive::updateCorners() {
    changed_.clear();
    for (const std::size_t i : uncertainCorners_) {
        const Probe& probe = lattice_->probes[i];
        if (cornerEvidence_[i].samples == probe.samples) continue;
        cornerEvidence_[i].samples = probe.samples;
        cornerEvidence_[i].error = halvesApart(probe.sum, probe.half, probe.samples);
        changed_.push_back(i);
    }
    for (const std::size_t i : changed_) {
        const auto [x, y] = lattice_->corners.placeOf(i);
        forNeighbourhood(lattice_->corners, x, y, [&](int u, int v) {
            const std::size_t j = lattice_->offset(u, v);
            if (!lattice_->probes[j].has(kProbeUncertain)) return;
            if (isFirstWorkOn(cornerEvidence_[j])) updateVariance(j);
        });
    }
}

void Adaptive::updateVariance(std::size_t corner) {
    const auto samples = static_cast<double>(cornerEvidence_[corner].samples);
    double sum = 0.0;
    double count = 0.0;
    const auto [x, y] = lattice_->corners.placeOf(corner);
    forNeighbourhood(lattice_->corners, x, y, [&](int u, int v) {
        const std::size_t j = lattice_->offset(u, v);
        if (!lattice_->probes[j].has(kProbeUncertain)) return;
        const Evidence& other = cornerEvidence_[j];
        const double ratio = static_cast<double>(other.samples) / samples;
        sum += ratio == 1.0 ? other.error : other.error * ratio * std::sqrt(ratio);
        count += 1.0;
    });
    variance_[corner] = sum / count;
}

/// Mean of the variances of the corners of the pixel with this upper left corner.
double Adaptive::noiseAround(std::size_t corner) const {
    const std::size_t below = corner + lattice_->stride();
    return 0.25 *
           (variance_[corner] + variance_[corner + 1] + variance_[below] + variance_[below + 1]);
}

void Adaptive::lookAtSmooth(std::size_t pixel, const SmoothPixel& found, double noise) {
    bias_[pixel] = found.squaredBias;
    isBiased_[pixel] = found.isBiased ? 1 : 0;
    pixelError_[pixel] = found.squaredBias + 0.25 * noise;
}

/// Whether the pixels around are smooth too: then all corners lie on one surface.
bool Adaptive::isAmongSmooth(std::size_t pixel) const {
    const std::size_t x = pixel % width_;
    if (x == 0 || x + 1 == width_ || pixel < width_ || pixel + width_ >= kind_.size()) return false;
    for (const std::size_t i : {pixel - width_, pixel, pixel + width_}) {
        if (!isSmooth(i - 1) || !isSmooth(i) || !isSmooth(i + 1)) return false;
    }
    return true;
}

void Adaptive::lookAtWide(std::size_t pixel) {
    Wide& wide = wide_[pixel];
    wide.isKnown = isAmongSmooth(pixel);
    if (!wide.isKnown) return;
    const std::size_t corner = cornerOf(pixel);
    const std::size_t stride = lattice_->stride();
    double all = 0.0;
    for (std::size_t row = corner - stride - 1; row < corner + 3 * stride - 1; row += stride) {
        all += variance_[row] + variance_[row + 1] + variance_[row + 2] + variance_[row + 3];
    }
    const double inner = 4.0 * noiseAround(corner);
    // The inner corners weigh 1/16 - 1/4 in the step, the others 1/16.
    wide.variance = static_cast<float>(all / 256.0);
    wide.stepVariance = static_cast<float>((all + 8.0 * inner) / 256.0);
    wide.squaredStep = smoothPixels_->squaredStepToWide(corner);
}

/// Takes the wide mean where it has less error than the narrow one, which `lookAtSmooth` has put
/// down.
void Adaptive::chooseCorners(std::size_t pixel) {
    Wide& wide = wide_[pixel];
    wide.isChosen = false;
    const double narrow = pixelError_[pixel];
    if (!wide.isKnown || !(wide.variance > 0.0F)) return;
    double excess = 0.0;
    double count = 0.0;
    for (const std::size_t i : {pixel - width_, pixel, pixel + width_}) {
        for (std::size_t j = i - 1; j <= i + 1; ++j) {
            if (kind_[j] != Kind::kUncertain || !wide_[j].isKnown) continue;
            excess += static_cast<double>(wide_[j].squaredStep - wide_[j].stepVariance);
            count += 1.0;
        }
    }
    const double bias = kBiasInStep * std::max(excess / count, 0.0);
    const double error = bias_[pixel] + bias + static_cast<double>(wide.variance);
    if (error >= narrow) return;
    wide.isChosen = true;
    pixelError_[pixel] = error;
}

/// Of all uncertain pixels: a corner enters what is said of 36 of them.
void Adaptive::updateSmoothPixels() {
    if (changed_.empty()) return;
    const std::size_t stride = lattice_->stride();
    for (const std::size_t i : changed_) smoothPixels_->readColor(i);
    for (const std::size_t i : changed_) {
        const std::size_t column = i % stride;
        smoothPixels_->measure(i);
        if (column > 0) smoothPixels_->measure(i - 1);
        if (column + 1 < stride) smoothPixels_->measure(i + 1);
        if (i >= stride) smoothPixels_->measure(i - stride);
        if (i + stride < variance_.size()) smoothPixels_->measure(i + stride);
    }
    for (const std::size_t pixel : uncertainPixels_) {
        const double noise = noiseAround(cornerOf(pixel));
        lookAtSmooth(pixel, smoothPixels_->at(cornerOf(pixel), noise), noise);
        lookAtWide(pixel);
    }
    for (const std::size_t pixel : uncertainPixels_) chooseCorners(pixel);
}

void Adaptive::updateSampledPixels() {
    changed_.clear();
    for (const std::size_t i : sampled_) {
        const PixelState& pixel = film_.pixels[i];
        const auto samples = static_cast<std::uint32_t>(pixel.samples);
        if (pixelEvidence_[i].samples == samples) continue;
        pixelEvidence_[i].samples = samples;
        pixelEvidence_[i].error = halvesApart(pixel.sum, pixel.half, samples);
        changed_.push_back(i);
    }
    for (const std::size_t i : changed_) {
        const auto [x, y] = film_.area.placeOf(i);
        forNeighbourhood(film_.area, x, y, [&](int u, int v) {
            const std::size_t j = film_.offset(u, v);
            if (!isSmooth(j) && isFirstWorkOn(pixelEvidence_[j])) updatePooledError(j);
        });
    }
}

void Adaptive::updatePooledError(std::size_t pixel) {
    double sum = 0.0;
    double count = 0.0;
    const auto [x, y] = film_.area.placeOf(pixel);
    forNeighbourhood(film_.area, x, y, [&](int u, int v) {
        const std::size_t j = film_.offset(u, v);
        if (isSmooth(j)) return;
        sum += pixelEvidence_[j].error * static_cast<double>(pixelEvidence_[j].samples);
        count += 1.0;
    });
    const auto samples = static_cast<double>(pixelEvidence_[pixel].samples);
    pixelError_[pixel] = samples > 0.0 ? sum / (count * samples) : 0.0;
}

void Adaptive::update() {
    ++updates_;
    if (lattice_ && classified_) {
        updateCorners();
        updateSmoothPixels();
    }
    updateSampledPixels();
    spreadSuspicion();
    double sum = 0.0;
    for (const double error : pixelError_) sum += error;
    for (const std::size_t pixel : suspects_) {
        if (isSmooth(pixel)) sum += static_cast<double>(suspicion_[pixel]);
    }
    squaredError_ = pixelError_.empty() ? 0.0 : sum / static_cast<double>(pixelError_.size());
    squaredError_ += missed_;
}

/// What audits would find lies in smooth pixels, nobody knows in which.
std::vector<double> Adaptive::squaredErrors() const {
    std::vector<double> errors = pixelError_;
    const std::size_t smooth = errors.size() - sampled_.size();
    const double missed = missed_ * static_cast<double>(errors.size()) /
                          static_cast<double>(std::max<std::size_t>(smooth, 1));
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
        if (!isSmooth(pixel)) continue;
        errors[pixel] += missed;
        if (isSuspect(pixel)) errors[pixel] += static_cast<double>(suspicion_[pixel]);
    }
    return errors;
}

}  // namespace rt
