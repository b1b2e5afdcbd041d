// Phong's local illumination for one direction of light.
#pragma once

#include "rt/core/vec.h"
#include "rt/math/portable.h"
#include "rt/shading/fresnel.h"
#include "rt/shading/material.h"

#include <algorithm>

namespace rt {

/// kd max(n.w, floor) + ks max(r.v, 0)^p [n.w > 0]: n the shading normal, v to the viewer, w to the
/// light, all unit; r is w mirrored at n.
/// Phong, Illumination for Computer Generated Pictures, CACM 18(6), 1975.
inline Color phong(const Material& material, const Vec3& n, const Vec3& v, const Vec3& w,
                   double floor) {
    const double cosine = glm::dot(n, w);
    Color sum = material.diffuse * std::max(cosine, floor);
    if (cosine > 0.0 && material.specular != Color(0.0)) {
        const double lobe = std::max(glm::dot(2.0 * cosine * n - w, v), 0.0);
        sum += material.specular * portable::powUnit(std::min(lobe, 1.0), material.exponent);
    }
    return sum;
}

}  // namespace rt
