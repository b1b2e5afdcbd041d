// Floats of sixteen rays side by side: one register of AVX-512, or two of AVX2.
#pragma once

#if defined(__AVX2__)

#include <immintrin.h>

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

}  // namespace rt::packet

#endif
