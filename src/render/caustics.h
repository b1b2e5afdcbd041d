// The photons of a picture: traced before its tiles, in passes, until what their light is off by is
// a small enough share of the error that the picture may have.
#pragma once

#include "rt/render/renderer.h"
#include "rt/trace/photon_map.h"

#include <memory>

namespace rt {

/// A function of the scene, the trace settings and the target alone, to the bit, unless the job is
/// cancelled or has a time limit, of which photons take at most half.
struct Caustics {
    std::shared_ptr<const PhotonMap> map;  ///< null where no photons were traced
    CausticReport report;
};
Caustics traceCaustics(const RenderScene& scene, const RenderJob& job);

}  // namespace rt
