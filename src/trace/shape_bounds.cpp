#include "rt/trace/csg_shape.h"
#include "rt/trace/render_scene.h"

#include <algorithm>
#include <limits>

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
    Bounds operator()(const std::shared_ptr<const CsgShape>& shape) const { return shape->bounds; }
};

struct KindOf {
    template <class Solid>
    SolidKind operator()(const Solid&) const {
        return Solid::kKind;
    }
    SolidKind operator()(const std::shared_ptr<const MeshShape>& shape) const {
        return {.convex = false, .closed = shape->mesh.closed};
    }
    SolidKind operator()(const std::shared_ptr<const CsgShape>& shape) const {
        return {.convex = shape->convex};
    }
};

struct NameOf {
    template <class Solid>
    const char* operator()(const Solid&) const {
        return Solid::kName;
    }
    const char* operator()(const std::shared_ptr<const MeshShape>&) const { return "mesh"; }
    const char* operator()(const std::shared_ptr<const CsgShape>& shape) const {
        return shape->name;
    }
};

/// Sheets have an extent of 0, which would say that nothing is known.
constexpr double kThinnest = std::numeric_limits<double>::min();

double thicknessOf(const RenderScene& scene, const Instance& instance, double CsgShape::*ofCsg) {
    const Shape& shape = scene.shapes[instance.shape];
    const bool isMesh = std::holds_alternative<std::shared_ptr<const MeshShape>>(shape);
    if (isMesh || !kindOf(shape).bounded) return kInfinity;
    if (!(instance.objectScale > 0.0)) return 0.0;
    if (const auto* csg = std::get_if<std::shared_ptr<const CsgShape>>(&shape)) {
        return std::max((**csg).*ofCsg, kThinnest) / instance.objectScale;
    }
    if (std::holds_alternative<Quadric>(shape)) return kThinnest;
    const Vec3 size = scene.shapeBoxes[instance.shape].bounds().extent();
    return std::max(std::min({size.x, size.y, size.z}), kThinnest) / instance.objectScale;
}

}  // namespace

const char* nameOf(const Shape& shape) {
    return std::visit(NameOf{}, shape);
}

SolidKind kindOf(const Shape& shape) {
    return std::visit(KindOf{}, shape);
}

Bounds boundsOf(const Shape& shape) {
    return std::visit(BoundsOf{}, shape);
}

double thicknessOf(const RenderScene& scene, const Instance& instance) {
    return thicknessOf(scene, instance, &CsgShape::thickness);
}

double partThicknessOf(const RenderScene& scene, const Instance& instance) {
    return thicknessOf(scene, instance, &CsgShape::partThickness);
}

}  // namespace rt
