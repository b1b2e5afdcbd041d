// A ray as the single-precision boxes of a WideTree see it.
//
// In the frame of the tree a far ray starts where it enters the neighbourhood of [-1, 1]^3 (found
// in double, so that a far origin costs nothing); its direction is scaled by a power of two to a
// longest component in [1, 2); and tau = t rate - start is its parameter, at most 6 within the
// tree. kBoxPad moves every plane outwards, each axis by itself, by more than a slab test can be
// off; the pad of a ray grows by the rounding in double of its own origin, which is what a
// primitive's test may be off by.
#pragma once

#include "rt/accel/wide_tree.h"
#include "rt/core/numeric.h"
#include "rt/core/ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace rt {

/// From a ray's own parameter t to that of the tree, tau = t rate - start.
struct TauOfT {
    /// Ten times what is met within the tree: beyond it, all values are alike.
    static constexpr double kLimit = 64.0;

    /// Bounds in float of the tau of `t`, which may be infinite.
    float above(double t) const {
        const double tau = clamped(t);
        return static_cast<float>(tau + slack(tau));
    }
    float below(double t) const {
        const double tau = clamped(t);
        return static_cast<float>(tau - slack(tau));
    }

    double rate;
    double start;
    double startSlack;

  private:
    double clamped(double t) const { return std::clamp(t * rate - start, -kLimit, kLimit); }
    double slack(double tau) const { return startSlack + kFloatRounding * std::fabs(tau); }
};

class BoxRay {
  public:
    /// False where the line misses the tree's surroundings, or the ray is not finite.
    [[nodiscard]] static bool make(const TreeFrame& frame, const Ray& ray, BoxRay& out);

    // By axis; the fourth is of no account.
    float reciprocal[4];
    float nearShift[4];  ///< tau of a near plane p is p * reciprocal + nearShift
    float farShift[4];
    int nearPlane[3];  ///< rows of WideNode::plane
    int farPlane[3];
    TauOfT tau;

  private:
    void setAxes(const Vec3& origin, const Vec3& direction, double pad);
    /// Moves a far `origin` towards the tree; false where the line passes it by.
    bool approach(Vec3& origin, const Vec3& direction, double pad);
};

inline bool isFinite(const Vec3& v) {
    return std::fabs(v.x) < kInfinity && std::fabs(v.y) < kInfinity && std::fabs(v.z) < kInfinity;
}

/// The largest absolute value of a component.
inline double longestComponent(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

inline void BoxRay::setAxes(const Vec3& origin, const Vec3& direction, double pad) {
    // All axes at once; values are not passed around, as their registers differ by processor.
    using Four = double __attribute__((vector_size(32)));
    using Bits = std::int64_t __attribute__((vector_size(32)));
    using Floats = float __attribute__((vector_size(16)));
    const Four o{origin.x, origin.y, origin.z, 0.0};
    const Four d{direction.x, direction.y, direction.z, 1.0};
    constexpr std::int64_t kSignBit = std::numeric_limits<std::int64_t>::min();
    const Bits sign = (Bits)d & kSignBit;
    const Four size = (Four)((Bits)d & ~kSignBit);
    const Four clamped = size > kLeastSlope ? size : Four{} + kLeastSlope;
    const Four inverse = 1.0 / (Four)((Bits)clamped | sign);
    const Four outward = (Four)((Bits)(Four{} + pad) | sign);
    const Four nearAt = o + outward;
    const Four farAt = o - outward;
    const Floats all[] = {__builtin_convertvector(inverse, Floats),
                          __builtin_convertvector(-nearAt * inverse, Floats),
                          __builtin_convertvector(-farAt * inverse, Floats)};
    std::memcpy(reciprocal, &all[0], sizeof reciprocal);
    std::memcpy(nearShift, &all[1], sizeof nearShift);
    std::memcpy(farShift, &all[2], sizeof farShift);
    for (int axis = 0; axis < 3; ++axis) {
        const int backwards = sign[axis] < 0 ? 1 : 0;
        nearPlane[axis] = 2 * axis + backwards;
        farPlane[axis] = 2 * axis + 1 - backwards;
    }
}

inline bool BoxRay::approach(Vec3& origin, const Vec3& direction, double pad) {
    // All of the unit cube, and its pads, lie within `reach` of the centre.
    const double reach = 2.0 + 2.0 * pad;
    const double squared = glm::dot(direction, direction);
    const double foot = -glm::dot(origin, direction) / squared;
    const Vec3 nearest = origin + foot * direction;
    if (!(glm::dot(nearest, nearest) < reach * reach)) return false;
    tau.start = foot - reach / std::sqrt(squared);
    tau.startSlack += kOriginRounding * std::fabs(tau.start);
    origin += tau.start * direction;
    return true;
}

inline bool BoxRay::make(const TreeFrame& frame, const Ray& ray, BoxRay& out) {
    Vec3 direction = ray.direction;
    double longest = longestComponent(direction);
    if (!(longest > 0.0 && isFinite(direction))) return false;
    out.tau.rate = frame.scale;
    if (!(longest > 0x1p-1000 && longest < 0x1p1000)) {
        const double shrink = longest < 1.0 ? 0x1p500 : 0x1p-500;
        direction *= shrink;
        longest *= shrink;
        out.tau.rate /= shrink;
    }
    constexpr std::uint64_t kExponentBits = std::uint64_t{0x7ff} << 52;
    const double power =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(longest) & kExponentBits);
    // The exponent is neither the least nor the largest, so that this is 1 / power.
    direction *=
        std::bit_cast<double>((std::uint64_t{0x7fe} << 52) - std::bit_cast<std::uint64_t>(power));
    out.tau.rate *= power;

    Vec3 origin = (ray.origin - frame.centre) * frame.scale;
    const double away = longestComponent(origin);
    if (!(isFinite(origin) && out.tau.rate > 0.0 && out.tau.rate < kInfinity)) return false;
    const double pad =
        kBoxPad + kOriginRounding * (away + longestComponent(frame.centre) * frame.scale);
    out.tau.start = 0.0;
    out.tau.startSlack = kFloatRounding;
    if (away > 2.0 && !out.approach(origin, direction, pad)) return false;
    out.setAxes(origin, direction, pad);
    return true;
}

}  // namespace rt
