#include "rt/scene/scene_desc.h"

#include <doctest/doctest.h>

using namespace rt;

TEST_CASE("a node that was never changed is the same for every render") {
    const NodeDesc node("n", kNone, {});
    CHECK(node.at(0).transform.isIdentity());
    CHECK(&node.at(0) == &node.at(1000));
    CHECK(&node.latest() == &node.at(0));
}

TEST_CASE("changes between two renders share one state") {
    NodeDesc node("n", 7, {"scene.lua", 3});
    node.edit(0).reflection = 0.5;
    node.edit(0).fresnel = true;
    CHECK(node.versionCount() == 1);
    CHECK(node.at(0).reflection == 0.5);
    CHECK(node.at(0).fresnel);
    CHECK(node.geometry == 7);
    CHECK(node.where.line == 3);
}

TEST_CASE("each render sees the last state that was written before it") {
    NodeDesc node("n", kNone, {});
    node.edit(0).transform.translation = Vec3(1);
    node.edit(2).transform.translation = Vec3(2);
    node.edit(2).reflection = 0.25;
    node.edit(5).transform.translation = Vec3(5);
    const double expected[] = {1, 1, 2, 2, 2, 5, 5};
    for (std::size_t render = 0; render < 7; ++render) {
        CAPTURE(render);
        CHECK(node.at(render).transform.translation == Vec3(expected[render]));
        CHECK(node.at(render).reflection.has_value() == (render >= 2));
    }
    CHECK(node.versionCount() == 3);
}

TEST_CASE("a node that is made late starts with the state that its first render sees") {
    NodeDesc node("n", kNone, {});
    node.edit(4).children.push_back({3, {}, {}});
    CHECK(node.at(4).children.size() == 1);
    CHECK(node.at(3).children.empty());
}
