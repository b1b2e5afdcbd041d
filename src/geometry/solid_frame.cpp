#include "solid_frame.h"

#include <sstream>
#include <stdexcept>

namespace rt {

void requirePositive(const char* solid, const char* what, double value) {
    if (value > 0.0 && value < kInfinity) return;
    std::ostringstream message;
    message << solid << ": " << what << " must be > 0 and finite, got " << value;
    throw std::invalid_argument(message.str());
}

void requireFinite(const char* solid, const char* what, const Vec3& value) {
    if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return;
    std::ostringstream message;
    message << solid << ": " << what << " must be finite, got (" << value.x << ", " << value.y
            << ", " << value.z << ")";
    throw std::invalid_argument(message.str());
}

}  // namespace rt
