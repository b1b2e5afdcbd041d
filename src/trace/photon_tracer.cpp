#include "photon_tracer.h"

#include "rt/sampling/random.h"
#include "tracer.h"
#include "tracer_light.h"
#include "tracer_path.h"
#include "tracer_photon.h"
#include "tracer_probe.h"
#include "tracer_variants.h"

#include <algorithm>
#include <vector>

namespace rt {
namespace {

using PhotonTracer = Tracer<kVariantFeatures | kBeside>;

/// Names the photons' random numbers among all of a seed.
constexpr std::uint64_t kPhotonStream = 0x70686f746f6e73;

constexpr std::uint32_t kBetweenLooks = 256;

/// What weighs less than this in a sample adds next to nothing to its error.
constexpr double kLeastSeen = 1.0 / 128;

bool isCancelled(const TraceSettings& settings) {
    return settings.cancel && settings.cancel->load(std::memory_order_relaxed);
}

}  // namespace

void tracePhotons(const RenderScene& scene, const TraceSettings& settings, const PhotonPlan& plan,
                  std::uint32_t pass, std::uint32_t group, std::vector<Photon>& photons) {
    TraceCounts uncounted;
    PhotonTracer tracer(scene, settings, uncounted);
    Photon like;
    like.pass = static_cast<std::uint16_t>(pass);
    like.group = static_cast<std::uint16_t>(group);
    const std::uint64_t groupKey = subKey(subKey(mixBits(plan.seed), kPhotonStream), group);
    for (std::size_t i = 0; i < plan.sources.size(); ++i) {
        const PhotonSource& source = plan.sources[i];
        const std::uint64_t key = subKey(groupKey, i);
        const double photonsOfPass = 1.0 * source.count * plan.groups;
        for (std::uint32_t j = 0; j < source.count; ++j) {
            if (j % kBetweenLooks == 0 && isCancelled(settings)) return;
            const std::uint32_t index = pass * source.count + j;
            PhotonStart start = photonStart(scene, plan, source,
                                            sobolPair(index, SobolPair::kPixel, subKey(key, 0)),
                                            sobolPair(index, SobolPair::kLens, subKey(key, 1)));
            start.share /= photonsOfPass;
            tracer.photon(start, subKey(subKey(key, 2), index), like, photons);
        }
    }
}

void seenThrough(const RenderScene& scene, const TraceSettings& settings, const PixelPlace& pixel,
                 int samples, SeenPixel& seen) {
    TraceCounts uncounted;
    PhotonTracer tracer(scene, settings, uncounted);
    for (int i = 0; i < samples; ++i) tracer.see(pixel.x, pixel.y, i, seen);
    seen.value /= samples;
    std::erase_if(seen.points, [](const SeenPoint& point) {
        const Color weight = glm::abs(point.weight);
        return std::max({weight.x, weight.y, weight.z}) < kLeastSeen;
    });
    for (SeenPoint& point : seen.points) point.weight /= samples;
}

}  // namespace rt
