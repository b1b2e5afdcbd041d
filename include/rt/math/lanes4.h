// Four doubles side by side: the three parts of a vector and one to spare, or four of a kind.
//
// Every lane rounds as the same operation on a double does, so the results do not depend on the
// instruction set. Lanes4 lives within functions only: code for different instruction sets shares
// the scene's data, and lays these out differently.
#pragma once

#include <cmath>
#include <cstddef>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace rt {

// Each has a name of its own for the linker, lest a program of mixed instruction sets (a benchmark)
// take one for the other.
#if defined(__AVX2__)

inline namespace lanes_avx2 {

class Lanes4 {
  public:
    Lanes4() = default;
    Lanes4(double x, double y, double z, double w) : v_(_mm256_setr_pd(x, y, z, w)) {}
    static Lanes4 all(double x) { return _mm256_set1_pd(x); }
    static Lanes4 load(const double* four) { return _mm256_loadu_pd(four); }
    /// Three doubles and 0.
    static Lanes4 loadThree(const double* three) {
        return _mm256_maskload_pd(three, _mm256_setr_epi64x(-1, -1, -1, 0));
    }
    static Lanes4 load(const float* four) { return _mm256_cvtps_pd(_mm_loadu_ps(four)); }
    void store(double* four) const { _mm256_storeu_pd(four, v_); }
    void storeThree(double* three) const {
        _mm_storeu_pd(three, _mm256_castpd256_pd128(v_));
        _mm_store_sd(three + 2, _mm256_extractf128_pd(v_, 1));
    }

    friend Lanes4 operator+(Lanes4 a, Lanes4 b) { return _mm256_add_pd(a.v_, b.v_); }
    friend Lanes4 operator-(Lanes4 a, Lanes4 b) { return _mm256_sub_pd(a.v_, b.v_); }
    friend Lanes4 operator*(Lanes4 a, Lanes4 b) { return _mm256_mul_pd(a.v_, b.v_); }
    friend Lanes4 operator/(Lanes4 a, Lanes4 b) { return _mm256_div_pd(a.v_, b.v_); }
    /// a b + c and a b - c, rounded once.
    friend Lanes4 fma(Lanes4 a, Lanes4 b, Lanes4 c) { return _mm256_fmadd_pd(a.v_, b.v_, c.v_); }
    friend Lanes4 fms(Lanes4 a, Lanes4 b, Lanes4 c) { return _mm256_fmsub_pd(a.v_, b.v_, c.v_); }
    /// Of a NaN and b, b.
    friend Lanes4 greater(Lanes4 a, Lanes4 b) { return _mm256_max_pd(a.v_, b.v_); }
    friend Lanes4 lesser(Lanes4 a, Lanes4 b) { return _mm256_min_pd(a.v_, b.v_); }
    friend Lanes4 magnitude(Lanes4 a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v_); }
    friend Lanes4 withSign(Lanes4 a, Lanes4 sign) {
        const __m256d bit = _mm256_set1_pd(-0.0);
        return _mm256_or_pd(_mm256_andnot_pd(bit, a.v_), _mm256_and_pd(bit, sign.v_));
    }
    /// Lane by lane: `up` where `sign` is not negative, else `down`.
    friend Lanes4 chosenBySign(Lanes4 sign, Lanes4 up, Lanes4 down) {
        return _mm256_blendv_pd(up.v_, down.v_, sign.v_);
    }
    /// Bit i: lane i is negative.
    friend unsigned signBits(Lanes4 a) { return static_cast<unsigned>(_mm256_movemask_pd(a.v_)); }
    /// Lane I in all four.
    template <int I>
    Lanes4 spread() const {
        return _mm256_permute4x64_pd(v_, I * 0x55);
    }
    /// Bit i: a <= b in lane i.
    friend unsigned notAbove(Lanes4 a, Lanes4 b) {
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a.v_, b.v_, _CMP_LE_OQ)));
    }
    /// The largest, the least of the first three lanes.
    friend double largestOfThree(Lanes4 a) {
        const __m128d xy = _mm256_castpd256_pd128(a.v_);
        const __m128d z = _mm256_extractf128_pd(a.v_, 1);
        return _mm_cvtsd_f64(_mm_max_sd(_mm_max_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
    }
    friend double leastOfThree(Lanes4 a) {
        const __m128d xy = _mm256_castpd256_pd128(a.v_);
        const __m128d z = _mm256_extractf128_pd(a.v_, 1);
        return _mm_cvtsd_f64(_mm_min_sd(_mm_min_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
    }

  private:
    Lanes4(__m256d v) : v_(v) {}
    __m256d v_;
};

}  // namespace lanes_avx2

#else

inline namespace lanes_plain {

class Lanes4 {
  public:
    Lanes4() = default;
    Lanes4(double x, double y, double z, double w) : v_{x, y, z, w} {}
    static Lanes4 all(double x) { return {x, x, x, x}; }
    static Lanes4 load(const double* four) { return {four[0], four[1], four[2], four[3]}; }
    /// Three doubles and 0.
    static Lanes4 loadThree(const double* three) { return {three[0], three[1], three[2], 0.0}; }
    static Lanes4 load(const float* four) { return {four[0], four[1], four[2], four[3]}; }
    void store(double* four) const {
        for (std::size_t i = 0; i < 4; ++i) four[i] = v_[i];
    }
    void storeThree(double* three) const {
        for (std::size_t i = 0; i < 3; ++i) three[i] = v_[i];
    }

    friend Lanes4 operator+(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] + b.v_[i]; });
    }
    friend Lanes4 operator-(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] - b.v_[i]; });
    }
    friend Lanes4 operator*(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] * b.v_[i]; });
    }
    friend Lanes4 operator/(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] / b.v_[i]; });
    }
    /// a b + c and a b - c, rounded once.
    friend Lanes4 fma(Lanes4 a, Lanes4 b, Lanes4 c) {
        return each([&](std::size_t i) { return std::fma(a.v_[i], b.v_[i], c.v_[i]); });
    }
    friend Lanes4 fms(Lanes4 a, Lanes4 b, Lanes4 c) {
        return each([&](std::size_t i) { return std::fma(a.v_[i], b.v_[i], -c.v_[i]); });
    }
    /// Of a NaN and b, b.
    friend Lanes4 greater(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] > b.v_[i] ? a.v_[i] : b.v_[i]; });
    }
    friend Lanes4 lesser(Lanes4 a, Lanes4 b) {
        return each([&](std::size_t i) { return a.v_[i] < b.v_[i] ? a.v_[i] : b.v_[i]; });
    }
    friend Lanes4 magnitude(Lanes4 a) {
        return each([&](std::size_t i) { return std::fabs(a.v_[i]); });
    }
    friend Lanes4 withSign(Lanes4 a, Lanes4 sign) {
        return each([&](std::size_t i) { return std::copysign(a.v_[i], sign.v_[i]); });
    }
    /// Lane by lane: `up` where `sign` is not negative, else `down`.
    friend Lanes4 chosenBySign(Lanes4 sign, Lanes4 up, Lanes4 down) {
        return each(
            [&](std::size_t i) { return std::signbit(sign.v_[i]) ? down.v_[i] : up.v_[i]; });
    }
    /// Bit i: lane i is negative.
    friend unsigned signBits(Lanes4 a) {
        unsigned mask = 0;
        for (std::size_t i = 0; i < 4; ++i) mask |= (std::signbit(a.v_[i]) ? 1u : 0u) << i;
        return mask;
    }
    /// Lane I in all four.
    template <int I>
    Lanes4 spread() const {
        return all(v_[I]);
    }
    /// Bit i: a <= b in lane i.
    friend unsigned notAbove(Lanes4 a, Lanes4 b) {
        unsigned mask = 0;
        for (std::size_t i = 0; i < 4; ++i) mask |= (a.v_[i] <= b.v_[i] ? 1u : 0u) << i;
        return mask;
    }
    /// The largest, the least of the first three lanes.
    friend double largestOfThree(Lanes4 a) {
        const double xy = a.v_[0] > a.v_[1] ? a.v_[0] : a.v_[1];
        return xy > a.v_[2] ? xy : a.v_[2];
    }
    friend double leastOfThree(Lanes4 a) {
        const double xy = a.v_[0] < a.v_[1] ? a.v_[0] : a.v_[1];
        return xy < a.v_[2] ? xy : a.v_[2];
    }

  private:
    template <class Lane>
    static Lanes4 each(const Lane& lane) {
        return {lane(0), lane(1), lane(2), lane(3)};
    }
    double v_[4];
};

}  // namespace lanes_plain

#endif

}  // namespace rt
