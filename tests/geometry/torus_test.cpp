#include "rt/geometry/torus.h"

#include "torus_cases.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace rt;
using namespace rt::test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTurn = 2.0 * std::numbers::pi;

void checkNear(const std::vector<double>& got, const std::vector<double>& expected) {
    REQUIRE(got.size() == expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        CHECK(got[i] == doctest::Approx(expected[i]).epsilon(1e-14));
    }
}

void checkNear(const Vec3& got, const Vec3& expected, double tolerance) {
    CAPTURE(got.x);
    CAPTURE(got.y);
    CAPTURE(got.z);
    CHECK(glm::length(got - expected) <= tolerance);
}

SurfacePoint surfaceAt(const Torus& torus, const Ray& ray, Interval range = {}) {
    PrimitiveHit hit;
    REQUIRE(torus.intersect(ray, range, hit));
    return torus.surface(hit);
}

TEST_CASE("a ray in the equator of a ring crosses it four times") {
    const Torus torus(Vec3(1.0, 2.0, 3.0), 2.0, 0.5);
    checkNear(parameters(crossings(torus, {{-9.0, 2.0, 3.0}, {1.0, 0.0, 0.0}})),
              {7.5, 8.5, 11.5, 12.5});
    checkNear(parameters(crossings(torus, {{1.0, 22.0, 3.0}, {0.0, -2.0, 0.0}})),
              {8.75, 9.25, 10.75, 11.25});
}

TEST_CASE("rays in the equator through the axis meet rings of any radii") {
    Random random(31);
    for (int i = 0; i < 2000; ++i) {
        INFO("case " << i);
        const double major = random.uniform(0.3, 3.0);
        const double minor = major * random.uniform(0.05, 0.95);
        const double angle = random.uniform(0.0, kTurn);
        const Vec3 towards(std::cos(angle), std::sin(angle), 0.0);
        const double away = random.uniform(4.0, 20.0) * major;
        const std::vector<double> t =
            parameters(crossings(Torus(Vec3(0.0), major, minor), {-away * towards, towards}));
        const double expected[] = {-major - minor, minor - major, major - minor, major + minor};
        REQUIRE(t.size() == 4);
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(std::fabs(t[k] - away - expected[k]) <= 8.0 * kUnitRoundoff * away);
        }
    }
}

TEST_CASE("a ray along the axis or through the hole misses a ring") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    PrimitiveHit hit;
    CHECK_FALSE(torus.intersect({{0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}}, kWholeLine, hit));
    CHECK_FALSE(torus.intersect({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, kWholeLine, hit));
    CHECK_FALSE(torus.intersect({{1.4, 0.0, 5.0}, {0.0, 0.0, -1.0}}, kWholeLine, hit));
    CHECK_FALSE(torus.intersect({{-1.0, 0.3, 5.0}, {0.3, 0.0, -1.0}}, kWholeLine, hit));
}

TEST_CASE("a ray parallel to the axis meets the two heights of its circle") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    for (const double rho : {1.6, 1.75, 2.0, 2.25, 2.4}) {
        const double height = std::sqrt(0.25 - (rho - 2.0) * (rho - 2.0));
        checkNear(parameters(crossings(torus, {{0.0, rho, 4.0}, {0.0, 0.0, -1.0}})),
                  {4.0 - height, 4.0 + height});
    }
}

TEST_CASE("rays from within the tube and from its centre meet it from inside") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    PrimitiveHit hit;
    REQUIRE(torus.intersect({{2.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(0.5));
    REQUIRE(torus.intersect({{2.25, 0.0, 0.0}, {4.0, 0.0, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(0.0625));
    REQUIRE(torus.intersect({{0.0, 0.0, 0.0}, {0.6, 0.8, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(1.5));
    checkNear(torus.surface(hit).normal, {-0.6, -0.8, 0.0}, 1e-15);
}

TEST_CASE("rays through the axis cross a ring wherever they meet it") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    // In the plane of a meridian, where rho is |x|: two circles.
    checkNear(parameters(crossings(torus, {{-4.0, 0.0, -0.25}, {1.0, 0.0, 0.0}})),
              {2.0 - std::sqrt(0.1875), 2.0 + std::sqrt(0.1875), 6.0 - std::sqrt(0.1875),
               6.0 + std::sqrt(0.1875)});
    checkNear(parameters(crossings(torus, {{-2.0, 0.0, -2.0}, {1.0, 0.0, 1.0}})), {});
    PrimitiveHit hit;
    REQUIRE(torus.intersect({{0.0, 0.0, -2.0}, {0.0, 1.0, 1.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(2.0 - std::sqrt(0.125)));
}

TEST_CASE("a spindle torus shows both of its sheets") {
    const Torus torus(Vec3(0.0), 1.0, 2.0);
    const Ray equator{{-10.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    checkNear(parameters(crossings(torus, equator)), {7.0, 9.0, 11.0, 13.0});
    checkNear(surfaceAt(torus, equator).normal, {-1.0, 0.0, 0.0}, 1e-15);
    // The gradient of the quartic points into the lemon.
    checkNear(surfaceAt(torus, equator, {8.0, 20.0}).normal, {1.0, 0.0, 0.0}, 1e-15);
    checkNear(surfaceAt(torus, equator, {10.0, 20.0}).normal, {-1.0, 0.0, 0.0}, 1e-15);
    checkNear(surfaceAt(torus, equator, {12.0, 20.0}).normal, {1.0, 0.0, 0.0}, 1e-15);
    PrimitiveHit hit;
    REQUIRE(torus.intersect({{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(1.0));
}

TEST_CASE("a spindle torus is met on its axis at the tips of the lemon") {
    const Torus torus(Vec3(0.0), 1.0, 2.0);
    PrimitiveHit hit;
    REQUIRE(torus.intersect({{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(9.0 - std::sqrt(3.0)));
    REQUIRE(torus.intersect({{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(std::sqrt(3.0)));
    CHECK(glm::length(torus.surface(hit).normal) == doctest::Approx(1.0));
}

TEST_CASE("a horn torus closes in its centre") {
    const Torus torus(Vec3(0.0), 1.0, 1.0);
    checkNear(parameters(crossings(torus, {{1.0, 0.0, 5.0}, {0.0, 0.0, -1.0}})), {4.0, 6.0});
    PrimitiveHit hit;
    REQUIRE(torus.intersect({{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(3.0));
    REQUIRE(torus.intersect({{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(1.5));
}

TEST_CASE("texture coordinates and their derivatives follow the two angles") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    const SurfacePoint outer = surfaceAt(torus, {{9.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    CHECK(outer.uv.x == 0.0);
    CHECK(outer.uv.y == 0.0);
    checkNear(outer.dpdu, {0.0, kTurn * 2.5, 0.0}, 1e-14);
    checkNear(outer.dpdv, {0.0, 0.0, kTurn * 0.5}, 1e-14);
    const SurfacePoint top = surfaceAt(torus, {{0.0, 2.0, 9.0}, {0.0, 0.0, -1.0}});
    CHECK(top.uv.x == doctest::Approx(0.25));
    CHECK(top.uv.y == doctest::Approx(0.25));
    checkNear(top.dpdv, {0.0, -kTurn * 0.5, 0.0}, 1e-14);
    const SurfacePoint inner = surfaceAt(torus, {{0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    CHECK(inner.uv.x == doctest::Approx(0.5));
    CHECK(inner.uv.y == doctest::Approx(0.5));
    const SurfacePoint below = surfaceAt(torus, {{0.0, -2.0, -9.0}, {0.0, 0.0, 1.0}});
    CHECK(below.uv.x == doctest::Approx(0.75));
    CHECK(below.uv.y == doctest::Approx(0.75));
}

TEST_CASE("just below a whole turn the texture coordinates start again") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    PrimitiveHit hit;
    hit.local = Vec3(2.5, -1e-300, -1e-300);
    CHECK(torus.surface(hit).uv.x == 0.0);
    CHECK(torus.surface(hit).uv.y == 0.0);
}

TEST_CASE("the error bound of a point that is off the surface says so") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    for (const double off : {1e-9, -1e-9, 1e-3}) {
        PrimitiveHit hit;
        hit.local = Vec3(0.0, 2.0, 0.5 + off);
        CHECK(torus.surface(hit).error >= std::fabs(off));
        CHECK(torus.surface(hit).error <= std::fabs(off) + 1e-14);
    }
}

TEST_CASE("the bounds are the outer equator and the two planes that the tube lies between") {
    const Bounds box = Torus(Vec3(1.0, 2.0, 3.0), 2.0, 0.5).bounds();
    checkNear(box.min, {-1.5, -0.5, 2.5}, 1e-14);
    checkNear(box.max, {3.5, 4.5, 3.5}, 1e-14);
    CHECK((box.min.x <= -1.5 && box.max.y >= 4.5 && box.max.z >= 3.5));
}

TEST_CASE("radii that are not positive and finite are refused with their values") {
    for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
        CHECK_THROWS_AS(Torus(Vec3(0.0), bad, 1.0), std::invalid_argument);
        CHECK_THROWS_AS(Torus(Vec3(0.0), 1.0, bad), std::invalid_argument);
    }
    CHECK_THROWS_WITH(Torus(Vec3(0.0), 2.0, -1.0),
                      "torus: the radii must be positive and finite, got major 2, minor -1");
}

TEST_CASE("a crossing whose parameter would be infinite is none") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    PrimitiveHit hit;
    CHECK_FALSE(torus.intersect({{-1e10, 0.0, 0.0}, {1e-300, 0.0, 0.0}}, {}, hit));
    REQUIRE(torus.intersect({{-9.0, 0.0, 0.0}, {1e-300, 0.0, 0.0}}, {}, hit));
    CHECK(hit.t == doctest::Approx(6.5e300));
}

TEST_CASE("rays that are no rays hit nothing") {
    const Torus torus(Vec3(0.0), 2.0, 0.5);
    PrimitiveHit hit;
    const Vec3 origin(-9.0, 0.0, 0.0);
    CHECK_FALSE(torus.intersect({origin, {0.0, 0.0, 0.0}}, {}, hit));
    for (const double bad : {kNaN, kInfinity, -kInfinity}) {
        CHECK_FALSE(torus.intersect({origin, {1.0, bad, 0.0}}, {}, hit));
        CHECK_FALSE(torus.intersect({{-9.0, bad, 0.0}, {1.0, 0.0, 0.0}}, {}, hit));
    }
    CHECK_FALSE(torus.intersect({origin, {1.0, 0.0, 0.0}}, {kNaN, kInfinity}, hit));
    CHECK_FALSE(torus.intersect({origin, {1.0, 0.0, 0.0}}, {0.0, kNaN}, hit));
}

}  // namespace
