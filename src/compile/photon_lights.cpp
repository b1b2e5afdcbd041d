#include "photon_lights.h"

namespace rt {

void sendByPhotons(RenderScene& scene, const SourceLocation& where, Diagnostics& diagnostics) {
    bool sendsOn = false;
    bool everywhere = false;
    for (const Instance& instance : scene.instances) {
        if (!scene.looks[instance.look].sendsOn()) continue;
        sendsOn = true;
        everywhere = everywhere || !kindOf(scene.shapes[instance.shape]).bounded;
    }
    if (!sendsOn) return;
    if (!scene.moving.empty()) {
        diagnostics.warn("caustics", where, "there are no caustics where nodes move");
        return;
    }
    for (Light& light : scene.lights) {
        if (everywhere && light.kind == LightKind::kSun) {
            diagnostics.warn("caustics", where,
                             "a sun throws no caustics where a plane mirrors or refracts");
            continue;
        }
        light.byPhotons = true;
        scene.features |= kFeatureCaustics;
    }
}

}  // namespace rt
