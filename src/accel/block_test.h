// One ray against the triangles of a block: geometry/triangle.h, to the bit, lane by lane.
#pragma once

#include "block_lanes.h"
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
    BlockTester() = default;
    explicit BlockTester(const TriangleRay& ray)
        : x_(ray.x),
          y_(ray.y),
          z_(ray.z),
          originX_(lanes::all(ray.origin[ray.x])),
          originY_(lanes::all(ray.origin[ray.y])),
          originZ_(lanes::all(ray.origin[ray.z])),
          shearX_(lanes::all(ray.shearX)),
          shearY_(lanes::all(ray.shearY)),
          dz_(lanes::all(ray.dz)) {}

    /// Offers the hits of the block to `best`, and lowers range.max to the nearest.
    [[gnu::always_inline]] void nearest(const TriangleBlock& block, Interval& range,
                                        NearestInBlocks& best) const {
        eachGroup(block, range, [&](std::size_t first, const Hits& hits) {
            alignas(64) double t[lanes::kCount], u[lanes::kCount], v[lanes::kCount],
                w[lanes::kCount];
            lanes::store(t, hits.t);
            lanes::store(u, hits.u);
            lanes::store(v, hits.v);
            lanes::store(w, hits.w);
            for (unsigned left = hits.mask; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                if (best.offer(t[lane], block.id[first + lane], {u[lane], v[lane], w[lane]})) {
                    range.max = t[lane];
                }
            }
            return false;
        });
    }

    /// Whether the block has a hit in `range`, its end included.
    [[gnu::always_inline]] bool any(const TriangleBlock& block, Interval range) const {
        return eachGroup(block, range, [&](std::size_t, const Hits& hits) {
            return (hits.mask & ~lanes::atLeast(hits.t, lanes::all(range.max))) != 0;
        });
    }

  private:
    struct Hits {
        unsigned mask;
        lanes::Real t, u, v, w;
    };

    /// Calls take(first lane, hits) for groups of lanes with hits in ]range.min, range.max], until
    /// it returns true; returns whether it did.
    template <class Take>
    [[gnu::always_inline]] bool eachGroup(const TriangleBlock& block, const Interval& range,
                                          Take&& take) const {
        using namespace lanes;
        const Table tz = relativeTo(block.corner[z_], originZ_);
        const Table tx = sheared(relativeTo(block.corner[x_], originX_), tz, shearX_);
        const Table ty = sheared(relativeTo(block.corner[y_], originY_), tz, shearY_);
        for (std::size_t first = 0; first < block.count; first += lanes::kCount) {
            const Pick a = pick(block.triangle[0] + first);
            const Pick b = pick(block.triangle[1] + first);
            const Pick c = pick(block.triangle[2] + first);
            const Real ax = look(tx, a), bx = look(tx, b), cx = look(tx, c);
            const Real ay = look(ty, a), by = look(ty, b), cy = look(ty, c);
            const Real u = lanes::differenceOfProducts(cx, by, cy, bx);
            const Real v = lanes::differenceOfProducts(ax, cy, ay, cx);
            const Real w = lanes::differenceOfProducts(bx, ay, by, ax);
            const Real zero = all(0.0);
            const Real sum = u + v + w;
            unsigned mask = (atLeast(u, zero) & atLeast(v, zero) & atLeast(w, zero)) |
                            (atLeast(zero, u) & atLeast(zero, v) & atLeast(zero, w));
            mask &= notZero(sum);
            if (mask == 0) continue;
            const Real depth =
                multiplyAdd(u, look(tz, a), multiplyAdd(v, look(tz, b), w * look(tz, c)));
            const Real t = depth / sum / dz_;
            mask &= above(t, all(range.min)) & atLeast(all(range.max), t);
            if (mask != 0 && take(first, Hits{mask, t, u, v, w})) return true;
        }
        return false;
    }

    int x_, y_, z_;
    lanes::Real originX_, originY_, originZ_, shearX_, shearY_, dz_;
};

}  // namespace rt
