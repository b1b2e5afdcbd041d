#include "rt/compile/compile.h"

#include "support/render_script.h"

#include <doctest/doctest.h>

#include <string>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kWhite =
    "white = gr.material({1, 1, 1}, {0.5, 0.5, 0.5}, 10)\nroot = gr.node('root')\n";

std::string rendering(const std::string& lights = "{}", const std::string& lens = "") {
    return "\ngr.render(root, 'x.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0.25,0.25,0.25}, " +
           lights + lens + ")";
}

RenderScene compiled(const std::string& script, Diagnostics& diagnostics,
                     const CompileSettings& settings = {}) {
    const Described run = describe(script);
    AssetCache assets(1);
    return compileScene(run.scene, 0, settings, assets, diagnostics);
}

RenderScene compiled(const std::string& script) {
    Diagnostics diagnostics;
    return compiled(script, diagnostics);
}

}  // namespace

TEST_CASE("placing a mesh a hundred times holds it once") {
    const RenderScene scene = compiled(kWhite + R"(
        local mesh = gr.mesh('m', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0, 1, 2}})
        for i = 1, 100 do
            local place = gr.node('place')
            place:translate(i, 0, 0)
            place:add_child(mesh, white)
            root:add_child(place)
        end)" + rendering());
    CHECK(scene.instances.size() == 100);
    CHECK(scene.shapes.size() == 1);
    CHECK(scene.looks.size() == 1);
    CHECK(!scene.instances[0].closed);
}

TEST_CASE("features are those that the scene uses, and no others") {
    CHECK(compiled(kWhite + "root:add_child(gr.sphere('s'), white)" + rendering()).features == 0);
    CHECK(compiled(kWhite + "s = gr.sphere('s') s:set_reflection(0.5) root:add_child(s, white)" +
                   rendering())
              .features == kFeatureReflection);
    CHECK(compiled(kWhite + "s = gr.sphere('s') s:set_refraction(1.5, 0) root:add_child(s, white)" +
                   rendering())
              .features == kFeatureRefraction);
    CHECK(compiled(kWhite + "root:add_child(gr.sphere('s'), white)" +
                   rendering("{gr.light({0,5,0}, {1,1,1}, {1,0,0}, 2)}"))
              .features == kFeatureAreaLights);
    CHECK(compiled(kWhite + "root:add_child(gr.sphere('s'), white)" +
                   rendering("{}", ", gr.focal(5, 0.1, 0.2)"))
              .features == kFeatureLens);
    CHECK(compiled(kWhite + "root:add_child(gr.sphere('s'), white)" +
                   rendering("{}", ", gr.focal(5, 0.1, 0)"))
              .features == 0);
}

TEST_CASE("a flat object is skipped with a warning, a matrix without an inverse is an error") {
    Diagnostics diagnostics;
    const RenderScene scene = compiled(
        kWhite + "s = gr.sphere('s') s:scale(0, 1, 1) root:add_child(s, white)" + rendering(),
        diagnostics);
    CHECK(scene.instances.empty());
    CHECK(diagnostics.countByKind().count("flat-object") == 1);
}

TEST_CASE("what is placed without an appearance is an error that names the node and its line") {
    CHECK_THROWS_WITH_AS(
        compiled(kWhite + "\n\nroot:add_child(gr.sphere('naked'))" + rendering()),
        doctest::Contains("scene.lua:5: node 'naked' has neither a material nor a texture"),
        SceneError);
}

TEST_CASE("more objects than the limit are refused before they are made") {
    CompileSettings settings;
    settings.maxInstances = 1000;
    Diagnostics diagnostics;
    const std::string script =
        kWhite +
        "n = gr.sphere('s') n:set_material(white)\nfor i = 1, 40 do local p = gr.node('p') "
        "p:add_child(n) p:add_child(n) n = p end\nroot:add_child(n)" +
        rendering();
    CHECK_THROWS_WITH_AS(compiled(script, diagnostics, settings),
                         doctest::Contains("1099511627776 objects"), LimitError);
}

TEST_CASE("nothing is brighter than the bound") {
    const std::string ball = kWhite + "root:add_child(gr.sphere('s'), white)";
    // kd * ambient + I / (c0 + c1 d) * (kd + ks), d at least 9 from the light to the ball's box.
    const RenderScene scene =
        compiled(ball + rendering("{gr.light({0, 10, 0}, {2, 1, 1}, {1, 1, 0})}"));
    CHECK(scene.radianceBound == doctest::Approx(0.25 + 2.0 / 10.0 * 1.5));
    CHECK(compiled(ball + rendering("{gr.light({0, 0, 0}, {1, 1, 1}, {0, 1, 0})}")).radianceBound ==
          kInfinity);
    CHECK(compiled("gr.background({7, 0, 0})\n" + ball + rendering()).radianceBound == 7.0);
}

TEST_CASE("a snapshot is what the script had said by then") {
    const Described run = describe(kWhite + R"(
        local ball = gr.sphere('ball')
        root:add_child(ball, white))" +
                                   rendering() + R"(
        ball:translate(5, 0, 0)
        root:add_child(gr.sphere('late'), white))" +
                                   rendering());
    AssetCache assets(1);
    Diagnostics diagnostics;
    const RenderScene first = compileScene(run.scene, 0, {}, assets, diagnostics);
    const RenderScene second = compileScene(run.scene, 1, {}, assets, diagnostics);
    REQUIRE(first.instances.size() == 1);
    CHECK(first.instances[0].transform.isIdentity());
    REQUIRE(second.instances.size() == 2);
    CHECK(second.instances[0].transform.toWorld().translation == Vec3(5, 0, 0));
}
