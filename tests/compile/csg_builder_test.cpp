#include "compile/csg_builder.h"

#include "rt/compile/compile.h"
#include "rt/core/error.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace rt;
using namespace rt::test;

namespace {

RenderScene compiled(const std::string& script, Diagnostics& diagnostics) {
    const Described run =
        describe("m = gr.material({1, 1, 1}, {0, 0, 0}, 10)\nroot = gr.node('root')\n" + script +
                 "\ngr.render(root, 'x.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})");
    AssetCache assets(1);
    return compileScene(run.scene, 0, {}, assets, diagnostics);
}

RenderScene compiled(const std::string& script) {
    Diagnostics diagnostics;
    return compiled(script, diagnostics);
}

const CsgShape& onlyCsg(const RenderScene& scene) {
    return *std::get<std::shared_ptr<const CsgShape>>(scene.shapes[scene.instances[0].shape]);
}

std::size_t warnings(const std::string& script, const std::string& kind) {
    Diagnostics diagnostics;
    compiled(script, diagnostics);
    const auto counts = diagnostics.countByKind();
    const auto found = counts.find(kind);
    return found == counts.end() ? 0 : found->second;
}

std::string failure(const std::string& script) {
    try {
        compiled(script);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

void checkBounds(const std::string& solid, const Vec3& lo, const Vec3& hi) {
    CAPTURE(solid);
    const RenderScene scene = compiled("root:add_child(" + solid + ", m)");
    const Bounds bounds = boundsOf(scene.shapes[scene.instances[0].shape]);
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::fabs(bounds.min[axis] - lo[axis]) < 1e-14);
        CHECK(std::fabs(bounds.max[axis] - hi[axis]) < 1e-14);
        CHECK(bounds.min[axis] <= lo[axis]);
        CHECK(bounds.max[axis] >= hi[axis]);
    }
}

const std::string kTwo = "a, b = gr.nh_box('a', {0,0,0}, 2), gr.nh_box('b', {1,1,1}, 4)\n";

}  // namespace

TEST_CASE("bounds are those of all, of what is common, and of the first") {
    const std::string two = "gr.nh_box('a', {0,0,0}, 2), gr.nh_sphere('b', {2,1,1}, 2))";
    checkBounds("gr.union('u', " + two, Vec3(0.0, -1.0, -1.0), Vec3(4.0, 3.0, 3.0));
    checkBounds("gr.intersection('i', " + two, Vec3(0.0), Vec3(2.0));
    checkBounds("gr.difference('d', " + two, Vec3(0.0), Vec3(2.0));
    checkBounds("gr.intersection('i', gr.union('u', " + two + ", gr.nh_box('c', {3,0,0}, 9))",
                Vec3(3.0, 0.0, 0.0), Vec3(4.0, 3.0, 3.0));
}

TEST_CASE("solids within solids become one expression, without what changes nothing") {
    const std::string calls[] = {
        "gr.union('x', gr.union('y', a, b), a, b)",
        "gr.intersection('x', gr.intersection('y', a, b), gr.intersection('z', a, b))",
        "gr.difference('x', gr.difference('y', a, b), gr.union('z', b, b))"};
    for (const std::string& call : calls) {
        CAPTURE(call);
        const RenderScene scene = compiled(kTwo + "root:add_child(" + call + ", m)");
        CHECK(onlyCsg(scene).leaves.size() == 4);
        CHECK(onlyCsg(scene).nodes.size() == 5);
    }
    const RenderScene far = compiled(
        kTwo + "root:add_child(gr.difference('d', a, gr.nh_sphere('far', {50, 0, 0}, 1)), m)");
    CHECK(onlyCsg(far).leaves.size() == 1);
}

TEST_CASE("the parts of a union of many lie in a tree, and those that one of them is less") {
    const auto crowds = [](const std::string& call, int parts) {
        const RenderScene scene =
            compiled("t = {} for i = 1, " + std::to_string(parts) +
                     " do t[i] = gr.nh_box('t', {i / 90, 0, 0}, 1) end\n" +
                     "a = gr.nh_box('a', {0, 0, 0}, 3) root:add_child(" + call + ", m)");
        const CsgShape& shape = onlyCsg(scene);
        CHECK(shape.leaves.size() >= std::size_t(parts));
        std::vector<std::size_t> sizes;
        for (const CsgCrowd& crowd : shape.crowds) sizes.push_back(crowd.children.size());
        return sizes;
    };
    using Sizes = std::vector<std::size_t>;
    CHECK(crowds("gr.union('u', table.unpack(t))", 8) == Sizes{});
    CHECK(crowds("gr.union('u', table.unpack(t))", 20) == Sizes{20});
    CHECK(crowds("gr.union('u', a, gr.union('v', table.unpack(t)))", 20) == Sizes{21});
    CHECK(crowds("gr.difference('d', a, table.unpack(t))", 8) == Sizes{});
    CHECK(crowds("gr.difference('d', a, table.unpack(t))", 20) == Sizes{20});
    CHECK(crowds("gr.intersection('i', a, table.unpack(t))", 20) == Sizes{});
    CHECK(crowds("gr.intersection('i', a, gr.union('v', table.unpack(t)))", 20) == Sizes{20});
}

TEST_CASE("an intersection of convex solids is convex, and nothing else is") {
    const auto isConvex = [](const std::string& solid) {
        return onlyCsg(compiled(kTwo + "root:add_child(" + solid + ", m)")).convex;
    };
    CHECK(isConvex("gr.intersection('i', a, gr.intersection('j', b, a))"));
    CHECK(!isConvex("gr.intersection('i', a, gr.torus('t'))"));
    CHECK(!isConvex("gr.union('u', a, b)"));
    CHECK(!isConvex("gr.difference('d', a, b)"));
    CHECK(!isConvex("gr.intersection('i', a, gr.union('u', a, b))"));
}

TEST_CASE("what bounds no solid is an error that says what would") {
    for (const auto& [part, what] :
         {std::pair("gr.plane('p')", "'p' of line 4, a plane, which bounds no solid: a box"),
          {"gr.disc('p')", "'p' of line 4, a disc"},
          {"gr.quad('p')", "'p' of line 4, a quad"},
          {"gr.mesh('p', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0,1,2}})",
           "'p' of line 4, an open mesh, which bounds no solid: each edge must belong to two"}}) {
        const std::string script =
            kTwo + "p = " + part + "\ng = gr.node('g') g:add_child(p)\nroot:add_child(";
        for (const std::string call : {"gr.difference('cut', a, p), m)",
                                       "gr.difference('cut', a, gr.union('u', b, g)), m)"}) {
            const std::string message = failure(script + call);
            CAPTURE(message);
            CHECK(contains(message, ":6: gr.difference: 'cut' cannot use " + std::string(what)));
        }
    }
}

TEST_CASE("a part that moves by itself is an error") {
    CHECK(contains(failure(kTwo + "b:move(1, 0, 0) root:add_child(gr.union('u', a, b), m)"),
                   "which moves by itself"));
    CHECK(failure(kTwo + "u = gr.union('u', a, b) u:move(1, 0, 0) root:add_child(u, m)") == "");
}

TEST_CASE("a part without an appearance is an error where the whole has none either") {
    const std::string message =
        failure(kTwo + "a:set_material(m)\nroot:add_child(gr.union('u', a, b))");
    CHECK(contains(message, ":3: node 'b' has neither a material nor a texture"));
    CHECK(failure(kTwo + "u = gr.union('u', a, b) u:set_material(m) root:add_child(u)") == "");
}

TEST_CASE("too many nodes in one solid, and too deep ones, are refused with the number") {
    CHECK(contains(failure(kTwo + "for i = 1, 17 do a = gr.union('u', a, a) end\n"
                                  "root:add_child(a, m)"),
                   "combines more than 65536 nodes"));
    CHECK(contains(failure(kTwo + "g = gr.node('g') for i = 1, 40 do local h = gr.node('h') "
                                  "h:add_child(g) h:add_child(g) g = h end\n"
                                  "root:add_child(gr.union('u', a, g), m)"),
                   "combines more than 65536 nodes"));
    CHECK(contains(failure(kTwo + "for i = 1, 1200 do a = gr.difference('u', a, b) end\n"
                                  "root:add_child(a, m)"),
                   "more than 1000 deep"));
    CHECK(failure(kTwo + "for i = 1, 450 do a = gr.union('v', gr.difference('u', a, b), b) end\n"
                         "root:add_child(a, m)") == "");
}

TEST_CASE("a solid of which nothing is left is skipped with a warning") {
    CHECK(warnings(kTwo + "root:add_child(gr.intersection('i', a, gr.nh_sphere('s', {9,9,9}, 1)), "
                          "m)",
                   "empty-solid") == 1);
    CHECK(warnings(kTwo + "g = gr.node('g') root:add_child(gr.union('u', g, g), m)",
                   "empty-solid") == 1);
    CHECK(warnings(kTwo + "g = gr.node('g') root:add_child(gr.difference('u', g, a), m)",
                   "empty-solid") == 1);
    CHECK(warnings(kTwo + "g = gr.node('g') root:add_child(gr.difference('u', a, g), m)",
                   "empty-solid") == 0);
    CHECK(warnings(kTwo + "b:scale(0, 1, 1) root:add_child(gr.union('u', a, b), m)",
                   "flat-object") == 1);
}

TEST_CASE("refraction is the whole's: that of a part is warned of") {
    CHECK(warnings(kTwo + "b:set_refraction(1.5, 0) root:add_child(gr.union('u', a, b), m)",
                   "unused-refraction") == 1);
    const RenderScene scene =
        compiled(kTwo +
                 "b:set_reflection(0.25) u = gr.union('u', a, b) u:set_refraction(1.5, 0) "
                 "root:add_child(u, m)");
    REQUIRE(scene.looks.size() == 2);
    CHECK(scene.looks[0].refracts);
    CHECK(scene.looks[1].refracts);
    CHECK(!scene.looks[0].reflects);
    CHECK(scene.looks[1].reflects);
    CHECK(scene.looks[1].reflectionOwnWeight == 0.25);
}

TEST_CASE("a node cannot be a part of itself") {
    CHECK(contains(failure(kTwo + "g = gr.node('g') u = gr.union('u', a, g)\nroot:add_child(u, m)\n"
                                  "g:add_child(u)"),
                   "cycle: u -> g -> u"));
}

TEST_CASE("parts are read when a picture is rendered, as children are") {
    Diagnostics diagnostics;
    const RenderScene scene = compiled(
        kTwo + "u = gr.union('u', a, b) root:add_child(u, m) b:translate(10, 0, 0)", diagnostics);
    CHECK(onlyCsg(scene).bounds.max.x == doctest::Approx(15.0));
}
