// The search for cycles, against reachability by brute force.
#include "../../src/script/ancestry.h"

#include <doctest/doctest.h>

#include <random>

using namespace rt;

namespace {

/// Whether a path leads from each node to each other: kept by closing over every edge.
class Reachability {
  public:
    explicit Reachability(std::size_t count) : reaches_(count, std::vector<bool>(count, false)) {
        for (std::size_t i = 0; i < count; ++i) reaches_[i][i] = true;
    }
    bool reaches(std::size_t from, std::size_t to) const { return reaches_[from][to]; }
    void add(std::size_t parent, std::size_t child) {
        for (std::size_t a = 0; a < reaches_.size(); ++a) {
            for (std::size_t b = 0; b < reaches_.size(); ++b) {
                if (reaches_[a][parent] && reaches_[child][b]) reaches_[a][b] = true;
            }
        }
    }

  private:
    std::vector<std::vector<bool>> reaches_;
};

std::vector<NodeDesc> makeNodes(std::size_t count) {
    std::vector<NodeDesc> nodes;
    for (std::size_t i = 0; i < count; ++i) nodes.emplace_back("", kNone, SourceLocation{});
    return nodes;
}

}  // namespace

TEST_CASE("an edge closes a cycle exactly where the child reaches the parent") {
    const std::uint32_t seed = 20240517;
    CAPTURE(seed);
    std::mt19937 random(seed);
    int refused = 0;
    for (int round = 0; round < 60; ++round) {
        const Index count = 2 + static_cast<Index>(random() % 24);
        std::vector<NodeDesc> nodes = makeNodes(count);
        Ancestry ancestry(nodes);
        Reachability truth(count);
        for (int edge = 0; edge < 80; ++edge) {
            const Index parent = static_cast<Index>(random() % count);
            const Index child = static_cast<Index>(random() % count);
            const bool closes = truth.reaches(child, parent);
            REQUIRE(ancestry.closesCycle(parent, child) == closes);
            const std::vector<Index> path = ancestry.pathDown(child, parent);
            REQUIRE(path.empty() == !closes);
            if (closes) {
                ++refused;
                REQUIRE(path.front() == child);
                REQUIRE(path.back() == parent);
                continue;
            }
            nodes[parent].edit(0).children.push_back({child, {}, {}});
            ancestry.add(parent, child);
            truth.add(parent, child);
        }
    }
    CHECK(refused > 500);
}
