// What the pixels' centres show, beside the picture.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <vector>

namespace rt {

/// Row-major hits of the pixels of `area`, the same for any number of threads and any kernel.
std::vector<FirstHit> firstHits(const RenderScene& scene, const TraceSettings& settings,
                                const Tile& area, int threads, const TraceKernel& kernel);

}  // namespace rt
