#include "scene_report.h"

#include <memory>
#include <variant>

namespace rt {
namespace {

struct FeatureText {
    unsigned feature;
    const char* name;
    const char* leftOut;  ///< what is skipped without it
    const char* why;
};

constexpr FeatureText kTexts[] = {
    {kFeatureReflection | kFeatureRefraction, "secondary rays", "secondary rays and the path stack",
     "no object reflects or refracts"},
    {kFeatureReflection, "reflection", "mirror rays", "no object has set_reflection"},
    {kFeatureRefraction, "refraction", "media around each ray, and Fresnel terms",
     "no object has set_refraction"},
    {kFeatureRefraction, "transparent shadows", "shadow rays that walk through glass",
     "no object has set_refraction"},
    {kFeatureAbsorption, "absorption", "what media absorb along each ray",
     "no object that light shines through has set_absorption"},
    {kFeatureMotion, "motion blur", "a moment of its own for each sample", "no node moves"},
    {kFeatureImages, "textures and bump maps", "texture look-ups and tangents",
     "no object has a texture or a bump map"},
    {kFeatureAreaLights, "area lights", "light samples", "every light is a point"},
    {kFeatureLightKinds, "light kinds", "what spots, suns and rectangles give",
     "every light is a gr.light"},
    {kFeatureManyLights, "many lights", "a choice of lights at each point",
     "the lights are few enough to look at them all"},
    {kFeatureLens, "lens", "lens samples", "no gr.focal with a lens radius above 0"},
    {kFeatureCsg, "combined solids", "what solids have in common",
     "no gr.union, gr.intersection or gr.difference is placed"},
    {kFeatureCaustics, "caustics", "photons",
     "no gr.options{caustics = true}, or nothing that mirrors or refracts light at rest"},
    {kFeatureMeshes, "meshes", "mesh trees and normal interpolation", "no gr.mesh is placed"},
};

bool usesBackgroundImage(const RenderScene& scene) {
    return scene.background.image != nullptr;
}

}  // namespace

std::vector<std::string> featuresOf(const RenderScene& scene) {
    std::vector<std::string> names;
    for (const FeatureText& text : kTexts) {
        if (scene.features & text.feature) names.emplace_back(text.name);
    }
    if (usesBackgroundImage(scene)) names.emplace_back("background image");
    if (!scene.lights.empty()) names.emplace_back("lights");
    return names;
}

std::vector<SkippedFeature> skippedBy(const RenderScene& scene) {
    std::vector<SkippedFeature> skipped;
    for (const FeatureText& text : kTexts) {
        if (!(scene.features & text.feature)) skipped.push_back({text.leftOut, text.why});
    }
    if (!usesBackgroundImage(scene)) {
        skipped.push_back({"background image look-ups", "no gr.background with an image"});
    }
    if (scene.lights.empty()) skipped.push_back({"shadow rays", "there are no lights"});
    return skipped;
}

SceneCounts countsOf(const RenderScene& scene) {
    SceneCounts counts;
    for (const Shape& shape : scene.shapes) {
        if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape)) {
            counts.triangles += (*mesh)->mesh.triangles.size();
        }
    }
    for (const Instance& instance : scene.instances) {
        const Shape& shape = scene.shapes[instance.shape];
        if (!std::holds_alternative<std::shared_ptr<const MeshShape>>(shape)) ++counts.primitives;
    }
    return counts;
}

std::string explanation(const RenderScene& scene) {
    std::string text = "Used:";
    for (const std::string& name : featuresOf(scene)) text += " " + name + ";";
    text += "\n";
    for (const SkippedFeature& skipped : skippedBy(scene)) {
        text += "Left out: " + skipped.what + ", because " + skipped.why + "\n";
    }
    return text;
}

}  // namespace rt
