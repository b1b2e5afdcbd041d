// The hits of one block, found one by one, after a look in single precision at all triangles.
//
// A triangle is passed over where two of its edge functions have opposite signs for certain. Each
// is a difference p - q of products. With coordinates rounded to float (u = 2^-24 each), the
// products and the difference, it is off by at most 3.1 u (|p| + |q|) + u |p - q| < 5 u (|p| +
// |q|), and by a denormal where a product underflows. What overflows is not certain of anything.
#pragma once

#include "block_lanes.h"
#include "rt/core/ray.h"
#include "rt/geometry/triangle.h"

#include <bit>
#include <cstddef>

namespace rt::lanes {

/// Of |p| + |q|; 8 u.
inline constexpr float kEdgeRounding = 0x1p-21f;
/// More than products of floats lose where they underflow.
inline constexpr float kEdgeUnderflow = 0x1p-125f;

#if defined(__AVX2__)

inline __m256 toFloats(const Table& table) {
    return _mm256_set_m128(_mm256_cvtpd_ps(table.part[1]), _mm256_cvtpd_ps(table.part[0]));
}

/// Which corner each triangle wants.
inline __m256i pick(const std::uint8_t* corners) {
    return _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(corners)));
}

/// Gathers certain signs of edge functions.
struct CertainSigns {
    __m256 negative = _mm256_setzero_ps();
    __m256 positive = _mm256_setzero_ps();

    /// Of a b - c d.
    void add(__m256 a, __m256 b, __m256 c, __m256 d) {
        const __m256 sign = _mm256_set1_ps(-0.0f);
        const __m256 p = _mm256_mul_ps(a, b);
        const __m256 q = _mm256_mul_ps(c, d);
        const __m256 size = _mm256_add_ps(_mm256_andnot_ps(sign, p), _mm256_andnot_ps(sign, q));
        const __m256 doubt =
            _mm256_fmadd_ps(size, _mm256_set1_ps(kEdgeRounding), _mm256_set1_ps(kEdgeUnderflow));
        const __m256 edge = _mm256_sub_ps(p, q);
        positive = _mm256_or_ps(positive, _mm256_cmp_ps(edge, doubt, _CMP_GT_OQ));
        negative =
            _mm256_or_ps(negative, _mm256_cmp_ps(edge, _mm256_xor_ps(doubt, sign), _CMP_LT_OQ));
    }
    unsigned opposite() const {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(negative, positive)));
    }
};

/// The triangles, one bit each, that the ray may pass through.
inline unsigned mayHit(const TriangleBlock& block, const ShearedBlock& corners) {
    const __m256 x = toFloats(corners.x), y = toFloats(corners.y);
    const __m256i a = pick(block.triangle[0]), b = pick(block.triangle[1]),
                  c = pick(block.triangle[2]);
    const __m256 ax = _mm256_permutevar8x32_ps(x, a), ay = _mm256_permutevar8x32_ps(y, a);
    const __m256 bx = _mm256_permutevar8x32_ps(x, b), by = _mm256_permutevar8x32_ps(y, b);
    const __m256 cx = _mm256_permutevar8x32_ps(x, c), cy = _mm256_permutevar8x32_ps(y, c);
    CertainSigns signs;
    signs.add(cx, by, cy, bx);
    signs.add(ax, cy, ay, cx);
    signs.add(bx, ay, by, ax);
    const unsigned used = (1u << block.count) - 1;
    return used & ~signs.opposite();
}

#else

/// Without lanes, the full test is as cheap.
inline unsigned mayHit(const TriangleBlock& block, const ShearedBlock&) {
    return (1u << block.count) - 1;
}

#endif

/// Calls take(triangle, t, weights) for the hits in ]range.min, range.max], until it returns true;
/// returns whether it did.
template <class Take>
[[gnu::always_inline]] inline bool eachHit(const TriangleBlock& block, const ShearedBlock& corners,
                                           double dz, const Interval& range, Take&& take) {
    unsigned left = mayHit(block, corners);
    if (left == 0) return false;
    alignas(64) double x[TriangleBlock::kSize], y[TriangleBlock::kSize], z[TriangleBlock::kSize];
    store(x, corners.x);
    store(y, corners.y);
    store(z, corners.z);
    for (; left != 0; left &= left - 1) {
        const auto triangle = static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t a = block.triangle[0][triangle], b = block.triangle[1][triangle],
                          c = block.triangle[2][triangle];
        const TriangleWeights weights =
            triangleWeights({x[a], y[a], z[a]}, {x[b], y[b], z[b]}, {x[c], y[c], z[c]});
        if (!weights.inside()) continue;
        const double t = triangleDistance(dz, weights, z[a], z[b], z[c]);
        if (range.min < t && t <= range.max && take(triangle, t, weights)) return true;
    }
    return false;
}

}  // namespace rt::lanes
