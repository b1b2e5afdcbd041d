// Tiles x threads x kernel -> film.
#pragma once

#include "rt/render/film.h"
#include "rt/render/render_log.h"
#include "rt/render/snapshot.h"
#include "rt/trace/trace_kernel.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rt {

struct RenderJob {
    TraceSettings settings;
    Tile area;    ///< of the image; what lies outside is not rendered
    Shard shard;  ///< of the area's tiles; towards an error target all are rendered, for all decide
    int threads = 1;
    double timeLimit = 0.0;  ///< seconds; 0 = none
    /// Sample until the estimated RMSE of the area is at most this; 0 = exactly settings.spp
    /// samples a pixel, and settings.spp is the most that a pixel gets otherwise.
    double errorTarget = 0.0;
    /// Of scenes with kFeatureCaustics: trace photons until their light is off by at most this
    /// RMSE.
    double causticTarget = 0.0;
    bool adaptive = true;  ///< towards an error target: more samples where they help most
    bool wantsPixelErrors = false;
    const TraceKernel* kernel = nullptr;
    const std::atomic<bool>* cancel = nullptr;
    /// Told the share of the work that is done, from the calling thread or a worker, one at a time.
    std::function<void(double share)> onProgress;
    /// Told the estimated RMSE so far, between passes towards an error target, where it is known.
    std::function<void(double error)> onEstimate;
    /// Told what there is so far whenever `wantsSnapshot` is true, and at the end; from the calling
    /// thread or a worker, one at a time. The film does not depend on it, to the bit.
    std::function<void(RenderSnapshot snapshot)> onSnapshot;
    const std::atomic<bool>* wantsSnapshot = nullptr;
    /// Where not null: what it holds of an equal job is not traced again, and what is traced goes
    /// in. The film is then the same, to the bit.
    RenderLog* log = nullptr;
    /// Told that now is a time to save the log, every `checkpointEvery` seconds (0: never) and
    /// where the render was cancelled; from the calling thread or a worker, one at a time.
    std::function<void()> onCheckpoint;
    double checkpointEvery = 0.0;
};

/// What the tracer is told in it.
TraceSettings traceSettingsOf(const RenderJob& job);

/// Where a render stood after a pass.
struct PassRecord {
    std::uint64_t samples = 0;  ///< camera rays so far
    std::optional<double> errorEstimate;
    double seconds = 0.0;  ///< since the start
};

/// What became of the photons, and how far their light is off in the picture: RMSE of values
/// clipped to [0, 1], by chance and by the width of the kernel.
struct CausticReport {
    double noise = 0.0;
    double bias = 0.0;
    std::uint64_t sent = 0;
    std::uint64_t kept = 0;  ///< that came down after something had mirrored or refracted them
    std::uint32_t passes = 0;
    double firstRadius = 0.0;  ///< in units of the world
    double lastRadius = 0.0;
    bool isEnough = true;  ///< no further off than was asked for
    /// The last radius where photons light what pixels show, in the median.
    double lastRadiusInPixels = 1.0;

    double squaredError() const { return noise * noise + bias * bias; }
};

struct RenderOutcome {
    explicit RenderOutcome(const Tile& area) : film(area) {}

    Film film;
    TraceCounts counts;
    std::vector<TraceCounts> tileCounts;  ///< of the area's tiles, without probes
    std::vector<PassRecord> passes;       ///< in order
    double seconds = 0.0;
    double cpuSeconds = 0.0;
    /// Estimated RMSE of the image, photons and what was cut included; of single samples nothing
    /// can be said.
    std::optional<double> errorEstimate;
    /// Where they were asked for and are known: the estimated squared error of each pixel, whose
    /// mean is the square of the estimate less what was cut.
    std::vector<double> pixelErrors;
    /// Of scenes with kFeatureCaustics, and what the tracer was told to read.
    std::optional<CausticReport> caustics;
    std::shared_ptr<const PhotonMap> photons;
    bool cancelled = false;
    bool outOfTime = false;
    bool converged = false;  ///< all that was asked for was reached
};

/// What the samples of a film say of its error, where each pixel has its own: the estimated RMSE,
/// but for what was cut, and the squared error of each pixel. Nothing where a pixel has less than
/// two.
struct UniformError {
    double rmse = 0.0;
    std::vector<double> squared;
};
std::optional<UniformError> uniformError(Film& film);

/// The same film, to the bit, for any number of threads and any kernel, unless it is cancelled or
/// runs out of time: then some pixels have fewer samples, or none. Without an error target a pixel
/// does not depend on the area either.
RenderOutcome render(const RenderScene& scene, const RenderJob& job);

}  // namespace rt
