// Floats of sixteen rays side by side: one register of AVX-512, or two of AVX2.
#pragma once

#if defined(__AVX2__)

#include <immintrin.h>

#include <limits>

namespace rt::packet {

inline constexpr int kRays = 16;

#if defined(__AVX512F__)

using Register = __m512;
inline constexpr int kRegisterWidth = 16;

inline Register loadRegister(const float* values) {
    return _mm512_load_ps(values);
}
inline void storeRegister(float* values, Register a) {
    _mm512_store_ps(values, a);
}
inline Register allRegister(float value) {
    return _mm512_set1_ps(value);
}
inline Register multiplyAdd(Register a, Register b, Register c) {
    return _mm512_fmadd_ps(a, b, c);
}
/// Masked with all lanes on: g++ 12 takes the plain ones for uses of undefined values.
inline Register larger(Register a, Register b) {
    return _mm512_maskz_max_ps(0xffff, a, b);
}
inline Register smaller(Register a, Register b) {
    return _mm512_maskz_min_ps(0xffff, a, b);
}
inline unsigned atMost(Register a, Register b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}

#else

using Register = __m256;
inline constexpr int kRegisterWidth = 8;

inline Register loadRegister(const float* values) {
    return _mm256_load_ps(values);
}
inline void storeRegister(float* values, Register a) {
    _mm256_store_ps(values, a);
}
inline Register allRegister(float value) {
    return _mm256_set1_ps(value);
}
inline Register multiplyAdd(Register a, Register b, Register c) {
    return _mm256_fmadd_ps(a, b, c);
}
inline Register larger(Register a, Register b) {
    return _mm256_max_ps(a, b);
}
inline Register smaller(Register a, Register b) {
    return _mm256_min_ps(a, b);
}
inline unsigned atMost(Register a, Register b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)));
}

#endif

/// All ones in the lanes whose bits are set.
inline __m256 lanesOf(unsigned which) {
    const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(which)), bits);
    return _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, bits));
}

/// Of the values whose bits are set, of which there is one at least.
inline float least(const float* values, unsigned which) {
    const __m256 none = _mm256_set1_ps(std::numeric_limits<float>::infinity());
    const __m256 some =
        _mm256_min_ps(_mm256_blendv_ps(none, _mm256_load_ps(values), lanesOf(which)),
                      _mm256_blendv_ps(none, _mm256_load_ps(values + 8), lanesOf(which >> 8)));
    __m128 low = _mm_min_ps(_mm256_castps256_ps128(some), _mm256_extractf128_ps(some, 1));
    low = _mm_min_ps(low, _mm_movehl_ps(low, low));
    return _mm_cvtss_f32(_mm_min_ss(low, _mm_movehdup_ps(low)));
}
inline float greatest(const float* values, unsigned which) {
    const __m256 none = _mm256_set1_ps(-std::numeric_limits<float>::infinity());
    const __m256 some =
        _mm256_max_ps(_mm256_blendv_ps(none, _mm256_load_ps(values), lanesOf(which)),
                      _mm256_blendv_ps(none, _mm256_load_ps(values + 8), lanesOf(which >> 8)));
    __m128 high = _mm_max_ps(_mm256_castps256_ps128(some), _mm256_extractf128_ps(some, 1));
    high = _mm_max_ps(high, _mm_movehl_ps(high, high));
    return _mm_cvtss_f32(_mm_max_ss(high, _mm_movehdup_ps(high)));
}

}  // namespace rt::packet

#endif
