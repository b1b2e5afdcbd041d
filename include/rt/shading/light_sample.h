// How a light is seen from a point, and directions towards it.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"
#include "rt/sampling/warp.h"
#include "rt/shading/light.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt {

/// One direction to a light, and what it brings with nothing in its way.
struct LightRay {
    Vec3 w{0.0};            ///< unit
    Color irradiance{0.0};  ///< on a surface that faces it, weight included
    double reach = 0.0;     ///< distance to the light, of a rectangle
};

/// The cone that a light of radius R at distance d fills: sin A = R / d. From inside the light it
/// is the hemisphere about the direction of the centre; for a point light it is one direction. Of a
/// rectangle it is the cone of the sphere around it.
struct LightView {
    Vec3 axis{0.0};         ///< unit, towards the centre
    double distance = 0.0;  ///< of the centre; infinite for a sun
    double radius = 0.0;
    double oneMinusCos = 0.0;  ///< 1 - cos A
    /// 2 / (1 + cos A): makes the mean of n.w over the whole cone exactly n.axis.
    double weight = 1.0;
    Color irradiance{0.0};             ///< intensity / (c0 + c1 d + c2 d^2), d at least R
    const Light* rectangle = nullptr;  ///< whose points differ in irradiance

    bool isPoint() const { return radius == 0.0 && oneMinusCos == 0.0; }
    /// Whether all of the cone brings the same irradiance.
    bool isEven() const { return !rectangle; }
    /// Distance along the unit direction w to the light's sphere; from inside, to where w leaves
    /// it.
    double reach(const Vec3& w) const;
    double reach(const LightRay& ray) const { return rectangle ? ray.reach : reach(ray.w); }
    /// The one direction of a point.
    LightRay onlyRay() const { return {axis, weight * irradiance}; }
    /// From `from`, by a point of the unit square: uniform in the cone, or on a rectangle's area.
    LightRay ray(const Vec2& u, const Vec3& from) const;
};

/// The views of the other kinds than balls.
std::optional<LightView> viewOfOther(const Light& light, const Vec3& from);
LightRay rayToRectangle(const LightView& view, const Vec2& u, const Vec3& from);

/// Nothing at the very place of a point light, which gives nothing there.
inline std::optional<LightView> viewOfBall(const Light& light, const Vec3& from) {
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

inline std::optional<LightView> viewOf(const Light& light, const Vec3& from) {
    if (light.kind == LightKind::kBall) [[likely]]
        return viewOfBall(light, from);
    return viewOfOther(light, from);
}

inline double LightView::reach(const Vec3& w) const {
    if (radius == 0.0) return distance;
    const double along = distance * glm::dot(w, axis);
    const Vec3 aside = distance * (axis - glm::dot(w, axis) * w);
    const double half = std::sqrt(std::max(radius * radius - glm::dot(aside, aside), 0.0));
    return distance > radius ? along - half : along + half;
}

inline LightRay LightView::ray(const Vec2& u, const Vec3& from) const {
    if (rectangle) [[unlikely]]
        return rayToRectangle(*this, u, from);
    return {coneDirection(axis, oneMinusCos, u), weight * irradiance};
}

/// Where a ball about a point lies to the cones of a spot: all of it in the full light, all of it
/// in none, between them with room (the light changes little across the ball), or at an edge.
enum class SpotPlace { kLit, kDark, kFading, kEdge };
SpotPlace placeInSpot(const Light& spot, const Vec3& point, double radius);

}  // namespace rt
