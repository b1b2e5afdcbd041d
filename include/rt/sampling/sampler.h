// The numbers that a sample of a pixel needs: two each for the place in the pixel, the lens, and
// every light at every node of the tree of paths. All are functions of (seed, pixel, index, stream)
// alone, so neither threads nor tiles nor the order of samples can change them.
//
//   joint    Owen-scrambled Sobol points, pixel, lens and light jointly (sobol.h). Each (node,
//            light) reuses the light's two dimensions under its own scramble: the value of a sample
//            is a sum of functions of six variables, and each stays well sampled. Points do not
//            depend on how many there will be.
//   jitter   one random point in each of `samples` cells of equal area, in independent random
//            order for each stream (Cook, Porter and Carpenter, Distributed Ray Tracing, SIGGRAPH
//            1984). From index `samples` on, a fresh pass over the cells.
//   grid     the middles of those cells, the same for pixel, lens and lights and in every pixel.
//   random   independent numbers.
#pragma once

#include "rt/core/vec.h"
#include "rt/sampling/pixel_filter.h"
#include "rt/sampling/random.h"
#include "rt/sampling/sampler_kind.h"
#include "rt/sampling/sobol.h"
#include "rt/sampling/strata.h"

#include <cstdint>

namespace rt {

struct SamplerSettings {
    SamplerKind kind = SamplerKind::kJoint;
    FilterKind filter = FilterKind::kBox;
    std::uint64_t seed = 0;
    int samples = 16;  ///< cells of a pixel for jitter and grid; at least 1
};

class Sampler {
  public:
    explicit Sampler(const SamplerSettings& settings)
        : kind_(settings.kind),
          filter_(&PixelFilter::of(settings.filter)),
          seed_(settings.seed),
          strata_(settings.samples) {}

    /// Turns to sample number `index` of pixel (x, y).
    void start(int x, int y, int index) {
        pixelKey_ = pixelKey(seed_, x, y);
        index_ = static_cast<std::uint32_t>(index);
    }

    /// Turns to another sample of the same pixel.
    void turnTo(std::uint32_t index) { index_ = index; }

    /// Where in the image plane, and what the sample counts for.
    FilterSample pixel() const { return filter_->sample(pixelPoint()); }

    /// The point of the unit square behind pixel().
    Vec2 pixelPoint() const { return point(SobolPair::kPixel, 0); }

    /// A point of the unit square for the lens.
    Vec2 lens() const { return point(SobolPair::kLens, 1); }

    /// A moment of the shutter, 0 .. 1. Its stream is one that no light has: their nodes begin
    /// at 1.
    double time() const { return point(SobolPair::kLight, 2).x; }

    /// A point of the unit square for a light as seen from a node of the tree of paths.
    Vec2 light(std::uint32_t node, std::uint32_t light) const {
        constexpr std::uint64_t kFirstLight = 2;
        return point(SobolPair::kLight,
                     kFirstLight + (static_cast<std::uint64_t>(node) << 32 | light));
    }

  private:
    Vec2 point(SobolPair pair, std::uint64_t stream) const {
        const std::uint64_t key = subKey(pixelKey_, stream);
        if (kind_ == SamplerKind::kJoint) [[likely]] {
            const UnitPoint p = sobolPair(index_, pair, key);
            return {p.x, p.y};
        }
        return simplePoint(key);
    }

    [[gnu::noinline]] Vec2 simplePoint(std::uint64_t key) const {
        if (kind_ == SamplerKind::kJitter) return strata_.jittered(index_, key);
        if (kind_ == SamplerKind::kGrid) return strata_.middle(index_);
        const std::uint64_t bits = subKey(key, index_);
        return {toUnit(bits), toUnit(mixBits(bits))};
    }

    SamplerKind kind_;
    const PixelFilter* filter_;
    std::uint64_t seed_;
    Strata strata_;
    std::uint64_t pixelKey_ = 0;
    std::uint32_t index_ = 0;
};

}  // namespace rt
