// One ray against the eight boxes of a node: the slab test (Kay, Kajiya, "Ray tracing complex
// scenes", 1986), one lane a box, and the boxes met in order of distance.
// Every instruction set may round differently here: the ray's pad covers all of them, and no answer
// depends on which boxes were met in vain, or when.
#pragma once

#include "rt/accel/box_ray.h"

#include <bit>
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace rt {

/// A child that waits for its turn, and the tau at which the ray enters its box.
struct WaitingChild {
    std::uint32_t child;
    float entry;
};

class BoxTester {
  public:
    explicit BoxTester(const BoxRay& ray);

    /// Writes the children whose boxes meet the ray at some tau in [tauMin, tauMax] to `out`, which
    /// has room for eight, far ones first, save the nearest, which goes to `nearest`; returns how
    /// many there are.
    int meet(const WideNode& node, float tauMin, float tauMax, WaitingChild* out,
             std::uint32_t& nearest) const;

  private:
    static int insertSorted(unsigned mask, const WideNode& node, const float* entries,
                            WaitingChild* out);

#if defined(__AVX2__)
    static const float* planeAt(const WideNode& node, std::size_t offset) {
        return reinterpret_cast<const float*>(reinterpret_cast<const char*>(&node) + offset);
    }
    __m256 nearTau(const WideNode& node, int axis) const {
        const __m256 plane = _mm256_load_ps(planeAt(node, nearPlane_[axis]));
        return _mm256_fmadd_ps(plane, reciprocal_[axis], nearShift_[axis]);
    }
    __m256 farTau(const WideNode& node, int axis) const {
        const __m256 plane = _mm256_load_ps(planeAt(node, farPlane_[axis]));
        return _mm256_fmadd_ps(plane, reciprocal_[axis], farShift_[axis]);
    }

    __m256 reciprocal_[3], nearShift_[3], farShift_[3];
    std::size_t nearPlane_[3], farPlane_[3];  ///< bytes from the start of a node
#else
    const BoxRay& ray_;
#endif
};

/// Any number of children, one after another.
inline int BoxTester::insertSorted(unsigned mask, const WideNode& node, const float* entries,
                                   WaitingChild* out) {
    int size = 0;
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        const WaitingChild added{node.child[lane], entries[lane]};
        int place = size++;
        for (; place > 0 && out[place - 1].entry < added.entry; --place)
            out[place] = out[place - 1];
        out[place] = added;
    }
    return size;
}

#if defined(__AVX2__)

inline BoxTester::BoxTester(const BoxRay& ray) {
    for (int axis = 0; axis < 3; ++axis) {
        reciprocal_[axis] = _mm256_set1_ps(ray.reciprocal[axis]);
        nearShift_[axis] = _mm256_set1_ps(ray.nearShift[axis]);
        farShift_[axis] = _mm256_set1_ps(ray.farShift[axis]);
        nearPlane_[axis] = sizeof(__m256) * static_cast<std::size_t>(ray.nearPlane[axis]);
        farPlane_[axis] = sizeof(__m256) * static_cast<std::size_t>(ray.farPlane[axis]);
    }
}

[[gnu::always_inline]] inline int BoxTester::meet(const WideNode& node, float tauMin, float tauMax,
                                                  WaitingChild* out, std::uint32_t& nearest) const {
    // Its line is wanted as soon as the boxes have been tested.
    __builtin_prefetch(node.child);
    const __m256 enter = _mm256_max_ps(_mm256_max_ps(nearTau(node, 0), nearTau(node, 1)),
                                       _mm256_max_ps(nearTau(node, 2), _mm256_set1_ps(tauMin)));
    const __m256 leave = _mm256_min_ps(_mm256_min_ps(farTau(node, 0), farTau(node, 1)),
                                       _mm256_min_ps(farTau(node, 2), _mm256_set1_ps(tauMax)));
    const auto mask =
        static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
    if (mask == 0) return 0;
    const int first = std::countr_zero(mask);
    const unsigned others = mask & (mask - 1);
    nearest = node.child[first];
    if (others == 0) return 1;
    alignas(32) float entries[kTreeWidth];
    _mm256_store_ps(entries, enter);
    const int second = std::countr_zero(others);
    const unsigned more = others & (others - 1);
    if (more == 0) {
        if (entries[second] < entries[first]) {
            out[0] = {nearest, entries[first]};
            nearest = node.child[second];
        } else {
            out[0] = {node.child[second], entries[second]};
        }
        return 2;
    }
    const int count = insertSorted(mask, node, entries, out);
    nearest = out[count - 1].child;
    return count;
}

#else

inline BoxTester::BoxTester(const BoxRay& ray) : ray_(ray) {}

inline int BoxTester::meet(const WideNode& node, float tauMin, float tauMax, WaitingChild* out,
                           std::uint32_t& nearest) const {
    float entry[kTreeWidth];
    float leave[kTreeWidth];
    for (int lane = 0; lane < kTreeWidth; ++lane) {
        entry[lane] = tauMin;
        leave[lane] = tauMax;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const float* nearPlane = node.plane[ray_.nearPlane[axis]];
        const float* farPlane = node.plane[ray_.farPlane[axis]];
        for (int lane = 0; lane < kTreeWidth; ++lane) {
            const float enter = nearPlane[lane] * ray_.reciprocal[axis] + ray_.nearShift[axis];
            const float exit = farPlane[lane] * ray_.reciprocal[axis] + ray_.farShift[axis];
            entry[lane] = enter > entry[lane] ? enter : entry[lane];
            leave[lane] = exit < leave[lane] ? exit : leave[lane];
        }
    }
    unsigned mask = 0;
    for (int lane = 0; lane < kTreeWidth; ++lane) {
        mask |= (entry[lane] <= leave[lane] ? 1u : 0u) << lane;
    }
    const int count = insertSorted(mask, node, entry, out);
    if (count > 0) nearest = out[count - 1].child;
    return count;
}

#endif

}  // namespace rt
