#include "ear_clipper.h"

namespace rt {
namespace {

// A search of the tree takes some tens of steps.
constexpr std::uint64_t kStepsPerCorner = 512;

// What is left of the steps each time that no corner of area is an ear: the polygon then crosses
// itself, and looking on brings little.
constexpr std::uint64_t kPatience = 8;

}  // namespace

EarClipper::EarClipper(std::span<const Vec2> polygon)
    : points_(polygon),
      previous_(polygon.size()),
      next_(polygon.size()),
      reflex_(polygon.size()),
      reflexTree_(polygon, reflexCorners()) {}

/// Links the corners into a ring on the way.
std::vector<Index> EarClipper::reflexCorners() {
    const Index count = static_cast<Index>(points_.size());
    std::vector<Index> corners;
    for (Index i = 0; i < count; ++i) {
        previous_[i] = i == 0 ? count - 1 : i - 1;
        next_[i] = i + 1 == count ? 0 : i + 1;
        reflex_[i] = !(turnAt(i) > 0.0);
        if (reflex_[i]) corners.push_back(i);
    }
    return corners;
}

double EarClipper::turnAt(Index i) const {
    return orientation(points_[previous_[i]], points_[i], points_[next_[i]]);
}

bool EarClipper::isEar(Index i) {
    ++looks_;
    if (reflex_[i]) return false;
    return !reflexTree_.anyIn({points_[previous_[i]], points_[i], points_[next_[i]]});
}

/// Corners only ever become convex while ears are cut off.
void EarClipper::settle(Index i) {
    if (!reflex_[i] || !(turnAt(i) > 0.0)) return;
    reflex_[i] = false;
    reflexTree_.remove(i);
}

void EarClipper::cut(Index i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    reflexTree_.remove(i);
    settle(previous_[i]);
    settle(next_[i]);
}

void EarClipper::clip(std::vector<std::array<Index, 3>>& triangles) {
    std::uint64_t mostSteps = kStepsPerCorner * points_.size();
    std::size_t left = points_.size();
    std::size_t fruitless = 0;
    Index i = 0;
    while (left > 3) {
        const std::uint64_t steps = looks_ + reflexTree_.steps();
        if (steps < mostSteps && !isEar(i)) {
            i = next_[i];
            if (++fruitless < left) continue;
            if (turnAt(i) != 0.0) mostSteps = steps + (mostSteps - steps) / kPatience;
        }
        triangles.push_back({previous_[i], i, next_[i]});
        cut(i);
        --left;
        fruitless = 0;
        // Leaving out the neighbour keeps one corner from collecting all slivers.
        i = next_[next_[i]];
    }
    triangles.push_back({previous_[i], i, next_[i]});
}

}  // namespace rt
