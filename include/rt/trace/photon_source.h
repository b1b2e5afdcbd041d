// Where photons start, and where they are sent.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"

#include <cstdint>
#include <vector>

namespace rt {

/// A ball around objects that mirror or refract; of infinite radius, everywhere.
struct PhotonTarget {
    Vec3 centre{0.0};
    double radius = kInfinity;
};

/// The photons of one light that are sent to one target.
struct PhotonSource {
    Index light = 0;
    Index target = 0;
    std::uint32_t count = 0;  ///< of one group in one pass
};

/// What one pass sends out: directions that several targets share are weighed by one over their
/// number.
struct PhotonPlan {
    std::vector<PhotonTarget> targets;
    std::vector<PhotonSource> sources;
    std::uint32_t groups = 1;
    double reach = 0.0;  ///< a sun's photons start this far before the centre of their target
    std::uint64_t seed = 0;
};

}  // namespace rt
