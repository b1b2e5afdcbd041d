// How one sample of a pixel came about: every ray that the tracer followed for it, and what each
// brought.
#pragma once

#include "rt/core/ray.h"
#include "rt/core/vec.h"
#include "rt/shading/material.h"

#include <vector>

namespace rt {

struct PixelPlace;
struct RenderScene;
struct TraceSettings;

enum class RayKind { kCamera, kReflected, kRefracted };

/// A look at one light, where it would bring anything.
struct TracedLight {
    Index light = 0;
    Vec3 direction{0.0};  ///< of the shadow ray, unit
    double reach = 0.0;   ///< its length
    Color unhidden{0.0};  ///< what the light brings with nothing in its way
    Color visible{0.0};   ///< the share of it that arrives
    Index first = kNone;  ///< the first instance in its way, if any is
};

/// The shares of the value at a hit; own, reflected and refracted add up to 1.
struct TracedParts {
    double own = 1.0;
    double cut = 0.0;  ///< what of `own` could have brought so little that it was not followed
    double reflected = 0.0;
    double refracted = 0.0;
};

/// A ray of the tree: it brings weight * parts.own * color.
struct TracedRay {
    RayKind kind = RayKind::kCamera;
    int depth = 0;
    Ray ray;
    Color weight{1.0};       ///< of its value in the sample, less what was absorbed on its way
    double index = 1.0;      ///< of refraction, where it runs
    Index instance = kNone;  ///< that it hits; what follows says nothing where it hits none
    Index piece = 0;         ///< of the shape, see PrimitiveHit
    double t = kInfinity;
    Vec3 point{0.0};
    Vec3 geometricNormal{0.0};  ///< unit, towards the ray's origin
    Vec3 normal{0.0};           ///< that shades, unit
    bool fromInside = false;
    Material material;
    TracedParts parts;
    std::vector<TracedLight> lights;
    Color thrown{0.0};  ///< by photons
    /// The surface's own, by all lights, photons and the ambient light; or the background.
    Color color{0.0};
};

struct TracedSample {
    double x = 0.0;  ///< image point, in pixels
    double y = 0.0;
    double filterWeight = 1.0;
    double time = 0.5;  ///< from 0, where the shutter opens, to 1, where it closes
    /// A ray before those that it spawns, the refracted ones before the reflected ones.
    std::vector<TracedRay> rays;
    Color value{0.0};  ///< the sum of what the rays bring, in their order, times the filter weight
};

/// Sample number `index` of a pixel: by the tracer that renders, with the same value to the bit,
/// whatever instruction set that uses.
TracedSample tracedSample(const RenderScene& scene, const TraceSettings& settings,
                          const PixelPlace& pixel, int index);

}  // namespace rt
