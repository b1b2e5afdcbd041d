#include "trace/medium_set.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace rt;

namespace {

/// `count` instances of index 1.1, 1.2, ..., created in the order of `orders`.
RenderScene glasses(const std::vector<Index>& orders) {
    RenderScene scene;
    for (Index i = 0; i < orders.size(); ++i) {
        Look look;
        look.index = 1.1 + 0.1 * i;
        scene.looks.push_back(look);
        Instance instance;
        instance.look = i;
        instance.order = orders[i];
        scene.instances.push_back(instance);
    }
    return scene;
}

}  // namespace

TEST_CASE("outside of everything the index is 1") {
    CHECK(MediumSet().index(glasses({0, 1})) == 1.0);
}

TEST_CASE(
    "of overlapping solids the one created last decides, in whatever order they are entered") {
    const RenderScene scene = glasses({2, 0, 1});
    for (const std::vector<Index>& way : {std::vector<Index>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
        MediumSet media;
        for (const Index instance : way) media.toggle(instance);
        CHECK(media.index(scene) == doctest::Approx(1.1));
        media.toggle(0);
        CHECK(media.index(scene) == doctest::Approx(1.3));
        media.toggle(2);
        CHECK(media.index(scene) == doctest::Approx(1.2));
        media.toggle(1);
        CHECK(media.index(scene) == 1.0);
    }
}

TEST_CASE("a set of many behaves as a set") {
    std::set<Index> expected;
    MediumSet media;
    for (std::uint32_t step = 0; step < 5000; ++step) {
        const Index instance = step * 2654435761u % 23;
        media.toggle(instance);
        if (!expected.erase(instance)) expected.insert(instance);
        for (Index i = 0; i < 23; ++i) REQUIRE(media.contains(i) == (expected.count(i) > 0));
    }
}
