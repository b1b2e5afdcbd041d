// Lights: spheres and points, spots, the sun, rectangles. None of them can be seen itself.
#pragma once

#include "rt/core/vec.h"

#include <cstdint>

namespace rt {

enum class LightKind : std::uint8_t { kBall, kSpot, kSun, kRectangle };

/// Irradiance at distance d from the centre: intensity / (c0 + c1 d + c2 d^2), d at least `radius`.
/// The other kinds are made by spotLight, sunLight and rectangleLight.
struct Light {
    Vec3 position{0.0};  ///< the centre; nothing to a sun
    Color intensity{0.0};
    double c0 = 1.0;
    double c1 = 0.0;
    double c2 = 0.0;
    double radius = 0.0;  ///< of the sphere; of a rectangle, of the sphere around it
    /// Floor of n.w in the diffuse term.
    double brightness = 0.0;

    /// What of it passes through refracting objects comes as photons, not straight.
    bool byPhotons = false;

    LightKind kind = LightKind::kBall;
    Vec3 direction{0.0};  ///< unit, the way that a spot's or a sun's light goes
    double inner = 0.0;   ///< half-angle up to which a spot gives its full light, in radians
    double outer = 0.0;   ///< half-angle of a spot from which on it gives none, in radians
    double innerCosine = 1.0;
    double outerCosine = 1.0;
    double oneMinusCos = 0.0;  ///< 1 - cos A of a sun's half-angle A
    Vec3 halfU{0.0};           ///< from a rectangle's centre to the middle of a side,
    Vec3 halfV{0.0};           ///< and of the one next to it
};

/// Whether all of the light comes from one point, or from one direction.
bool isPointLike(const Light& light);

/// `ball` about the unit `direction` alone: its light times the smooth step s^2 (3 - 2 s), with
/// s = (cos t - cos outer) / (cos inner - cos outer) clamped to [0, 1] and t the angle at the
/// centre between `direction` and what is lit. 0 <= inner <= outer <= 180, in degrees; where they
/// are equal, the edge is sharp. Pharr, Jakob, Humphreys, Physically Based Rendering, 4th edition,
/// 2023, section 12.2.1.
Light spotLight(Light ball, const Vec3& direction, double innerDegrees, double outerDegrees);

/// A light of the same irradiance everywhere, from all of the disc of this half-angle (0 <= A < 90
/// degrees) in the sky about -direction, in the mean of the light's equation over it. `direction`
/// is unit.
Light sunLight(const Vec3& direction, const Color& intensity, double halfAngleDegrees,
               double brightness);

/// The mean over the points of a rectangle (any parallelogram), uniform by area, of the light that
/// a point light of this intensity and falloff there would give; it shines to both sides. `u` and
/// `v` are its sides from `corner`.
Light rectangleLight(Light point, const Vec3& corner, const Vec3& u, const Vec3& v);

}  // namespace rt
