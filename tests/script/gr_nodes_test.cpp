// Nodes, transforms, primitives, meshes and the graph that they make.
#include "gr_script.h"

#include "rt/core/numeric.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace rt;
using rt::test::runScene;
using rt::test::SceneFolder;
using rt::test::ScriptRun;

namespace {

Vec3 moved(const ScriptRun& run, std::size_t node, const Vec3& p) {
    return run.scene().nodes.at(node).latest().transform.point(p);
}

void checkClose(const Vec3& a, const Vec3& b) {
    CAPTURE(a.x);
    CAPTURE(a.y);
    CAPTURE(a.z);
    CHECK(glm::distance(a, b) <= gamma(32) * (1.0 + glm::length(b)));
}

template <class Shape>
const Shape& shapeOf(const ScriptRun& run, std::size_t node) {
    return std::get<Shape>(run.scene().geometries.at(run.scene().nodes.at(node).geometry).shape);
}

void checkBounds(const Bounds& bounds, const Vec3& lo, const Vec3& hi) {
    checkClose(bounds.min, lo);
    checkClose(bounds.max, hi);
}

}  // namespace

TEST_CASE("a node starts with the identity, its name and the line that made it") {
    const ScriptRun run = runScene("\ngr.node('root')");
    REQUIRE(run.error == "");
    const NodeDesc& node = run.scene().nodes.at(0);
    CHECK(node.name == "root");
    CHECK(node.geometry == kNone);
    CHECK(node.where.line == 2);
    CHECK(node.latest().transform.isIdentity());
    CHECK(node.latest().children.empty());
    CHECK_FALSE(node.latest().fresnel);
    CHECK_FALSE(node.latest().reflection);
}

TEST_CASE("what is called last is applied last") {
    const ScriptRun run = runScene(
        "n = gr.node('a') n:translate(1, 0, 0) n:rotate('z', 90) n:scale(2, 2, 2)\n"
        "m = gr.node('b') gr.scale(m, 2, 2, 2) gr.rotate(m, 'Z', 90) gr.translate(m, 1, 0, 0)");
    REQUIRE(run.error == "");
    checkClose(moved(run, 0, {1, 0, 0}), {0, 4, 0});
    checkClose(moved(run, 1, {1, 0, 0}), {1, 2, 0});
}

TEST_CASE("legacy transforms apply first what is called last") {
    ScriptSettings settings;
    settings.legacyTransforms = true;
    const ScriptRun run =
        runScene("n = gr.node('a') n:translate(1, 0, 0) n:rotate('z', 90)", settings);
    checkClose(moved(run, 0, {1, 0, 0}), {1, 1, 0});
}

TEST_CASE("rotations are right-handed about the named axis") {
    const ScriptRun run = runScene(
        "gr.node('x'):rotate('X', 90) gr.node('y'):rotate('y', 90) gr.node('z'):rotate('z', 90)");
    checkClose(moved(run, 0, {0, 1, 0}), {0, 0, 1});
    checkClose(moved(run, 1, {0, 0, 1}), {1, 0, 0});
    checkClose(moved(run, 2, {1, 0, 0}), {0, 1, 0});
}

TEST_CASE("a joint turns first about x, then about y") {
    const ScriptRun run = runScene("gr.joint('j', {-180, 90, 180}, {-180, 90, 180})");
    checkClose(moved(run, 0, {0, 1, 0}), {1, 0, 0});
    checkClose(moved(run, 0, {1, 0, 0}), {0, 0, -1});
}

TEST_CASE("a joint's initial angle is brought into its range with a warning") {
    const ScriptRun run = runScene("\ngr.joint('j', {0, 0, 0}, {-45, 120, 90})");
    REQUIRE(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.joint: y: the initial angle 120 lies outside -45 .. 90; 90 "
                       "is used") == 1);
    checkClose(moved(run, 0, {0, 0, 1}), {1, 0, 0});
    const ScriptRun swapped = runScene("gr.joint('j', {0, 0, 0}, {90, 100, -45})");
    REQUIRE(swapped.error == "");
    CHECK(swapped.warnings("gr.joint: y: min 90 is above max -45; they are swapped") == 1);
    checkClose(moved(swapped, 0, {0, 0, 1}), {1, 0, 0});
}

TEST_CASE("a scale by zero warns and keeps the flat matrix") {
    const ScriptRun run = runScene("n = gr.sphere('s')\nn:scale(0, 1, 1)\nn:translate(3, 0, 0)");
    REQUIRE(run.error == "");
    CHECK(run.warnings("scene.lua:2: gr.scale: 's' is scaled by 0: the object is flat and is "
                       "skipped") == 1);
    CHECK(moved(run, 0, {5, 1, 1}) == Vec3(3, 1, 1));
}

TEST_CASE("a matrix that overflows, or whose inverse does, is refused at the call") {
    CHECK(runScene("n = gr.node('n') n:scale(1e300,1,1)\nn:scale(1e300,1,1)").error ==
          "scene.lua:2: gr.scale: the node's matrix is no longer finite");
    CHECK(runScene("n = gr.node('n') n:scale(1e-200,1,1)\nn:scale(1e-200,1,1)").error ==
          "scene.lua:2: gr.scale: the node's matrix has no finite inverse any more");
    CHECK(runScene("n = gr.node('n')\nn:scale(1e-320,1,1)").error ==
          "scene.lua:2: gr.scale: the node's matrix has no finite inverse any more");
    CHECK(runScene("n = gr.node('n') n:translate(1e308,0,0)\nn:translate(1e308,0,0)").error ==
          "scene.lua:2: gr.translate: the node's matrix is no longer finite");
}

TEST_CASE("a mirror is an ordinary scale") {
    const ScriptRun run = runScene("n = gr.sphere('s') n:scale(-1, 2, 3)");
    CHECK(run.error == "");
    CHECK(run.warnings("gr.scale") == 0);
}

TEST_CASE("every primitive lies where its call says") {
    const ScriptRun run = runScene(R"(
        gr.sphere('0') gr.cube('1') gr.cylinder('2') gr.cone('3') gr.torus('4')
        gr.torus('5', 3) gr.torus('6', 3, 2)
        gr.nh_sphere('7', {1,2,3}, 4)
        gr.nh_box('8', {1,2,3}, 4) gr.nh_box('9', {1,2,3}, {4,5,6})
        gr.nh_cylinder('10', {1,2,3}, 5, 2) gr.nh_cone('11', {1,2,3}, 5, 2)
        gr.nh_torus('12', {1,2,3}, 4, 1) gr.nh_torus('13', {0,0,0}, 1, 2))");
    REQUIRE(run.error == "");
    checkBounds(shapeOf<Sphere>(run, 0).bounds(), Vec3(-1), Vec3(1));
    checkBounds(shapeOf<Box>(run, 1).bounds(), Vec3(0), Vec3(1));
    checkBounds(shapeOf<Cylinder>(run, 2).bounds(), Vec3(-1), Vec3(1));
    checkBounds(shapeOf<Cone>(run, 3).bounds(), {-1, 0, -1}, {1, 1, 1});
    checkBounds(shapeOf<Torus>(run, 4).bounds(), {-1.25, -1.25, -0.25}, {1.25, 1.25, 0.25});
    checkBounds(shapeOf<Torus>(run, 5).bounds(), {-3.25, -3.25, -0.25}, {3.25, 3.25, 0.25});
    checkBounds(shapeOf<Torus>(run, 6).bounds(), {-5, -5, -2}, {5, 5, 2});
    checkBounds(shapeOf<Sphere>(run, 7).bounds(), {-3, -2, -1}, {5, 6, 7});
    checkBounds(shapeOf<Box>(run, 8).bounds(), {1, 2, 3}, {5, 6, 7});
    checkBounds(shapeOf<Box>(run, 9).bounds(), {1, 2, 3}, {5, 7, 9});
    checkBounds(shapeOf<Cylinder>(run, 10).bounds(), {-1, 2, 1}, {3, 7, 5});
    checkBounds(shapeOf<Cone>(run, 11).bounds(), {-1, 2, 1}, {3, 7, 5});
    checkBounds(shapeOf<Torus>(run, 12).bounds(), {-4, -3, 2}, {6, 7, 4});
    checkBounds(shapeOf<Torus>(run, 13).bounds(), {-3, -3, -2}, {3, 3, 2});
}

TEST_CASE("an edge carries its own appearance, and one child hangs under many parents") {
    const ScriptRun run = runScene(R"(
        s = gr.sphere('s') m = gr.material({1,0,0}, {0,0,0}, 1) own = gr.material({0,1,0}, {0,0,0}, 1)
        s:set_material(own)
        a = gr.node('a') b = gr.node('b')
        a:add_child(s) b:add_child(s, m) b:add_child(s, nil, nil, nil)
        s:add_child(gr.node('below')))");
    REQUIRE(run.error == "");
    const auto& nodes = run.scene().nodes;
    REQUIRE(nodes.at(2).latest().children.size() == 2);
    CHECK(nodes[1].latest().children.at(0).appearance.material == kNone);
    CHECK(nodes[2].latest().children[0].child == 0);
    CHECK(nodes[2].latest().children[0].appearance.material == 0);
    CHECK(nodes[2].latest().children[0].appearance.texture == kNone);
    CHECK(nodes[2].latest().children[0].where.line == 5);
    CHECK(nodes[2].latest().children[1].appearance.material == kNone);
    CHECK(nodes[0].latest().appearance.material == 1);
    CHECK(nodes[0].latest().children.at(0).child == 3);
}

TEST_CASE("a cycle is refused at the add_child that closes it") {
    CHECK(runScene("a = gr.node('a')\na:add_child(a)").error ==
          "scene.lua:2: gr.add_child: cycle: a -> a");
    CHECK(runScene("a = gr.node('a') b = gr.node('b') a:add_child(b)\nb:add_child(a)").error ==
          "scene.lua:2: gr.add_child: cycle: a -> b -> a");
    CHECK(runScene("a = gr.node('a') b = gr.node('b') c = gr.sphere('c') d = gr.node('d')\n"
                   "a:add_child(d) a:add_child(b) b:add_child(c) c:add_child(d)\n"
                   "d:add_child(b)")
              .error == "scene.lua:3: gr.add_child: cycle: b -> c -> d -> b");
    const std::string chain =
        "p = gr.node('top') first = p\n"
        "for i = 1, 1000 do c = gr.node('n' .. i) p:add_child(c) p = c end\n";
    CHECK(runScene(chain + "p:add_child(first)").error ==
          "scene.lua:3: gr.add_child: cycle: top -> n1 -> n2 -> n3 -> n4 -> n5 -> n6 -> n7 -> n8 "
          "-> n9 -> n10 -> n11 -> ... -> n1000 -> top");
}

TEST_CASE("a refused edge is not in the graph") {
    const ScriptRun run = runScene(
        "a = gr.node('a') b = gr.node('b') a:add_child(b) assert(not pcall(b.add_child, b, a))\n"
        "c = gr.node('c') c:add_child(a) b:add_child(gr.node('d'))");
    REQUIRE(run.error == "");
    CHECK(run.scene().nodes[1].latest().children.size() == 1);
}

TEST_CASE("chains, wide groups and ladders of many nodes are built in linear time") {
    // Each of these takes a day where a search visits what it need not.
    const ScriptRun run = runScene(R"(
        local n = 100000
        local top = gr.node('') for i = 1, n do local c = gr.node('') top:add_child(c) top = c end
        local low = gr.node('') for i = 1, n do local p = gr.node('') p:add_child(low) low = p end
        local pairs_ = gr.node('')
        for i = 1, n // 2 do
          local p, q = gr.node(''), gr.node('') p:add_child(q) q:add_child(pairs_) pairs_ = p
        end
        local wide, under = gr.node(''), gr.node('') gr.node(''):add_child(under)
        for i = 1, n do wide:add_child(gr.node('')) end
        for i = 1, 1000 do
          local p = gr.node('') under:add_child(p) p:add_child(wide)
        end
        local ladder = gr.node('')
        for i = 1, n do
          local p = gr.node('') p:add_child(ladder) p:add_child(ladder) ladder = p
        end)");
    CHECK(run.error == "");
    CHECK(run.scene().nodes.size() > 500000);
}

TEST_CASE("a mesh file has one geometry for each smoothing, and a node for each call") {
    const SceneFolder folder;
    folder.write("cow.obj");
    const ScriptRun run = runScene(folder, R"(
        gr.mesh('a', 'cow.obj') gr.mesh('cow.obj', 'b') gr.mesh('c', './cow.obj', {smooth = true})
        gr.mesh('d', 'cow.obj', {smooth = false}) gr.mesh('e', 'cow.obj', {smooth = 0})
        gr.mesh('f.obj', 'cow.obj', {smooth = 30}) gr.mesh('cow.obj', 'g', {smooth = 30}))");
    REQUIRE(run.error == "");
    const SceneDesc& scene = run.scene();
    CHECK(scene.nodes.size() == 7);
    CHECK(scene.geometries.size() == 3);
    const Index geometry[] = {0, 0, 0, 1, 1, 2, 2};
    for (std::size_t i = 0; i < 7; ++i) CHECK(scene.nodes[i].geometry == geometry[i]);
    CHECK(scene.nodes[1].name == "b");
    CHECK(scene.nodes[5].name == "f.obj");
    CHECK(shapeOf<MeshFileDesc>(run, 0).path == (folder.path() / "cow.obj").string());
    CHECK_FALSE(shapeOf<MeshFileDesc>(run, 0).smoothAngle);
    CHECK(shapeOf<MeshFileDesc>(run, 3).smoothAngle == 0.0);
    CHECK(shapeOf<MeshFileDesc>(run, 5).smoothAngle == 30.0);
    CHECK(std::count(run.result->filesRead.begin(), run.result->filesRead.end(),
                     (folder.path() / "cow.obj").string()) == 1);
}

TEST_CASE("a mesh of tables keeps its polygons, and skips what has no area") {
    const ScriptRun run = runScene(
        "v = {{0,0,0}, {1,0,0}, {1,1,0}, {'0', 1, 0}, {0,0,1}}\n"
        "gr.mesh('m', v, {{0,1,2,3}, {0,1}, {4,'1',2.0}}, {smooth = 20})\n");
    REQUIRE(run.error == "");
    const auto& mesh = shapeOf<MeshTableDesc>(run, 0);
    CHECK(mesh.vertices.size() == 5);
    CHECK(mesh.vertices[3] == Vec3(0, 1, 0));
    CHECK(mesh.corners == std::vector<Index>{0, 1, 2, 3, 4, 1, 2});
    CHECK(mesh.faceSizes == std::vector<Index>{4, 3});
    CHECK(mesh.smoothAngle == 20.0);
    CHECK(run.warnings("scene.lua:2: gr.mesh: faces[2] has 2 corners and is skipped") == 1);
}

TEST_CASE("a mesh without faces warns") {
    const ScriptRun run = runScene("gr.mesh('m', {}, {})");
    CHECK(run.error == "");
    CHECK(run.warnings("gr.mesh: 'm' has no faces") == 1);
}

TEST_CASE("the tables of a mesh are checked to the last entry") {
    const std::string v = "v = {{0,0,0}, {1,0,0}, {1,1,0}}\n";
    const auto error = [&](const char* call) { return runScene(v + call).error; };
    CHECK(error("gr.mesh('m', v, {{0,1,3}})") ==
          "scene.lua:2: gr.mesh: faces[1][3] is vertex 3 of 3 (they count from 0)");
    CHECK(error("gr.mesh('m', v, {{0,1,2}, {0,-1,2}})").substr(0, 61) ==
          "scene.lua:2: gr.mesh: faces[2][2] must be a whole number in 0");
    CHECK(error("gr.mesh('m', v, {{0,1,1.5}})").substr(0, 61) ==
          "scene.lua:2: gr.mesh: faces[1][3] must be a whole number in 0");
    CHECK(error("gr.mesh('m', v, {{0,1,2^32+1}})").substr(0, 58) ==
          "scene.lua:2: gr.mesh: faces[1][3] must be a whole number i");
    CHECK(error("gr.mesh('m', v, {{0,1,{}}})") ==
          "scene.lua:2: gr.mesh: faces[1][3] must be a whole number (got table)");
    CHECK(error("gr.mesh('m', v, {7})") ==
          "scene.lua:2: gr.mesh: faces[1] must be a table of vertex numbers (got number 7)");
    CHECK(error("gr.mesh('m', {{0,0,0}, {0,0}}, {})") ==
          "scene.lua:2: gr.mesh: vertices[2] must have 3 numbers (got 2)");
    CHECK(error("gr.mesh('m', {{0,0,0}, {0,'y',0}}, {})") ==
          "scene.lua:2: gr.mesh: vertices[2][2] must be a number (got string \"y\")");
    CHECK(error("gr.mesh('m', {{0,0,0}, {0,0,0/0}}, {})") ==
          "scene.lua:2: gr.mesh: vertices[2][3] must be finite (got nan)");
    CHECK(error("gr.mesh('m', v)") ==
          "scene.lua:2: gr.mesh: faces is missing; the call is "
          "gr.mesh(name, vertices, faces [, options])");
    CHECK(error("gr.mesh('m', v, {}, {smoth = 1})") ==
          "scene.lua:2: gr.mesh: unknown option 'smoth'; did you mean 'smooth'? (known: smooth)");
    CHECK(error("gr.mesh('m', v, {}, {smooth = 181})") ==
          "scene.lua:2: gr.mesh: smooth must be in 0 .. 180 (got 181)");
    CHECK(error("gr.mesh('m', v, {}, {smooth = 'x'})") ==
          "scene.lua:2: gr.mesh: smooth must be true, false or degrees (got string \"x\")");
    CHECK(error("gr.mesh('m', v, {}, {1})") ==
          "scene.lua:2: gr.mesh: options must have names as keys (got number 1)");
}
