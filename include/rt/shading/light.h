// Sphere lights; radius 0 is a point.
#pragma once

#include "rt/core/vec.h"

namespace rt {

/// Irradiance at distance d from the centre: intensity / (c0 + c1 d + c2 d^2), d at least `radius`.
struct Light {
    Vec3 position{0.0};
    Color intensity{0.0};
    double c0 = 1.0;
    double c1 = 0.0;
    double c2 = 0.0;
    double radius = 0.0;
    /// Floor of n.w in the diffuse term.
    double brightness = 0.0;
};

}  // namespace rt
