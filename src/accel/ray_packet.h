// Sixteen rays as the boxes of a tree see them, and what bounds several of them at once.
#pragma once

#include "packet_lanes.h"
#include "rt/accel/box_ray.h"

#if defined(__AVX2__)

#include <bit>
#include <span>

namespace rt {

/// The slab test (box_test.h), one lane a ray.
class RayPacket {
  public:
    /// The rays that may meet the tree, one bit each.
    unsigned set(const TreeFrame& frame, std::span<const Ray> rays,
                 std::span<const Interval> ranges) {
        unsigned usable = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!BoxRay::make(frame, rays[i], boxRays[i])) continue;
            usable |= 1u << i;
            const BoxRay& ray = boxRays[i];
            for (int axis = 0; axis < 3; ++axis) {
                reciprocal[axis][i] = ray.reciprocal[axis];
                nearShift[axis][i] = ray.nearShift[axis];
                farShift[axis][i] = ray.farShift[axis];
                nearOrigin[axis][i] = ray.nearOrigin[axis];
                farOrigin[axis][i] = ray.farOrigin[axis];
            }
            tauMin[i] = ray.tauBelow(ranges[i].min);
            tauMax[i] = ray.tauAbove(ranges[i].max);
        }
        return usable;
    }

    /// Of `rays`, those whose directions have the same signs as the first one's.
    unsigned alike(unsigned rays) const {
        const auto signs = [&](int ray) {
            return std::bit_cast<std::uint32_t>(reciprocal[0][ray]) >> 31 |
                   std::bit_cast<std::uint32_t>(reciprocal[1][ray]) >> 31 << 1 |
                   std::bit_cast<std::uint32_t>(reciprocal[2][ray]) >> 31 << 2;
        };
        const std::uint32_t first = signs(std::countr_zero(rays));
        unsigned result = 0;
        for (unsigned left = rays; left != 0; left &= left - 1) {
            const int ray = std::countr_zero(left);
            result |= (signs(ray) == first ? 1u : 0u) << ray;
        }
        return result;
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
    BoxRay boxRays[packet::kRays];
};

/// Bounds of the rays of one octant: a box that it misses is missed by all of them. With o and r
/// the origins and reciprocal slopes of an axis, (p - o) r is bilinear, so that its bounds lie at
/// the ends of both intervals.
class PacketFrustum {
  public:
    PacketFrustum(const RayPacket& bundle, unsigned rays) {
        using packet::greatest, packet::least;
        const BoxRay& first = bundle.boxRays[std::countr_zero(rays)];
        for (int axis = 0; axis < 3; ++axis) {
            nearPlane[axis] = first.nearPlane[axis];
            farPlane[axis] = first.farPlane[axis];
            const float* const nears = bundle.nearOrigin[axis];
            const float* const fars = bundle.farOrigin[axis];
            const bool backwards = first.reciprocal[axis] < 0.0f;
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
