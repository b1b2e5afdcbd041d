#include "rt/trace/render_scene.h"

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

}  // namespace rt
