#include "build_wide_tree.h"

#include "rt/core/numeric.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rt {
namespace {

/// From here on, ranges are cut in halves by count: three halvings a level end any range within
/// the ten levels that are left.
constexpr int kHalvingDepth = WideTree::kMaxDepth - 12;

bool isFinite(const Bounds& box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(box.min[axis]) || !std::isfinite(box.max[axis])) return false;
    }
    return !box.isEmpty();
}

/// Below `value` by up to two roundings, which is less than a ray's pad by far.
float roundedDown(double value) {
    return static_cast<float>(value - kFloatRounding * std::fabs(value));
}

float roundedUp(double value) {
    return -roundedDown(-value);
}

WideNode emptyNode() {
    WideNode node;
    for (int row = 0; row < 6; ++row) {
        std::fill_n(node.plane[row], kTreeWidth, row % 2 == 0 ? Box4::kFar : -Box4::kFar);
    }
    std::fill_n(node.child, kTreeWidth, ChildRef::leaf(0, 1).bits());
    return node;
}

void setBox(WideNode& node, int lane, const Box4& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.plane[2 * axis][lane] = box.lo[axis];
        node.plane[2 * axis + 1][lane] = box.hi[axis];
    }
}

bool isUsed(const WideNode& node, int lane) {
    return node.plane[0][lane] <= node.plane[1][lane];
}

}  // namespace

TreeFrame frameFor(const Bounds& bounds) {
    TreeFrame frame;
    if (bounds.isEmpty()) return frame;
    frame.centre = bounds.centre();
    const Vec3 reach = glm::max(bounds.max - frame.centre, frame.centre - bounds.min);
    double extent = std::max({reach.x, reach.y, reach.z});
    for (int axis = 0; axis < 3; ++axis) {
        // What is smaller than the rounding of its position counts as that large.
        extent = std::max(extent, kUnitRoundoff * std::fabs(frame.centre[axis]));
    }
    constexpr int kLargestExponent = 1000;
    const int exponent = extent > 0.0 ? std::ilogb(extent) + 1 : 0;
    frame.scale = std::ldexp(1.0, -std::clamp(exponent, -kLargestExponent, kLargestExponent));
    return frame;
}

Box4 boxInFrame(const TreeFrame& frame, const Bounds& box) {
    Box4 result;
    for (int axis = 0; axis < 3; ++axis) {
        // The differences round by less than what a ray's pad allows for.
        result.lo[axis] = roundedDown((box.min[axis] - frame.centre[axis]) * frame.scale);
        result.hi[axis] = roundedUp((box.max[axis] - frame.centre[axis]) * frame.scale);
    }
    result.lo[3] = result.hi[3] = 0.0f;
    return result;
}

WideTreeBuilder::WideTreeBuilder(LargeArray<BoxRef> refs, std::size_t count,
                                 const Settings& settings)
    : refs_(std::move(refs)), count_(count), settings_(settings), items_(count) {}

WideTree WideTreeBuilder::build(const TreeFrame& frame, const Bounds& bounds) {
    WideTree tree;
    tree.frame_ = frame;
    tree.bounds_ = bounds;
    if (count_ == 0) return tree;
    constexpr std::size_t kSmallestJob = 1024;
    jobSize_ = std::max(kSmallestJob, count_ / 64);
    threadsNow_ = settings_.threads;
    std::vector<WideNode> top;
    std::vector<Job> jobs;
    buildNode(measureRange(refs_.data(), 0, count_, threadsNow_), 0, top, &jobs);
    threadsNow_ = 1;
    forEachIndex(jobs.size(), settings_.threads, [&](std::size_t i, int) {
        constexpr std::size_t kItemsPerNode = 12;
        jobs[i].nodes.reserve(jobs[i].range.size() / kItemsPerNode);
        buildNode(jobs[i].range, jobs[i].depth, jobs[i].nodes, nullptr);
    });
    tree.nodes_ = joinNodes(top, jobs);
    tree.items_ = std::move(items_);
    return tree;
}

void WideTreeBuilder::buildNode(const RefRange& range, int depth, std::vector<WideNode>& nodes,
                                std::vector<Job>* jobs) {
    const std::size_t self = nodes.size();
    nodes.push_back(emptyNode());
    const LaneSet set = gatherLanes(range, depth);
    for (int lane = 0; lane < set.count; ++lane) {
        const RefRange& part = set.lanes[lane].range;
        setBox(nodes[self], lane, part.box);
        if (set.lanes[lane].isLeaf) {
            nodes[self].child[lane] = addLeaf(part);
        } else if (jobs != nullptr && part.size() <= jobSize_) {
            jobs->push_back({self, lane, part, depth + 1, {}});
        } else {
            nodes[self].child[lane] =
                ChildRef::node(static_cast<std::uint32_t>(nodes.size())).bits();
            buildNode(part, depth + 1, nodes, jobs);
        }
    }
}

/// Splits the range until all lanes are in use or only leaves are left.
WideTreeBuilder::LaneSet WideTreeBuilder::gatherLanes(const RefRange& range, int depth) {
    const bool byCount = depth >= kHalvingDepth;
    LaneSet set;
    set.lanes[set.count++].range = range;
    while (set.count < kTreeWidth) {
        const int chosen = laneToSplit(set, byCount);
        if (chosen < 0) break;
        const Lane& lane = set.lanes[chosen];
        const Halves halves = byCount ? divideInOrder(refs_.data(), lane.range) : halve(lane);
        set.lanes[chosen] = {halves.left, {}, false, false};
        set.lanes[set.count++] = {halves.right, {}, false, false};
    }
    for (int i = 0; i < set.count; ++i) {
        Lane& lane = set.lanes[i];
        if (byCount)
            lane.isLeaf = lane.range.size() <= settings_.maxLeafItems;
        else
            decide(lane);
    }
    return set;
}

/// The lane to split next; -1 if none. Of the lanes that need more than one node (if leaves are
/// full), the one with the largest box; then of those whose leaves all find room here, which saves
/// their node.
int WideTreeBuilder::laneToSplit(LaneSet& set, bool byCount) {
    const std::size_t oneNode = kTreeWidth * settings_.maxLeafItems;
    const auto spare = static_cast<std::size_t>(kTreeWidth - set.count);
    const std::size_t spareItems = (spare + 1) * settings_.maxLeafItems;
    for (;;) {
        int chosen = -1;
        float heaviest = -1.0f;
        bool chosenIsLarge = false;
        for (int i = 0; i < set.count; ++i) {
            const Lane& lane = set.lanes[i];
            const std::size_t size = lane.range.size();
            if (lane.isLeaf || size < 2) continue;
            if (byCount && size <= settings_.maxLeafItems) continue;
            const bool isLarge = byCount || size > oneNode;
            if (!isLarge && (chosenIsLarge || size > spareItems)) continue;
            const float weight = byCount ? static_cast<float>(size) : lane.range.box.halfArea();
            if (weight > heaviest || (isLarge && !chosenIsLarge)) {
                heaviest = weight;
                chosen = i;
                chosenIsLarge = isLarge;
            }
        }
        if (chosen < 0 || byCount) return chosen;
        decide(set.lanes[chosen]);
        if (!set.lanes[chosen].isLeaf) return chosen;
    }
}

/// Looks for the best split, and whether a leaf is better.
void WideTreeBuilder::decide(Lane& lane) {
    const RefRange& range = lane.range;
    if (lane.searched || lane.isLeaf) return;
    if (range.size() == 1) {
        lane.isLeaf = true;
        return;
    }
    lane.split = findSplit(refs_.data(), range, settings_.costs, threadsNow_);
    lane.searched = true;
    if (range.size() > settings_.maxLeafItems) return;
    const float area = range.box.halfArea();
    lane.isLeaf = !(lane.split.cost + settings_.costs.node * area <
                    settings_.costs.leaf(range.size()) * area);
}

Halves WideTreeBuilder::halve(const Lane& lane) {
    if (!lane.split.exists()) return divideInOrder(refs_.data(), lane.range);
    return divide(refs_.data(), lane.range, lane.split, threadsNow_);
}

std::uint32_t WideTreeBuilder::addLeaf(const RefRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) items_[i] = refs_[i].item();
    return ChildRef::leaf(static_cast<std::uint32_t>(range.begin),
                          static_cast<std::uint32_t>(range.size()))
        .bits();
}

/// The top nodes, then the jobs' nodes in the order of the jobs, which is the same for any number
/// of threads.
LargeArray<WideNode> WideTreeBuilder::joinNodes(std::vector<WideNode>& top,
                                                std::vector<Job>& jobs) {
    std::vector<std::size_t> first(jobs.size() + 1, top.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) first[i + 1] = first[i] + jobs[i].nodes.size();
    LargeArray<WideNode> all(first.back());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        top[jobs[i].parent].child[jobs[i].lane] =
            ChildRef::node(static_cast<std::uint32_t>(first[i])).bits();
    }
    std::copy(top.begin(), top.end(), all.data());
    forEachIndex(jobs.size(), settings_.threads, [&](std::size_t i, int) {
        WideNode* to = all.data() + first[i];
        for (WideNode node : jobs[i].nodes) {
            for (int lane = 0; lane < kTreeWidth; ++lane) {
                const ChildRef child = ChildRef::fromBits(node.child[lane]);
                if (child.isLeaf() || !isUsed(node, lane)) continue;
                node.child[lane] =
                    ChildRef::node(child.nodeIndex() + static_cast<std::uint32_t>(first[i])).bits();
            }
            *to++ = node;
        }
        jobs[i].nodes = {};
    });
    return all;
}

WideTree WideTree::build(std::span<const Bounds> boxes, const Settings& settings) {
    if (boxes.size() > ChildRef::kMaxFirst) {
        throw std::length_error("a tree holds at most 2^27 boxes, not " +
                                std::to_string(boxes.size()));
    }
    Bounds bounds;
    for (const Bounds& box : boxes) {
        if (isFinite(box)) bounds.unite(box);
    }
    const TreeFrame frame = frameFor(bounds);
    LargeArray<BoxRef> refs(boxes.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!isFinite(boxes[i])) continue;
        BoxRef& ref = refs[count++];
        ref.box = boxInFrame(frame, boxes[i]);
        ref.setItem(static_cast<Index>(i));
    }
    const std::uint32_t most = std::clamp(settings.maxLeafItems, 1u, ChildRef::kMaxCount);
    WideTreeBuilder builder(std::move(refs), count, {BuildCosts{}, most, settings.threads});
    return builder.build(frame, bounds);
}

}  // namespace rt
