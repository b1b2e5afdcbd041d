// How a sphere light is seen from a point, and directions towards it.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"
#include "rt/shading/light.h"

#include <algorithm>
#include <cmath>
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
inline std::optional<LightView> viewOf(const Light& light, const Vec3& from) {
    const Vec3 toCentre = light.position - from;
    const double distance = glm::length(toCentre);
    if (!(distance > 0.0) && light.radius == 0.0) return std::nullopt;

    LightView view;
    view.distance = distance;
    view.radius = light.radius;
    view.axis = distance > 0.0 ? toCentre / distance : Vec3(0.0, 1.0, 0.0);
    const double d = std::max(distance, light.radius);
    view.irradiance = light.intensity / (light.c0 + d * (light.c1 + d * light.c2));
    const double sine = std::min(light.radius / d, 1.0);
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    view.oneMinusCos = sine * sine / (1.0 + cosine);
    view.weight = 2.0 / (1.0 + cosine);
    return view;
}

inline double LightView::reach(const Vec3& w) const {
    if (isPoint()) return distance;
    const double along = distance * glm::dot(w, axis);
    const Vec3 aside = distance * (axis - glm::dot(w, axis) * w);
    const double half = std::sqrt(std::max(radius * radius - glm::dot(aside, aside), 0.0));
    return distance > radius ? along - half : along + half;
}

}  // namespace rt
