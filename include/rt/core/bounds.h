// Axis-aligned boxes.
#pragma once

#include "rt/core/ray.h"

#include <glm/common.hpp>

namespace rt {

/// The closed box [min, max]; the default box is empty, and the identity of `unite`.
struct Bounds {
    Vec3 min{kInfinity};
    Vec3 max{-kInfinity};

    bool isEmpty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    Vec3 centre() const { return 0.5 * min + 0.5 * max; }
    Vec3 extent() const { return max - min; }

    void unite(const Vec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void unite(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
};

}  // namespace rt
