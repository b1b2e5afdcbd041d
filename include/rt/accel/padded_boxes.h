// Boxes in double precision, and the slab test of a ray against them (Kay, Kajiya, "Ray tracing
// complex scenes", 1986).
//
// A WideTree's boxes are single precision and padded by 2^-18 of the tree: a ray that leaves a
// surface is always inside its box. These are padded by a few roundings, less than what keeps a
// secondary ray off its surface: a ray that leaves the face of a box meets that box no more, and
// the primitive's own test is spared. Up to kFewBoxes of them are tested one after another faster
// than a tree is walked.
//
// Like those of a tree, they never lose a hit that a primitive's own test finds, provided that the
// point at the found t lies within 2^-47 of the ray's origin distance, or of `rounding`, of the
// primitive's Bounds. Every instruction set may round differently here; no answer depends on it.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/numeric.h"
#include "rt/core/ray.h"
#include "rt/core/transform.h"
#include "rt/math/lanes4.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace rt {

inline constexpr std::size_t kFewBoxes = 16;

struct alignas(32) PaddedBox {
    double min[4] = {kInfinity, kInfinity, kInfinity, 0.0};  ///< the last lane is spare
    double max[4] = {-kInfinity, -kInfinity, -kInfinity, 0.0};

    /// The default is met by no ray.
    PaddedBox() = default;
    /// `rounding`: magnitude of the coordinates that hits on what is in the box are computed from,
    /// beside those of the box itself. Infinity: every ray meets the box.
    PaddedBox(const Bounds& bounds, double rounding) {
        const Vec3 low = glm::abs(bounds.min);
        const Vec3 high = glm::abs(bounds.max);
        const double size = std::max({low.x, low.y, low.z, high.x, high.y, high.z, rounding});
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = bounds.min[axis] - kOriginRounding * size;
            max[axis] = bounds.max[axis] + kOriginRounding * size;
        }
    }

    Bounds bounds() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
};

/// Four boxes side by side: min x, max x, min y, max y, min z, max z.
struct alignas(32) BoxQuad {
    double plane[6][4];
};

/// The boxes, four by four, in their order.
inline std::vector<BoxQuad> boxQuads(std::span<const PaddedBox> boxes) {
    std::vector<BoxQuad> quads((boxes.size() + 3) / 4);
    for (std::size_t i = 0; i < 4 * quads.size(); ++i) {
        const PaddedBox box = i < boxes.size() ? boxes[i] : PaddedBox();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            quads[i / 4].plane[2 * axis][i % 4] = box.min[axis];
            quads[i / 4].plane[2 * axis + 1][i % 4] = box.max[axis];
        }
    }
    return quads;
}

/// A ray as these boxes see it. Lives on one function's stack (Lanes4).
class SlabRay {
  public:
    /// False for a ray that is not finite, or whose direction's square leaves the doubles: such a
    /// ray knows nothing of boxes.
    [[nodiscard]] [[gnu::always_inline]] bool make(const Ray& ray) {
        return make(Lanes4::loadThree(&ray.origin.x), Lanes4::loadThree(&ray.direction.x));
    }

    /// Whether the box is met at some t in [range.min, range.max].
    [[gnu::always_inline]] bool meets(const PaddedBox& box, Interval range) const {
        const Lanes4 low = (Lanes4::load(box.min) - lowOrigin_) * inverse_;
        const Lanes4 high = (Lanes4::load(box.max) - highOrigin_) * inverse_;
        const double entry = largestOfThree(chosenBySign(direction_, low, high));
        const double exit = leastOfThree(chosenBySign(direction_, high, low));
        return std::max(entry, range.min) <= std::min(exit, range.max);
    }

    /// The ray in object space, in plain double: a quick look, whose roundings boxes allow for
    /// while the map's condition() is at most kBoxedCondition. False where nothing is known of it
    /// there.
    [[nodiscard]] [[gnu::always_inline]] bool make(const Transform& place, const Ray& ray) {
        const Mat3& inverse = place.toObject().linear;
        const Lanes4 x = Lanes4::loadThree(&inverse[0].x);
        const Lanes4 y = Lanes4::loadThree(&inverse[1].x);
        const Lanes4 z = Lanes4::loadThree(&inverse[2].x);
        const auto object = [&](const Vec3& v) __attribute__((always_inline)) {
            return fma(x, Lanes4::all(v.x), fma(y, Lanes4::all(v.y), z * Lanes4::all(v.z)));
        };
        return make(object(ray.origin - place.toWorld().translation), object(ray.direction));
    }

  private:
    friend class QuadTester;

    [[gnu::always_inline]] bool make(Lanes4 origin, Lanes4 direction) {
        const Lanes4 size = magnitude(direction);
        const Lanes4 distance = magnitude(origin);
        const double longest = largestOfThree(size);
        const unsigned finite =
            notAbove(distance, Lanes4::all(std::numeric_limits<double>::max())) &
            notAbove(size, Lanes4::all(kLongestSlope));
        if (!(finite == 0xf && longest > 1.0 / kLongestSlope)) return false;
        const Lanes4 slope =
            withSign(greater(size, Lanes4::all(kLeastSlopeShare * longest)), direction);
        const Lanes4 pad = Lanes4::all(kOriginRounding * largestOfThree(distance));
        direction_ = direction;
        inverse_ = Lanes4::all(1.0) / slope;
        lowOrigin_ = origin + pad;
        highOrigin_ = origin - pad;
        return true;
    }

    Lanes4 direction_;
    Lanes4 inverse_;
    Lanes4 lowOrigin_;   ///< moved up, as a box's lower planes are to be moved down
    Lanes4 highOrigin_;  ///< moved down
};

/// A SlabRay against four boxes at a time.
class QuadTester {
  public:
    [[gnu::always_inline]] explicit QuadTester(const SlabRay& ray) {
        const unsigned signs = signBits(ray.direction_);
        const Lanes4 low = Lanes4::all(0.0) - ray.lowOrigin_ * ray.inverse_;
        const Lanes4 high = Lanes4::all(0.0) - ray.highOrigin_ * ray.inverse_;
        const Lanes4 near = chosenBySign(ray.direction_, low, high);
        const Lanes4 far = chosenBySign(ray.direction_, high, low);
        x_ = {ray.inverse_.spread<0>(), near.spread<0>(), far.spread<0>(), signs & 1};
        y_ = {ray.inverse_.spread<1>(), near.spread<1>(), far.spread<1>(), 2 + (signs >> 1 & 1)};
        z_ = {ray.inverse_.spread<2>(), near.spread<2>(), far.spread<2>(), 4 + (signs >> 2 & 1)};
    }

    /// Bit i: the ray meets box i of the four within `range`, at `entries[i]` first.
    [[gnu::always_inline]] unsigned meet(const BoxQuad& quad, Interval range,
                                         double* entries) const {
        const Lanes4 enter = greater(greater(x_.near(quad), y_.near(quad)),
                                     greater(z_.near(quad), Lanes4::all(range.min)));
        const Lanes4 leave = lesser(lesser(x_.far(quad), y_.far(quad)),
                                    lesser(z_.far(quad), Lanes4::all(range.max)));
        enter.store(entries);
        return notAbove(enter, leave);
    }

  private:
    /// t of a plane p is p inverse + shift. Where both are infinite, a NaN: greater and lesser
    /// pass over it when it comes first, and a box is then met in vain at worst.
    struct Axis {
        Lanes4 inverse;
        Lanes4 nearShift;
        Lanes4 farShift;
        std::size_t nearPlane;

        Lanes4 near(const BoxQuad& quad) const {
            return fma(Lanes4::load(quad.plane[nearPlane]), inverse, nearShift);
        }
        Lanes4 far(const BoxQuad& quad) const {
            return fma(Lanes4::load(quad.plane[nearPlane ^ 1]), inverse, farShift);
        }
    };

    Axis x_;
    Axis y_;
    Axis z_;
};

}  // namespace rt
