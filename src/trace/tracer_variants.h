// The variants of the tracer, one for each set of features that a scene may use.
#pragma once

#include "rt/trace/trace_kernel.h"

namespace rt {

constexpr unsigned kVariantFeatures = kFeatureReflection | kFeatureRefraction | kFeatureImages |
                                      kFeatureAreaLights | kFeatureAbsorption | kFeatureLightKinds |
                                      kFeatureManyLights | kFeatureCaustics;

/// The features of the leanest variant that renders scenes with these. Glass needs all that mirrors
/// need: total internal reflection. What absorbs is glass. One variant with everything is enough
/// for the kinds of light, and for many of them; and another for photons.
constexpr unsigned variantOf(unsigned features) {
#ifdef RT_TWO_VARIANTS
    return (features & kVariantFeatures) ? kVariantFeatures : 0;
#else
    if (features & kFeatureCaustics) return kVariantFeatures;
    if (features & (kFeatureLightKinds | kFeatureManyLights)) {
        return kVariantFeatures & ~kFeatureCaustics;
    }
    features &= kVariantFeatures;
    if (features & kFeatureAbsorption) features |= kFeatureRefraction;
    return (features & kFeatureRefraction) ? features | kFeatureReflection : features;
#endif
}

/// TraceKernel's functions of the same names.
struct TracerVariant {
    void (*renderTile)(const RenderScene&, const TraceSettings&, const Tile&,
                       const std::uint32_t* ends, PixelState*, TraceCounts&) = nullptr;
    void (*probeTile)(const RenderScene&, const TraceSettings&, const Tile&, int spacing,
                      const std::uint32_t* ends, Probe*, TraceCounts&) = nullptr;
    void (*probePixels)(const RenderScene&, const TraceSettings&, std::span<const PixelPlace>,
                        std::uint32_t samples, Probe*, TraceCounts&) = nullptr;
    void (*firstHits)(const RenderScene&, const TraceSettings&, const Tile&, FirstHit*) = nullptr;
};

/// The leanest variant that renders scenes with these features.
TracerVariant tracerFor(unsigned features);

}  // namespace rt
