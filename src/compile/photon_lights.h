// Which lights of a compiled scene throw caustics.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/trace/render_scene.h"

namespace rt {

/// Lets lights send photons where there is anything to send them on, all of it at rest: a photon's
/// moment is not that of a sample. A sun sends none where what sends on has no bounds, for it would
/// have to send them everywhere. Warns, at `where` the scene is rendered, of what is left out.
void sendByPhotons(RenderScene& scene, const SourceLocation& where, Diagnostics& diagnostics);

}  // namespace rt
