// Unions, intersections and differences of nodes -> solids that rays can be asked of.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"
#include "rt/trace/csg_shape.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rt {

/// One solid is made of no more nodes than this, each counted as often as it is reached.
inline constexpr std::size_t kMostCsgNodes = 65536;
/// Nodes within nodes, to this depth.
inline constexpr std::size_t kMostCsgDepth = 1000;

/// What a leaf's surface looks like, as far as the nodes below the whole have said.
struct CsgLeafLook {
    Index node = kNone;  ///< the leaf's
    AppearanceDesc appearance;
    Affine patternSpace;  ///< from the whole's space to that of the node that gave the appearance
    std::optional<double> reflection;
};

struct BuiltCsg {
    std::shared_ptr<const CsgShape> shape;  ///< none where nothing is left
    std::vector<CsgLeafLook> looks;         ///< of its leaves
};

/// What the compiler of the scene lends.
struct CsgSources {
    const SceneDesc& scene;
    std::size_t render;
    Diagnostics& diagnostics;
    /// False for what is flat.
    std::function<bool(const NodeDesc&, const Affine&, Transform&)> place;
    /// Of a geometry that is no combined solid; nullptr for a mesh without triangles.
    std::function<const Shape*(Index geometry)> shape;
};

/// The solid of a node that combines others. Throws SceneError, with the line of the call that
/// combines, for what bounds no solid and for what moves within the whole; LimitError beyond
/// kMostCsgNodes and kMostCsgDepth.
BuiltCsg buildCsg(const CsgSources& sources, Index node);

}  // namespace rt
