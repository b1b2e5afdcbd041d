#include "build_split.h"

#include "rt/core/parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rt {
namespace {

/// Refs to a job of a parallel loop: a constant, so that results do not depend on the threads.
constexpr std::size_t kChunk = std::size_t{1} << 14;
constexpr std::size_t kParallelFrom = 4 * kChunk;

std::size_t chunkCount(std::size_t size) {
    return (size + kChunk - 1) / kChunk;
}

struct Bin {
    Box4 box;
};

struct BinSet {
    Bin bin[3][Split::kMaxBins];
    std::uint32_t count[3][Split::kMaxBins] = {};

    void add(const BinMap& map, const BoxRef& ref) {
        const Float4 centre = ref.centre();
        for (int axis = 0; axis < 3; ++axis) {
            const int at = map.bin(centre, axis);
            bin[axis][at].box.unite(ref.box);
            ++count[axis][at];
        }
    }
    void add(const BinSet& other, int bins) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = 0; i < bins; ++i) {
                bin[axis][i].box.unite(other.bin[axis][i].box);
                count[axis][i] += other.count[axis][i];
            }
        }
    }
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
        box.unite(set.bin[axis][i].box);
        count += set.count[axis][i];
        rightCost[i] = count > 0 ? box.halfArea() * costs.leaf(count) : Box4::kFar;
    }
    box = {};
    count = 0;
    for (int i = 1; i < bins; ++i) {
        box.unite(set.bin[axis][i - 1].box);
        count += set.count[axis][i - 1];
        if (count == 0) continue;
        const float cost = box.halfArea() * costs.leaf(count) + rightCost[i];
        if (cost < best.cost) best = {axis, i, bins, cost};
    }
}

Halves emptyHalves(const RefRange& range, std::size_t middle, bool inSpare) {
    Halves halves;
    halves.left.begin = range.begin;
    halves.left.end = halves.right.begin = middle;
    halves.right.end = range.end;
    halves.left.inSpare = halves.right.inSpare = inSpare;
    return halves;
}

void joinBounds(RefRange& range, const RefRange& part) {
    range.box.unite(part.box);
    range.centres.unite(part.centres);
}

/// Sorts in place, from both ends.
Halves divideInPlace(BoxRef* refs, const RefRange& range, const BinMap& map, const Split& split) {
    const auto goesLeft = [&](const BoxRef& ref) {
        return map.bin(ref.centre(), split.axis) < split.bin;
    };
    RefRange left, right;
    std::size_t low = range.begin;
    std::size_t high = range.end;
    for (;;) {
        while (low < high && goesLeft(refs[low])) left.add(refs[low++]);
        while (low < high && !goesLeft(refs[high - 1])) right.add(refs[--high]);
        if (low == high) break;
        std::swap(refs[low], refs[high - 1]);
    }
    Halves halves = emptyHalves(range, low, range.inSpare);
    joinBounds(halves.left, left);
    joinBounds(halves.right, right);
    return halves;
}

/// Sorts into the other buffer, chunk by chunk, keeping the order within each side.
Halves divideInParallel(const BoxRef* refs, BoxRef* spare, const RefRange& range, const BinMap& map,
                        const Split& split, int threads) {
    const std::size_t chunks = chunkCount(range.size());
    const auto chunkEnd = [&](std::size_t chunk) {
        return std::min(range.end, range.begin + (chunk + 1) * kChunk);
    };
    const auto goesLeft = [&](const BoxRef& ref) {
        return map.bin(ref.centre(), split.axis) < split.bin;
    };
    std::vector<std::size_t> lefts(chunks + 1, 0);
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        const std::size_t begin = range.begin + chunk * kChunk;
        lefts[chunk + 1] =
            static_cast<std::size_t>(std::count_if(refs + begin, refs + chunkEnd(chunk), goesLeft));
    });
    for (std::size_t i = 0; i < chunks; ++i) lefts[i + 1] += lefts[i];

    const std::size_t middle = range.begin + lefts[chunks];
    std::vector<Halves> parts(chunks);
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        const std::size_t begin = range.begin + chunk * kChunk;
        BoxRef* left = spare + range.begin + lefts[chunk];
        BoxRef* right = spare + middle + (begin - range.begin) - lefts[chunk];
        Halves part;
        for (std::size_t i = begin; i < chunkEnd(chunk); ++i) {
            const bool toLeft = goesLeft(refs[i]);
            (toLeft ? part.left : part.right).add(refs[i]);
            *(toLeft ? left++ : right++) = refs[i];
        }
        parts[chunk] = part;
    });
    Halves halves = emptyHalves(range, middle, !range.inSpare);
    for (const Halves& part : parts) {
        joinBounds(halves.left, part.left);
        joinBounds(halves.right, part.right);
    }
    return halves;
}

}  // namespace

BinMap::BinMap(const Box4& centres, int bins) : base_(centres.lo), perUnit_{}, last_(bins - 1) {
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
    BinSet set;
    if (range.size() < kParallelFrom) {
        for (std::size_t i = range.begin; i < range.end; ++i) set.add(map, refs[i]);
    } else {
        // Unions and sums do not depend on the order.
        const std::size_t chunks = chunkCount(range.size());
        const std::size_t jobs = std::min<std::size_t>(chunks, 64);
        std::vector<BinSet> parts(jobs);
        forEachIndex(jobs, threads, [&](std::size_t job, int) {
            const std::size_t begin = range.begin + range.size() * job / jobs;
            const std::size_t end = range.begin + range.size() * (job + 1) / jobs;
            for (std::size_t i = begin; i < end; ++i) parts[job].add(map, refs[i]);
        });
        for (const BinSet& part : parts) set.add(part, bins);
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (map.splits(axis)) sweep(set, axis, bins, costs, best);
    }
    return best;
}

Halves divide(BoxRef* refs, BoxRef* spare, const RefRange& range, const Split& split, int threads) {
    const BinMap map(range.centres, split.bins);
    if (range.size() < kParallelFrom) return divideInPlace(refs, range, map, split);
    return divideInParallel(refs, spare, range, map, split, threads);
}

Halves divideInOrder(const BoxRef* refs, const RefRange& range) {
    Halves halves = emptyHalves(range, range.begin + range.size() / 2, range.inSpare);
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
