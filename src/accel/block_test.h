// One ray against the triangles of a block: geometry/triangle.h, to the bit, lane by lane.
#pragma once

#include "rt/accel/triangle_block.h"
#include "rt/core/ray.h"
#include "rt/geometry/triangle.h"

#include <cstddef>

namespace rt {

inline Vec3 cornerOf(const TriangleBlock& block, std::size_t which, std::size_t triangle) {
    const std::size_t at = block.triangle[which][triangle];
    return {block.corner[0][at], block.corner[1][at], block.corner[2][at]};
}

/// The nearest hit of all blocks so far: lowest t, then lowest triangle.
class NearestInBlocks {
  public:
    explicit NearestInBlocks(Interval range) : best_{range.max, {}, kNone} {}

    /// Takes a hit at t, which is within the range of the query, if it comes first; returns
    /// whether.
    bool offer(double t, Index triangle, const TriangleWeights& weights) {
        if (!(t < best_.t ||
              (t == best_.t && triangle < best_.triangle && best_.triangle != kNone)))
            return false;
        best_ = {t, weights, triangle};
        return true;
    }

    bool take(PrimitiveHit& hit) const {
        if (best_.triangle == kNone) return false;
        const TriangleWeights& w = best_.weights;
        hit = {best_.t, Vec3(w.u, w.v, w.w) / w.sum(), best_.triangle};
        return true;
    }

  private:
    struct Best {
        double t;
        TriangleWeights weights;
        Index triangle;
    };
    Best best_;
};

class BlockTester {
  public:
    explicit BlockTester(const TriangleRay& ray) : ray_(ray) {}

    /// Offers the hits of the block to `best`, and lowers range.max to the nearest.
    void nearest(const TriangleBlock& block, Interval& range, NearestInBlocks& best) const {
        eachHit(block, [&](double t, std::size_t i, const TriangleWeights& weights) {
            if (range.min < t && best.offer(t, block.id[i], weights)) range.max = t;
            return false;
        });
    }

    bool any(const TriangleBlock& block, Interval range) const {
        return eachHit(block, [&](double t, std::size_t, const TriangleWeights&) {
            return range.contains(t);
        });
    }

  private:
    template <class Take>
    bool eachHit(const TriangleBlock& block, Take&& take) const {
        ShearedCorner corner[TriangleBlock::kSize];
        for (std::size_t i = 0; i < TriangleBlock::kSize; ++i) {
            corner[i] =
                shear(ray_, Vec3(block.corner[0][i], block.corner[1][i], block.corner[2][i]));
        }
        for (std::size_t i = 0; i < block.count; ++i) {
            const ShearedCorner& a = corner[block.triangle[0][i]];
            const ShearedCorner& b = corner[block.triangle[1][i]];
            const ShearedCorner& c = corner[block.triangle[2][i]];
            const TriangleWeights weights = triangleWeights(a, b, c);
            if (!weights.inside()) continue;
            if (take(triangleDistance(ray_, weights, a.z, b.z, c.z), i, weights)) return true;
        }
        return false;
    }

    const TriangleRay& ray_;
};

}  // namespace rt
