// Constructive solid geometry: unions, intersections and differences of solids, as one solid.
//
// A point is in the whole where an expression of which solids it is in says so. Along a line, all
// crossings of all solids are put in order, and the whole's own crossings are those at which the
// expression's value changes (Roth, Ray Casting for Modeling Solids, Computer Graphics and Image
// Processing 18, 1982). They depend on the line alone, not on where a ray on it starts.
//
// Crossings that are closer together than surfaces can be told apart (kCoincidence) are one: the
// value before all of them and the value after all of them count. So of a face that a difference's
// solids share nothing is left, and a union has no wall where its solids touch. Where the value
// changes at several surfaces, the one that is seen is that of the first leaf without which it
// would not have changed, or if there is none such, of the first that changes it by itself.
#pragma once

#include "rt/accel/padded_boxes.h"
#include "rt/accel/wide_tree.h"
#include "rt/core/transform.h"
#include "rt/trace/shape.h"

#include <vector>

namespace rt {

/// A solid within the whole; never a combined one.
struct CsgLeaf {
    Shape shape;
    Transform transform;     ///< into the whole's space
    bool insideOut = false;  ///< what it bounds is outside of the whole: a cavity's wall
};

/// A part of the expression: a leaf, or the solid that its children make. Children follow their
/// parent, those that count where they are met before those that count where they are not.
struct CsgNode {
    PaddedBox box;  ///< around it
    Index end = 0;  ///< of its descendants, which lie behind it
    Index leaf = kNone;
    Index crowd = kNone;   ///< its children again, where they are many; of a union alone
    Index needed = 1;      ///< so many children must count: 1 in a union, else all
    Index outside = 0;     ///< so many count at a point outside of all of them
    bool negated = false;  ///< counts for its parent where a point is outside of it

    bool needsAll() const { return needed > 1; }
};

/// The children of a union of many, to be met near ones first.
struct CsgCrowd {
    WideTree tree;
    std::vector<Index> children;  ///< nodes, by the tree's items
};

struct CsgShape {
    const char* name = "";  ///< "union", for people
    std::vector<CsgLeaf> leaves;
    std::vector<CsgNode> nodes;  ///< a parent before its children; the first is the whole
    std::vector<CsgCrowd> crowds;
    Bounds bounds;
    /// Magnitude of the coordinates that hits are computed from, beside those of the bounds.
    double rounding = 0.0;
    bool convex = false;
    /// The least extent of its parts, in its own space; 0 where nothing is known of it.
    double thickness = 0.0;
    /// The same, however little is left of its parts.
    double partThickness = 0.0;
};

/// The whole's nearest crossing in `range`; `hit` is one of the leaf that is seen there.
[[nodiscard]] bool intersectCsg(const CsgShape& csg, const Ray& ray, Interval range,
                                PrimitiveHit& hit);

/// The surface at a hit, in the whole's space, its normals away from the whole.
SurfacePoint csgSurface(const CsgShape& csg, const PrimitiveHit& hit, SurfaceDetail detail);

}  // namespace rt
