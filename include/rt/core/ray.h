// Rays and the parameter intervals they are tested over.
#pragma once

#include "rt/core/vec.h"

#include <limits>

namespace rt {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Points origin + t * direction. The direction need not be unit length: t counts
/// multiples of it, which lets an instance transform a ray without rescaling t.
struct Ray {
    Vec3 origin;
    Vec3 direction;

    Vec3 at(double t) const { return origin + t * direction; }
};

/// Open interval. A NaN is in no interval, so `contains` also rejects failed arithmetic.
struct Interval {
    double min = 0.0;
    double max = kInfinity;

    bool contains(double t) const { return min < t && t < max; }
};

}  // namespace rt
