#include "rt/trace/render_scene.h"

#include <algorithm>

namespace rt {
namespace {

struct BoundsOf {
    template <class Solid>
    Bounds operator()(const Solid& solid) const {
        return solid.bounds();
    }
    Bounds operator()(const std::shared_ptr<const MeshShape>& shape) const {
        return shape->tree.bounds();
    }
};

}  // namespace

Bounds boundsOf(const Shape& shape) {
    return std::visit(BoundsOf{}, shape);
}

double thicknessOf(const RenderScene& scene, const Instance& instance) {
    if (std::holds_alternative<std::shared_ptr<const MeshShape>>(scene.shapes[instance.shape])) {
        return kInfinity;
    }
    if (!(instance.objectScale > 0.0)) return 0.0;
    const Vec3 size = scene.shapeBoxes[instance.shape].bounds().extent();
    return std::min({size.x, size.y, size.z}) / instance.objectScale;
}

}  // namespace rt
