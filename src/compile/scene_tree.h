// Boxes of what a scene places, and the tree over them.
#pragma once

#include "rt/trace/render_scene.h"

namespace rt {

/// Fills what the scene knows of the extents of its shapes, instances and motions, and builds the
/// tree. The shapes, looks and motions are there already.
void buildSceneTree(RenderScene& scene, int threads);

}  // namespace rt
