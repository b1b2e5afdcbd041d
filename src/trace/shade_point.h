// A hit as shading sees it: in the world, turned towards the viewer.
#pragma once

#include "rt/trace/trace_kernel.h"

namespace rt {

struct ShadePoint {
    Vec3 position{0.0};
    Vec3 geometricNormal{0.0};  ///< unit, towards the viewer
    Vec3 normal{0.0};           ///< shading normal, unit, in the geometric normal's hemisphere
    Vec3 shadowOrigin{0.0};     ///< off `position` on smooth meshes only: on the rounded surface
    /// Secondary rays start this far off the surface: more than the error of `position`.
    double clearance = 0.0;
    bool fromInside = false;  ///< the ray came from where the surface's own normal does not point
    Material material;        ///< with the texture's colour put in

    /// Whether this is a facet that stands for a rounded surface.
    bool isRounded() const { return shadowOrigin != position; }

    /// Start of a ray that leaves in direction w from `from`, on w's side of the surface.
    Vec3 leave(const Vec3& from, const Vec3& w) const {
        const double side = glm::dot(w, geometricNormal) < 0.0 ? -clearance : clearance;
        return from + side * geometricNormal;
    }
};

struct Beam;

/// `images`: whether textures and bump maps have to be looked up. Textures of surfaces without a
/// bump map are averaged over the share of the pixel that a `beam` has.
ShadePoint shadePoint(const RenderScene& scene, const SceneHit& hit, const Vec3& rayDirection,
                      bool images, const Beam* beam = nullptr);

/// w, sent to the side of the geometric surface where `side` (+1 the viewer's, -1 the other) is.
inline Vec3 broughtToSide(const Vec3& w, const Vec3& geometricNormal, double side) {
    const double cosine = glm::dot(w, geometricNormal);
    return cosine * side < 0.0 ? w - 2.0 * cosine * geometricNormal : w;
}

}  // namespace rt
