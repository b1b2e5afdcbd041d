// Coloured glass: what a way through a solid leaves of light.
#pragma once

#include "rt/core/vec.h"
#include "rt/math/portable.h"

namespace rt {

/// T = exp(-a d) in each channel: a >= 0 the absorption in one over units of the world, d >= 0 the
/// way in these units. A channel that is not absorbed passes whole, however long the way.
/// Beer, Bestimmung der Absorption des rothen Lichts in farbigen Fluessigkeiten, Annalen der Physik
/// und Chemie 162, 1852.
inline Color transmittance(const Color& absorption, double distance) {
    const auto through = [distance](double a) {
        return a > 0.0 ? portable::exp(-a * distance) : 1.0;
    };
    return {through(absorption.x), through(absorption.y), through(absorption.z)};
}

}  // namespace rt
