// Tiles x threads x kernel -> film.
#pragma once

#include "rt/render/film.h"
#include "rt/trace/trace_kernel.h"

#include <atomic>
#include <functional>

namespace rt {

struct RenderJob {
    TraceSettings settings;
    Tile area;  ///< of the image; what lies outside is not rendered
    int threads = 1;
    double timeLimit = 0.0;  ///< seconds; 0 = until every pixel has settings.spp samples
    const TraceKernel* kernel = nullptr;
    const std::atomic<bool>* cancel = nullptr;
    /// Told the share of the work that is done, from the calling thread or a worker, one at a time.
    std::function<void(double share)> onProgress;
};

struct RenderOutcome {
    Film film;
    TraceCounts counts;
    double seconds = 0.0;
    double cpuSeconds = 0.0;
    bool cancelled = false;
    bool outOfTime = false;
};

/// The same film, to the bit, for any number of threads, any kernel and any area, unless it is
/// cancelled or runs out of time: then some pixels have fewer samples, or none.
RenderOutcome render(const RenderScene& scene, const RenderJob& job);

}  // namespace rt
