#include "ancestry.h"

#include <algorithm>
#include <deque>
#include <unordered_map>

namespace rt {

namespace {

/// Operands of a node, then its children.
std::size_t countBelow(const NodeDesc& node) {
    return node.operands.size() + node.latest().children.size();
}

Index below(const NodeDesc& node, std::size_t i) {
    const std::size_t operands = node.operands.size();
    return i < operands ? node.operands[i] : node.latest().children[i - operands].child;
}

}  // namespace

void Ancestry::grow() {
    const std::size_t count = nodes_.size();
    if (firstLink_.size() >= count) return;
    firstLink_.resize(count, kNone);
    for (auto& seen : seen_) seen.resize(count, 0);
}

void Ancestry::add(Index parent, Index child) {
    grow();
    links_.push_back({parent, firstLink_[child]});
    firstLink_[child] = static_cast<Index>(links_.size() - 1);
}

Ancestry::Stop Ancestry::stopAt(Side side, Index node) const {
    return {node, side == kDown ? 0 : firstLink_[node]};
}

bool Ancestry::step(Side side, std::vector<Stop>& way, Index goal) {
    Stop& stop = way.back();
    Index neighbour = kNone;
    if (side == kDown) {
        if (stop.next < countBelow(nodes_[stop.node])) {
            neighbour = below(nodes_[stop.node], stop.next++);
        }
    } else if (stop.next != kNone) {
        neighbour = links_[stop.next].parent;
        stop.next = links_[stop.next].next;
    }
    if (neighbour == kNone) {
        way.pop_back();
    } else if (seen_[side][neighbour] != search_) {
        seen_[side][neighbour] = search_;
        way.push_back(stopAt(side, neighbour));
    }
    return neighbour == goal;
}

bool Ancestry::closesCycle(Index parent, Index child) {
    grow();
    if (parent == child) return true;
    const bool parentIsFresh = firstLink_[parent] == kNone;
    if (parentIsFresh || countBelow(nodes_[child]) == 0) return false;
    if (++search_ == 0) {  // the counter wrapped: forget all marks
        for (auto& seen : seen_) std::fill(seen.begin(), seen.end(), 0);
        search_ = 1;
    }
    std::vector<Stop> below{stopAt(kDown, child)};
    std::vector<Stop> above{stopAt(kUp, parent)};
    while (!below.empty() && !above.empty()) {
        if (step(kDown, below, parent) || step(kUp, above, child)) return true;
    }
    return false;
}

std::vector<Index> Ancestry::pathDown(Index from, Index to) const {
    std::unordered_map<Index, Index> cameFrom{{from, kNone}};
    std::deque<Index> waiting{from};
    while (!waiting.empty() && cameFrom.count(to) == 0) {
        const Index node = waiting.front();
        waiting.pop_front();
        for (Index i = 0; i < countBelow(nodes_[node]); ++i) {
            const Index next = below(nodes_[node], i);
            if (cameFrom.emplace(next, node).second) waiting.push_back(next);
        }
    }
    std::vector<Index> path;
    if (cameFrom.count(to) == 0) return path;
    for (Index node = to; node != kNone; node = cameFrom.at(node)) path.push_back(node);
    std::reverse(path.begin(), path.end());
    return path;
}

}  // namespace rt
