// One look at a corner of the pixel grid: what neighbouring pixels share where nothing but smooth
// shading lies between their corners.
#pragma once

#include "rt/core/vec.h"

#include <glm/ext/vector_float3.hpp>

#include <cmath>
#include <cstdint>

namespace rt {

/// Narrower than this, in pixels, a thing may pass between corners, or show in too few of them.
inline constexpr double kNarrowPixels = 3.0;

/// What a probe has seen, as bits of `Probe::marks`.
enum ProbeMark : std::uint32_t {
    kProbeHit = 1u << 0,        ///< the camera ray hit something
    kProbeDetail = 1u << 1,     ///< finer than a pixel, for all that is known: never smooth
    kProbeUncertain = 1u << 2,  ///< some light was neither proved lit nor proved dark
};

/// Whether sums of single precision take this, and their squares.
inline bool fitsProbe(const Color& sum) {
    constexpr double kLargest = 0x1p56;
    return std::fabs(sum.x) < kLargest && std::fabs(sum.y) < kLargest &&
           std::fabs(sum.z) < kLargest;
}

/// The colour seen through a corner, as the sums of single samples of the lights, and evidence of
/// what surrounds it. Colours are kept in single precision: a probe is off by 2^-23 of its value,
/// far below what an image file holds.
struct Probe {
    glm::vec3 sum{0.0F};   ///< of `samples` colours, each with its own point on every light
    glm::vec3 half{0.0F};  ///< the first half of them
    std::uint32_t samples = 0;
    std::uint32_t marks = 0;
    /// Names the surfaces that the tree of paths met, and in what order.
    std::uint64_t surfaces = 0;
    /// One bit for each (hit, light), in order, modulo 64: proved wholly lit; proved wholly dark.
    std::uint64_t lit = 0;
    std::uint64_t dark = 0;
    glm::vec3 position{0.0F};  ///< of the camera ray's hit, relative to the eye
    glm::vec3 normal{0.0F};    ///< geometric, there

    glm::vec3 mean() const { return samples ? sum * (1.0F / static_cast<float>(samples)) : sum; }
    bool has(ProbeMark mark) const { return (marks & mark) != 0; }
};

}  // namespace rt
