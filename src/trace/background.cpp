#include "rt/math/portable.h"
#include "rt/trace/render_scene.h"

#include <algorithm>

namespace rt {

Color Background::at(const Vec3& direction) const {
    if (image) {
        constexpr double kPi = 3.14159265358979323846;
        const double u = 0.5 + portable::atan2(direction.x, -direction.z) / (2.0 * kPi);
        const double v = 0.5 + portable::asin(std::clamp(direction.y, -1.0, 1.0)) / kPi;
        return image->bilinear({u, v});
    }
    if (bottom == top) return bottom;
    return glm::mix(bottom, top, 0.5 + 0.5 * direction.y);
}

}  // namespace rt
