#include "rt/geometry/box.h"

#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

/// Where u and v run on a face: an axis each, and whether against it.
struct FaceTexture {
    int uAxis;
    bool uDown;
    int vAxis;
    bool vDown;
};

constexpr FaceTexture kFaces[6] = {
    {2, false, 1, false}, {2, true, 1, false},  // -x +x
    {0, false, 2, false}, {0, false, 2, true},  // -y +y
    {0, true, 1, false},  {0, false, 1, false}  // -z +z
};

/// A ray relative to the box's centre, and the part of it inside. The span holds t itself.
struct BoxRay {
    Vec3 origin;
    Vec3 originError;
    Vec3 direction;
    Vec3 inverse;
    InsideSpan inside{{-kInfinity, 0}, {kInfinity, 0}};
};

/// The slab of one axis. For a ray within it, d = +-0 gives -inf and inf, and a NaN on a face.
inline void cut(BoxRay& ray, double origin, double inverse, double lo, double hi, Index axis) {
    const bool upwards = inverse >= 0.0;
    ray.inside.enterAt(((upwards ? lo : hi) - origin) * inverse, 2 * axis + (upwards ? 0 : 1));
    ray.inside.leaveAt(((upwards ? hi : lo) - origin) * inverse, 2 * axis + (upwards ? 1 : 0));
}

/// t is off by a rounding of the ray's way to the box; the point that it gives is on the ray to a
/// rounding of the box, so its distance to the face tells how far to go on.
bool meet(const BoxRay& ray, const Crossing& at, double face, Interval range, PrimitiveHit& hit) {
    if (!range.contains(at.s)) return false;
    const int axis = static_cast<int>(at.part / 2);
    const Vec3& d = ray.direction;
    const Vec3 p(std::fma(at.s, d.x, ray.origin.x) + ray.originError.x,
                 std::fma(at.s, d.y, ray.origin.y) + ray.originError.y,
                 std::fma(at.s, d.z, ray.origin.z) + ray.originError.z);
    const double further = (face - p[axis]) * ray.inverse[axis];
    const double t = at.s + further;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local =
        Vec3(std::fma(further, d.x, p.x), std::fma(further, d.y, p.y), std::fma(further, d.z, p.z));
    hit.local[axis] = face;
    hit.part = at.part;
    return true;
}

}  // namespace

Box::Box(const Vec3& lo, const Vec3& size) {
    requireFinite("box", "corner", lo);
    for (int axis = 0; axis < 3; ++axis) {
        requirePositive("box", "size", size[axis]);
        centre_[axis] = lo[axis] + 0.5 * size[axis];
        const TwoTerms toLow = exactDifference(lo[axis], centre_[axis]);
        lo_[axis] = toLow.value;
        hi_[axis] = (size[axis] + toLow.value) + toLow.error;
    }
}

Bounds Box::bounds() const {
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        bounds.min[axis] = sumBelow(centre_[axis], lo_[axis]);
        bounds.max[axis] = sumAbove(centre_[axis], hi_[axis]);
    }
    return bounds;
}

bool Box::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    const TwoTerms x = exactDifference(ray.origin.x, centre_.x);
    const TwoTerms y = exactDifference(ray.origin.y, centre_.y);
    const TwoTerms z = exactDifference(ray.origin.z, centre_.z);
    const Vec3& d = ray.direction;
    BoxRay local{Vec3(x.value, y.value, z.value), Vec3(x.error, y.error, z.error), d,
                 Vec3(1.0 / d.x, 1.0 / d.y, 1.0 / d.z)};
    cut(local, x.value, local.inverse.x, lo_.x, hi_.x, 0);
    cut(local, y.value, local.inverse.y, lo_.y, hi_.y, 1);
    cut(local, z.value, local.inverse.z, lo_.z, hi_.z, 2);
    if (local.inside.isEmpty()) return false;
    const auto face = [&](Index part) {
        const int axis = static_cast<int>(part / 2);
        return part % 2 == 0 ? lo_[axis] : hi_[axis];
    };
    const Crossing& entry = local.inside.entry;
    const Crossing& exit = local.inside.exit;
    return meet(local, entry, face(entry.part), range, hit) ||
           meet(local, exit, face(exit.part), range, hit);
}

SurfacePoint Box::surface(const PrimitiveHit& hit) const {
    const int axis = static_cast<int>(hit.part / 2);
    const bool positive = hit.part % 2 != 0;
    Vec3 normal(0.0);
    normal[axis] = positive ? 1.0 : -1.0;
    Vec3 local;
    Vec3 fraction;
    Vec3 size;
    for (int i = 0; i < 3; ++i) {
        local[i] = std::min(std::max(hit.local[i], lo_[i]), hi_[i]);
        size[i] = hi_[i] - lo_[i];
        fraction[i] = clampToUnit((local[i] - lo_[i]) / size[i]);
    }
    local[axis] = positive ? hi_[axis] : lo_[axis];

    SurfacePoint surface;
    placeSurface(surface, centre_, local, normal);
    // Each face is off by 2 roundings of the size, and the point's three coordinates as much.
    surface.error = gamma(4) * largestComponent(size) + placementError(surface.point);
    const FaceTexture& face = kFaces[hit.part];
    const double u = fraction[face.uAxis];
    const double v = fraction[face.vAxis];
    surface.uv = Vec2(face.uDown ? 1.0 - u : u, face.vDown ? 1.0 - v : v);
    surface.dpdu[face.uAxis] = face.uDown ? -size[face.uAxis] : size[face.uAxis];
    surface.dpdv[face.vAxis] = face.vDown ? -size[face.vAxis] : size[face.vAxis];
    return surface;
}

}  // namespace rt
