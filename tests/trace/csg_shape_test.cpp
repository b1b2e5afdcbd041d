// Combined solids against what the words mean: a point is in them where it is in their parts as the
// expression says, and a line crosses them where that changes. Which points are in a part is asked
// of formulas of the test's own, in the part's own space.
#include "trace/csg_signature.h"
#include "trace/scene_intersect.h"

#include "rt/compile/compile.h"
#include "rt/trace/csg_shape.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.17g", x);
    return buffer;
}

std::string text(const Vec3& v) {
    return "{" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + "}";
}

/// A solid as a script says it, and how far inside it a point is: above 0 within, and about a
/// length near the surface.
struct Solid {
    std::string script;  ///< an expression
    std::function<double(const Vec3&)> depth;
};

class Draws {
  public:
    explicit Draws(unsigned seed) : random_(seed) {}

    double uniform(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random_);
    }
    int below(int n) { return static_cast<int>(uniform(0.0, n)); }
    Vec3 vector(double reach) {
        const double x = uniform(-reach, reach);
        const double y = uniform(-reach, reach);
        return {x, y, uniform(-reach, reach)};
    }
    /// From outside, through the middle or so.
    Ray ray() {
        const Vec3 target = vector(1.2);
        const Vec3 direction = vector(1.0);
        return {target - 6.0 * direction, direction};
    }

  private:
    std::mt19937 random_;
};

const std::string kCubeMesh =
    "gr.mesh('m', {{-1,-1,-1}, {1,-1,-1}, {1,1,-1}, {-1,1,-1}, {-1,-1,1}, {1,-1,1}, {1,1,1}, "
    "{-1,1,1}}, {{0,3,2,1}, {4,5,6,7}, {0,1,5,4}, {2,3,7,6}, {1,2,6,5}, {0,4,7,3}})";

double inBox(const Vec3& p, const Vec3& lo, const Vec3& hi) {
    const Vec3 d = glm::min(p - lo, hi - p);
    return std::min({d.x, d.y, d.z});
}

Solid leaf(Draws& draws) {
    switch (draws.below(9)) {
        case 7: {
            // A hyperboloid of one sheet or of two, cut by a box.
            const double c = draws.uniform(-0.3, 0.3);
            const double yy = draws.uniform(-1.5, -0.3);
            const Vec3 hi = glm::abs(draws.vector(0.5)) + 0.6;
            return {
                "gr.quadric('q', {xx = 1, yy = " + text(yy) + ", zz = 1, xy = 0.3, c = " + text(c) +
                    "}, {-0.8, -0.7, -0.9}, " + text(hi) + ")",
                [=](const Vec3& p) {
                    const double q = p.x * p.x + yy * p.y * p.y + p.z * p.z + 0.3 * p.x * p.y + c;
                    return std::min(-q, inBox(p, Vec3(-0.8, -0.7, -0.9), hi));
                }};
        }
        case 0: {
            const Vec3 c = draws.vector(1.0);
            const double r = draws.uniform(0.3, 1.5);
            return {"gr.nh_sphere('s', " + text(c) + ", " + text(r) + ")",
                    [=](const Vec3& p) { return r - glm::length(p - c); }};
        }
        case 1: {
            const Vec3 lo = draws.vector(1.0) - 0.7;
            const Vec3 size = glm::abs(draws.vector(1.5)) + 0.3;
            return {"gr.nh_box('b', " + text(lo) + ", " + text(size) + ")",
                    [=](const Vec3& p) { return inBox(p, lo, lo + size); }};
        }
        case 2: {
            const double h = draws.uniform(0.5, 2.5);
            const double r = draws.uniform(0.3, 1.2);
            return {"gr.nh_cylinder('c', {0, -1, 0}, " + text(h) + ", " + text(r) + ")",
                    [=](const Vec3& p) {
                        return std::min({r - std::hypot(p.x, p.z), p.y + 1.0, h - 1.0 - p.y});
                    }};
        }
        case 3: {
            const double h = draws.uniform(0.5, 2.5);
            const double r = draws.uniform(0.3, 1.2);
            return {"gr.nh_cone('k', {0, -1, 0}, " + text(h) + ", " + text(r) + ")",
                    [=](const Vec3& p) {
                        return std::min(r / h * (p.y + 1.0) - std::hypot(p.x, p.z), h - 1.0 - p.y);
                    }};
        }
        case 4: {
            const double R = draws.uniform(0.6, 1.2);
            const double r = draws.uniform(0.1, 0.5);
            return {"gr.nh_torus('t', {0, 0, 0}, " + text(R) + ", " + text(r) + ")",
                    [=](const Vec3& p) { return r - std::hypot(std::hypot(p.x, p.y) - R, p.z); }};
        }
        case 5: {
            const double r = draws.uniform(0.5, 1.4);
            return {"gr.nh_hemisphere('h', {0, 0, 0}, " + text(r) + ")",
                    [=](const Vec3& p) { return std::min(r - glm::length(p), p.y); }};
        }
        case 6: {
            const double h = draws.uniform(0.5, 2.0);
            const double a = draws.uniform(0.2, 1.0);
            const double b = draws.uniform(1.1, 1.5);
            return {
                "gr.nh_frustum('f', {0, -1, 0}, " + text(h) + ", " + text(a) + ", " + text(b) + ")",
                [=](const Vec3& p) {
                    const double radius = a + (b - a) * (p.y + 1.0) / h;
                    return std::min({radius - std::hypot(p.x, p.z), p.y + 1.0, h - 1.0 - p.y});
                }};
        }
        default:
            return {kCubeMesh, [](const Vec3& p) { return inBox(p, Vec3(-1.0), Vec3(1.0)); }};
    }
}

/// Stretched, turned about y, moved.
Solid moved(Draws& draws, const Solid& solid) {
    const Vec3 by = draws.vector(0.8);
    const double degrees = draws.uniform(-180.0, 180.0);
    const Vec3 scale(draws.uniform(0.6, 1.4), draws.uniform(0.6, 1.4), draws.uniform(0.6, 1.4));
    const double a = degrees * 3.14159265358979323846 / 180.0;
    const std::string numbers = text(scale.x) + ", " + text(scale.y) + ", " + text(scale.z) + ", " +
                                text(degrees) + ", " + text(by.x) + ", " + text(by.y) + ", " +
                                text(by.z);
    const auto depth = solid.depth;
    return {"moved(" + solid.script + ", " + numbers + ")", [=](const Vec3& p) {
                const Vec3 q = p - by;
                const Vec3 turned(std::cos(a) * q.x - std::sin(a) * q.z, q.y,
                                  std::sin(a) * q.x + std::cos(a) * q.z);
                return depth(turned / scale);
            }};
}

Solid expression(Draws& draws, int levels) {
    if (levels == 0) return moved(draws, leaf(draws));
    std::vector<Solid> parts;
    const int count = 2 + draws.below(2);
    for (int i = 0; i < count; ++i) {
        parts.push_back(expression(draws, draws.below(levels + 1) ? levels - 1 : 0));
    }
    const int kind = draws.below(4);
    const std::string names[] = {"gr.union('u'", "gr.intersection('i'", "gr.difference('d'",
                                 "group("};
    std::string script = names[kind];
    for (std::size_t i = 0; i < parts.size(); ++i) {
        script += (kind == 3 && i == 0 ? "" : ", ") + parts[i].script;
    }
    const auto depth = [=](const Vec3& p) {
        double value = parts[0].depth(p);
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const double other = parts[i].depth(p);
            if (kind == 0 || kind == 3) value = std::max(value, other);
            if (kind == 1) value = std::min(value, other);
            if (kind == 2) value = std::min(value, -other);
        }
        return value;
    };
    return moved(draws, {script + ")", depth});
}

/// A union of many small solids, every fourth of them cut.
Solid crowd(Draws& draws, int count) {
    std::vector<Solid> parts;
    std::string script = "gr.union('u'";
    for (int i = 0; i < count; ++i) {
        const Solid part = expression(draws, i % 4 == 0 ? 1 : 0);
        const Vec3 by = draws.vector(1.5);
        parts.push_back({"moved(" + part.script + ", 0.25, 0.25, 0.25, 0, " + text(by.x) + ", " +
                             text(by.y) + ", " + text(by.z) + ")",
                         [=](const Vec3& p) { return part.depth((p - by) / 0.25); }});
        script += ", " + parts.back().script;
    }
    return {script + ")", [=](const Vec3& p) {
                double value = -kInfinity;
                for (const Solid& part : parts) value = std::max(value, part.depth(p));
                return value;
            }};
}

/// What it leaves of a box.
Solid lessCrowd(const Solid& many) {
    return {"gr.difference('d', gr.nh_box('b', {-1.1, -1.2, -1.3}, {2.5, 2.5, 2.5}), " +
                many.script + ")",
            [=](const Vec3& p) {
                return std::min(inBox(p, Vec3(-1.1, -1.2, -1.3), Vec3(1.4, 1.3, 1.2)),
                                -many.depth(p));
            }};
}

const std::string kTools = R"(
    m = gr.material({1, 1, 1}, {0, 0, 0}, 0)
    function moved(node, sx, sy, sz, degrees, x, y, z)
        node:scale(sx, sy, sz) node:rotate('y', degrees) node:translate(x, y, z)
        return node
    end
    function group(...)
        local node = gr.node('group')
        for _, part in ipairs{...} do node:add_child(part) end
        return node
    end
    root = gr.node('root')
)";

/// A scene of one object, all of it white.
RenderScene sceneOf(const std::string& solid) {
    // A group is no solid by itself.
    const Described run =
        describe(kTools + "root:add_child(gr.union('whole', " + solid +
                 ", gr.nh_sphere('far', {90, 0, 0}, 1)), m)\n" +
                 "gr.render(root, 'x.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})");
    AssetCache assets(1);
    Diagnostics diagnostics;
    return compileScene(run.scene, 0, {}, assets, diagnostics);
}

std::vector<PrimitiveHit> crossings(const RenderScene& scene, const Ray& ray) {
    std::vector<PrimitiveHit> all;
    Interval rest;
    PrimitiveHit hit;
    while (intersectInstance(scene, 0, ray, rest, hit)) {
        all.push_back(hit);
        rest.min = hit.t;
    }
    return all;
}

/// Draws points of a line between a solid's crossings.
struct Turns {
    int inside = 0;
    int cut = 0;

    /// Every third line starts near the solid's middle, the others `away` from it.
    void check(Draws& draws, const Solid& solid, int lines, double away) {
        CAPTURE(solid.script);
        const RenderScene scene = sceneOf(solid.script);
        REQUIRE(scene.instances.size() == 1);
        for (int k = 0; k < lines; ++k) {
            const Vec3 target = draws.vector(1.2);
            const Vec3 direction = draws.vector(1.0);
            const bool near = k % 3 == 0;
            checkLine(draws, solid, scene, {near ? target : target - away * direction, direction});
        }
    }

  private:
    void checkLine(Draws& draws, const Solid& solid, const RenderScene& scene, const Ray& ray) {
        const std::vector<PrimitiveHit> hits = crossings(scene, ray);
        double from = 0.0;
        for (std::size_t h = 0; h <= hits.size(); ++h) {
            const double to = h < hits.size() ? hits[h].t : from + 20.0;
            const bool expected = (hits.size() - h) % 2 == 1;
            for (int s = 0; s < 8; ++s) {
                const Vec3 p = ray.at(draws.uniform(from, to));
                if (p.x > 80.0) continue;
                const double depth = solid.depth(p);
                if (std::fabs(depth) < 1e-9) continue;
                CAPTURE(p.x);
                CAPTURE(p.y);
                CAPTURE(p.z);
                CHECK((depth > 0.0) == expected);
                inside += expected ? 1 : 0;
            }
            if (h < hits.size()) {
                ++cut;
                CHECK(std::fabs(solid.depth(ray.at(hits[h].t))) < 1e-11);
            }
            from = to;
        }
    }
};

}  // namespace

TEST_CASE("between its crossings a line is in a combined solid as its parts say, and in turns") {
    Draws draws(7);
    Turns turns;
    for (int i = 0; i < 120; ++i) {
        turns.check(draws, expression(draws, 1 + draws.below(3)), 60, 6.0);
    }
    CHECK(turns.inside > 8000);
    CHECK(turns.cut > 4000);
}

TEST_CASE("so it is in a solid of many parts, whose boxes lie in a tree") {
    Draws draws(11);
    Turns turns;
    for (int i = 0; i < 24; ++i) {
        const Solid many = crowd(draws, 30 + draws.below(40));
        turns.check(draws, many, 30, 6.0);
        turns.check(draws, lessCrowd(many), 30, 9.0);
    }
    CHECK(turns.inside > 4000);
    CHECK(turns.cut > 2000);
}

TEST_CASE("of many parts, too, faces that coincide are one, and the first part is seen") {
    std::string row;
    for (int i = 0; i < 40; ++i) {
        row += ", gr.nh_box('b', {" + std::to_string(i) + ", 0, 0}, 1)";
    }
    const RenderScene scene = sceneOf("gr.union('u'" + row + row + ")");
    for (const double from : {-3.0, 0.5, 17.25, 39.5}) {
        CAPTURE(from);
        const std::vector<PrimitiveHit> hits =
            crossings(scene, {Vec3(from, 0.875, 0.875), Vec3(1.0, 0.0, 0.0)});
        REQUIRE(hits.size() == (from < 0.0 ? 2 : 1));
        CHECK(hits.back().t == 40.0 - from);
        CHECK(hits.back().leaf == 39);
        if (from < 0.0) CHECK(hits[0].leaf == 0);
    }
}

TEST_CASE("normals of combined solids point out of them, on the walls of what is taken away, too") {
    Draws draws(8);
    int checked = 0;
    for (int i = 0; i < 60; ++i) {
        const Solid solid = expression(draws, 1 + draws.below(3));
        CAPTURE(solid.script);
        const RenderScene scene = sceneOf(solid.script);
        for (int k = 0; k < 40; ++k) {
            const Ray ray = draws.ray();
            for (const PrimitiveHit& hit : crossings(scene, ray)) {
                const SurfacePoint surface = surfaceAt(scene, {hit, 0, 0.0}, SurfaceDetail::kShape);
                if (surface.point.x > 80.0) continue;
                CHECK(glm::length(surface.point - ray.at(hit.t)) < 1e-11);
                CHECK(std::fabs(glm::length(surface.normal) - 1.0) < 1e-12);
                const double step = 1e-7;
                const double out = solid.depth(surface.point + step * surface.normal);
                const double in = solid.depth(surface.point - step * surface.normal);
                // Not where another surface is as near.
                const bool plain = std::fabs(out + in) < 0.01 * step && in - out > 0.1 * step;
                if (!plain) {
                    CHECK(!(out > 0.1 * step && in < -0.1 * step));
                    continue;
                }
                CHECK(out < 0.0);
                CHECK(in > 0.0);
                ++checked;
            }
        }
    }
    CHECK(checked > 1500);
}

TEST_CASE("a ray answers for its part of the line alone, wherever it starts") {
    Draws draws(9);
    for (int i = 0; i < 40; ++i) {
        const Solid solid = expression(draws, 2);
        const RenderScene scene = sceneOf(solid.script);
        for (int k = 0; k < 40; ++k) {
            const Ray ray = draws.ray();
            const std::vector<PrimitiveHit> hits = crossings(scene, ray);
            const double middle = draws.uniform(0.0, 12.0);
            PrimitiveHit found;
            const bool before = intersectInstance(scene, 0, ray, {0.0, middle}, found);
            CHECK(before == (!hits.empty() && hits[0].t < middle));
            CHECK(instanceBlocks(scene, 0, ray, {0.0, middle}) == before);
            std::size_t next = 0;
            while (next < hits.size() && !(hits[next].t > middle)) ++next;
            const bool after = intersectInstance(scene, 0, ray, {middle, kInfinity}, found);
            CHECK(after == (next < hits.size()));
            if (after && next < hits.size()) {
                CHECK(found.t == hits[next].t);
                CHECK(found.leaf == hits[next].leaf);
            }
        }
    }
}

TEST_CASE("of a face that solids share a difference leaves nothing, and a union has no wall") {
    const RenderScene step = sceneOf(
        "gr.difference('d', gr.nh_box('a', {0,0,0}, 1), gr.nh_box('b', {0.25,0.5,0.25}, "
        "{0.5,0.5,0.5}))");
    const Ray down{Vec3(0.5, 3.0, 0.5), Vec3(0.0, -1.0, 0.0)};
    std::vector<PrimitiveHit> hits = crossings(step, down);
    REQUIRE(hits.size() == 2);
    CHECK(hits[0].t == 2.5);
    CHECK(hits[0].leaf == 1);
    CHECK(hits[1].t == 3.0);

    const RenderScene row = sceneOf(
        "gr.union('u', gr.nh_box('a', {0,0,0}, 1), gr.nh_box('b', {1,0,0}, 1), "
        "moved(gr.nh_box('c', {-0.5,0,-0.5}, 1), 1, 1, 1, 90, 2.5, 0, 0.5))");
    hits = crossings(row, {Vec3(-1.0, 0.5, 0.25), Vec3(1.0, 0.0, 0.0)});
    REQUIRE(hits.size() == 4);
    CHECK(hits[0].t == 1.0);
    CHECK(hits[1].t == 4.0);
}

TEST_CASE(
    "of surfaces that coincide the first is seen without which there would be none, or else "
    "the first that would be there alone") {
    const std::string box = "gr.nh_box('x', {0,0,0}, 1)";
    const std::string thin = "gr.nh_box('y', {0,-1,-1}, {0.5, 3, 3})";
    const Ray ray{Vec3(-1.0, 0.5, 0.25), Vec3(1.0, 0.0, 0.0)};
    for (const auto& [solid, leaf] :
         {std::pair("gr.union('u', gr.difference('d', " + box + ", " + thin + "), " + box + ")",
                    2u),
          {"gr.union('u', " + box + ", " + box + ")", 0u},
          {"gr.union('u', gr.intersection('i', " + box + ", " + thin + "), " + box + ")", 2u},
          {"gr.intersection('i', " + thin + ", " + box + ")", 0u}}) {
        CAPTURE(solid);
        const std::vector<PrimitiveHit> hits = crossings(sceneOf(solid), ray);
        REQUIRE(!hits.empty());
        CHECK(hits[0].t == 1.0);
        CHECK(hits[0].leaf == leaf);
    }
}

TEST_CASE("a solid less itself is empty, with itself it is as before, whatever the line") {
    Draws draws(10);
    for (int i = 0; i < 40; ++i) {
        const Solid solid = expression(draws, i % 3);
        CAPTURE(solid.script);
        const RenderScene none = sceneOf("(function() local a = " + solid.script +
                                         " return gr.difference('n', a, a) end)()");
        const RenderScene one = sceneOf(solid.script);
        const RenderScene twice =
            sceneOf("(function() local a = " + solid.script + " return gr.union('n', a, a) end)()");
        const RenderScene both = sceneOf("(function() local a = " + solid.script +
                                         " return gr.intersection('n', a, a) end)()");
        for (int k = 0; k < 40; ++k) {
            const Ray ray = draws.ray();
            const std::vector<PrimitiveHit> hits = crossings(one, ray);
            for (const RenderScene* scene : {&twice, &both}) {
                const std::vector<PrimitiveHit> others = crossings(*scene, ray);
                REQUIRE(others.size() == hits.size());
                for (std::size_t h = 0; h < hits.size(); ++h) CHECK(others[h].t == hits[h].t);
            }
            for (const PrimitiveHit& hit : crossings(none, ray)) CHECK(ray.at(hit.t).x > 80.0);
        }
    }
}

TEST_CASE("a line along an edge or through a corner keeps count of inside and outside") {
    const RenderScene boxes = sceneOf("gr.union('u', gr.nh_box('a', {-1,-1,-1}, 2), " + kCubeMesh +
                                      ", gr.nh_box('c', {3,-1,-1}, "
                                      "2))");
    const RenderScene drilled =
        sceneOf("gr.difference('d', " + kCubeMesh + ", gr.nh_box('a', {-0.5,-0.5,-2}, {1, 1, 4}))");
    for (const RenderScene* scene : {&boxes, &drilled}) {
        for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0, 3.0}) {
                const Ray ray{Vec3(x, y, 9.0), Vec3(0.0, 0.0, -1.0)};
                CHECK(crossings(*scene, ray).size() % 2 == 0);
                const Ray askew{Vec3(x + 4.0, y + 4.0, 4.0), Vec3(-1.0, -1.0, -1.0)};
                CHECK(crossings(*scene, askew).size() % 2 == 0);
            }
        }
    }
    // Through the diagonals of the mesh's faces, along which two triangles meet.
    const std::vector<PrimitiveHit> hits =
        crossings(sceneOf(kCubeMesh), {Vec3(0.0, 0.0, 9.0), Vec3(0.0, 0.0, -1.0)});
    REQUIRE(hits.size() == 2);
    CHECK(hits[0].t == 8.0);
    CHECK(hits[1].t == 10.0);
}

TEST_CASE("rays of one signature cross the same of a combined solid in the same order") {
    Draws draws(12);
    int again = 0;
    for (int i = 0; i < 30; ++i) {
        const Solid solid = expression(draws, 2 + draws.below(2));
        CAPTURE(solid.script);
        const RenderScene scene = sceneOf(solid.script);
        std::map<std::uint64_t, std::vector<Index>> seen;
        for (int k = 0; k < 400; ++k) {
            const Vec3 direction = glm::normalize(draws.vector(1.0));
            const Ray ray{draws.vector(1.2) - 9.0 * direction, direction};
            std::vector<Index> leaves;
            for (const PrimitiveHit& hit : crossings(scene, ray)) leaves.push_back(hit.leaf);
            const auto [entry, added] =
                seen.try_emplace(csgSignature(scene, ray, {0.0, kInfinity}), leaves);
            CHECK(entry->second == leaves);
            again += added ? 0 : 1;
        }
    }
    CHECK(again > 2000);
}

TEST_CASE("a signature tells the sides of what two parts share, and ends with the range") {
    const RenderScene lens = sceneOf(
        "gr.intersection('i', gr.nh_sphere('a', {-0.9, 0, 0}, 1), gr.nh_sphere('b', {0.9, 0, 0}, "
        "1), gr.nh_box('c', {-9, -9, -9}, 18))");
    const auto through = [&](double x, double reach) {
        const Ray ray{Vec3(x, 0.0, 5.0), Vec3(0.0, 0.0, -1.0)};
        return csgSignature(lens, ray, {0.0, reach});
    };
    CHECK(through(-0.099, kInfinity) != through(0.099, kInfinity));
    CHECK(through(-0.099, kInfinity) == through(-0.09, kInfinity));
    CHECK(through(0.5, kInfinity) == 0);
    CHECK(through(0.0, 4.0) == 0);
    CHECK(through(0.0, 5.0) != 0);
    CHECK(through(0.0, 5.0) != through(0.0, kInfinity));
}
