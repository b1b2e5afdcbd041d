#include "solid_frame.h"

#include <sstream>
#include <stdexcept>

namespace rt {

Vec3 extremeUnitVector(const Vec3& v) {
    const Vec3 scaled = scaleByPowerOfTwo(v, -std::ilogb(largestComponent(v)));
    const double inverse = 1.0 / std::sqrt(dot(scaled, scaled));
    return Vec3(scaled.x * inverse, scaled.y * inverse, scaled.z * inverse);
}

Radial extremeRadial(double x, double z) {
    const double size = std::max(std::fabs(x), std::fabs(z));
    if (!(size > 0.0)) return {0.0, 1.0, 0.0};
    const int exponent = std::ilogb(size);
    const double sx = std::ldexp(x, -exponent);
    const double sz = std::ldexp(z, -exponent);
    const double length = std::sqrt(sx * sx + sz * sz);
    return {sx / length, sz / length, std::ldexp(length, exponent)};
}

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
