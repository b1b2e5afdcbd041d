// The renderer's inner loops, compiled once for each instruction set and chosen at run time.
// All variants give the same bits.
#pragma once

#include "rt/geometry/hit.h"
#include "rt/sampling/sampler_kind.h"
#include "rt/trace/first_hit.h"
#include "rt/trace/probe.h"
#include "rt/trace/render_scene.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

struct Photon;
struct PhotonMap;
struct PhotonPlan;
struct SeenPixel;

struct TraceSettings {
    int spp = 16;  ///< samples that each pixel will get; jitter and grid divide the pixel by it
    int maxDepth = 16;
    double cutoff = 1.0 / 2048;  ///< 0: nothing is cut
    std::uint64_t raysPerSample = 4096;
    std::uint64_t seed = 0;
    SamplerKind sampler = SamplerKind::kJoint;
    FilterKind filter = FilterKind::kBox;
    /// Textures are averaged over a sample's share of its pixel: one of so many cells, or of as
    /// many as there were samples before it (sampling/pixel_share.h). 0: read at full resolution.
    std::uint32_t textureShares = 128;
    /// Where there are many lights, so many are chosen at each point; 0: all are looked at.
    int lightsAtPoint = 16;
    /// What mirrors and glass send onto surfaces, of scenes with kFeatureCaustics; null: nothing.
    const PhotonMap* photons = nullptr;
    /// Once true, pixels are left with the samples that they have; looked at now and then.
    const std::atomic<bool>* cancel = nullptr;
};

/// What a pixel has gathered: plain data, the one thing that a checkpoint or a shard has to carry.
struct PixelState {
    Color sum{0.0};
    Color half{0.0};  ///< sum of the first samples / 2 of them
    std::uint64_t samples = 0;

    Color mean() const { return samples ? sum / static_cast<double>(samples) : Color(0.0); }
};

struct PixelPlace {
    int x = 0;
    int y = 0;
};

/// Half-open rectangle of pixels.
struct Tile {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    /// Where pixel (x, y) lies among them, row by row, and back.
    std::size_t offset(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) +
               static_cast<std::size_t>(x - x0);
    }
    PixelPlace placeOf(std::size_t index) const {
        const auto columns = static_cast<std::size_t>(width());
        return {x0 + static_cast<int>(index % columns), y0 + static_cast<int>(index / columns)};
    }
};

/// Rays traced, by what they were for.
struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflection = 0;
    std::uint64_t refraction = 0;
};

/// What the work on some samples came to; adds up over tiles.
struct TraceCounts {
    RayCounts rays;
    std::uint64_t cutPaths = 0;
    double cutBound = 0.0;        ///< sum over samples of the bounds of what was cut
    std::uint64_t nonFinite = 0;  ///< samples that were NaN or infinite, and count as 0
    int nonFiniteX = 0;           ///< the first of them
    int nonFiniteY = 0;

    void add(const TraceCounts& other);
};

struct SceneHit {
    PrimitiveHit at;
    Index instance = kNone;
    /// How far from this in t other crossings may lie that count as one with it; 0 if there are
    /// none.
    double spread = 0.0;
};

/// MeshTree's questions, as this instruction set answers them.
struct MeshQueries {
    bool (*closestHit)(const MeshTree& tree, const Ray& ray, Interval range, PrimitiveHit& hit);
    bool (*anyHit)(const MeshTree& tree, const Ray& ray, Interval range);
    void (*closestHits)(const MeshTree& tree, std::span<const Ray> rays,
                        std::span<const Interval> ranges, std::span<PrimitiveHit> hits);
    void (*anyHits)(const MeshTree& tree, std::span<const Ray> rays,
                    std::span<const Interval> ranges, std::span<bool> met);
};

struct TraceKernel {
    const char* name;
    MeshQueries mesh;

    /// Adds to each pixel of `tile` the samples that it lacks of its number in `ends`. `pixels` and
    /// `ends` are row-major, tile.width() wide.
    void (*renderTile)(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
                       const std::uint32_t* ends, PixelState* pixels, TraceCounts& counts);

    /// Adds to each probe the samples of lights that it lacks of its number in `ends`, an even
    /// one. Corner (x, y) of `corners` is the upper left one of pixel (spacing x, spacing y). The
    /// scene has no lens.
    void (*probeTile)(const RenderScene& scene, const TraceSettings& settings, const Tile& corners,
                      int spacing, const std::uint32_t* ends, Probe* probes, TraceCounts& counts);

    /// Fills one probe for each pixel: looks through its centre, with `samples` of each light, an
    /// even number. The scene has no lens.
    void (*probePixels)(const RenderScene& scene, const TraceSettings& settings,
                        std::span<const PixelPlace> pixels, std::uint32_t samples, Probe* probes,
                        TraceCounts& counts);

    /// Fills one hit for each pixel of `tile`, row-major.
    void (*firstHits)(const RenderScene& scene, const TraceSettings& settings, const Tile& tile,
                      FirstHit* hits);

    /// Appends the photons of one group in one pass, in a fixed order. The scene has
    /// kFeatureCaustics.
    void (*tracePhotons)(const RenderScene& scene, const TraceSettings& settings,
                         const PhotonPlan& plan, std::uint32_t pass, std::uint32_t group,
                         std::vector<Photon>& photons);

    /// The first `samples` samples of a pixel.
    void (*seenThrough)(const RenderScene& scene, const TraceSettings& settings,
                        const PixelPlace& pixel, int samples, SeenPixel& seen);

    /// One shape by itself, placed by `transform`: the nearest hit of a world-space ray, and the
    /// unit geometric normal there, in the world.
    bool (*intersectShape)(const Shape& shape, const Transform& transform, const Ray& ray,
                           Interval range, PrimitiveHit& hit, Vec3& normal);
};

}  // namespace rt
