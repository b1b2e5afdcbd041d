// The corners of a block, moved to a ray's frame: doubles side by side, 8, 4 or 1. Every operation
// rounds alike on all of them.
#pragma once

#include "rt/accel/triangle_block.h"

#include <cmath>
#include <cstdint>

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
/// c - a b, rounded once.
inline Real subtractProduct(Real a, Real b, Real c) {
    return _mm512_fnmadd_pd(a, b, c);
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
/// c - a b, rounded once.
inline Real subtractProduct(Real a, Real b, Real c) {
    return _mm256_fnmadd_pd(a, b, c);
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
/// c - a b, rounded once.
inline Real subtractProduct(Real a, Real b, Real c) {
    return std::fma(-a, b, c);
}

#endif

/// One coordinate of all corners of a block.
struct Table {
    Real part[TriangleBlock::kSize / kCount];
};

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

/// All corners of a block in the frame of a ray: sheared x and y, and z.
struct ShearedBlock {
    Table x, y, z;
};

inline void store(double* values, const Table& table) {
    for (const Real& part : table.part) {
        store(values, part);
        values += kCount;
    }
}

}  // namespace rt::lanes
