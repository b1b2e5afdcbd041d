#include "rt/trace/camera.h"

#include "rt/math/portable.h"

namespace rt {

Camera::Camera(const Frame& frame, int width, int height)
    : eye_(frame.eye),
      forward_(glm::normalize(frame.view)),
      right_(glm::normalize(glm::cross(forward_, glm::normalize(frame.up)))),
      up_(glm::cross(right_, forward_)),
      centre_(0.5 * width, 0.5 * height),
      lensRadius_(frame.lensRadius),
      focusDistance_(frame.focusDistance) {
    const double half = 0.5 * frame.fovDegrees;
    const double pixel = 2.0 * portable::sinDegrees(half) / portable::cosDegrees(half) / height;
    perPixelRight_ = pixel * right_;
    perPixelDown_ = -pixel * up_;
}

Camera::Projection Camera::project(const Vec3& p) const {
    const Vec3 offset = p - eye_;
    const double depth = glm::dot(offset, forward_);
    const double perPixel = pixelSize() * depth;
    return {centre_.x + glm::dot(offset, right_) / perPixel,
            centre_.y - glm::dot(offset, up_) / perPixel, depth};
}

Ray Camera::ray(double x, double y, const Vec2& lens) const {
    const Vec3 through =
        forward_ + (x - centre_.x) * perPixelRight_ + (y - centre_.y) * perPixelDown_;
    if (!hasLens()) return {eye_, glm::normalize(through)};
    const Vec3 offset = lensRadius_ * (lens.x * right_ + lens.y * up_);
    return {eye_ + offset, glm::normalize(focusDistance_ * through - offset)};
}

}  // namespace rt
