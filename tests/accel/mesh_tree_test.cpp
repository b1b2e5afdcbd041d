// The tree over triangles against the plain loop over all of them, to the bit; and no leaks.
#include "rt/accel/mesh_tree.h"

#include "accel/accel_cases.h"
#include "rt/geometry/triangle.h"
#include "rt/render/kernel_choice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

using namespace rt;
using namespace rt::test;

namespace {

/// Every triangle hit in `range`, by t, then by number.
std::vector<PrimitiveHit> allByLoop(const TriangleMesh& mesh, const Ray& ray, Interval range) {
    const TriangleRay prepared(ray);
    std::vector<PrimitiveHit> hits;
    for (Index i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleMesh::Corners& at = mesh.triangles[i];
        PrimitiveHit hit;
        if (!intersectTriangle(prepared, mesh.positions[at[0]], mesh.positions[at[1]],
                               mesh.positions[at[2]], range, hit)) {
            continue;
        }
        hit.part = i;
        hits.push_back(hit);
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const PrimitiveHit& a, const PrimitiveHit& b) { return a.t < b.t; });
    return hits;
}

bool same(const PrimitiveHit& a, const PrimitiveHit& b) {
    return a.t == b.t && a.part == b.part && a.local == b.local;
}

/// Whether single rays and packets on every instruction set give the first of `truths[i]` for ray
/// i.
bool kernelsAgree(const MeshTree& tree, const std::vector<Ray>& rays,
                  const std::vector<Interval>& ranges,
                  const std::vector<std::vector<PrimitiveHit>>& truths) {
    std::vector<PrimitiveHit> hits(rays.size());
    const std::unique_ptr<bool[]> met(new bool[rays.size()]);
    bool agree = true;
    for (const TraceKernel* kernel : availableKernels()) {
        const MeshQueries& mesh = kernel->mesh;
        mesh.closestHits(tree, rays, ranges, hits);
        mesh.anyHits(tree, rays, ranges, {met.get(), rays.size()});
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool isHit = !truths[i].empty();
            PrimitiveHit hit;
            agree = agree && mesh.closestHit(tree, rays[i], ranges[i], hit) == isHit;
            agree = agree && mesh.anyHit(tree, rays[i], ranges[i]) == isHit && met[i] == isHit;
            agree = agree && (hits[i].part != kNone) == isHit;
            if (isHit) agree = agree && same(hit, truths[i][0]) && same(hits[i], truths[i][0]);
        }
    }
    return agree;
}

/// Asks the tree the same as the loop; returns whether all answers agree.
bool agrees(const std::vector<PrimitiveHit>& truth, const MeshTree& tree, const Ray& ray,
            Interval range) {
    PrimitiveHit hit;
    std::vector<PrimitiveHit> all;
    tree.allHits(ray, range, all);
    const bool found = tree.closestHit(ray, range, hit);
    return found == !truth.empty() && tree.anyHit(ray, range) == found &&
           (!found || same(hit, truth.front())) &&
           std::equal(all.begin(), all.end(), truth.begin(), truth.end(), same);
}

/// A ray much like `ray`, as the next one of a packet is: sometimes the very same.
Ray nearby(Draws& draws, const Ray& ray, double size) {
    const double apart = draws.below(8) == 0 ? 0.0 : draws.magnitude(-8, -1);
    const Vec3 target = ray.origin + ray.direction + apart * size * draws.unit();
    Ray next = ray;
    if (draws.below(2) == 0) next.origin += apart * size * draws.unit();
    next.direction = apart > 0.0 ? target - next.origin : ray.direction;
    return next;
}

/// Hostile rays: 48 by themselves, then 48 in bundles, and so on.
std::vector<Ray> hostileRays(Draws& draws, const TriangleMesh& mesh, double size, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const bool follows = i / 48 % 2 == 1 && draws.below(24) != 0;
        rays.push_back(follows ? nearby(draws, rays.back(), size) : hostileRay(draws, mesh, size));
    }
    return rays;
}

void compareWithLoop(unsigned seed, int meshes, int raysEach) {
    CAPTURE(seed);
    Draws draws{std::mt19937_64(seed)};
    for (int round = 0; round < meshes; ++round) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 at = round % 3 == 0 ? Vec3(0.0) : size * draws.magnitude(0, 6) * draws.unit();
        const TriangleMesh mesh = triangleSoup(draws, 1 + draws.below(60), size, at);
        const MeshTree tree = MeshTree::build(mesh, 1);
        const std::vector<Ray> rays = hostileRays(draws, mesh, size, raysEach);
        std::vector<Interval> ranges;
        std::vector<std::vector<PrimitiveHit>> truths;
        int wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ranges.push_back(i % 3 == 0 ? Interval{0.25, 1.5} : Interval{});
            truths.push_back(allByLoop(mesh, rays[i], ranges[i]));
            wrong += agrees(truths[i], tree, rays[i], ranges[i]) ? 0 : 1;
        }
        REQUIRE(wrong == 0);
        REQUIRE(kernelsAgree(tree, rays, ranges, truths));
    }
}

/// Rays from inside a closed mesh at its corners and at points of its edges, `count` of each.
int leaks(Draws& draws, const TriangleMesh& mesh, const MeshTree& tree, int count, double scale,
          const Vec3& centre) {
    int lost = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 eye = centre + 0.5 * scale * draws.unit();
        const auto& at = mesh.triangles[draws.below(mesh.triangles.size())];
        const Vec3 a = mesh.positions[at[0]], b = mesh.positions[at[1]];
        for (const Vec3& target : {a, a + draws.between(0, 1) * (b - a), 0.5 * (a + b)}) {
            PrimitiveHit hit;
            lost += tree.closestHit({eye, target - eye}, {}, hit) ? 0 : 1;
        }
    }
    return lost;
}

void checkLeaks(unsigned seed, int count) {
    CAPTURE(seed);
    Draws draws{std::mt19937_64(seed)};
    for (const double scale : {1.0, 1e-3, 1e3}) {
        for (const double offset : {0.0, 1e6}) {
            const Vec3 centre = offset * Vec3(1.0, -0.7, 0.3);
            const TriangleMesh mesh = closedBall(draws, 5, scale, centre);
            const MeshTree tree = MeshTree::build(mesh, 2);
            CAPTURE(scale);
            CAPTURE(offset);
            CHECK(leaks(draws, mesh, tree, count, scale, centre) == 0);
        }
    }
}

/// Long needles at all angles among specks, such as splitting is for.
TriangleMesh needles(Draws& draws, int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 from = draws.unit();
        const double length = i % 10 == 0 ? 2.0 : 0.002;
        const auto first = static_cast<Index>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(),
                              {from, from + length * draws.unit(), from + 0.002 * draws.unit()});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

}  // namespace

TEST_CASE("an empty mesh has a tree that meets nothing") {
    const MeshTree tree = MeshTree::build({}, 2);
    PrimitiveHit hit;
    CHECK_FALSE(tree.closestHit({{0, 0, 0}, {0, 0, 1}}, {}, hit));
    CHECK_FALSE(tree.anyHit({{0, 0, 0}, {0, 0, 1}}, {}));
    CHECK(tree.bounds().isEmpty());
    CHECK_FALSE(MeshTree().anyHit({{0, 0, 0}, {0, 0, 1}}, {}));
}

TEST_CASE("one triangle is hit as by itself") {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const MeshTree tree = MeshTree::build(mesh, 1);
    PrimitiveHit hit;
    REQUIRE(tree.closestHit({{0.25, 0.5, 3}, {0, 0, -2}}, {}, hit));
    CHECK(hit.t == 1.5);
    CHECK(hit.part == 0);
    CHECK(hit.local == Vec3(0.25, 0.25, 0.5));
    CHECK_FALSE(tree.anyHit({{0.25, 0.5, 3}, {0, 0, -2}}, {1.5, 9.0}));
    CHECK_FALSE(tree.anyHit({{0.25, 0.5, 3}, {0, 0, -2}}, {0.0, 1.5}));
    CHECK(tree.bounds().max == Vec3(1, 1, 0));
}

TEST_CASE("of triangles hit at the same t the first is named, whatever the tree") {
    TriangleMesh mesh;
    for (int i = 0; i < 500; ++i) {
        const auto first = static_cast<Index>(mesh.positions.size());
        const double r = std::ldexp(1.0, (i * 37) % 11);
        mesh.positions.insert(mesh.positions.end(),
                              {Vec3(-r, -r, 0), Vec3(2 * r, -r, 0), Vec3(-r, 2 * r, 0)});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const MeshTree tree = MeshTree::build(mesh, 1);
    PrimitiveHit hit;
    REQUIRE(tree.closestHit({{0, 0, 1}, {0, 0, -1}}, {}, hit));
    CHECK(hit.part == 0);
    std::vector<PrimitiveHit> all;
    tree.allHits({{0, 0, 1}, {0, 0, -1}}, {}, all);
    CHECK(all.size() == 500);
}

TEST_CASE("the tree answers as the plain loop does, to the bit") {
    compareWithLoop(41, 100, 1000);
}

TEST_CASE("the tree answers as the plain loop does, ten million times" * doctest::skip()) {
    compareWithLoop(42, 2000, 5000);
}

TEST_CASE("a mesh of needles is split, and answers all the same") {
    Draws draws{std::mt19937_64(43)};
    const TriangleMesh mesh = needles(draws, 400);
    const MeshTree tree = MeshTree::build(mesh, 1);
    int wrong = 0;
    for (const Ray& ray : hostileRays(draws, mesh, 1.0, 5000)) {
        wrong += agrees(allByLoop(mesh, ray, {}), tree, ray, {}) ? 0 : 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("packets and single rays on every instruction set answer alike in a large mesh") {
    Draws draws{std::mt19937_64(48)};
    const TriangleMesh mesh = closedBall(draws, 6, 1.0, Vec3(0.0));
    const MeshTree tree = MeshTree::build(mesh, 2);
    const std::vector<Ray> rays = hostileRays(draws, mesh, 0.1, 20000);
    const std::vector<Interval> ranges(rays.size(), Interval{0.01, 3.0});
    std::vector<std::vector<PrimitiveHit>> truths;
    for (const Ray& ray : rays) {
        PrimitiveHit hit;
        truths.emplace_back(tree.closestHit(ray, ranges[0], hit) ? 1 : 0, hit);
    }
    CHECK(kernelsAgree(tree, rays, ranges, truths));
}

TEST_CASE("broken, tiny and huge rays in a packet are answered as by themselves") {
    Draws draws{std::mt19937_64(49)};
    const TriangleMesh mesh = closedBall(draws, 3, 1.0, Vec3(0.0));
    const MeshTree tree = MeshTree::build(mesh, 1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Ray> rays;
    for (const double length : {1.0, 6e-309, 1e-310, 1e-200, 1e200, 1e307, 0.0, kInfinity, nan}) {
        for (int i = 0; i < 7; ++i) {
            const Vec3 eye = 3.0 * draws.unit();
            rays.push_back({eye, length * (0.3 * draws.unit() - eye)});
            rays.push_back({0.5 * eye, Vec3(1e-12, 0.0, length)});
        }
        rays.push_back({Vec3(0.0, length, 0.0), Vec3(0.0, -1.0, 0.0)});
    }
    const std::vector<Interval> ranges(rays.size());
    std::vector<std::vector<PrimitiveHit>> truths;
    std::size_t hits = 0;
    for (const Ray& ray : rays) {
        PrimitiveHit hit;
        truths.emplace_back(tree.closestHit(ray, {}, hit) ? 1 : 0, hit);
        hits += truths.back().size();
    }
    CHECK(hits > rays.size() / 3);
    CHECK(kernelsAgree(tree, rays, ranges, truths));
}

TEST_CASE("no ray from inside slips between the triangles of a closed mesh") {
    checkLeaks(44, 2000);
}

TEST_CASE("no ray from inside slips out, millions of times" * doctest::skip()) {
    checkLeaks(45, 350000);
}

TEST_CASE("a hundred thousand equal triangles build, and the first one is hit") {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles.assign(100000, {0, 1, 2});
    const MeshTree tree = MeshTree::build(mesh, 2);
    PrimitiveHit hit;
    REQUIRE(tree.closestHit({{0.25, 0.25, 1}, {0, 0, -1}}, {}, hit));
    CHECK(hit.part == 0);
}

TEST_CASE("a mesh tree is the same for any number of threads") {
    Draws draws{std::mt19937_64(46)};
    const TriangleMesh ball = closedBall(draws, 7, 1.0, Vec3(0.0));
    const TriangleMesh thin = needles(draws, 30000);
    for (const TriangleMesh* mesh : {&ball, &thin}) {
        const MeshTree one = MeshTree::build(*mesh, 1);
        for (const int threads : {2, 5}) {
            const MeshTree other = MeshTree::build(*mesh, threads);
            REQUIRE(other.bytes() == one.bytes());
            const std::size_t nodes = one.tree().nodeCount() * sizeof(WideNode);
            CHECK(std::memcmp(other.tree().nodes(), one.tree().nodes(), nodes) == 0);
        }
    }
}

TEST_CASE("a usual mesh costs at most 110 bytes a triangle") {
    Draws draws{std::mt19937_64(47)};
    const TriangleMesh ball = closedBall(draws, 6, 1.0, Vec3(0.0));
    CHECK(MeshTree::build(ball, 1).bytes() <= 110 * ball.triangles.size());
}
