// Images that functions of a script paint, once it has ended.
#pragma once

#include "scene_builder.h"
#include "trampoline.h"

namespace rt {

inline constexpr double kMostPaintedSide = 8192.0;

/// Keeps the function in this slot for paintImages; its number.
int keepFunction(lua_State* L, int slot);

/// Calls each function (u, v) at the centres of the texels. Where the script does not say how many
/// texels, it starts with few and doubles their number along a side until the image's bilinear
/// value meets the function at the next texels to 1/512, half a step of 8 bits, or until there is a
/// texel for each pixel along the larger side of the largest render. Throws SceneError, with the
/// line of the texture, for values that are not finite numbers.
void paintImages(lua_State* L, SceneBuilder& builder);

}  // namespace rt
