// The expression of a combined solid while it is put together.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/vec.h"

#include <vector>

namespace rt {

/// A solid: a leaf, or what its children make. Without a leaf and without children, nothing.
struct CsgPart {
    enum class Kind { kLeaf, kAny, kAll };

    Kind kind = Kind::kAny;
    bool negated = false;  ///< its parent takes it away
    Index leaf = kNone;
    Bounds bounds;
    double rounding = 0.0;  ///< as PaddedBox has it
    std::vector<CsgPart> children;

    bool isEmpty() const { return kind != Kind::kLeaf && children.empty(); }
};

CsgPart csgLeaf(Index leaf, const Bounds& bounds, double rounding);
/// All of the parts together.
CsgPart csgUnion(std::vector<CsgPart> parts);
/// What is in each of the parts and, of those that are negated, in none; one at least is not.
CsgPart csgIntersection(std::vector<CsgPart> parts);

}  // namespace rt
