#include "rt/math/portable.h"
#include "rt/trace/render_scene.h"

#include <algorithm>

namespace rt {

Color Background::at(const Vec3& direction) const {
    if (image) {
        constexpr double kPi = 3.14159265358979323846;
        const double u = 0.5 + portable::atan2(direction.x, -direction.z) / (2.0 * kPi);
        const double up = 0.5 + portable::asin(std::clamp(direction.y, -1.0, 1.0)) / kPi;
        // Textures repeat: beyond the middle of the last row lies the other pole.
        const double halfRow = 0.5 / image->height();
        const double v = std::clamp(up, halfRow, 1.0 - halfRow);
        return image->bilinear({u, image->flipsV() ? 1.0 - v : v});
    }
    if (bottom == top) return bottom;
    return glm::mix(bottom, top, 0.5 + 0.5 * direction.y);
}

}  // namespace rt
