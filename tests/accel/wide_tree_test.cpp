// The tree over boxes: what a build must survive, and that no box that a ray meets is passed over.
#include "rt/accel/wide_tree.h"

#include "accel/accel_cases.h"
#include "rt/accel/traverse.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>

using namespace rt;
using namespace rt::test;

namespace {

using Quad = __float128;

/// Whether the box meets the ray at some t in the interval, without rounding: products instead of
/// quotients, in quadruple precision.
bool meets(const Bounds& box, const Ray& ray, Interval range) {
    Quad low = range.min;
    Quad high = range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const Quad d = ray.direction[axis];
        Quad near = static_cast<Quad>(box.min[axis]) - ray.origin[axis];
        Quad far = static_cast<Quad>(box.max[axis]) - ray.origin[axis];
        if (d == 0) {
            if (near > 0 || far < 0) return false;
            continue;
        }
        if (d < 0) std::swap(near, far);
        low = std::max(low, near / d);
        high = std::min(high, far / d);
    }
    return low <= high;
}

std::multiset<Index> visited(const WideTree& tree, const Ray& ray, Interval range) {
    std::multiset<Index> items;
    traverseAny(tree, ray, range, [&](Index item) {
        items.insert(item);
        return false;
    });
    return items;
}

std::vector<Bounds> scatteredBoxes(Draws& draws, std::size_t count, double size, const Vec3& at) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        Bounds box;
        box.unite(at + size * draws.unit());
        Vec3 other = box.min + size * draws.magnitude(-6, 0) * draws.unit();
        if (draws.below(3) == 0) other[static_cast<int>(draws.below(3))] = box.min.x;
        box.unite(draws.below(4) == 0 ? box.min : other);
        boxes.push_back(box);
    }
    return boxes;
}

int depthOf(const WideTree& tree, std::uint32_t index) {
    int deepest = 0;
    const WideNode& node = tree.nodes()[index];
    for (int lane = 0; lane < kTreeWidth; ++lane) {
        const ChildRef child = ChildRef::fromBits(node.child[lane]);
        if (!child.isLeaf()) deepest = std::max(deepest, 1 + depthOf(tree, child.nodeIndex()));
    }
    return deepest;
}

}  // namespace

TEST_CASE("a tree of nothing, of empty boxes and of boxes that are not finite meets no ray") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Bounds> useless{Bounds{}, Bounds{Vec3(nan), Vec3(1)},
                                      Bounds{Vec3(0), Vec3(1, kInfinity, 1)}};
    CHECK(WideTree::build({}, {}).isEmpty());
    CHECK(WideTree::build(useless, {}).isEmpty());
    CHECK(visited(WideTree::build(useless, {}), {{0, 0, 0}, {1, 1, 1}}, {}).empty());
    std::vector<Bounds> one = useless;
    one.push_back({Vec3(-1), Vec3(1)});
    const WideTree tree = WideTree::build(one, {});
    CHECK(visited(tree, {{0, 0, -5}, {0, 0, 1}}, {}) == std::multiset<Index>{3});
    CHECK(visited(tree, {{0, 3, -5}, {0, 0, 1}}, {}).empty());
}

TEST_CASE("rays of no direction, and rays that are not finite, meet nothing and return") {
    const std::vector<Bounds> boxes(20, Bounds{Vec3(-1), Vec3(1)});
    const WideTree tree = WideTree::build(boxes, {});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(visited(tree, {{0, 0, 0}, {0, 0, 0}}, {}).empty());
    for (const double bad : {nan, kInfinity, -kInfinity}) {
        CHECK(visited(tree, {{0, 0, 0}, {0, bad, 1}}, {}).empty());
        CHECK(visited(tree, {{bad, 0, 0}, {0, 0, 1}}, {}).empty());
        visited(tree, {{0, 0, 0}, {0, 0, 1}}, {bad, bad});
    }
}

TEST_CASE("boxes that no plane can tell apart build, and are all found once") {
    const std::size_t count = 1000000;
    const std::vector<Bounds> boxes(count, Bounds{Vec3(1, 2, 3), Vec3(1, 3, 4)});
    const WideTree tree = WideTree::build(boxes, {.maxLeafItems = 4, .threads = 2});
    CHECK(depthOf(tree, 0) < WideTree::kMaxDepth);
    std::vector<bool> seen(count, false);
    std::size_t found = 0;
    traverseAny(tree, {{0, 2.5, 3.5}, {1, 0, 0}}, {}, [&](Index item) {
        found += seen[item] ? 0 : 1;
        seen[item] = true;
        return false;
    });
    CHECK(found == count);
}

TEST_CASE("boxes at exponentially growing distances stay within the depth of the stack") {
    std::vector<Bounds> boxes;
    for (int i = -900; i < 900; ++i) {
        for (int k = 0; k < 3; ++k)
            boxes.push_back({Vec3(std::ldexp(1.0, i)), Vec3(std::ldexp(1.0, i))});
    }
    const WideTree tree = WideTree::build(boxes, {});
    CHECK(depthOf(tree, 0) < WideTree::kMaxDepth);
    CHECK(visited(tree, {{0, 0, 0}, {1, 1, 1}}, {}).size() == boxes.size());
}

TEST_CASE("the tree is the same for any number of threads") {
    Draws draws{std::mt19937_64(31)};
    const std::vector<Bounds> boxes = scatteredBoxes(draws, 150000, 1.0, Vec3(0.0));
    const WideTree one = WideTree::build(boxes, {.maxLeafItems = 2, .threads = 1});
    for (const int threads : {2, 3, 8}) {
        const WideTree other = WideTree::build(boxes, {.maxLeafItems = 2, .threads = threads});
        REQUIRE(other.nodeCount() == one.nodeCount());
        CHECK(std::memcmp(other.nodes(), one.nodes(), one.nodeCount() * sizeof(WideNode)) == 0);
        CHECK(std::equal(one.items(), one.items() + one.itemCount(), other.items()));
    }
}

TEST_CASE("every box that the ray meets is visited, once, at all scales and from everywhere") {
    constexpr unsigned kSeed = 32;
    CAPTURE(kSeed);
    Draws draws{std::mt19937_64(kSeed)};
    for (int round = 0; round < 60; ++round) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 at = round % 3 == 0 ? Vec3(0.0) : size * draws.magnitude(0, 6) * draws.unit();
        const std::vector<Bounds> boxes = scatteredBoxes(draws, 1 + draws.below(200), size, at);
        TriangleMesh corners;  // to aim at
        for (const Bounds& box : boxes) {
            const auto first = static_cast<Index>(corners.positions.size());
            corners.positions.insert(corners.positions.end(), {box.min, box.max, box.centre()});
            corners.triangles.push_back({first, first + 1, first + 2});
        }
        const auto leaf = static_cast<std::uint32_t>(1 + draws.below(4));
        const WideTree tree = WideTree::build(boxes, {.maxLeafItems = leaf, .threads = 1});
        for (int i = 0; i < 300; ++i) {
            const Ray ray = hostileRay(draws, corners, size);
            if (ray.direction == Vec3(0.0)) continue;
            const Interval range = i % 2 == 0 ? Interval{} : Interval{0.5, 1.5};
            const std::multiset<Index> items = visited(tree, ray, range);
            std::size_t missed = 0;
            for (Index k = 0; k < boxes.size(); ++k) {
                if (items.count(k) > 1 || (meets(boxes[k], ray, range) && items.count(k) == 0)) {
                    ++missed;
                }
            }
            REQUIRE(missed == 0);
        }
    }
}

TEST_CASE("few boxes are visited in vain") {
    Draws draws{std::mt19937_64(33)};
    const std::vector<Bounds> boxes = scatteredBoxes(draws, 20000, 1.0, Vec3(0.0));
    const WideTree tree = WideTree::build(boxes, {});
    std::size_t visits = 0, needed = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray{2.0 * draws.unit(), draws.unit()};
        visits += visited(tree, ray, {}).size();
        for (const Bounds& box : boxes) needed += meets(box, ray, {}) ? 1 : 0;
    }
    CHECK(visits <= needed + needed / 50 + 10);
}

TEST_CASE("a closest walk goes from near to far, and stops where the range ends") {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 500; ++i) boxes.push_back({Vec3(3 * i, 0, 0), Vec3(3 * i + 1, 1, 1)});
    const WideTree tree = WideTree::build(boxes, {});
    for (const double way : {1.0, -1.0}) {
        std::vector<Index> order;
        traverseClosest(tree, {{way > 0 ? -1.0 : 1501.0, 0.5, 0.5}, {way, 0, 0}}, {},
                        [&](Index item, Interval now) {
                            order.push_back(item);
                            return order.size() == 20 ? 61.0 : now.max;
                        });
        REQUIRE(order.size() >= 20);
        CHECK(order.size() <= 22);
        for (std::size_t i = 0; i < order.size(); ++i) {
            CHECK(order[i] == (way > 0 ? i : 499 - i));
        }
    }
}

TEST_CASE("an any walk stops as soon as it is told to") {
    const std::vector<Bounds> boxes(100, Bounds{Vec3(-1), Vec3(1)});
    const WideTree tree = WideTree::build(boxes, {.maxLeafItems = 8, .threads = 1});
    int calls = 0;
    CHECK(traverseAny(tree, {{0, 0, -3}, {0, 0, 1}}, {}, [&](Index) { return ++calls == 5; }));
    CHECK(calls == 5);
}
