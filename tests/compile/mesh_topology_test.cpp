#include "rt/compile/mesh_topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

namespace {

using namespace rt;

using Triangles = std::vector<TriangleMesh::Corners>;

TEST_CASE("equal positions merge into the first of them, -0 and 0 being equal") {
    const std::vector<Vec3> p = {
        {0, 1, 2}, {1, 1, 2}, {-0.0, 1, 2}, {0, 1, 2.0000000001}, {1, 1, 2}};
    CHECK(mergeEqualPositions(p) == std::vector<Index>{0, 1, 0, 3, 1});
    CHECK(mergeEqualPositions({}).empty());
}

TEST_CASE("merging agrees with an ordered map") {
    const unsigned seed = 17;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < 20000; ++i) {
        points.push_back({static_cast<double>(random() % 20) - 10,
                          1e-3 * static_cast<double>(random() % 20),
                          1e9 * static_cast<double>(random() % 20)});
    }
    std::map<std::array<double, 3>, Index> first;
    const std::vector<Index> merged = mergeEqualPositions(points);
    for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
        const Vec3& p = points[i];
        CHECK(merged[i] == first.try_emplace({p.x, p.y, p.z}, i).first->second);
    }
}

const Triangles kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST_CASE("the corners at a vertex are those that name it or its equals, in order") {
    const Triangles triangles = {{0, 1, 2}, {3, 1, 4}};
    const MeshTopology topology(triangles, {0, 1, 2, 0, 4});
    const auto corners = [&](Index v) {
        const auto span = topology.cornersAt(v);
        return std::vector<Index>(span.begin(), span.end());
    };
    CHECK(corners(0) == std::vector<Index>{0, 3});
    CHECK(corners(1) == std::vector<Index>{1, 4});
    CHECK(corners(2) == std::vector<Index>{2});
    CHECK(corners(3).empty());
    CHECK(corners(4) == std::vector<Index>{5});
}

bool closed(const Triangles& triangles, std::vector<Index> merged) {
    return MeshTopology(triangles, std::move(merged)).isClosed(triangles);
}

TEST_CASE("closed means two triangles at every edge, whichever way round they run") {
    CHECK(closed(kTetrahedron, {0, 1, 2, 3}));
    Triangles turned = kTetrahedron;
    std::swap(turned[1][0], turned[1][2]);
    CHECK(closed(turned, {0, 1, 2, 3}));
    for (std::size_t gap = 0; gap < 4; ++gap) {
        Triangles open = kTetrahedron;
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(gap));
        CHECK_FALSE(closed(open, {0, 1, 2, 3}));
    }
    CHECK_FALSE(closed({}, {}));
    CHECK_FALSE(closed({{0, 1, 2}}, {0, 1, 2}));

    Triangles twice = kTetrahedron;
    twice.insert(twice.end(), kTetrahedron.begin(), kTetrahedron.end());
    CHECK_FALSE(closed(twice, {0, 1, 2, 3}));
    // A fin of two more triangles at an edge: four of them there.
    Triangles fin = kTetrahedron;
    fin.push_back({0, 1, 4});
    fin.push_back({0, 1, 4});
    CHECK_FALSE(closed(fin, {0, 1, 2, 3, 4}));
    // Two bodies that share no vertex.
    Triangles both = kTetrahedron;
    for (const auto& [a, b, c] : kTetrahedron) both.push_back({a + 4, b + 4, c + 4});
    CHECK(closed(both, {0, 1, 2, 3, 4, 5, 6, 7}));
    // Two bodies that meet at a vertex only, and two that meet at an edge.
    CHECK(closed(both, {0, 1, 2, 3, 0, 5, 6, 7}));
    CHECK_FALSE(closed(both, {0, 1, 2, 3, 0, 1, 6, 7}));
}

TEST_CASE("closedness agrees with counting edges in a map") {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        std::mt19937 engine(seed);
        const auto random = [&] { return static_cast<Index>(engine()); };
        Triangles triangles = kTetrahedron;
        for (unsigned i = 0; i < seed % 5; ++i) {
            const Index a = random() % 6;
            const Index b = (a + 1 + random() % 5) % 6;
            Index c = random() % 6;
            while (c == a || c == b) c = (c + 1) % 6;
            triangles.push_back({a, b, c});
            if (seed % 2) triangles.push_back({b, a, c});
            if (seed % 3 == 0) triangles.erase(triangles.begin());
        }
        std::map<std::pair<Index, Index>, int> edges;
        for (const TriangleMesh::Corners& t : triangles) {
            for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax({t[k], t[(k + 1) % 3]})];
        }
        const bool expected =
            !triangles.empty() && std::all_of(edges.begin(), edges.end(),
                                              [](const auto& edge) { return edge.second == 2; });
        CHECK(closed(triangles, {0, 1, 2, 3, 4, 5}) == expected);
    }
}

TEST_CASE("a triangle is at the border if an edge of it belongs to no other") {
    const auto border = [](const Triangles& triangles, std::vector<Index> merged) {
        return MeshTopology(triangles, std::move(merged)).onBorder(triangles);
    };
    CHECK(border(kTetrahedron, {0, 1, 2, 3}) == std::vector<bool>(4, false));
    // The middle one of four, each of whose edges another has; merged vertices count as one.
    const Triangles four = {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}};
    CHECK(border(four, {0, 1, 2, 3, 4, 5}) == std::vector<bool>{false, true, true, true});
    CHECK(border({{0, 1, 2}, {3, 4, 5}}, {0, 1, 2, 0, 1, 2}) == std::vector<bool>(2, false));
    CHECK(border({{0, 1, 2}, {3, 4, 5}}, {0, 1, 2, 3, 4, 5}) == std::vector<bool>(2, true));
}

}  // namespace
