// The Tracer that tells what it does. It is compiled for any x86-64 alone: other instruction sets
// give the same bits, and nobody waits for one pixel.
#include "rt/trace/traced_sample.h"

#include "tracer.h"
#include "tracer_light.h"
#include "tracer_path.h"
#include "tracer_photon.h"
#include "tracer_probe.h"
#include "tracer_variants.h"

#include <utility>

namespace rt {

template <unsigned Features>
void Tracer<Features>::tellRay(const Path& path) {
    TracedRay told;
    if (path.depth > 0) told.kind = path.node & 1 ? RayKind::kRefracted : RayKind::kReflected;
    told.depth = path.depth;
    told.ray = path.ray;
    told.weight = Color(path.weight);
    told.index = path.media.index(scene_);
    told_.rays.push_back(std::move(told));
}

template <unsigned Features>
void Tracer<Features>::tellHit(const Path& path, const SceneHit& hit, const ShadePoint& point) {
    TracedRay& told = toldRay();
    told.weight = Color(path.weight);
    told.instance = hit.instance;
    told.piece = hit.at.part;
    told.t = hit.at.t;
    told.point = point.position;
    told.geometricNormal = point.geometricNormal;
    told.normal = point.normal;
    told.fromInside = point.fromInside;
    told.material = point.material;
}

template <unsigned Features>
void Tracer<Features>::tellLight(Index light, const Vec3& w, double reach, const Color& unhidden,
                                 const Share& visible, const ShadePoint& point) {
    TracedLight told{light, w, reach, unhidden, Color(visible), kNone};
    SceneHit first;
    const Ray ray{point.leave(point.position, w), w};
    const bool isHidden = told.visible != Color(1.0);
    if (isHidden && closestHit(scene_, ray, {0.0, reach * (1.0 - kCoincidence)}, first)) {
        told.first = first.instance;
    }
    toldRay().lights.push_back(told);
}

template <unsigned Features>
TracedSample Tracer<Features>::tracedSample(int x, int y, int index) {
    told_ = {};
    told_.value = sample(x, y, index);
    const FilterSample at = sampler_.pixel();
    told_.x = x + 0.5 + at.offset.x;
    told_.y = y + 0.5 + at.offset.y;
    told_.filterWeight = at.weight;
    if (moment_) told_.time = sampler_.time();
    return std::move(told_);
}

/// By the variant with everything, which comes to the same bits as the leaner ones.
TracedSample tracedSample(const RenderScene& scene, const TraceSettings& settings,
                          const PixelPlace& pixel, int index) {
    TraceCounts uncounted;
    return Tracer<kVariantFeatures | kTelling>(scene, settings, uncounted)
        .tracedSample(pixel.x, pixel.y, index);
}

}  // namespace rt
