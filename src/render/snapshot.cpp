#include "rt/render/snapshot.h"

#include "rt/render/adaptive.h"

#include <cmath>

namespace rt {

RenderSnapshot snapshotOf(const Film& film) {
    RenderSnapshot snapshot;
    snapshot.area = film.area;
    snapshot.means.reserve(film.pixels.size());
    snapshot.samples.reserve(film.pixels.size());
    for (const PixelState& pixel : film.pixels) {
        snapshot.means.emplace_back(pixel.mean());
        snapshot.samples.push_back(static_cast<std::uint32_t>(pixel.samples));
    }
    return snapshot;
}

RenderSnapshot Adaptive::snapshot() const {
    RenderSnapshot snapshot = snapshotOf(film_);
    for (std::size_t pixel = 0; pixel < kind_.size(); ++pixel) {
        if (kind_[pixel] == Kind::kUncertain) {
            snapshot.means[pixel] = glm::vec3(colorOf(pixel));
            snapshot.samples[pixel] = 1;
        } else if (lattice_ && snapshot.samples[pixel] == 0) {
            snapshot.means[pixel] = glm::vec3(meanSeenThroughCorners(pixel).value_or(Color(0.0)));
        }
    }
    // In the middle of a pass the last estimates hold, though some pixels lack samples.
    if (!knowsError() && !(squaredError_ > 0.0)) return snapshot;
    snapshot.errors.reserve(pixelError_.size());
    for (const double squared : pixelError_) {
        snapshot.errors.push_back(static_cast<float>(std::sqrt(squared)));
    }
    return snapshot;
}

}  // namespace rt
