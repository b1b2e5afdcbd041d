#include "build_split.h"

#include "rt/core/parallel.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace rt {
namespace {

/// Refs to a job of a parallel loop: a constant, so that results do not depend on the threads.
constexpr std::size_t kChunk = std::size_t{1} << 14;
constexpr std::size_t kParallelFrom = 4 * kChunk;

std::size_t chunkCount(std::size_t size) {
    return (size + kChunk - 1) / kChunk;
}

/// Boxes and counts of the bins of three axes.
class BinSet {
  public:
    explicit BinSet(int bins) : bins_(bins) {
        for (int axis = 0; axis < 3; ++axis) {
            std::uninitialized_fill_n(box(axis), bins, Box4{});
            std::fill_n(count_[axis], bins, 0u);
        }
    }

    Box4* box(int axis) { return reinterpret_cast<Box4*>(storage_) + axis * Split::kMaxBins; }
    const Box4* box(int axis) const {
        return reinterpret_cast<const Box4*>(storage_) + axis * Split::kMaxBins;
    }
    const std::uint32_t* count(int axis) const { return count_[axis]; }

    void add(const BinMap& map, const BoxRef& ref) {
        const Int4 at = map.bins(ref.centre());
        for (int axis = 0; axis < 3; ++axis) {
            box(axis)[at[axis]].unite(ref.box);
            ++count_[axis][at[axis]];
        }
    }
    void add(const BinSet& other) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = 0; i < bins_; ++i) {
                box(axis)[i].unite(other.box(axis)[i]);
                count_[axis][i] += other.count_[axis][i];
            }
        }
    }

  private:
    int bins_;
    std::uint32_t count_[3][Split::kMaxBins];
    /// Only the bins in use are worth the time to initialise.
    alignas(Box4) std::byte storage_[3 * Split::kMaxBins * sizeof(Box4)];
};

/// Few items do not repay many bins.
int binsFor(std::size_t count) {
    return static_cast<int>(std::min<std::size_t>(Split::kMaxBins, 6 + count / 16));
}

void sweep(const BinSet& set, int axis, int bins, const BuildCosts& costs, Split& best) {
    float rightCost[Split::kMaxBins];
    Box4 box;
    std::size_t count = 0;
    for (int i = bins - 1; i > 0; --i) {
        box.unite(set.box(axis)[i]);
        count += set.count(axis)[i];
        rightCost[i] = count > 0 ? box.halfArea() * costs.leaf(count) : Box4::kFar;
    }
    box = {};
    count = 0;
    for (int i = 1; i < bins; ++i) {
        box.unite(set.box(axis)[i - 1]);
        count += set.count(axis)[i - 1];
        if (count == 0) continue;
        const float cost = box.halfArea() * costs.leaf(count) + rightCost[i];
        if (cost < best.cost) best = {axis, i, bins, cost};
    }
}

Halves emptyHalves(const RefRange& range, std::size_t middle) {
    Halves halves;
    halves.left.begin = range.begin;
    halves.left.end = halves.right.begin = middle;
    halves.right.end = range.end;
    return halves;
}

void joinBounds(RefRange& range, const RefRange& part) {
    range.box.unite(part.box);
    range.centres.unite(part.centres);
}

/// Tells which side of a split a ref belongs to.
class Sides {
  public:
    Sides(const RefRange& range, const Split& split)
        : map_(range.centres, split.bins), axis_(split.axis), bin_(split.bin) {}
    bool isLeft(const BoxRef& ref) const { return map_.bins(ref.centre())[axis_] < bin_; }

  private:
    BinMap map_;
    int axis_;
    int bin_;
};

/// Sorts refs[begin, end) in place, from both ends.
Halves divideRun(BoxRef* refs, std::size_t begin, std::size_t end, const Sides& sides) {
    RefRange left, right;
    std::size_t low = begin;
    std::size_t high = end;
    for (;;) {
        while (low < high && sides.isLeft(refs[low])) left.add(refs[low++]);
        while (low < high && !sides.isLeft(refs[high - 1])) right.add(refs[--high]);
        if (low == high) break;
        std::swap(refs[low], refs[high - 1]);
    }
    left.begin = begin;
    left.end = right.begin = low;
    right.end = end;
    return {left, right};
}

using Runs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Swaps the refs number `from` to `to` of two lists of runs.
void swapRuns(BoxRef* refs, const Runs& a, const Runs& b, std::size_t from, std::size_t to) {
    const auto seek = [&](const Runs& runs, std::size_t& run) {
        std::size_t skip = from;
        for (run = 0; runs[run].second - runs[run].first <= skip; ++run) {
            skip -= runs[run].second - runs[run].first;
        }
        return runs[run].first + skip;
    };
    std::size_t runA, runB;
    std::size_t i = seek(a, runA);
    std::size_t j = seek(b, runB);
    for (std::size_t left = to - from; left > 0; --left) {
        std::swap(refs[i++], refs[j++]);
        if (left == 1) break;
        if (i == a[runA].second) i = a[++runA].first;
        if (j == b[runB].second) j = b[++runB].first;
    }
}

/// Sorts chunks by themselves, then exchanges what lies on the wrong side of the middle.
Halves divideInParallel(BoxRef* refs, const RefRange& range, const Sides& sides, int threads) {
    const std::size_t chunks = chunkCount(range.size());
    std::vector<Halves> parts(chunks);
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        const std::size_t begin = range.begin + chunk * kChunk;
        parts[chunk] = divideRun(refs, begin, std::min(range.end, begin + kChunk), sides);
    });
    std::size_t middle = range.begin;
    for (const Halves& part : parts) middle += part.left.size();
    Halves halves = emptyHalves(range, middle);
    Runs wrongRights, wrongLefts;
    std::size_t wrong = 0;
    for (const Halves& part : parts) {
        joinBounds(halves.left, part.left);
        joinBounds(halves.right, part.right);
        if (part.right.begin < std::min(part.right.end, middle)) {
            wrongRights.emplace_back(part.right.begin, std::min(part.right.end, middle));
            wrong += wrongRights.back().second - wrongRights.back().first;
        }
        if (std::max(part.left.begin, middle) < part.left.end) {
            wrongLefts.emplace_back(std::max(part.left.begin, middle), part.left.end);
        }
    }
    forEachIndex(chunkCount(wrong), threads, [&](std::size_t job, int) {
        swapRuns(refs, wrongRights, wrongLefts, job * kChunk, std::min(wrong, (job + 1) * kChunk));
    });
    return halves;
}

}  // namespace

BinMap::BinMap(const Box4& centres, int bins) : base_(centres.lo), perUnit_{} {
    const float last = static_cast<float>(bins - 1);
    last_ = Float4{last, last, last, last};
    base_[3] = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = centres.hi[axis] - centres.lo[axis];
        const float perUnit = static_cast<float>(bins) / extent;
        // Too flat to tell bins apart, or flat altogether.
        perUnit_[axis] = extent > 0.0f && perUnit < Box4::kFar ? perUnit : 0.0f;
    }
}

Split findSplit(const BoxRef* refs, const RefRange& range, const BuildCosts& costs, int threads) {
    const int bins = binsFor(range.size());
    const BinMap map(range.centres, bins);
    BinSet set(bins);
    if (range.size() < kParallelFrom) {
        for (std::size_t i = range.begin; i < range.end; ++i) set.add(map, refs[i]);
    } else {
        // Unions and sums do not depend on the order.
        const std::size_t chunks = chunkCount(range.size());
        const std::size_t jobs = std::min<std::size_t>(chunks, 64);
        std::vector<BinSet> parts(jobs, BinSet(bins));
        forEachIndex(jobs, threads, [&](std::size_t job, int) {
            const std::size_t begin = range.begin + range.size() * job / jobs;
            const std::size_t end = range.begin + range.size() * (job + 1) / jobs;
            for (std::size_t i = begin; i < end; ++i) parts[job].add(map, refs[i]);
        });
        for (const BinSet& part : parts) set.add(part);
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (map.splits(axis)) sweep(set, axis, bins, costs, best);
    }
    return best;
}

Halves divide(BoxRef* refs, const RefRange& range, const Split& split, int threads) {
    const Sides sides(range, split);
    if (range.size() < kParallelFrom) return divideRun(refs, range.begin, range.end, sides);
    return divideInParallel(refs, range, sides, threads);
}

Halves divideInOrder(const BoxRef* refs, const RefRange& range) {
    Halves halves = emptyHalves(range, range.begin + range.size() / 2);
    for (RefRange* half : {&halves.left, &halves.right}) {
        for (std::size_t i = half->begin; i < half->end; ++i) half->add(refs[i]);
    }
    return halves;
}

RefRange measureRange(const BoxRef* refs, std::size_t begin, std::size_t end, int threads) {
    const std::size_t chunks = chunkCount(end - begin);
    std::vector<RefRange> parts(chunks);
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        const std::size_t from = begin + chunk * kChunk;
        const std::size_t to = std::min(end, from + kChunk);
        for (std::size_t i = from; i < to; ++i) parts[chunk].add(refs[i]);
    });
    RefRange range;
    range.begin = begin;
    range.end = end;
    for (const RefRange& part : parts) joinBounds(range, part);
    return range;
}

}  // namespace rt
