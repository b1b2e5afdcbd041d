// The options of a run -> what the tracer is told.
#pragma once

#include "rt/scene/render_options.h"
#include "rt/trace/trace_kernel.h"

namespace rt {

inline constexpr double kDefaultError = 0.003;
inline constexpr int kDefaultMaxSpp = 4096;
inline constexpr int kDefaultSpp = 16;  ///< of samplers that must know the number beforehand

/// How long to sample, and how.
struct SamplingGoal {
    TraceSettings trace;         ///< trace.spp is the exact number, or the most, of samples a pixel
    double errorTarget = 0.0;    ///< 0: exactly trace.spp samples
    double causticTarget = 0.0;  ///< RMSE that photons may leave
    double timeLimit = 0.0;      ///< seconds; 0: none
    bool adaptive = true;        ///< towards an error target, more samples where they help most
};

/// Every field of `options` passed the checks of the option table. Without spp, error and time the
/// goal is kDefaultError. `reference` switches off all that trades truth for speed: no path is cut,
/// every pixel gets the same number of samples. Throws UsageError for an error target with a
/// sampler whose points depend on their number.
SamplingGoal samplingGoal(const RenderOptions& options);

}  // namespace rt
