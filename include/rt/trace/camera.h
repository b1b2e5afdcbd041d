// Camera: image points and lens points to rays.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"

namespace rt {

/// Right-handed, `view` forward, row 0 at the top, pixel (x, y) covering [x, x+1) x [y, y+1).
/// With a lens of radius a > 0 every ray of one image point passes through the same point of the
/// plane at distance p along the view direction, and starts on the lens' disc at the eye.
class Camera {
  public:
    struct Frame {
        Vec3 eye{0.0};
        Vec3 view{0.0, 0.0, -1.0};  ///< any length but 0
        Vec3 up{0.0, 1.0, 0.0};     ///< not along view
        double fovDegrees = 50.0;   ///< vertical
        double lensRadius = 0.0;
        double focusDistance = 1.0;
    };

    Camera() = default;
    Camera(const Frame& frame, int width, int height);

    bool hasLens() const { return lensRadius_ > 0.0; }
    double lensRadius() const { return lensRadius_; }
    const Vec3& eye() const { return eye_; }
    /// Side of a pixel on the plane at distance 1.
    double pixelSize() const { return glm::length(perPixelDown_); }
    /// The image point, in pixels, that shows p, and its distance along the view direction.
    struct Projection {
        double x, y, depth;
    };
    Projection project(const Vec3& p) const;
    const Vec3& forward() const { return forward_; }
    /// Steps on the plane at distance 1 from one pixel to the next.
    const Vec3& perPixelRight() const { return perPixelRight_; }
    const Vec3& perPixelDown() const { return perPixelDown_; }

    /// The ray through image point (x, y), in pixels; `lens` is a point of the unit disc.
    /// The direction has unit length.
    Ray ray(double x, double y, const Vec2& lens) const;

  private:
    Vec3 eye_{0.0};
    Vec3 forward_{0.0, 0.0, -1.0};
    Vec3 perPixelRight_{0.0};
    Vec3 perPixelDown_{0.0};
    Vec3 right_{0.0};
    Vec3 up_{0.0};
    Vec2 centre_{0.0};
    double lensRadius_ = 0.0;
    double focusDistance_ = 1.0;
};

}  // namespace rt
