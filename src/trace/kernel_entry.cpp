// The one symbol by which a kernel is seen from outside; see tools/seal_kernel.sh.
#include "photon_tracer.h"
#include "rt/trace/trace_kernel.h"
#include "scene_intersect.h"
#include "tracer_variants.h"

#include <utility>

#if defined(RT_KERNEL_AVX512)
#define RT_KERNEL_ENTRY rtKernel_avx512
#define RT_KERNEL_NAME "avx512"
#elif defined(RT_KERNEL_AVX2)
#define RT_KERNEL_ENTRY rtKernel_avx2
#define RT_KERNEL_NAME "avx2"
#else
#define RT_KERNEL_ENTRY rtKernel_baseline
#define RT_KERNEL_NAME "baseline"
#endif

namespace rt {
namespace {

void renderTile(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
                const std::uint32_t* ends, PixelState* pixels, TraceCounts& counts) {
    tracerFor(scene.features).renderTile(scene, settings, tile, ends, pixels, counts);
}

void probeTile(const RenderScene& scene, const TraceSettings& settings, const Tile& corners,
               int spacing, const std::uint32_t* ends, Probe* probes, TraceCounts& counts) {
    tracerFor(scene.features).probeTile(scene, settings, corners, spacing, ends, probes, counts);
}

void probePixels(const RenderScene& scene, const TraceSettings& settings,
                 std::span<const PixelPlace> pixels, std::uint32_t samples, Probe* probes,
                 TraceCounts& counts) {
    tracerFor(scene.features).probePixels(scene, settings, pixels, samples, probes, counts);
}

void firstHits(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
               FirstHit* hits) {
    tracerFor(scene.features).firstHits(scene, settings, tile, hits);
}

/// Member functions of MeshTree as plain ones.
template <auto Member, class... Arguments>
auto ask(const MeshTree& tree, Arguments... arguments) {
    return (tree.*Member)(std::forward<Arguments>(arguments)...);
}

constexpr MeshQueries kMesh{&ask<&MeshTree::closestHit>, &ask<&MeshTree::anyHit>,
                            &ask<&MeshTree::closestHits>, &ask<&MeshTree::anyHits>};

constexpr TraceKernel kKernel{RT_KERNEL_NAME, kMesh,        &renderTile,
                              &probeTile,     &probePixels, &firstHits,
                              &tracePhotons,  &seenThrough, &intersectShape};

}  // namespace
}  // namespace rt

extern "C" const rt::TraceKernel* RT_KERNEL_ENTRY() {
    return &rt::kKernel;
}
