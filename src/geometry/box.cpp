#include "rt/geometry/box.h"

#include "solid_frame.h"
#include "solid_texture.h"

namespace rt {
namespace {

struct BoxShape {
    const Vec3& centre;
    const Vec3& lo;  ///< the corners relative to the centre
    const Vec3& hi;
};

/// A ray relative to the box's centre, its origin in two terms.
struct BoxRay {
    const Vec3& lo;  ///< the box's own
    Vec3 origin;
    Vec3 originError;
    const Vec3& direction;
    Vec3 inverse;
};

/// The planes that bound the box on one side of the ray, and t there.
struct Planes {
    Vec3 face;
    Vec3 t;
};

/// For a ray along a slab, d = +-0 gives -inf and inf, and NaN where it runs in a face.
inline Planes planesAt(const BoxRay& ray, const Vec3& face) {
    return {face,
            Vec3((face.x - ray.origin.x) * ray.inverse.x, (face.y - ray.origin.y) * ray.inverse.y,
                 (face.z - ray.origin.z) * ray.inverse.z)};
}

/// The largest (smallest) of three; a NaN is passed over.
inline double largestOf(const Vec3& v) {
    const double x = v.x > -kInfinity ? v.x : -kInfinity;
    const double xy = v.y > x ? v.y : x;
    return v.z > xy ? v.z : xy;
}

inline double smallestOf(const Vec3& v) {
    const double x = v.x < kInfinity ? v.x : kInfinity;
    const double xy = v.y < x ? v.y : x;
    return v.z < xy ? v.z : xy;
}

/// t is off by a rounding of the ray's way to the box; the point that it gives is on the ray to a
/// rounding of the box, so its distance to the face tells how far to go on.
inline bool meet(const BoxRay& ray, const Planes& planes, double rough, Interval range,
                 PrimitiveHit& hit) {
    if (!(std::fabs(rough) < kInfinity)) return false;
    const int axis = rough == planes.t.z ? 2 : (rough == planes.t.y ? 1 : 0);
    const double face = planes.face[axis];
    const Vec3& d = ray.direction;
    const Vec3 p(std::fma(rough, d.x, ray.origin.x) + ray.originError.x,
                 std::fma(rough, d.y, ray.origin.y) + ray.originError.y,
                 std::fma(rough, d.z, ray.origin.z) + ray.originError.z);
    const double further = (face - p[axis]) * ray.inverse[axis];
    const double t = rough + further;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local =
        Vec3(std::fma(further, d.x, p.x), std::fma(further, d.y, p.y), std::fma(further, d.z, p.z));
    hit.local[axis] = face;
    hit.part = static_cast<Index>(2 * axis + (face == ray.lo[axis] ? 0 : 1));
    return true;
}

[[gnu::always_inline]] inline bool cross(const BoxShape& box, const Ray& ray, Interval range,
                                         PrimitiveHit& hit) {
    const TwoTerms x = exactDifference(ray.origin.x, box.centre.x);
    const TwoTerms y = exactDifference(ray.origin.y, box.centre.y);
    const TwoTerms z = exactDifference(ray.origin.z, box.centre.z);
    // A NaN is passed over below, so that none may come from outside.
    if (!(std::fabs(x.value + y.value + z.value) < kInfinity)) return false;
    const Vec3& d = ray.direction;
    const BoxRay local{box.lo, Vec3(x.value, y.value, z.value), Vec3(x.error, y.error, z.error), d,
                       Vec3(1.0 / d.x, 1.0 / d.y, 1.0 / d.z)};
    const bool upX = local.inverse.x >= 0.0;
    const bool upY = local.inverse.y >= 0.0;
    const bool upZ = local.inverse.z >= 0.0;
    const Planes near = planesAt(local, Vec3(upX ? box.lo.x : box.hi.x, upY ? box.lo.y : box.hi.y,
                                             upZ ? box.lo.z : box.hi.z));
    const Planes far = planesAt(local, Vec3(upX ? box.hi.x : box.lo.x, upY ? box.hi.y : box.lo.y,
                                            upZ ? box.hi.z : box.lo.z));
    const double entry = largestOf(near.t);
    const double exit = smallestOf(far.t);
    if (!(entry <= exit)) return false;
    return meet(local, near, entry, range, hit) || meet(local, far, exit, range, hit);
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
    const double size = (hi_.x - lo_.x) + (hi_.y - lo_.y) + (hi_.z - lo_.z);
    if (isOrdinary(size, ray.direction)) [[likely]] {
        return cross({centre_, lo_, hi_}, ray, range, hit);
    }
    return intersectRescaled(
        size, ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross({scaleByPowerOfTwo(centre_, exponent), scaleByPowerOfTwo(lo_, exponent),
                          scaleByPowerOfTwo(hi_, exponent)},
                         scaled, scaledRange, found);
        });
}

SurfacePoint Box::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    const int axis = static_cast<int>(hit.part / 2);
    const bool positive = hit.part % 2 != 0;
    Vec3 normal(0.0);
    normal[axis] = positive ? 1.0 : -1.0;
    Vec3 local;
    Vec3 size;
    for (int i = 0; i < 3; ++i) {
        local[i] = std::min(std::max(hit.local[i], lo_[i]), hi_[i]);
        size[i] = hi_[i] - lo_[i];
    }
    local[axis] = positive ? hi_[axis] : lo_[axis];

    SurfacePoint surface;
    placeSurface(surface, centre_, local, normal);
    // Each face is off by 2 roundings of the size, and the point's three coordinates as much.
    surface.error = gamma(4) * largestComponent(size) + placementError(surface.point);
    if (detail == SurfaceDetail::kShape) return surface;
    layOnBoxFace(surface, local, lo_, size, hit.part);
    return surface;
}

}  // namespace rt
