// Materials, images, lights and lenses, and to whom they are given.
#include "gr_script.h"

#include <doctest/doctest.h>

using namespace rt;
using rt::test::runScene;
using rt::test::SceneFolder;
using rt::test::ScriptRun;

TEST_CASE("a material is three terms as given") {
    const ScriptRun run = runScene(
        "\ngr.material({0.1, 2, 0}, {0.5, 0.6, 0.7}, 25)\n"
        "gr.material({0,0,0}, {0,0,0}, 0) gr.material({0,0,0}, {0,0,0}, 1e9)");
    REQUIRE(run.error == "");
    const MaterialDesc& desc = run.scene().materials.at(0);
    CHECK(desc.material.diffuse == Color(0.1, 2, 0));
    CHECK(desc.material.specular == Color(0.5, 0.6, 0.7));
    CHECK(desc.material.exponent == 25.0);
    CHECK(desc.where.line == 2);
    CHECK(run.scene().materials.at(2).material.exponent == 1e9);
}

TEST_CASE("negative colours warn once for each call site, bright ones do not") {
    const ScriptRun run = runScene(
        "for i = 1, 9 do\n gr.material({-0.5, 1, 7}, {0,0,0}, 1)\nend\n"
        "gr.light({0,0,0}, {1,-1,1}, {1,0,0})\ngr.light(0,0,0, 1,1,-1, 1,0,0)\n"
        "gr.background({0,0,-1})");
    REQUIRE(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.material: diffuse[1] is negative (-0.5)") == 1);
    CHECK(run.warnings("scene.lua:4: gr.light: colour[2] is negative (-1)") == 1);
    CHECK(run.warnings("scene.lua:5: gr.light: the colour has a negative channel") == 1);
    CHECK(run.warnings("scene.lua:6: gr.background: colour[3] is negative (-1)") == 1);
    CHECK(run.diagnostics.countByKind().at("negative-colour") == 4);
}

TEST_CASE("images are found by their role, and the same file is one image") {
    const SceneFolder folder;
    folder.write("Texture/wood.png");
    folder.write("Bump/brick.png");
    folder.write("sky.exr");
    const ScriptRun run = runScene(folder, R"(
        gr.texture('wood.png', {0.1,0.2,0.3}, 5) gr.texture('Texture/wood.png', {0,0,0}, 1)
        gr.bumpmap('brick.png') gr.background('sky.exr') gr.bumpmap('./sky.exr')
        gr.render(gr.node('n'), 'a.png', 4, 4, {0,0,0}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {}))");
    REQUIRE(run.error == "");
    const SceneDesc& scene = run.scene();
    REQUIRE(scene.images.size() == 3);
    CHECK(scene.images[0].path == (folder.path() / "Texture/wood.png").string());
    CHECK(scene.images[0].where.line == 2);
    CHECK(scene.textures.at(0).image == 0);
    CHECK(scene.textures.at(0).specular == Color(0.1, 0.2, 0.3));
    CHECK(scene.textures.at(0).exponent == 5.0);
    CHECK(scene.textures.at(1).image == 0);
    CHECK(scene.bumps.at(0).image == 1);
    CHECK(scene.bumps.at(1).image == 2);
    CHECK(scene.renders.at(0).background.image == 2);
}

TEST_CASE("a missing asset is an error at its line that lists where it was looked for") {
    const SceneFolder folder;
    const std::string base = folder.path().string();
    const ScriptRun run = runScene(folder, "\ngr.texture('oak.png', {0,0,0}, 1)");
    CHECK(run.code == ExitCode::kScene);
    CHECK(run.error.find("scene.lua:2: gr.texture: cannot find 'oak.png'; looked for:") == 0);
    for (const char* place :
         {"/oak.png", "/Texture/oak.png", "/Assets/Texture/oak.png", "/Assets/oak.png"}) {
        CAPTURE(place);
        CHECK(run.error.find(base + place) != std::string::npos);
    }
    CHECK(run.error.find("Bump") == std::string::npos);
    CHECK(
        runScene(folder, "gr.bumpmap('no such bumps.png')").error.find("gr.bumpmap: cannot find") !=
        std::string::npos);
    CHECK(runScene(folder, "gr.background('no such sky.png')")
              .error.find("gr.background: cannot find") != std::string::npos);
    CHECK(runScene(folder, "gr.mesh('m', 'x.obj')").error.find(base + "/Model/x.obj") !=
          std::string::npos);
    CHECK(runScene(folder, "gr.mesh('m', '/etc/passwd')").error ==
          "scene.lua:1: gr.mesh: '/etc/passwd' is denied: absolute paths need --trust");
}

TEST_CASE("a geometry node takes its own appearance") {
    const SceneFolder folder;
    folder.write("a.png");
    const ScriptRun run = runScene(folder, R"(
        s = gr.sphere('s') t = gr.sphere('t')
        s:set_material(gr.material({1,1,1}, {0,0,0}, 1))
        s:set_texture(gr.texture('a.png', {0,0,0}, 1)) gr.set_bumpmap(s, gr.bumpmap('a.png'))
        s:set_reflection(0.25) s:set_refraction(1.5, 0.75) s:set_fresnel(true)
        s:set_absorption{0, 0.5, 2}
        t:set_reflection(0) t:set_fresnel(true) t:set_fresnel(false))");
    REQUIRE(run.error == "");
    const NodeState& state = run.scene().nodes.at(0).latest();
    CHECK(state.appearance.material == 0);
    CHECK(state.appearance.texture == 0);
    CHECK(state.appearance.bump == 0);
    CHECK(state.reflection == 0.25);
    REQUIRE(state.refraction);
    CHECK(state.refraction->index == 1.5);
    CHECK(state.refraction->ownWeight == 0.75);
    CHECK(state.fresnel);
    CHECK(state.absorption == Color(0.0, 0.5, 2.0));
    CHECK(run.scene().nodes.at(1).latest().reflection == 0.0);
    CHECK_FALSE(run.scene().nodes.at(1).latest().fresnel);
    CHECK_FALSE(run.scene().nodes.at(1).latest().refraction);
}

TEST_CASE("a group ignores appearance with a warning") {
    const ScriptRun run = runScene(
        "g = gr.node('g') m = gr.material({1,1,1}, {0,0,0}, 1)\n"
        "g:set_material(m)\ng:set_reflection(0.5)\ngr.node('p'):add_child(g, m)");
    REQUIRE(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.set_material: the material is ignored: 'g' is a group") ==
          1);
    CHECK(run.warnings("scene.lua:3: gr.set_reflection: the reflection is ignored") == 1);
    CHECK(run.warnings("scene.lua:4: gr.add_child: the appearance is ignored: 'g' is a group") ==
          1);
    CHECK(run.scene().nodes[0].latest().appearance.material == kNone);
    CHECK_FALSE(run.scene().nodes[0].latest().reflection);
    CHECK(run.scene().nodes[1].latest().children.at(0).appearance.material == kNone);
}

TEST_CASE("an index of refraction below one warns") {
    const ScriptRun run = runScene("gr.sphere('s'):set_refraction(0.9, 0)");
    CHECK(run.error == "");
    CHECK(run.warnings("gr.set_refraction: index 0.9 is below 1") == 1);
}

TEST_CASE("a light has the same values in every form") {
    const ScriptRun run = runScene(R"(
        ls = {gr.light({1,2,3}, {4,5,6}, {7,8,9}), gr.light({1,2,3}, {4,5,6}, {7,8,9}, 10),
              gr.light({1,2,3}, {4,5,6}, {7,8,9}, 10, 0.5),
              gr.light(1,2,3, 4,5,6, 7,8,9, 10, 0.5), gr.light(1,2,3, 4,5,6, 7,8,9),
              gr.light({1,2,3}, {4,5,6}, {0,0,2}, 0)}
        gr.render(gr.node('n'), 'a.png', 4, 4, {0,0,0}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, ls))");
    REQUIRE(run.error == "");
    CHECK(run.diagnostics.total() == 0);
    const auto& lights = run.scene().renders.at(0).lights;
    REQUIRE(lights.size() == 6);
    const double radius[] = {0, 10, 10, 10, 0};
    const double brightness[] = {0, 0, 0.5, 0.5, 0};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        const Light& light = lights[i].light;
        CHECK(light.position == Vec3(1, 2, 3));
        CHECK(light.intensity == Color(4, 5, 6));
        CHECK(Vec3(light.c0, light.c1, light.c2) == Vec3(7, 8, 9));
        CHECK(light.radius == radius[i]);
        CHECK(light.brightness == brightness[i]);
    }
    CHECK(lights[5].light.c0 == 0.0);
    CHECK(lights[3].where.line == 4);
}

TEST_CASE("a falloff of zeros is a constant one, with a warning") {
    const ScriptRun run = runScene(R"(
        ls = {gr.light({1,2,3}, {4,5,6}, {0,0,0}), gr.light(1,2,3, 4,5,6, 0,0,0)}
        gr.render(gr.node('n'), 'a.png', 4, 4, {0,0,0}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, ls))");
    REQUIRE(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.light: falloff {0,0,0} is taken as {1,0,0}") == 1);
    for (const LightDesc& desc : run.scene().renders.at(0).lights) {
        CHECK(Vec3(desc.light.c0, desc.light.c1, desc.light.c2) == Vec3(1, 0, 0));
    }
}

TEST_CASE("a lens is focused at a distance or on a point") {
    const ScriptRun run = runScene(R"(
        function go(f) gr.render(gr.node(''), 'a.png', 4, 4, {0,0,5}, {0,0,-3}, {0,1,0}, 50,
                                 {0,0,0}, {gr.light({0,0,0},{1,1,1},{1,0,0})}, f) end
        go(gr.focal(10, 2, 0.5)) go(gr.focal({1,1,0}, 4.9, 0)) go(nil))");
    REQUIRE(run.error == "");
    const auto& renders = run.scene().renders;
    REQUIRE(renders.size() == 3);
    CHECK(std::get<double>(renders[0].camera.focal->focus) == 10.0);
    CHECK(renders[0].camera.focal->focalLength == 2.0);
    CHECK(renders[0].camera.focal->lensRadius == 0.5);
    CHECK(std::get<Vec3>(renders[1].camera.focal->focus) == Vec3(1, 1, 0));
    CHECK_FALSE(renders[2].camera.focal);
}
