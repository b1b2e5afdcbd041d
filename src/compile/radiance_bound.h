// How bright a compiled scene can get.
#pragma once

#include "rt/trace/render_scene.h"

namespace rt {

/// No path brings more than this in any channel. A hit's value is a weighted mean of own colours
/// and of the sky, so the bound is that of the brightest own colour or sky:
///     kd ambient + sum over lights of 2 I / (c0 + c1 d + c2 d^2) (kd max(1, brightness) + ks),
/// with d at least the light's radius and its distance from all objects; without the 2 for points.
double radianceBound(const RenderScene& scene);

}  // namespace rt
