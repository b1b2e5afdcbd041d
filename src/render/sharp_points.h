// Where the outline of a shape may come to a point.
#pragma once

#include "rt/trace/render_scene.h"

#include <vector>

namespace rt {

/// Appends the points of a shape, in its own space, at which its outline may have a corner when it
/// is seen from `eye`: the corners of a box, the points of a rim at which the side turns away, and
/// the vertices of a mesh that has few. Not the apex of a cone, which may be narrow further on.
void addSharpPoints(const Shape& shape, const Vec3& eye, std::vector<Vec3>& points);

}  // namespace rt
