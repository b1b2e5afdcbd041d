// How a sphere light is seen from a point, and directions towards it.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"
#include "rt/shading/light.h"

#include <optional>

namespace rt {

/// The cone that a light of radius R at distance d fills: sin A = R / d. From inside the light it
/// is the hemisphere about the direction of the centre; for a point light it is one direction.
struct LightView {
    Vec3 axis{0.0};         ///< unit, towards the centre
    double distance = 0.0;  ///< of the centre
    double radius = 0.0;
    double oneMinusCos = 0.0;  ///< 1 - cos A
    /// 2 / (1 + cos A): makes the mean of n.w over the whole cone exactly n.axis.
    double weight = 1.0;
    Color irradiance{0.0};  ///< intensity / (c0 + c1 d + c2 d^2), d at least R

    bool isPoint() const { return radius == 0.0; }
    /// Distance along the unit direction w to the light's sphere; from inside, to where w leaves
    /// it.
    double reach(const Vec3& w) const;
};

/// Nothing at the very place of a point light, which gives nothing there.
std::optional<LightView> viewOf(const Light& light, const Vec3& from);

}  // namespace rt
