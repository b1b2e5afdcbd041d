#include "compile/flatten.h"

#include "support/render_script.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

const char* const kRender =
    "\ngr.render(root, 'x.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})";

std::vector<PlacedNode> placed(const SceneDesc& scene) {
    std::vector<PlacedNode> nodes;
    forEachPlaced(scene, scene.renders.at(0).root, 0,
                  [&](const PlacedNode& node) { nodes.push_back(node); });
    return nodes;
}

}  // namespace

TEST_CASE("a node comes before its children, and children in order") {
    const Described run = describe(R"(
        root = gr.sphere('root')
        local a, b, c = gr.sphere('a'), gr.node('b'), gr.sphere('c')
        local d = gr.sphere('d')
        root:add_child(a) root:add_child(b) root:add_child(c) b:add_child(d))" +
                                   std::string(kRender));
    std::string order;
    for (const PlacedNode& node : placed(run.scene)) order += run.scene.nodes[node.node].name + " ";
    CHECK(order == "root a d c ");
}

TEST_CASE("a point goes through its own matrix first, then through its parents'") {
    const Described run = describe(R"(
        root = gr.node('root')
        local group, ball = gr.node('group'), gr.sphere('ball')
        ball:translate(1, 0, 0)
        group:scale(2, 2, 2)
        group:add_child(ball)
        root:rotate('z', 90)
        root:add_child(group))" + std::string(kRender));
    const Vec3 centre = placed(run.scene).at(0).toWorld.point(Vec3(0.0));
    CHECK(glm::distance(centre, Vec3(0, 2, 0)) < 1e-15);
}

TEST_CASE("many ways to one node are counted without being walked") {
    const std::string levels =
        "root = gr.sphere('s')\nfor i = 1, 62 do\n local p = gr.node('p')\n p:add_child(root) "
        "p:add_child(root)\n root = p\nend";
    const Described run = describe(levels + kRender);
    CHECK(countPlaced(run.scene, run.scene.renders[0].root, 0) == std::uint64_t{1} << 62);
    const Described more = describe(levels +
                                    "\nfor i = 1, 9 do local p = gr.node('p') "
                                    "p:add_child(root) p:add_child(root) root = p end" +
                                    kRender);
    CHECK(countPlaced(more.scene, more.scene.renders[0].root, 0) >=
          std::numeric_limits<std::uint64_t>::max() - 1);
}

TEST_CASE("a chain of 10^5 nodes needs no deep stack") {
    const Described run = describe(
        "root = gr.sphere('s')\nfor i = 1, 100000 do\n local p = gr.node('p')\n "
        "p:add_child(root)\n "
        "root = p\nend" +
        std::string(kRender));
    CHECK(countPlaced(run.scene, run.scene.renders[0].root, 0) == 1);
    CHECK(placed(run.scene).size() == 1);
}

TEST_CASE("an edge's material hides the child's material and texture, its bump map only the bump") {
    const Described run = describe(R"(
        root = gr.node('root')
        local ball = gr.sphere('ball')
        ball:set_material(gr.material({0, 0, 0}, {0, 0, 0}, 0))
        root:add_child(ball)
        root:add_child(ball, gr.material({1, 1, 1}, {0, 0, 0}, 0)))" +
                                   std::string(kRender));
    const std::vector<PlacedNode> nodes = placed(run.scene);
    REQUIRE(nodes.size() == 2);
    CHECK(run.scene.materials[nodes[0].appearance.material].material.diffuse == Color(0.0));
    CHECK(run.scene.materials[nodes[1].appearance.material].material.diffuse == Color(1.0));
}
