// Doubles side by side, as many as the instruction set has: 8, 4 or 1. Every operation rounds
// alike on all of them.
#pragma once

#include "rt/accel/triangle_block.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace rt::lanes {

#if defined(__AVX512F__)

inline constexpr int kCount = 8;
using Real = __m512d;

inline Real all(double value) {
    return _mm512_set1_pd(value);
}
inline Real load(const double* values) {
    return _mm512_load_pd(values);
}
inline void store(double* values, Real a) {
    _mm512_store_pd(values, a);
}
/// a b + c, a b - c, c - a b, each rounded once.
inline Real multiplyAdd(Real a, Real b, Real c) {
    return _mm512_fmadd_pd(a, b, c);
}
inline Real multiplySubtract(Real a, Real b, Real c) {
    return _mm512_fmsub_pd(a, b, c);
}
inline Real subtractProduct(Real a, Real b, Real c) {
    return _mm512_fnmadd_pd(a, b, c);
}
/// One bit a lane.
inline unsigned above(Real a, Real b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
}
inline unsigned atLeast(Real a, Real b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ);
}
inline unsigned notZero(Real a) {
    return _mm512_cmp_pd_mask(a, _mm512_setzero_pd(), _CMP_NEQ_UQ);
}

/// Masked intrinsics with all lanes on: g++ 12 takes the plain ones for uses of undefined values.
inline constexpr __mmask8 kAllLanes = 0xff;

/// Which corner each lane wants.
using Pick = __m512i;
inline Pick pick(const std::uint8_t* corners) {
    return _mm512_maskz_cvtepu8_epi64(kAllLanes,
                                      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(corners)));
}
struct Table {
    Real part[1];
};
inline Real look(const Table& table, Pick at) {
    return _mm512_maskz_permutexvar_pd(kAllLanes, at, table.part[0]);
}

#elif defined(__AVX2__)

inline constexpr int kCount = 4;
using Real = __m256d;

inline Real all(double value) {
    return _mm256_set1_pd(value);
}
inline Real load(const double* values) {
    return _mm256_load_pd(values);
}
inline void store(double* values, Real a) {
    _mm256_store_pd(values, a);
}
/// a b + c, a b - c, c - a b, each rounded once.
inline Real multiplyAdd(Real a, Real b, Real c) {
    return _mm256_fmadd_pd(a, b, c);
}
inline Real multiplySubtract(Real a, Real b, Real c) {
    return _mm256_fmsub_pd(a, b, c);
}
inline Real subtractProduct(Real a, Real b, Real c) {
    return _mm256_fnmadd_pd(a, b, c);
}
/// One bit a lane.
inline unsigned above(Real a, Real b) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ)));
}
inline unsigned atLeast(Real a, Real b) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GE_OQ)));
}
inline unsigned notZero(Real a) {
    return static_cast<unsigned>(
        _mm256_movemask_pd(_mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_NEQ_UQ)));
}

/// Which corner each lane wants: its two halves within four corners, and in the sign bit which
/// four.
struct Pick {
    __m256i halves;
    __m256d upper;
};
inline Pick pick(const std::uint8_t* corners) {
    std::uint32_t bytes;
    std::memcpy(&bytes, corners, sizeof bytes);
    const __m256i at = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(static_cast<int>(bytes)));
    const __m256i twice = _mm256_shuffle_epi32(_mm256_add_epi64(at, at), 0xa0);
    return {_mm256_or_si256(twice, _mm256_set1_epi64x(std::int64_t{1} << 32)),
            _mm256_castsi256_pd(_mm256_slli_epi64(at, 61))};
}
struct Table {
    Real part[2];
};
inline Real look(const Table& table, const Pick& at) {
    const __m256 lower = _mm256_permutevar8x32_ps(_mm256_castpd_ps(table.part[0]), at.halves);
    const __m256 upper = _mm256_permutevar8x32_ps(_mm256_castpd_ps(table.part[1]), at.halves);
    return _mm256_blendv_pd(_mm256_castps_pd(lower), _mm256_castps_pd(upper), at.upper);
}

#else

inline constexpr int kCount = 1;
using Real = double;

inline Real all(double value) {
    return value;
}
inline Real load(const double* values) {
    return *values;
}
inline void store(double* values, Real a) {
    *values = a;
}
/// a b + c, a b - c, c - a b, each rounded once.
inline Real multiplyAdd(Real a, Real b, Real c) {
    return std::fma(a, b, c);
}
inline Real multiplySubtract(Real a, Real b, Real c) {
    return std::fma(a, b, -c);
}
inline Real subtractProduct(Real a, Real b, Real c) {
    return std::fma(-a, b, c);
}
/// One bit a lane.
inline unsigned above(Real a, Real b) {
    return a > b ? 1 : 0;
}
inline unsigned atLeast(Real a, Real b) {
    return a >= b ? 1 : 0;
}
inline unsigned notZero(Real a) {
    return a != 0.0 ? 1 : 0;
}

/// Which corner each lane wants.
using Pick = std::size_t;
inline Pick pick(const std::uint8_t* corners) {
    return *corners;
}
struct Table {
    Real part[TriangleBlock::kSize];
};
inline Real look(const Table& table, Pick at) {
    return table.part[at];
}

#endif

/// a b - c d by Kahan's difference of products, as rt::differenceOfProducts.
inline Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    return multiplySubtract(a, b, cd) + subtractProduct(c, d, cd);
}

/// Corner coordinates of one axis, relative to `origin`.
inline Table relativeTo(const double* corners, Real origin) {
    Table table;
    int at = 0;
    for (Real& part : table.part) {
        part = load(corners + at) - origin;
        at += kCount;
    }
    return table;
}

/// across - slope * along.
inline Table sheared(const Table& across, const Table& along, Real slope) {
    Table table;
    int at = 0;
    for (Real& part : table.part) {
        part = subtractProduct(slope, along.part[at], across.part[at]);
        ++at;
    }
    return table;
}

}  // namespace rt::lanes
