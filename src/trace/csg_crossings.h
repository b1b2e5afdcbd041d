// Where a line crosses the surfaces of the leaves of a combined solid.
#pragma once

#include "rt/accel/traverse.h"
#include "rt/trace/csg_shape.h"
#include "small_list.h"

namespace rt {

using CrossingList = SmallList<PrimitiveHit, 16>;

/// Adds all crossings of the ray's whole line with a leaf; an even number, each of them from one
/// side of its surface to the other, in order. `ray` is in the space of the whole; `label` becomes
/// the hits' leaf. Whether there are any.
bool addLeafCrossings(const CsgLeaf& leaf, Index label, const Ray& ray, CrossingList& crossings);

/// Calls test(child, Interval now) -> double for those whose boxes meet the ray, as
/// traverseClosest does.
template <class Test>
void visitCrowd(const CsgCrowd& crowd, const Ray& ray, Interval range, const Test& test) {
    traverseClosest(crowd.tree, ray, range,
                    [&](Index item, Interval now) { return test(crowd.children[item], now); });
}

}  // namespace rt
