// One ray against the eight boxes of a node: the slab test (Kay, Kajiya 1986), one lane a box.
// Every instruction set may round differently here: the ray's pad covers all of them, and no answer
// depends on which boxes were met in vain.
#pragma once

#include "rt/accel/box_ray.h"

#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace rt {

#if defined(__AVX2__)

class BoxTester {
  public:
    explicit BoxTester(const BoxRay& ray) {
        for (int axis = 0; axis < 3; ++axis) {
            reciprocal_[axis] = _mm256_set1_ps(ray.reciprocal[axis]);
            nearShift_[axis] = _mm256_set1_ps(ray.nearShift[axis]);
            farShift_[axis] = _mm256_set1_ps(ray.farShift[axis]);
            nearPlane_[axis] = ray.nearPlane[axis];
            farPlane_[axis] = ray.farPlane[axis];
        }
    }

    /// Bit i is set where box i meets the ray at some tau in [tauMin, tauMax]; `entry` is where.
    unsigned meet(const WideNode& node, float tauMin, float tauMax, float entry[kTreeWidth]) const {
        const __m256 enter = _mm256_max_ps(_mm256_max_ps(nearTau(node, 0), nearTau(node, 1)),
                                           _mm256_max_ps(nearTau(node, 2), _mm256_set1_ps(tauMin)));
        const __m256 leave = _mm256_min_ps(_mm256_min_ps(farTau(node, 0), farTau(node, 1)),
                                           _mm256_min_ps(farTau(node, 2), _mm256_set1_ps(tauMax)));
        _mm256_store_ps(entry, enter);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
    }

  private:
    __m256 nearTau(const WideNode& node, int axis) const {
        const __m256 plane = _mm256_load_ps(node.plane[nearPlane_[axis]]);
        return _mm256_fmadd_ps(plane, reciprocal_[axis], nearShift_[axis]);
    }
    __m256 farTau(const WideNode& node, int axis) const {
        const __m256 plane = _mm256_load_ps(node.plane[farPlane_[axis]]);
        return _mm256_fmadd_ps(plane, reciprocal_[axis], farShift_[axis]);
    }

    __m256 reciprocal_[3], nearShift_[3], farShift_[3];
    int nearPlane_[3], farPlane_[3];
};

#else

class BoxTester {
  public:
    explicit BoxTester(const BoxRay& ray) : ray_(ray) {}

    /// Bit i is set where box i meets the ray at some tau in [tauMin, tauMax]; `entry` is where.
    unsigned meet(const WideNode& node, float tauMin, float tauMax, float entry[kTreeWidth]) const {
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
        return mask;
    }

  private:
    const BoxRay& ray_;
};

#endif

}  // namespace rt
