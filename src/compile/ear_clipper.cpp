#include "ear_clipper.h"

#include "rt/core/numeric.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr std::uint64_t kStepsPerCorner = 1024;
constexpr int kMostCellsPerSide = 1024;

/// Nearest cell of a coordinate; NaN gives 0.
int cellOf(double cells, int count) {
    return cells > 0.0 ? static_cast<int>(std::min(cells, count - 1.0)) : 0;
}

}  // namespace

double orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    return differenceOfProducts(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x);
}

EarClipper::EarClipper(std::span<const Vec2> polygon)
    : points_(polygon), previous_(polygon.size()), next_(polygon.size()), reflex_(polygon.size()) {
    const Index count = static_cast<Index>(polygon.size());
    for (Index i = 0; i < count; ++i) {
        previous_[i] = i == 0 ? count - 1 : i - 1;
        next_[i] = i + 1 == count ? 0 : i + 1;
    }
    for (Index i = 0; i < count; ++i) {
        reflex_[i] = !(turnAt(i) > 0.0);
        reflexCount_ += reflex_[i];
    }
    buildGrid();
}

double EarClipper::turnAt(Index i) const {
    return orientation(points_[previous_[i]], points_[i], points_[next_[i]]);
}

void EarClipper::buildGrid() {
    Vec2 min(points_[0]);
    Vec2 max(points_[0]);
    for (const Vec2& p : points_) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    const double side = std::sqrt(static_cast<double>(reflexCount_));
    cellsPerSide_ = std::clamp(static_cast<int>(side), 1, kMostCellsPerSide);
    gridMin_ = min;
    cellsPerUnit_ = static_cast<double>(cellsPerSide_) / (max - min);
    reflexAtBuild_ = reflexCount_;

    const auto cellAt = [&](Index i) {
        const Cells cells = cellsOf(points_[i], points_[i]);
        return static_cast<std::size_t>(cells.minY * cellsPerSide_ + cells.minX);
    };
    const std::size_t cellCount = static_cast<std::size_t>(cellsPerSide_ * cellsPerSide_);
    cellFirst_.assign(cellCount + 1, 0);
    cellMembers_.resize(reflexCount_);
    const Index count = static_cast<Index>(points_.size());
    for (Index i = 0; i < count; ++i) {
        if (reflex_[i]) ++cellFirst_[cellAt(i)];
    }
    for (std::size_t c = 0; c < cellCount; ++c) cellFirst_[c + 1] += cellFirst_[c];
    for (Index i = 0; i < count; ++i) {
        if (reflex_[i]) cellMembers_[--cellFirst_[cellAt(i)]] = i;
    }
}

EarClipper::Cells EarClipper::cellsOf(const Vec2& min, const Vec2& max) const {
    const Vec2 from = (min - gridMin_) * cellsPerUnit_;
    const Vec2 to = (max - gridMin_) * cellsPerUnit_;
    return {cellOf(from.x, cellsPerSide_), cellOf(from.y, cellsPerSide_),
            cellOf(to.x, cellsPerSide_), cellOf(to.y, cellsPerSide_)};
}

/// Whether a reflex corner lies in the closed ear, other than at one of its corners.
bool EarClipper::blocks(Index reflex, const std::array<Index, 3>& ear) const {
    const Vec2& p = points_[reflex];
    const Vec2& a = points_[ear[0]];
    const Vec2& b = points_[ear[1]];
    const Vec2& c = points_[ear[2]];
    if (p == a || p == b || p == c) return false;
    return orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 &&
           orientation(c, a, p) >= 0.0;
}

bool EarClipper::cellBlocks(std::size_t cell, const std::array<Index, 3>& ear) {
    ++steps_;
    for (Index m = cellFirst_[cell]; m < cellFirst_[cell + 1]; ++m) {
        const Index i = cellMembers_[m];
        ++steps_;
        if (reflex_[i] && blocks(i, ear)) return true;
    }
    return false;
}

bool EarClipper::isEar(Index i) {
    ++steps_;
    if (reflex_[i]) return false;
    const std::array<Index, 3> ear = {previous_[i], i, next_[i]};
    const Vec2& a = points_[ear[0]];
    const Vec2& b = points_[ear[1]];
    const Vec2& c = points_[ear[2]];
    const Cells cells = cellsOf(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c));
    for (int y = cells.minY; y <= cells.maxY; ++y) {
        for (int x = cells.minX; x <= cells.maxX; ++x) {
            if (cellBlocks(static_cast<std::size_t>(y * cellsPerSide_ + x), ear)) return false;
        }
    }
    return true;
}

/// Where nothing is an ear: a corner whose triangle has no area, else one that turns left.
Index EarClipper::leastHarm(Index start) const {
    Index convex = start;
    Index i = start;
    do {
        const double turn = turnAt(i);
        if (turn == 0.0) return i;
        if (turn > 0.0) convex = i;
        i = next_[i];
    } while (i != start);
    return convex;
}

void EarClipper::cut(Index i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    reflexCount_ -= reflex_[i];
    reflex_[i] = 0;
    for (const Index neighbour : {previous_[i], next_[i]}) {
        if (!reflex_[neighbour] || !(turnAt(neighbour) > 0.0)) continue;
        reflex_[neighbour] = 0;
        --reflexCount_;
    }
    if (4 * reflexCount_ < reflexAtBuild_) buildGrid();
}

void EarClipper::clip(std::vector<std::array<Index, 3>>& triangles) {
    const std::uint64_t mostSteps = kStepsPerCorner * points_.size();
    std::size_t left = points_.size();
    std::size_t fruitless = 0;
    Index i = 0;
    while (left > 3) {
        const bool tired = steps_ > mostSteps;
        if (!tired && !isEar(i)) {
            i = next_[i];
            if (++fruitless < left) continue;
            i = leastHarm(i);
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
