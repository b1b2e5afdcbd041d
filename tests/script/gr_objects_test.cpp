// The userdata of scene scripts cannot be forged, opened, or mistaken for one another.
#include "gr_script.h"

#include <doctest/doctest.h>

using namespace rt;
using rt::test::runScene;
using rt::test::SceneFolder;
using rt::test::ScriptRun;

namespace {

const char* const kObjects =
    "n = gr.sphere('ball') m = gr.material({1,1,1}, {0,0,0}, 1)\n"
    "l = gr.light({0,0,0}, {1,1,1}, {1,0,0}) f = gr.focal(10, 1, 0.5)\n";

std::string errorOf(const std::string& line) {
    return runScene(kObjects + line).error;
}

}  // namespace

TEST_CASE("an object of another kind is named in the message") {
    CHECK(errorOf("n.translate(l, 1, 2, 3)") ==
          "scene.lua:3: gr.translate: node: gr.node expected, got gr.light");
    CHECK(errorOf("n:set_material(n)") ==
          "scene.lua:3: gr.set_material: material: gr.material expected, got gr.node");
    CHECK(errorOf("n:set_texture(m)") ==
          "scene.lua:3: gr.set_texture: texture: gr.texture expected, got gr.material");
    CHECK(errorOf("n:set_bumpmap(f)") ==
          "scene.lua:3: gr.set_bumpmap: bump: gr.bumpmap expected, got gr.focal");
    CHECK(errorOf("n:set_material(nil)") ==
          "scene.lua:3: gr.set_material: material: gr.material expected, got nil");
    CHECK(errorOf("n:add_child(m)") ==
          "scene.lua:3: gr.add_child: child: gr.node expected, got gr.material");
    CHECK(errorOf("n:add_child(gr.node('c'), nil, m)") ==
          "scene.lua:3: gr.add_child: texture: gr.texture expected, got gr.material");
    CHECK(errorOf("n.translate(1, 2, 3)") ==
          "scene.lua:3: gr.translate: node: gr.node expected, got number 1; the call is "
          "node:translate(dx, dy, dz)");
}

TEST_CASE("what only looks like an object is refused") {
    CHECK(errorOf("n.translate(io.stdout, 1, 2, 3)") ==
          "scene.lua:3: gr.translate: node: gr.node expected, got FILE*");
    CHECK(errorOf("n.translate({}, 1, 2, 3)").find("gr.node expected, got table") !=
          std::string::npos);
    CHECK(errorOf("n.translate(setmetatable({}, {__name = 'gr.node', __index = n}), 1, 2, 3)")
              .find("gr.node expected, got table") != std::string::npos);
    CHECK(errorOf("setmetatable({}, getmetatable(n))").find("setmetatable") != std::string::npos);
}

TEST_CASE("metatables are locked and hold no finaliser") {
    const ScriptRun run = runScene(std::string(kObjects) + R"(
        assert(getmetatable(n) == 'gr.node' and getmetatable(gr) == 'gr')
        assert(getmetatable(m) == 'gr.material' and getmetatable(l) == 'gr.light')
        assert(not pcall(function() return n.__gc end))
        assert(not pcall(setmetatable, gr, {}))
        assert(not pcall(rawget, n, '__index')))");
    CHECK(run.error == "");
}

TEST_CASE("objects take no fields and say so") {
    CHECK(
        errorOf("n.speed = 3") ==
        "scene.lua:3: gr.node takes no fields of its own (tried to set 'speed'); keep such values "
        "in a table");
    CHECK(errorOf("print(m.colour)") == "scene.lua:3: gr.material has no field 'colour'");
    CHECK(errorOf("l[{}] = 1").find("gr.light takes no fields of its own (tried to set 'table')") !=
          std::string::npos);
}

TEST_CASE("misspelt functions and methods are told the nearest name") {
    CHECK(runScene("\ngr.sphear('s')").error ==
          "scene.lua:2: gr has no function 'sphear'; did you mean 'sphere'?");
    CHECK(runScene("gr.Set_Materiel()").error ==
          "scene.lua:1: gr has no function 'Set_Materiel'; did you mean 'set_material'?");
    CHECK(runScene("gr.quadrilateral()").error ==
          "scene.lua:1: gr has no function 'quadrilateral'");
    CHECK(errorOf("n:transalte(1, 2, 3)") ==
          "scene.lua:3: gr.node has no method 'transalte'; did you mean 'translate'?");
    CHECK(runScene("return gr[{}]").error == "scene.lua:1: gr has no function 'table'");
    CHECK(runScene("gr['\\27[2J']()").error == "scene.lua:1: gr has no function '\\x1b[2J'");
}

TEST_CASE("tostring names the object, without an address") {
    const ScriptRun run = runScene(std::string(kObjects) + R"(
        assert(tostring(n) == "gr.node 'ball'", tostring(n))
        assert(tostring(m) == 'gr.material 1' and tostring(l) == 'gr.light 1')
        assert(tostring(f) == 'gr.focal 1')
        assert(tostring(gr.node('\27[2J')) == "gr.node '\\x1b[2J'"))");
    CHECK(run.error == "");
}

TEST_CASE("handles are themselves as keys, and survive collection in the graph") {
    const ScriptRun run = runScene(R"(
        root = gr.node('root') t = {[root] = 1} assert(t[root] == 1 and root ~= gr.node('root2'))
        do root:add_child(gr.sphere('gone')) end
        collectgarbage() collectgarbage()
        root:add_child(gr.node('more')))");
    REQUIRE(run.error == "");
    const auto& children = run.scene().nodes[0].latest().children;
    REQUIRE(children.size() == 2);
    CHECK(run.scene().nodes[children[0].child].name == "gone");
}

TEST_CASE("functions that a script adds to gr are methods too, and overwriting hurts only itself") {
    const ScriptRun run = runScene(R"(
        function gr.lift(node, by) node:translate(0, by, 0) return node end
        n = gr.node('n') assert(n:lift(3) == n)
        old = gr.sphere gr.sphere = nil assert(not pcall(function() return gr.sphere end))
        s = old('s') gr = nil s:translate(1, 0, 0))");
    REQUIRE(run.error == "");
    CHECK(run.scene().nodes[0].latest().transform.translation == Vec3(0, 3, 0));
    CHECK(run.scene().nodes[1].latest().transform.translation == Vec3(1, 0, 0));
}

TEST_CASE("a script may catch the error of a call and go on") {
    const ScriptRun run = runScene(R"(
        ok, why = pcall(gr.nh_sphere, 's', {0,0,0}, -1)
        assert(not ok and why:find('gr.nh_sphere: radius must be > 0 (got -1)', 1, true), why)
        ok, why = pcall(function() gr.sphear() end)
        assert(not ok and why:find("did you mean 'sphere'", 1, true), why)
        gr.node('after'))");
    REQUIRE(run.error == "");
    CHECK(run.scene().nodes.size() == 1);
}

TEST_CASE("errors inside coroutines and nested functions carry the line of the gr call") {
    CHECK(runScene("co = coroutine.create(function()\n gr.sphere()\nend)\n"
                   "_, why = coroutine.resume(co) error(why, 0)")
              .error.find("scene.lua:2: gr.sphere: name is") != std::string::npos);
    CHECK(runScene("function f(n)\n  return gr.sphere(n)\nend\nf({})").error.substr(0, 28) ==
          "scene.lua:2: gr.sphere: name");
}

TEST_CASE("extra arguments are ignored with one warning for each call site") {
    const ScriptRun run = runScene(
        "for i = 1, 100 do\n  gr.nh_sphere('s' .. i, {0,0,0}, 1, 'more', 2)\nend\n"
        "gr.nh_sphere('t', {0,0,0}, 1, 2)\ngr.nh_sphere('u', {0,0,0}, 1, nil)");
    CHECK(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.nh_sphere: takes 3 arguments; the rest is ignored") == 1);
    CHECK(run.warnings("scene.lua:4: gr.nh_sphere: takes 3 arguments") == 1);
    CHECK(run.diagnostics.countByKind().at("extra-arguments") == 2);
}

TEST_CASE("longer tuples are cut with one warning for each call site") {
    const ScriptRun run = runScene("for i = 1, 9 do\n  gr.nh_sphere('s' .. i, {1,2,3,4}, 1)\nend");
    CHECK(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.nh_sphere: centre has more than 3 values; the rest is "
                       "ignored") == 1);
}

TEST_CASE("a second node of the same name is noted, nameless nodes are not") {
    const ScriptRun run = runScene("gr.node('a')\ngr.sphere('a') gr.node('') gr.node('')");
    CHECK(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.sphere: another node is called 'a' too") == 1);
    CHECK(run.diagnostics.total() == 2);  // with "nothing was rendered"
}

TEST_CASE("the description counts against the script's memory") {
    ScriptSettings settings;
    settings.memoryLimit = std::size_t{8} << 20;
    const ScriptRun run = runScene("for i = 1, 1e9 do gr.node('') end", settings);
    CHECK(run.code == ExitCode::kLimit);
    CHECK(run.error.find("scene.lua:1: ") == 0);
    CHECK(run.error.find("--script-memory") != std::string::npos);
    const ScriptRun caught =
        runScene("pcall(function() for i = 1, 1e9 do gr.node('') end end)", settings);
    CHECK(caught.error == "");
    CHECK(caught.scene().nodes.size() < 100000);
}
