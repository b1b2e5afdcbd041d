// Affine maps, and the pair of them that places an object in the world.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/ray.h"
#include "rt/core/vec.h"

namespace rt {

/// p -> linear p + translation. `linear` is column-major, as GLM's matrices are.
struct Affine {
    Mat3 linear{1.0};
    Vec3 translation{0.0};

    Vec3 point(const Vec3& p) const { return linear * p + translation; }
    Vec3 vector(const Vec3& v) const { return linear * v; }
    bool isFinite() const;
    bool isIdentity() const;

    static Affine translate(const Vec3& by);
    static Affine scale(const Vec3& by);
    /// Right-handed turn about axis 0 = x, 1 = y, 2 = z; exact at multiples of 90 degrees.
    static Affine rotate(int axis, double degrees);
};

/// The map that applies `first`, then `second`.
Affine compose(const Affine& second, const Affine& first);

/// How an object lies in the world. Only invertible maps make a Transform.
class Transform {
  public:
    Transform() = default;

    /// False where the map or its inverse is singular or not finite; `out` is then untouched. A map
    /// counts as singular when changing its entries by a few roundings could make it so. The
    /// inverse's entries are off by about a rounding each, whatever the scales.
    [[nodiscard]] static bool make(const Affine& toWorld, Transform& out);

    const Affine& toWorld() const { return toWorld_; }
    const Affine& toObject() const { return toObject_; }
    bool isIdentity() const { return identity_; }
    /// A mirroring map, of negative determinant.
    bool flips() const { return flips_; }

    /// Lengths in object space for lengths in the world, of a map that keeps angles; 0 of others.
    double similarityToObject() const;

    /// The ray in object space; t means the same point on both. Off by about a rounding of the
    /// result, for maps of condition up to 2^24.
    Ray toObject(const Ray& world) const;
    /// An object-space normal, of any length but zero, as a unit normal of the world: by the
    /// inverse transpose, so that the outside stays the outside under a mirroring map too.
    Vec3 normalToWorld(const Vec3& normal) const;
    /// A box that contains the image of `object`, roundings included.
    Bounds boundsToWorld(const Bounds& object) const;
    /// Bound on the world-space distance between the image of a point and its computed image,
    /// when the object-space point is off by at most `objectError`; plus what mapping that image
    /// back with `toObject` is off by, seen in the world. So a ray that starts further than this
    /// from the surface starts on the same side of it in object space.
    double errorToWorld(const Vec3& objectPoint, double objectError) const;
    /// The larger of the largest row sums of |linear| |inverse| and |inverse| |linear|: 1 for
    /// scales along the axes, at most 3 for a turn of them. The roundings of plain double on the
    /// way to object space and back grow with it.
    double condition() const;

  private:
    Affine toWorld_;
    Affine toObject_;
    /// What the rounding of the inverse's entries left out, relative to each; columns, padded.
    float tails_[3][4] = {};
    /// Bound on the length of the image of a vector of length 1.
    double stretch_ = 1.0;
    /// What the way to object space and back is off by, relative to |linear| |object point|.
    float wayBack_ = 0.0F;
    bool identity_ = true;
    bool flips_ = false;
};

}  // namespace rt
