// How a ray changes with the image point that it belongs to (Igehy, Tracing Ray Differentials,
// SIGGRAPH 1999), and what that makes of a pixel on a texture.
//
// A ray P + t D has the derivatives dP, dD by the image point's x and y, in pixels. With G the
// geometric normal and n the shading normal where it meets a surface:
//
//     there          dp = q - D (q . G) / (D . G),     q = dP + t dD
//     mirrored       dD' = dD - 2 ((D . n) dn + d(D . n) n)
//     refracted      dD' = m dD + (m c - c') dn + (m dc - dc') n,  m the ratio of the indices,
//                    c = -D . n,  c' = -D' . n,  dc' = m^2 c dc / c'
//
// with the dn of curvature.h. Where a derivative is not known, behind a bump map that mirrors or
// bends for example, it is NaN, and textures are read at full resolution.
#pragma once

#include "rt/sampling/pixel_share.h"
#include "rt/trace/trace_kernel.h"
#include "shade_point.h"

#include <array>

namespace rt {

struct RayDifferential {
    struct By {
        Vec3 position{0.0};
        Vec3 direction{0.0};
    };
    std::array<By, 2> by;  ///< x, y
};

/// Of the camera's ray in `direction`, the point on the lens being kept.
RayDifferential cameraDifferential(const Camera& camera, const Vec3& direction);

/// Of the ray that goes on from a hit of `ray` in `direction`. `ratio`: of the indices, from over
/// to; 0 for a mirrored ray.
RayDifferential differentialBeyond(const RayDifferential& before, const RenderScene& scene,
                                   const Ray& ray, const SceneHit& hit, const ShadePoint& point,
                                   const Vec3& direction, double ratio);

/// What a path brings to a texture: its ray, how that changes, and the sample's share of the pixel.
struct Beam {
    const Ray& ray;
    const RayDifferential& differential;
    PixelShare share;

    /// What the sample's share of the pixel covers on the surface, in object space: the sides of a
    /// parallelogram, for a hit at `t` of a shape that is placed by `transform`.
    std::array<Vec3, 2> sidesOn(const SurfacePoint& surface, const Transform& transform,
                                double t) const;
    /// The part of the image that lies in the sample's share, for a hit at `t` of a shape that is
    /// placed by `transform`.
    TextureFootprint on(const SurfacePoint& surface, const Transform& transform, double t) const;
};

}  // namespace rt
