// What a shape is, asked in inner loops.
#pragma once

#include "rt/geometry/triangle.h"
#include "rt/trace/csg_shape.h"
#include "rt/trace/shape.h"

#include <cstddef>
#include <memory>
#include <variant>

namespace rt {

using MeshPointer = std::shared_ptr<const MeshShape>;
using CsgPointer = std::shared_ptr<const CsgShape>;

/// use(what alternative I of a shape holds); there may be fewer.
template <std::size_t I, class Use>
[[gnu::always_inline]] inline auto useOf(const Shape& shape, const Use& use) {
    if constexpr (I < std::variant_size_v<Shape>) {
        return use(*std::get_if<I>(&shape));
    } else {
        __builtin_unreachable();
        return use(*std::get_if<0>(&shape));
    }
}

/// Calls use(solid) or use(mesh pointer) with what the shape is. std::visit would go through a
/// table of functions, none of which is inlined.
template <class Use>
[[gnu::always_inline]] inline auto withShape(const Shape& shape, const Use& use) {
    static_assert(std::variant_size_v<Shape> <= 16);
    switch (shape.index()) {
        case 0:
            return useOf<0>(shape, use);
        case 1:
            return useOf<1>(shape, use);
        case 2:
            return useOf<2>(shape, use);
        case 3:
            return useOf<3>(shape, use);
        case 4:
            return useOf<4>(shape, use);
        case 5:
            return useOf<5>(shape, use);
        case 6:
            return useOf<6>(shape, use);
        case 7:
            return useOf<7>(shape, use);
        case 8:
            return useOf<8>(shape, use);
        case 9:
            return useOf<9>(shape, use);
        case 10:
            return useOf<10>(shape, use);
        case 11:
            return useOf<11>(shape, use);
        case 12:
            return useOf<12>(shape, use);
        case 13:
            return useOf<13>(shape, use);
        case 14:
            return useOf<14>(shape, use);
        default:
            return useOf<15>(shape, use);
    }
}

struct SurfaceOfShape {
    const PrimitiveHit& hit;
    SurfaceDetail detail;

    template <class Solid>
    SurfacePoint operator()(const Solid& solid) const {
        return solid.surface(hit, detail);
    }
    SurfacePoint operator()(const MeshPointer& shape) const {
        return triangleSurface(shape->mesh, hit.part, hit);
    }
    SurfacePoint operator()(const CsgPointer& shape) const {
        return csgSurface(*shape, hit, detail);
    }
};

/// Calls use(object-space ray) without copying the ray where the instance is not moved.
template <class Use>
[[gnu::always_inline]] inline bool inObjectSpace(const Transform& transform, const Ray& ray,
                                                 Use&& use) {
    if (transform.isIdentity()) return use(ray);
    const Ray local = transform.toObject(ray);
    return use(local);
}

}  // namespace rt
