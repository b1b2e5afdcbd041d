#include "scene_tree.h"

#include "motion_bounds.h"
#include "rt/core/numeric.h"
#include "rt/trace/csg_shape.h"

#include <algorithm>
#include <memory>
#include <variant>
#include <vector>

namespace rt {
namespace {

constexpr Bounds kEverywhere{Vec3(-kInfinity), Vec3(kInfinity)};

double largest(const Bounds& bounds) {
    const Vec3 v = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    return std::max({v.x, v.y, v.z});
}

/// Magnitude of the coordinates that hits on a shape are computed from, beside its bounds.
double roundingOf(const Shape& shape) {
    const auto* csg = std::get_if<std::shared_ptr<const CsgShape>>(&shape);
    return csg ? (*csg)->rounding : 0.0;
}

/// Boxes of an instance in the world.
struct Extent {
    Bounds box;     ///< of the shape
    Bounds around;  ///< of all points as far from the shape's origin as the shape's
};

/// The world box of a placed shape; met by no ray where a tree leaves it out, by all where the way
/// to object space may be off by more than boxes allow for.
PaddedBox worldBox(const Instance& instance, const Extent& extent) {
    const Vec3 size = extent.box.extent();
    if (extent.box.isEmpty() || !(size.x + size.y + size.z < kInfinity)) return {};
    if (!instance.boxed) return {extent.box, kInfinity};
    return {extent.box, largest(extent.around)};
}

/// Over the shutter's time; the tree leaves out what has no finite box.
Extent extentOf(const Shape& shape, const Transform& transform, const MotionPath* path,
                const Vec3& reach) {
    if (!kindOf(shape).bounded) return {kEverywhere, kEverywhere};
    const Bounds local = boundsOf(shape);
    const Bounds within{-reach, reach};
    Extent extent{transform.boundsToWorld(local), transform.boundsToWorld(within)};
    if (path) {
        extent.box.unite(sweptBounds(*path, local));
        extent.around.unite(sweptBounds(*path, within));
    }
    return extent;
}

/// A map that turns between uneven scales has other conditions at other times.
bool hasTurns(const MotionPath& path) {
    return std::any_of(path.steps.begin(), path.steps.end(),
                       [](const MotionStep& step) { return step.degrees != 0.0; });
}

}  // namespace

void buildSceneTree(RenderScene& scene, int threads) {
    std::vector<Bounds> boxes;
    std::vector<PaddedBox> padded;
    const bool few = scene.instances.size() <= kFewBoxes;
    for (const Shape& shape : scene.shapes) {
        scene.shapeBoxes.push_back({boundsOf(shape), roundingOf(shape)});
    }
    boxes.reserve(scene.instances.size());
    auto moving = scene.moving.begin();
    for (Instance& instance : scene.instances) {
        const Shape& shape = scene.shapes[instance.shape];
        const Bounds local = boundsOf(shape);
        const Vec3 reach =
            glm::max(glm::max(glm::abs(local.min), glm::abs(local.max)), Vec3(roundingOf(shape)));
        const bool moves = moving != scene.moving.end() && moving->instance == boxes.size();
        const MotionPath* path = moves ? &(moving++)->path : nullptr;
        const Extent extent = extentOf(shape, instance.transform, path, reach);
        instance.boxed = !(instance.transform.condition() > kBoxedCondition) &&
                         reach.x < kInfinity && !(path && hasTurns(*path));
        const double thickness = thicknessOf(scene, instance);
        if (thickness > 0.0) scene.thinnest = std::min(scene.thinnest, thickness);
        if (few) padded.push_back(worldBox(instance, extent));
        if (scene.looks[instance.look].refracts && instance.closed) {
            scene.refractingBounds.unite(extent.box);
        }
        boxes.push_back(extent.box);
    }
    if (few) scene.quads = boxQuads(padded);
    WideTree::Settings settings;
    settings.threads = threads;
    scene.tree = WideTree::build(boxes, settings);
}

}  // namespace rt
