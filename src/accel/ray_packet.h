// Sixteen rays as the boxes of a tree see them, and what bounds several of them at once.
#pragma once

#include "packet_lanes.h"
#include "rt/accel/box_ray.h"

#if defined(__AVX2__)

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace rt {

/// The slab test (box_test.h), one lane a ray.
class RayPacket {
  public:
    /// BoxRay::make, four rays at a time. Returns the rays that may meet the tree, one bit each;
    /// `odd` gets those whose directions are so long, short or broken that make has to see to them.
    unsigned set(const TreeFrame& frame, std::span<const Ray> rays,
                 std::span<const Interval> ranges, unsigned& odd);

    /// Ray `i` by itself.
    BoxRay single(int i) const {
        BoxRay ray;
        for (int axis = 0; axis < 3; ++axis) {
            ray.reciprocal[axis] = reciprocal[axis][i];
            ray.nearShift[axis] = nearShift[axis][i];
            ray.farShift[axis] = farShift[axis][i];
            const int backwards = reciprocal[axis][i] < 0.0f ? 1 : 0;
            ray.nearPlane[axis] = 2 * axis + backwards;
            ray.farPlane[axis] = 2 * axis + 1 - backwards;
        }
        ray.tau = {rate_[i], start_[i], startSlack_[i]};
        return ray;
    }
    void endAt(int i, double t) {
        tauMax[i] = TauOfT{rate_[i], start_[i], startSlack_[i]}.above(t);
    }

    /// Of `rays`, those whose directions have the same signs as the first one's.
    unsigned alike(unsigned rays) const {
        const int first = std::countr_zero(rays);
        for (const unsigned negative : backwards_) {
            rays &= (negative >> first & 1) != 0 ? negative : ~negative;
        }
        return rays;
    }

    /// The rays of one octant that meet box `lane` of the node; where each enters goes to `entry`.
    unsigned meet(const WideNode& node, int lane, const int (&nearPlane)[3],
                  const int (&farPlane)[3], float* entry) const {
        using namespace packet;
        const Register nearPlanes[3] = {allRegister(node.plane[nearPlane[0]][lane]),
                                        allRegister(node.plane[nearPlane[1]][lane]),
                                        allRegister(node.plane[nearPlane[2]][lane])};
        const Register farPlanes[3] = {allRegister(node.plane[farPlane[0]][lane]),
                                       allRegister(node.plane[farPlane[1]][lane]),
                                       allRegister(node.plane[farPlane[2]][lane])};
        unsigned met = 0;
        for (int at = 0; at < kRays; at += kRegisterWidth) {
            Register enter = loadRegister(tauMin + at);
            Register leave = loadRegister(tauMax + at);
            for (int axis = 0; axis < 3; ++axis) {
                const Register slope = loadRegister(reciprocal[axis] + at);
                enter = larger(enter, multiplyAdd(nearPlanes[axis], slope,
                                                  loadRegister(nearShift[axis] + at)));
                leave = smaller(
                    leave, multiplyAdd(farPlanes[axis], slope, loadRegister(farShift[axis] + at)));
            }
            storeRegister(entry + at, enter);
            met |= atMost(enter, leave) << at;
        }
        return met;
    }

    /// The rays whose range does not end before `entry`.
    unsigned reach(const float* entry) const {
        using namespace packet;
        unsigned reached = 0;
        for (int at = 0; at < kRays; at += kRegisterWidth) {
            reached |= atMost(loadRegister(entry + at), loadRegister(tauMax + at)) << at;
        }
        return reached;
    }

    alignas(64) float tauMin[packet::kRays] = {};
    alignas(64) float tauMax[packet::kRays] = {};
    alignas(64) float reciprocal[3][packet::kRays] = {};
    alignas(64) float nearShift[3][packet::kRays] = {};
    alignas(64) float farShift[3][packet::kRays] = {};
    alignas(64) float nearOrigin[3][packet::kRays] = {};
    alignas(64) float farOrigin[3][packet::kRays] = {};

  private:
    using Four = double __attribute__((vector_size(32)));
    using Bits = std::int64_t __attribute__((vector_size(32)));
    using Floats = float __attribute__((vector_size(16)));

    static Four absolute(Four a) {
        return (Four)((Bits)a & std::numeric_limits<std::int64_t>::max());
    }
    static Four greater(Four a, Four b) { return a > b ? a : b; }
    static void put(float* to, Four values) {
        const Floats rounded = __builtin_convertvector(values, Floats);
        std::memcpy(to, &rounded, sizeof rounded);
    }
    static Four squareRoot(Four a) {
        for (int i = 0; i < kFour; ++i) a[i] = std::sqrt(a[i]);
        return a;
    }
    static unsigned bitsOf(Bits lanes) {
        unsigned bits = 0;
        for (int i = 0; i < kFour; ++i) bits |= (lanes[i] != 0 ? 1u : 0u) << i;
        return bits;
    }
    struct Group;
    void setGroup(const TreeFrame& frame, Group& group, int at);
    static void approach(Group& group);
    void setAxes(const Group& group, int at);

    static constexpr int kFour = 4;

    unsigned backwards_[3] = {};  ///< rays that go down an axis, one bit each
    alignas(64) double rate_[packet::kRays];
    alignas(64) double start_[packet::kRays];
    alignas(64) double startSlack_[packet::kRays];
};

/// Four rays on their way into the frame.
struct RayPacket::Group {
    Four origin[3], direction[3];
    Four min, max;  ///< of their ranges
    Four away, pad, start, startSlack, rate;
    Bits usable, odd;
};

inline unsigned RayPacket::set(const TreeFrame& frame, std::span<const Ray> rays,
                               std::span<const Interval> ranges, unsigned& odd) {
    unsigned usable = 0;
    odd = 0;
    const int count = static_cast<int>(rays.size());
    for (int at = 0; at < count; at += kFour) {
        const auto four = [&](const auto& valueOf) {
            const auto lane = [&](int i) {
                return valueOf(static_cast<std::size_t>(std::min(at + i, count - 1)));
            };
            return Four{lane(0), lane(1), lane(2), lane(3)};
        };
        Group group;
        for (int axis = 0; axis < 3; ++axis) {
            group.origin[axis] = four([&](std::size_t i) { return rays[i].origin[axis]; });
            group.direction[axis] = four([&](std::size_t i) { return rays[i].direction[axis]; });
        }
        group.min = four([&](std::size_t i) { return ranges[i].min; });
        group.max = four([&](std::size_t i) { return ranges[i].max; });
        setGroup(frame, group, at);
        usable |= bitsOf(group.usable) << at;
        odd |= bitsOf(group.odd) << at;
    }
    const unsigned all = (1u << count) - 1;
    odd &= all;
    return usable & all;
}

inline void RayPacket::setGroup(const TreeFrame& frame, Group& group, int at) {
    Four* const d = group.direction;
    Four* const o = group.origin;
    const Four longest = greater(greater(absolute(d[0]), absolute(d[1])), absolute(d[2]));
    const Four sum = absolute(d[0] + d[1] + d[2]);
    group.odd = ~((longest > 0x1p-500) & (longest < 0x1p500) & (sum < kInfinity));
    constexpr std::int64_t kExponentBits = std::int64_t{0x7ff} << 52;
    const Bits power = (Bits)longest & kExponentBits;
    group.rate = frame.scale * (Four)power;
    const Four inverse = (Four)((std::int64_t{0x7fe} << 52) - power);
    for (int axis = 0; axis < 3; ++axis) {
        d[axis] *= inverse;
        o[axis] = (o[axis] - frame.centre[axis]) * frame.scale;
    }
    group.away = greater(greater(absolute(o[0]), absolute(o[1])), absolute(o[2]));
    const Four originSum = absolute(o[0] + o[1] + o[2]);
    group.odd |= ~((group.rate > 0.0) & (group.rate < kInfinity) & (originSum < kInfinity));
    group.pad =
        kBoxPad + kOriginRounding * (group.away + longestComponent(frame.centre) * frame.scale);
    group.start = Four{};
    group.startSlack = Four{} + kFloatRounding;
    group.usable = ~group.odd;
    if (bitsOf(group.away > 2.0) != 0) approach(group);
    std::memcpy(rate_ + at, &group.rate, sizeof group.rate);
    std::memcpy(start_ + at, &group.start, sizeof group.start);
    std::memcpy(startSlack_ + at, &group.startSlack, sizeof group.startSlack);
    setAxes(group, at);
}

inline void RayPacket::approach(Group& group) {
    Four* const d = group.direction;
    Four* const o = group.origin;
    const Bits far = group.away > 2.0;
    const Four reach = 2.0 + 2.0 * group.pad;
    const Four squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const Four foot = -(o[0] * d[0] + o[1] * d[1] + o[2] * d[2]) / squared;
    Four nearest = Four{};
    for (int axis = 0; axis < 3; ++axis) {
        const Four at = o[axis] + foot * d[axis];
        nearest += at * at;
    }
    group.usable &= ~far | (nearest < reach * reach);
    group.start = far ? foot - reach / squareRoot(squared) : group.start;
    group.startSlack += kOriginRounding * absolute(group.start);
    for (int axis = 0; axis < 3; ++axis) o[axis] += group.start * d[axis];
}

inline void RayPacket::setAxes(const Group& group, int at) {
    constexpr std::int64_t kSignBit = std::numeric_limits<std::int64_t>::min();
    for (int axis = 0; axis < 3; ++axis) {
        const Four d = group.direction[axis];
        const Bits sign = (Bits)d & kSignBit;
        const Four size = greater(absolute(d), Four{} + kLeastSlope);
        const Four inverse = 1.0 / (Four)((Bits)size | sign);
        const Four outward = (Four)((Bits)group.pad | sign);
        const Four nearAt = group.origin[axis] + outward;
        const Four farAt = group.origin[axis] - outward;
        put(reciprocal[axis] + at, inverse);
        put(nearShift[axis] + at, -nearAt * inverse);
        put(farShift[axis] + at, -farAt * inverse);
        put(nearOrigin[axis] + at, nearAt);
        put(farOrigin[axis] + at, farAt);
        backwards_[axis] |= bitsOf(sign) << at;
    }
    const auto tauOf = [&](Four t) {
        const Four tau = t * group.rate - group.start;
        const Four low = Four{} - TauOfT::kLimit, high = Four{} + TauOfT::kLimit;
        return greater(low, tau < high ? tau : high);
    };
    const Four first = tauOf(group.min), last = tauOf(group.max);
    put(tauMin + at, first - (group.startSlack + kFloatRounding * absolute(first)));
    put(tauMax + at, last + (group.startSlack + kFloatRounding * absolute(last)));
}

/// Bounds of the rays of one octant: a box that it misses is missed by all of them. With o and r
/// the origins and reciprocal slopes of an axis, (p - o) r is bilinear, so that its bounds lie at
/// the ends of both intervals.
class PacketFrustum {
  public:
    PacketFrustum(const RayPacket& bundle, unsigned rays) {
        using packet::greatest, packet::least;
        const int first = std::countr_zero(rays);
        for (int axis = 0; axis < 3; ++axis) {
            const float* const nears = bundle.nearOrigin[axis];
            const float* const fars = bundle.farOrigin[axis];
            const bool backwards = bundle.reciprocal[axis][first] < 0.0f;
            nearPlane[axis] = 2 * axis + (backwards ? 1 : 0);
            farPlane[axis] = 2 * axis + (backwards ? 0 : 1);
            low_[axis] = _mm256_set1_ps(least(bundle.reciprocal[axis], rays));
            high_[axis] = _mm256_set1_ps(greatest(bundle.reciprocal[axis], rays));
            nearOrigin_[axis] =
                _mm256_set1_ps(backwards ? least(nears, rays) : greatest(nears, rays));
            farOrigin_[axis] = _mm256_set1_ps(backwards ? greatest(fars, rays) : least(fars, rays));
        }
        tauMin_ = least(bundle.tauMin, rays);
    }

    /// The boxes that may be met before tauMax, and where.
    unsigned meet(const WideNode& node, float tauMax, float* entry) const {
        __m256 enter = _mm256_set1_ps(tauMin_);
        __m256 leave = _mm256_set1_ps(tauMax);
        for (int axis = 0; axis < 3; ++axis) {
            const __m256 toNear =
                _mm256_sub_ps(_mm256_load_ps(node.plane[nearPlane[axis]]), nearOrigin_[axis]);
            const __m256 toFar =
                _mm256_sub_ps(_mm256_load_ps(node.plane[farPlane[axis]]), farOrigin_[axis]);
            enter = _mm256_max_ps(enter, _mm256_min_ps(_mm256_mul_ps(toNear, low_[axis]),
                                                       _mm256_mul_ps(toNear, high_[axis])));
            leave = _mm256_min_ps(leave, _mm256_max_ps(_mm256_mul_ps(toFar, low_[axis]),
                                                       _mm256_mul_ps(toFar, high_[axis])));
        }
        _mm256_store_ps(entry, enter);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
    }

    int nearPlane[3], farPlane[3];

  private:
    __m256 low_[3], high_[3], nearOrigin_[3], farOrigin_[3];
    float tauMin_;
};

}  // namespace rt

#endif
