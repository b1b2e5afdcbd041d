// Building a WideTree from boxes in its frame; shared by trees of any boxes and trees of triangles.
#pragma once

#include "build_split.h"
#include "rt/accel/wide_tree.h"

#include <vector>

namespace rt {

/// A frame in which `bounds` lies in [-1, 1]^3.
TreeFrame frameFor(const Bounds& bounds);

/// `box` in the frame, rounded outwards.
Box4 boxInFrame(const TreeFrame& frame, const Bounds& box);

class WideTreeBuilder {
  public:
    struct Settings {
        BuildCosts costs;
        std::uint32_t maxLeafItems = 1;
        int threads = 1;
    };

    WideTreeBuilder(LargeArray<BoxRef> refs, std::size_t count, const Settings& settings);

    /// A tree over the refs, whose leaves are runs of items in the order of `items()`.
    WideTree build(const TreeFrame& frame, const Bounds& bounds);

    static LargeArray<WideNode>& nodesOf(WideTree& tree) { return tree.nodes_; }
    static LargeArray<Index>& itemsOf(WideTree& tree) { return tree.items_; }

  private:
    /// A subtree that is built by itself, later: the lane that waits for it, and its content.
    struct Job {
        std::size_t parent;
        int lane;
        RefRange range;
        int depth;
        std::vector<WideNode> nodes;
    };
    struct Lane {
        RefRange range;
        Split split;  ///< as far as it has been looked for
        bool searched = false;
        bool isLeaf = false;
    };
    struct LaneSet {
        Lane lanes[kTreeWidth];
        int count = 0;
    };

    void buildNode(const RefRange& range, int depth, std::vector<WideNode>& nodes,
                   std::vector<Job>* jobs);
    LaneSet gatherLanes(const RefRange& range, int depth);
    int laneToSplit(LaneSet& set, bool byCount);
    void decide(Lane& lane);
    Halves halve(const Lane& lane);
    std::uint32_t addLeaf(const RefRange& range);
    LargeArray<WideNode> joinNodes(std::vector<WideNode>& top, std::vector<Job>& jobs);

    LargeArray<BoxRef> refs_;
    std::size_t count_;
    Settings settings_;
    LargeArray<Index> items_;
    std::size_t jobSize_ = 0;
    int threadsNow_ = 1;
};

}  // namespace rt
