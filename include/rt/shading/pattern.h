// Colours that a formula gives to each point of an object's own space. With p the point, s the
// size, d the unit direction and N the noise below, the colour is first + (second - first) w:
//
//     checker    w = (floor(x/s) + floor(y/s) + floor(z/s)) mod 2
//     stripes    w = floor(p.d / s) mod 2
//     gradient   w = p.d / s, within 0 .. 1
//     noise      w = (1 + sum 2^-i N(2^i p/s) / sum 2^-i) / 2, i = 0 .. octaves - 1, within 0 .. 1
//     marble     w = (1 + sin 2 pi (p.d / s + turbulence sum 2^-i |N(2^i p/s)|)) / 2
//     wood       w = (1 - cos 2 pi (|p - (p.d) d| / s + turbulence sum 2^-i N(2^i p/s))) / 2
//
// N: gradient noise of the lattice of whole numbers, twice continuously differentiable, 0 at its
// points, within -1 .. 1, the same again after 256.
// Perlin, An Image Synthesizer, SIGGRAPH 1985 (turbulence, marble); Perlin, Improving Noise,
// SIGGRAPH 2002 (N).
#pragma once

#include "rt/core/vec.h"

#include <cstdint>

namespace rt {

enum class PatternKind : std::uint8_t { kChecker, kStripes, kGradient, kNoise, kMarble, kWood };

/// Perlin's noise of 2002; 0 beyond where doubles tell whole numbers apart.
double gradientNoise(const Vec3& p);

struct Pattern {
    PatternKind kind = PatternKind::kChecker;
    Color first{0.0};
    Color second{1.0};
    double size = 1.0;
    Vec3 direction{1.0, 0.0, 0.0};  ///< unit
    double turbulence = 0.0;
    int octaves = 1;

    Color at(const Vec3& p) const;

    /// The mean over the parallelogram `across`, `down` in which p lies at `phase` (0 .. 1 along
    /// each side), from one tap in each of its cells, which are as small as half of the pattern's
    /// finest part, but at most kMostTaps along a side. For a phase that is uniform the expectation
    /// is exactly the mean. A side that is not finite has one tap.
    Color mean(const Vec3& p, const Vec3& across, const Vec3& down, const Vec2& phase) const;
    static constexpr int kMostTaps = 8;

  private:
    double weight(const Vec3& p) const;
    int tapsAlong(const Vec3& side) const;
};

}  // namespace rt
