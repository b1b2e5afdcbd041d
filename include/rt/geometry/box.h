// Box: lo <= p <= lo + size, the faces parallel to the axes.
//
// Slabs, with comparisons that let the NaN of 0 / 0 pass (Kay and Kajiya, Ray Tracing Complex
// Scenes, 1986; Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013); then one step of refinement
// against the face that was met, in coordinates relative to the box.
//
// Texture: each face is one image, upright and unmirrored as seen from outside:
//     face   -x  +x  -y  +y  -z  +z
//     u to   +z  -z  +x  +x  -x  +x
//     v to   +y  +y  +z  -z  +y  +y
// On each, u and v run from 0 to 1 over the face's two sides.
#pragma once

#include "rt/core/bounds.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/solid_kind.h"

namespace rt {

class Box {
  public:
    static constexpr const char* kName = "box";
    static constexpr SolidKind kKind{};

    /// Refuses sizes that are not > 0 and finite, and a corner that is not finite
    /// (std::invalid_argument).
    Box(const Vec3& lo, const Vec3& size);

    Bounds bounds() const;
    /// The nearest crossing in `range`, if any. `hit.local` is relative to the centre, which is
    /// lo + size / 2 rounded. Parts 0 .. 5: -x +x -y +y -z +z.
    [[nodiscard]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const;
    /// `error` is at most about 3 roundings of the size and 2 of |x| + |y| + |z|.
    SurfacePoint surface(const PrimitiveHit& hit,
                         SurfaceDetail detail = SurfaceDetail::kParametrised) const;

  private:
    Vec3 centre_;
    /// The corners relative to the centre.
    Vec3 lo_;
    Vec3 hi_;
};

}  // namespace rt
