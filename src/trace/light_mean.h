// What a light that nothing hides brings, as the mean over its whole cone.
#pragma once

#include "rt/shading/light.h"
#include "rt/shading/light_sample.h"
#include "rt/shading/material.h"

#include <optional>

namespace rt {

/// Where a light's cone lies to the horizons of a surface: all of it above both of them, all of it
/// below the geometric one, or anything else.
enum class LightHorizon { kAbove, kBelow, kCut };

/// The cone is above a horizon of normal n if n . axis >= sin A, below it if n . axis <= -sin A.
LightHorizon horizonOf(const LightView& view, const Vec3& geometricNormal, const Vec3& normal);

/// The mean over the cone, times irradiance and weight, of
/// kd max(n.w, floor) + ks max(r.v, 0)^p, with v to the viewer, all unit: the diffuse part is
/// kd n . axis exactly (or kd floor, where the floor is above all n.w); the lobe is integrated by a
/// rule of the disc that the cone's directions map to, of degree 5 for blunt lobes and of Gauss
/// points by angles for sharper ones, to about 2e-4 of the lobe's peak. Nothing if the cone is not
/// above the horizons, the floor cuts through it, the point lies in the light, or the lobe is too
/// sharp for the rules: p (1 - cos A) > 64.
/// Rule of degree 5: Stroud, Approximate Calculation of Multiple Integrals, 1971, S2: 5-1.
std::optional<Color> unoccludedMean(const Material& material, const Vec3& normal,
                                    const Vec3& toViewer, const Light& light, const LightView& view,
                                    LightHorizon horizon);

}  // namespace rt
