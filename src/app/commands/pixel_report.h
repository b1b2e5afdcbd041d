// The rays behind one pixel, as --pixel shows them.
#pragma once

#include "rt/scene/scene_desc.h"
#include "scene_renderer.h"

#include <functional>
#include <string>

namespace rt {

/// Traces the samples of the pixel again, one after another, and hands on what there is to say of
/// them, whole lines. `image` is the picture's name. std::logic_error if they are not what the
/// picture has.
void reportPixel(const PixelTrace& trace, const RenderScene& scene, const SceneDesc& desc,
                 const std::string& image, const std::function<void(const std::string&)>& print);

}  // namespace rt
