// Phong material: what a surface does with light that reaches it.
#pragma once

#include "rt/core/vec.h"

namespace rt {

/// own = diffuse * (ambient + sum of light * n.w) + sum of specular * light * (r.v)^exponent;
/// exponent >= 0 and 0^0 = 1.
struct Material {
    Color diffuse{0.0};
    Color specular{0.0};
    double exponent = 0.0;
};

}  // namespace rt
