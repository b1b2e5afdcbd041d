// Boxes of the builder: single precision, four floats to a corner.
#pragma once

#include "rt/core/vec.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace rt {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 min4(Float4 a, Float4 b) {
#if defined(__SSE2__)
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}

inline Float4 max4(Float4 a, Float4 b) {
#if defined(__SSE2__)
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}

/// Cut off towards zero.
inline Int4 toInts(Float4 a) {
    return __builtin_convertvector(a, Int4);
}

/// A box, or the box of nothing; the fourth components are of no account.
struct Box4 {
    static constexpr float kFar = std::numeric_limits<float>::infinity();

    Float4 lo{kFar, kFar, kFar, kFar};
    Float4 hi{-kFar, -kFar, -kFar, -kFar};

    void unite(const Box4& other) {
        lo = min4(lo, other.lo);
        hi = max4(hi, other.hi);
    }
    void unite(Float4 point) {
        lo = min4(lo, point);
        hi = max4(hi, point);
    }
    /// Half the surface area; 0 for the box of nothing.
    float halfArea() const {
        const Float4 e = hi - lo;
        return e[0] >= 0.0f ? e[0] * e[1] + e[1] * e[2] + e[2] * e[0] : 0.0f;
    }
};

/// What the builder sorts: a box in the frame of the tree, and whose it is.
struct BoxRef {
    Box4 box;  ///< lo[3] carries the item's bits

    Index item() const { return std::bit_cast<Index>(static_cast<float>(box.lo[3])); }
    void setItem(Index item) { box.lo[3] = std::bit_cast<float>(item); }

    /// Twice the centre; the fourth component is 0, so that no item's bits are computed with.
    Float4 centre() const {
        const Int4 three = {-1, -1, -1, 0};
        const auto kept = [&](Float4 a) { return (Float4)((Int4)a & three); };
        return kept(box.lo) + kept(box.hi);
    }
};
static_assert(sizeof(BoxRef) == 32);

}  // namespace rt
