#include "tracer.h"

#include "tracer_first_hit.h"
#include "tracer_light.h"
#include "tracer_path.h"
#include "tracer_photon.h"
#include "tracer_probe.h"
#include "tracer_variants.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rt {
namespace {

/// Brings one pixel to `end` samples, remembering its sum at half of them.
template <unsigned Features>
void renderPixel(Tracer<Features>& tracer, const TraceSettings& settings, int x, int y,
                 std::uint64_t end, PixelState& pixel, TraceCounts& counts) {
    constexpr std::uint64_t kBetweenLooks = 64;
    for (std::uint64_t index = pixel.samples; index < end; ++index) {
        const bool look = settings.cancel && index % kBetweenLooks == 0;
        if (look && settings.cancel->load(std::memory_order_relaxed)) return;
        if (index == end / 2) pixel.half = pixel.sum;
        const Color value = tracer.sample(x, y, static_cast<int>(index));
        if (std::isfinite(value.x + value.y + value.z)) {
            pixel.sum += value;
        } else if (counts.nonFinite++ == 0) {
            counts.nonFiniteX = x;
            counts.nonFiniteY = y;
        }
        ++pixel.samples;
    }
}

template <unsigned Features>
void renderTileWith(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
                    const std::uint32_t* ends, PixelState* pixels, TraceCounts& counts) {
    Tracer<Features> tracer(scene, settings, counts);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x, ++pixels, ++ends) {
            renderPixel(tracer, settings, x, y, *ends, *pixels, counts);
        }
    }
}

template <unsigned Features>
void probeTileWith(const RenderScene& scene, const TraceSettings& settings, const Tile& corners,
                   int spacing, const std::uint32_t* ends, Probe* probes, TraceCounts& counts) {
    Tracer<Features> tracer(scene, settings, counts);
    for (int y = corners.y0; y < corners.y1; ++y) {
        if (settings.cancel && settings.cancel->load(std::memory_order_relaxed)) return;
        for (int x = corners.x0; x < corners.x1; ++x, ++probes, ++ends) {
            if (*ends > probes->samples)
                tracer.probeCorner(x * spacing, y * spacing, spacing, *ends, *probes);
        }
    }
}

template <unsigned Features>
void probePixelsWith(const RenderScene& scene, const TraceSettings& settings,
                     std::span<const PixelPlace> pixels, std::uint32_t samples, Probe* probes,
                     TraceCounts& counts) {
    Tracer<Features> tracer(scene, settings, counts);
    for (const PixelPlace& pixel : pixels) {
        if (settings.cancel && settings.cancel->load(std::memory_order_relaxed)) return;
        tracer.probeCentre(pixel.x, pixel.y, samples, *probes++);
    }
}

template <unsigned Features>
void firstHitsWith(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
                   FirstHit* hits) {
    TraceCounts uncounted;
    Tracer<Features | kBeside> tracer(scene, settings, uncounted);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) *hits++ = tracer.firstHit(x, y);
    }
}

constexpr bool isVariant(unsigned features) {
    return variantOf(features) == features;
}

constexpr std::size_t countVariants() {
    std::size_t count = 0;
    for (unsigned features = 0; features <= kVariantFeatures; ++features) {
        count += isVariant(features) ? 1 : 0;
    }
    return count;
}

/// All that variantOf can say.
constexpr auto kVariants = [] {
    std::array<unsigned, countVariants()> variants{};
    std::size_t count = 0;
    for (unsigned features = 0; features <= kVariantFeatures; ++features) {
        if (isVariant(features)) variants[count++] = features;
    }
    return variants;
}();

template <std::size_t... Place>
TracerVariant variantFor(unsigned features, std::index_sequence<Place...>) {
    TracerVariant found;
    ((kVariants[Place] == variantOf(features)
          ? void(found = {&renderTileWith<kVariants[Place]>, &probeTileWith<kVariants[Place]>,
                          &probePixelsWith<kVariants[Place]>, &firstHitsWith<kVariants[Place]>})
          : void()),
     ...);
    return found;
}

}  // namespace

TracerVariant tracerFor(unsigned features) {
    return variantFor(features, std::make_index_sequence<kVariants.size()>{});
}

}  // namespace rt
