// The expression of a combined solid while it is put together.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/vec.h"

#include <cstddef>
#include <vector>

namespace rt {

inline constexpr std::size_t kFewParts = 8;

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
    /// A union of more than are tried one after another faster than a tree is walked.
    bool isCrowd() const { return kind == Kind::kAny && children.size() > kFewParts; }
};

CsgPart csgLeaf(Index leaf, const Bounds& bounds, double rounding);
/// All of the parts together.
CsgPart csgUnion(std::vector<CsgPart> parts);
/// What is in each of the parts and, of those that are negated, in none; one at least is not.
CsgPart csgIntersection(std::vector<CsgPart> parts);
/// The same solid, in which what is taken away from one, where it is many, is taken away as a
/// union.
CsgPart csgGathered(CsgPart whole);

}  // namespace rt
