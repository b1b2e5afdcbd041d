// One binary split of a run of boxes: where the surface area heuristic wants it, and doing it.
#pragma once

#include "build_box.h"

#include <cstddef>
#include <cstdint>

namespace rt {

/// What the heuristic weighs: the cost of a node's box test, and of a block of items. A leaf of n
/// items costs ceil(n / blockSize) blocks.
struct BuildCosts {
    float node = 1.0f;
    float block = 1.0f;
    std::uint32_t blockSize = 1;

    float leaf(std::size_t count) const {
        return block * static_cast<float>((count + blockSize - 1) / blockSize);
    }
};

/// A run of refs, with the bounds of their boxes and of their (doubled) centres.
struct RefRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    Box4 box;
    Box4 centres;

    std::size_t size() const { return end - begin; }
    void add(const BoxRef& ref) {
        box.unite(ref.box);
        centres.unite(ref.centre());
    }
};

/// Refs go left where their bin on `axis` is below `bin`.
struct Split {
    static constexpr int kNone = -1;
    static constexpr int kMaxBins = 32;

    int axis = kNone;
    int bin = 0;
    int bins = 0;
    /// Sum over both sides of area times leaf cost.
    float cost = std::numeric_limits<float>::infinity();

    bool exists() const { return axis != kNone; }
};

/// Maps doubled centres to bins, alike for counting and for sorting.
class BinMap {
  public:
    BinMap(const Box4& centres, int bins);

    /// The bins on the three axes.
    Int4 bins(Float4 centre) const { return toInts(min4((centre - base_) * perUnit_, last_)); }
    bool splits(int axis) const { return perUnit_[axis] > 0.0f; }

  private:
    Float4 base_;
    Float4 perUnit_;  ///< 0 on an axis on which all centres are alike
    Float4 last_;
};

/// The best split of `range`, whose refs start at `refs`; none where all centres coincide.
Split findSplit(const BoxRef* refs, const RefRange& range, const BuildCosts& costs, int threads);

/// The two halves of `range`, after reordering its refs.
struct Halves {
    RefRange left, right;
};
Halves divide(BoxRef* refs, const RefRange& range, const Split& split, int threads);

/// Cuts a range in the middle, as its refs lie: for boxes that no plane can tell apart.
Halves divideInOrder(const BoxRef* refs, const RefRange& range);

/// Bounds of refs[begin, end).
RefRange measureRange(const BoxRef* refs, std::size_t begin, std::size_t end, int threads);

}  // namespace rt
