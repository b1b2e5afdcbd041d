#include "rt/shading/light_sample.h"

#include <algorithm>
#include <cmath>

namespace rt {

std::optional<LightView> viewOf(const Light& light, const Vec3& from) {
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

double LightView::reach(const Vec3& w) const {
    if (isPoint()) return distance;
    const double along = distance * glm::dot(w, axis);
    const Vec3 aside = distance * (axis - glm::dot(w, axis) * w);
    const double half = std::sqrt(std::max(radius * radius - glm::dot(aside, aside), 0.0));
    return distance > radius ? along - half : along + half;
}

}  // namespace rt
