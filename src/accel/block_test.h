// One ray against the triangles of a block: geometry/triangle.h, to the bit, lane by lane.
#pragma once

#if defined(__AVX512F__)
#include "block_eight.h"
#else
#include "block_filter.h"
#endif
#include "rt/accel/triangle_block.h"
#include "rt/core/ray.h"
#include "rt/geometry/triangle.h"

#include <bit>
#include <cstddef>

namespace rt {

inline Vec3 cornerOf(const TriangleBlock& block, std::size_t which, std::size_t triangle) {
    const std::size_t at = block.triangle[which][triangle];
    return {block.corner[0][at], block.corner[1][at], block.corner[2][at]};
}

/// The nearest hit of all blocks so far: lowest t, then lowest triangle.
class NearestInBlocks {
  public:
    NearestInBlocks() = default;
    explicit NearestInBlocks(Interval range) : t_(range.max) {}

    /// Takes a hit at t, which is within the range of the query, if it comes first; returns
    /// whether.
    bool offer(double t, Index triangle, const TriangleWeights& weights) {
        const bool first = t < t_ || (t == t_ && triangle < triangle_ && triangle_ != kNone);
        if (!first) return false;
        t_ = t;
        triangle_ = triangle;
        weights_ = weights;
        return true;
    }

    bool take(PrimitiveHit& hit) const {
        if (triangle_ == kNone) return false;
        hit = {t_, Vec3(weights_.u, weights_.v, weights_.w) / weights_.sum(), triangle_};
        return true;
    }

  private:
    double t_ = kInfinity;
    Index triangle_ = kNone;
    TriangleWeights weights_{};
};

class BlockTester {
  public:
    explicit BlockTester(const TriangleRay& ray)
        : x_(ray.x),
          y_(ray.y),
          z_(ray.z),
          originX_(lanes::all(ray.origin[ray.x])),
          originY_(lanes::all(ray.origin[ray.y])),
          originZ_(lanes::all(ray.origin[ray.z])),
          shearX_(lanes::all(ray.shearX)),
          shearY_(lanes::all(ray.shearY)),
          dz_(ray.dz) {}

    /// Offers the hits of the block to `best`, and lowers range.max to the nearest.
    [[gnu::always_inline]] void nearest(const TriangleBlock& block, Interval& range,
                                        NearestInBlocks& best) const {
        eachHit(block, range, [&](std::size_t triangle, double t, const TriangleWeights& weights) {
            if (best.offer(t, block.id[triangle], weights)) range.max = t;
            return false;
        });
    }

    /// Whether the block has a hit in `range`, its end included.
    [[gnu::always_inline]] bool any(const TriangleBlock& block, Interval range) const {
        return eachHit(block, range, [&](std::size_t, double t, const TriangleWeights&) {
            return t < range.max;
        });
    }

  private:
    /// Calls take(triangle, t, weights) for the hits in ]range.min, range.max], until it returns
    /// true; returns whether it did.
    template <class Take>
    [[gnu::always_inline]] bool eachHit(const TriangleBlock& block, const Interval& range,
                                        Take&& take) const {
        using namespace lanes;
        const Table tz = relativeTo(block.corner[z_], originZ_);
        const Table tx = sheared(relativeTo(block.corner[x_], originX_), tz, shearX_);
        const Table ty = sheared(relativeTo(block.corner[y_], originY_), tz, shearY_);
        return lanes::eachHit(block, {tx, ty, tz}, dz_, range, take);
    }

    int x_, y_, z_;
    lanes::Real originX_, originY_, originZ_, shearX_, shearY_;
    double dz_;
};

}  // namespace rt
