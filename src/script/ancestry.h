// Who hangs under whom, for refusing cycles while a graph is built.
#pragma once

#include "rt/scene/scene_desc.h"

#include <cstdint>
#include <vector>

namespace rt {

/// The edges of the node graph in both directions. An edge parent -> child closes a cycle exactly
/// where the child already reaches the parent; the descendants of the child and the ancestors of
/// the parent are searched in turns, so the cost is that of the smaller of the two sets: none for
/// a fresh node at either end, O(n log n) altogether for a forest of n nodes.
class Ancestry {
  public:
    explicit Ancestry(const std::vector<NodeDesc>& nodes) : nodes_(nodes) {}

    bool closesCycle(Index parent, Index child);
    /// To be called for every edge that is added.
    void add(Index parent, Index child);
    /// A shortest way down from `from` to `to`, both included; empty if there is none.
    std::vector<Index> pathDown(Index from, Index to) const;

  private:
    struct ParentLink {
        Index parent;
        Index next;  ///< into links_
    };
    /// A node on the way of a search, and the edge to follow next: of operands and children on the
    /// way down, of `links_` on the way up.
    struct Stop {
        Index node;
        Index next;
    };
    enum Side { kDown = 0, kUp = 1 };

    Stop stopAt(Side side, Index node) const;
    /// Follows one edge; true if it leads to `goal`.
    bool step(Side side, std::vector<Stop>& way, Index goal);
    void grow();

    const std::vector<NodeDesc>& nodes_;
    std::vector<Index> firstLink_;
    std::vector<ParentLink> links_;
    std::vector<std::uint32_t> seen_[2];  ///< the search that saw the node last
    std::uint32_t search_ = 0;
};

}  // namespace rt
