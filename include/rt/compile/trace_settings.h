// The options of a run -> what the tracer is told.
#pragma once

#include "rt/scene/render_options.h"
#include "rt/trace/trace_kernel.h"

namespace rt {

inline constexpr int kDefaultSpp = 16;

/// Every field of `options` passed the checks of the option table. `reference` switches off all that
/// trades truth for speed: no path is cut.
TraceSettings traceSettings(const RenderOptions& options);

}  // namespace rt
