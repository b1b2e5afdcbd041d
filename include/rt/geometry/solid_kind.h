// What the renderer takes from a primitive's form, beside its crossings.
#pragma once

namespace rt {

struct SolidKind {
    /// Lies behind each of its tangent planes, and hides all between two points that it hides.
    bool convex = true;
    /// Bounds a solid; a primitive that does not is a sheet.
    bool closed = true;
    /// The axis that it is round about: a cylinder about it as wide as its bounds holds it; -1
    /// none.
    int axis = -1;
    /// Has bounds; what has none is asked for every ray.
    bool bounded = true;
};

}  // namespace rt
