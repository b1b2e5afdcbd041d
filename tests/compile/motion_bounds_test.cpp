#include "compile/motion_bounds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace rt;

namespace {

Affine anyMap(std::mt19937_64& random) {
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    Affine map = Affine::rotate(static_cast<int>(random() % 3), 90.0 * any(random));
    map = compose(Affine::scale({any(random), any(random), any(random)}), map);
    return compose(Affine::translate({any(random), any(random), any(random)}), map);
}

MotionPath anyPath(std::mt19937_64& random) {
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    MotionPath path;
    for (std::uint64_t step = 0; step < 1 + random() % 3; ++step) {
        MotionStep next{.before = anyMap(random)};
        if (random() % 2) {
            next.by = {any(random), any(random), any(random)};
        } else {
            next.axis = static_cast<int>(random() % 3);
            next.degrees = 400.0 * any(random);
        }
        path.steps.push_back(next);
    }
    path.last = anyMap(random);
    return path;
}

double largestExtent(const Bounds& bounds) {
    const Vec3 e = bounds.extent();
    return std::max({e.x, e.y, e.z});
}

}  // namespace

TEST_CASE("swept bounds hold every corner at every time") {
    std::mt19937_64 random(20'261);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int outside = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const MotionPath path = anyPath(random);
        const Bounds box{Vec3(-unit(random)), Vec3(unit(random))};
        const Bounds swept = sweptBounds(path, box);
        for (int i = 0; i < 500; ++i) {
            const double s = i == 0 ? 0.0 : (i == 1 ? 1.0 : unit(random));
            const Vec3 corner(random() % 2 ? box.min.x : box.max.x,
                              random() % 2 ? box.min.y : box.max.y,
                              random() % 2 ? box.min.z : box.max.z);
            const Vec3 p = path.at(s).point(corner);
            if (glm::any(glm::lessThan(p, swept.min)) || glm::any(glm::greaterThan(p, swept.max)))
                ++outside;
        }
    }
    CHECK(outside == 0);
}

TEST_CASE("swept bounds are not much wider than they need be") {
    const Bounds box{Vec3(-1.0), Vec3(1.0)};
    MotionPath slides;
    slides.steps.push_back({.before = {}, .by = {3.0, 0.0, -1.0}});
    const Bounds slid = sweptBounds(slides, box);
    CHECK(slid.min.x == doctest::Approx(-1.0));
    CHECK(slid.max.x == doctest::Approx(4.0));
    CHECK(slid.min.z == doctest::Approx(-2.0));

    MotionPath turns;
    turns.steps.push_back({.before = {}, .axis = 2, .degrees = 90.0});
    CHECK(largestExtent(sweptBounds(turns, box)) < 1.1 * 2.0 * 1.4142135623730951);
    turns.steps.front().degrees = 1.0;
    CHECK(largestExtent(sweptBounds(turns, box)) < 1.04 * 2.0);
}

TEST_CASE("a path in a frame is the path of the frame after it") {
    std::mt19937_64 random(20'262);
    for (int trial = 0; trial < 100; ++trial) {
        const bool frameMoves = random() % 2 == 0;
        const bool innerMoves = random() % 2 == 0;
        const MotionPath outer = frameMoves ? anyPath(random) : MotionPath{};
        const MotionPath inner = innerMoves ? anyPath(random) : MotionPath{};
        const Affine frame = frameMoves ? outer.at(0.0) : anyMap(random);
        const Affine place = innerMoves ? inner.at(0.0) : anyMap(random);
        const MotionPath path = compose(outer, frame, inner, place);
        CHECK(path.moves() == (frameMoves || innerMoves));
        if (!path.moves()) continue;
        const double s = 0.01 * trial;
        const Vec3 p(0.3, -0.7, 0.9);
        const Vec3 inside = (innerMoves ? inner.at(s) : place).point(p);
        const Vec3 expected = (frameMoves ? outer.at(s) : frame).point(inside);
        const Vec3 found = path.at(s).point(p);
        CHECK(glm::length(found - expected) <= 1e-12 * (1.0 + glm::length(expected)));
    }
}
