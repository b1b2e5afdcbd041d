// Which photons a pass sends out.
#pragma once

#include "rt/trace/photon_source.h"
#include "rt/trace/render_scene.h"

namespace rt {

/// Balls around all that mirrors or refracts, not more than a few dozen, and from each light to
/// each of them a share of the photons in proportion to the flux. Nothing where no light comes by
/// photons.
PhotonPlan photonPlan(const RenderScene& scene, std::uint64_t seed);

}  // namespace rt
