// The variants of the tracer, one for each set of features that a scene may use.
#pragma once

#include "rt/trace/trace_kernel.h"

namespace rt {

using TileRenderer = void (*)(const RenderScene&, const TraceSettings&, const Tile&,
                              const std::uint32_t* ends, PixelState*, TraceCounts&);

using TileProber = void (*)(const RenderScene&, const TraceSettings&, const Tile&, int spacing,
                            const std::uint32_t* ends, Probe*, TraceCounts&);

/// The leanest variant that renders scenes with these features.
TileRenderer tileRendererFor(unsigned features);
TileProber tileProberFor(unsigned features);

}  // namespace rt
