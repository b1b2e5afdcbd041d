// The Tracer's way to the geometry behind a pixel's centre.
#pragma once

#include "tracer.h"
#include "tracer_probe.h"

namespace rt {

template <unsigned Features>
FirstHit Tracer<Features>::firstHit(int x, int y) {
    FirstHit first;
    const Path path = pathThrough(Vec2(x + 0.5, y + 0.5));
    SceneHit hit;
    if (!nextHit(path.ray, path.media, {}, hit)) return first;
    const ShadePoint point = pointAt(path, hit);
    first.position = point.position;
    first.depth = glm::dot(point.position - scene_.camera.eye(), scene_.camera.forward());
    first.normal = point.normal;
    first.albedo = point.material.diffuse;
    first.uv = surfaceAt(scene_, hit, SurfaceDetail::kParametrised).uv;
    first.object = hit.instance + 1;
    return first;
}

}  // namespace rt
