// TraceKernel's functions of the same names.
#pragma once

#include "rt/trace/trace_kernel.h"

namespace rt {

void tracePhotons(const RenderScene& scene, const TraceSettings& settings, const PhotonPlan& plan,
                  std::uint32_t pass, std::uint32_t group, std::vector<Photon>& photons);

void seenThrough(const RenderScene& scene, const TraceSettings& settings, const PixelPlace& pixel,
                 int samples, SeenPixel& seen);

}  // namespace rt
