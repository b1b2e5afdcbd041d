// How photons leave lights.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"
#include "rt/sampling/sobol.h"
#include "rt/trace/photon_source.h"
#include "rt/trace/render_scene.h"

namespace rt {

/// A photon at its light. Its flux where its way of length l ends is `share` times the light's
/// irradiance at `ray.at(l)`, the place where it would be had nothing turned it; times the squared
/// distance of that place from `centre`, but for a sun's. So a way that nothing turns brings what
/// the light brings straight.
struct PhotonStart {
    const Light* light = nullptr;
    Ray ray{};
    Vec3 centre{0.0};    ///< of the light; a point of a rectangle
    double share = 0.0;  ///< of solid angle, or of a sun's area
};

/// `direction` and `place` are points of the unit square: a ball sends a photon in a direction of
/// the cone that the target fills with the light's radius added, from a point of its disc across
/// that direction; a rectangle from a point of its own; a sun in a direction of its disc, along a
/// line through the target. All are uniform: the light's radiance is the same from everywhere.
PhotonStart photonStart(const RenderScene& scene, const PhotonPlan& plan,
                        const PhotonSource& source, const UnitPoint& direction,
                        const UnitPoint& place);

/// The flux of a photon after a way of this length.
Color fluxAfter(const PhotonStart& start, double way);

}  // namespace rt
