// How bright a compiled scene can get.
#pragma once

#include "rt/trace/render_scene.h"

namespace rt {

/// The values of two paths differ by no more than this in any channel: all lie between 0 and this,
/// or, where the scene has a colour below zero, within half of it from 0. A hit's value is a
/// weighted mean of own colours and of the sky, so the bound follows from the brightest own colour
/// or sky:
///     kd ambient + sum over lights of 2 I / (c0 + c1 d + c2 d^2) (kd max(1, brightness) + ks),
/// with d at least the light's radius and its distance from all objects; without the 2 for points.
double radianceBound(const RenderScene& scene);

/// The largest share of irradiance that a surface shows, in any channel.
double localBound(const RenderScene& scene);

}  // namespace rt
