// The node graph, a DAG with appearance on its edges, walked down to the objects that it places.
#pragma once

#include "rt/scene/scene_desc.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace rt {

/// One geometry node as reached on one way down from the root.
struct PlacedNode {
    Index node = kNone;
    Affine toWorld;
    MotionPath motion;          ///< in the world, while the shutter is open
    AppearanceDesc appearance;  ///< the last edge's, where it says something, over the node's own
};

/// What an edge says hides the child's own: a material or a texture hides both, a bump map the
/// bump.
AppearanceDesc over(const AppearanceDesc& edge, const AppearanceDesc& own);

/// How many objects the graph below `root` places, as render number `render` sees it; counted
/// without walking every way, so a DAG of 2^40 ways costs no more than its nodes. Saturates.
std::uint64_t countPlaced(const SceneDesc& scene, Index root, std::size_t render);

/// Calls visit for each of them: a node before its children, children in order.
void forEachPlaced(const SceneDesc& scene, Index root, std::size_t render,
                   const std::function<void(const PlacedNode&)>& visit);

}  // namespace rt
