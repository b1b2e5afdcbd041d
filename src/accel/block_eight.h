// The hits of one block, eight triangles at once: geometry/triangle.h, to the bit, lane by lane.
#pragma once

#include "block_lanes.h"
#include "rt/core/ray.h"
#include "rt/geometry/triangle.h"

#include <bit>
#include <cstddef>

namespace rt::lanes {

/// Masked intrinsics with all lanes on: g++ 12 takes the plain ones for uses of undefined values.
inline constexpr __mmask8 kAllLanes = 0xff;

/// Which corner each triangle wants, and the coordinate of it.
inline __m512i pick(const std::uint8_t* corners) {
    return _mm512_maskz_cvtepu8_epi64(kAllLanes,
                                      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(corners)));
}
inline Real look(const Table& table, __m512i at) {
    return _mm512_maskz_permutexvar_pd(kAllLanes, at, table.part[0]);
}

/// a b - c d by Kahan's difference of products, as rt::differenceOfProducts.
inline Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    return _mm512_fmsub_pd(a, b, cd) + subtractProduct(c, d, cd);
}

inline unsigned atLeast(Real a, Real b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ);
}

/// Calls take(triangle, t, weights) for the hits in ]range.min, range.max], until it returns true;
/// returns whether it did.
template <class Take>
[[gnu::always_inline]] inline bool eachHit(const TriangleBlock& block, const ShearedBlock& corners,
                                           double dz, const Interval& range, Take&& take) {
    const __m512i a = pick(block.triangle[0]);
    const __m512i b = pick(block.triangle[1]);
    const __m512i c = pick(block.triangle[2]);
    const Real ax = look(corners.x, a), bx = look(corners.x, b), cx = look(corners.x, c);
    const Real ay = look(corners.y, a), by = look(corners.y, b), cy = look(corners.y, c);
    const Real u = differenceOfProducts(cx, by, cy, bx);
    const Real v = differenceOfProducts(ax, cy, ay, cx);
    const Real w = differenceOfProducts(bx, ay, by, ax);
    const Real zero = _mm512_setzero_pd();
    const Real sum = u + v + w;
    unsigned mask = (atLeast(u, zero) & atLeast(v, zero) & atLeast(w, zero)) |
                    (atLeast(zero, u) & atLeast(zero, v) & atLeast(zero, w));
    mask &= _mm512_cmp_pd_mask(sum, zero, _CMP_NEQ_UQ);
    if (mask == 0) return false;
    const Real depth = _mm512_fmadd_pd(
        u, look(corners.z, a), _mm512_fmadd_pd(v, look(corners.z, b), w * look(corners.z, c)));
    const Real t = depth / sum / all(dz);
    mask &= _mm512_cmp_pd_mask(t, all(range.min), _CMP_GT_OQ) & atLeast(all(range.max), t);
    if (mask == 0) return false;
    alignas(64) double ts[kCount], us[kCount], vs[kCount], ws[kCount];
    store(ts, t);
    store(us, u);
    store(vs, v);
    store(ws, w);
    for (; mask != 0; mask &= mask - 1) {
        const auto at = static_cast<std::size_t>(std::countr_zero(mask));
        if (take(at, ts[at], {us[at], vs[at], ws[at]})) return true;
    }
    return false;
}

}  // namespace rt::lanes
