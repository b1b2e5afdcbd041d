// Sphere: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/sphere.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Model {
    Vec3 at;
    double radius;

    Sphere solid() const { return Sphere(at, radius); }
    Vec3 anchor() const { return at; }
    Vec3 centre() const { return at; }
    double size() const { return radius; }
    Model scaled(double by) const { return {by * at, by * radius}; }
    Quad distance(const QuadVec& p) const { return magnitude(length(p) - radius); }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return radius; }
    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const Quad a = dot(ray.direction, ray.direction);
        const Quad b = dot(ray.origin, ray.direction);
        const Quad c = dot(ray.origin, ray.origin) - Quad(radius) * radius;
        all.doubtful(length(ray.at(-b / a)) - radius);
        for (const Quad t : quadraticRoots(a, b, c)) all.add(ray, t, 0, ray.at(t));
        return all;
    }
};

Model drawn(Draws&, double size, const Vec3& centre) {
    return {centre, size};
}

SurfacePoint surfaceTowards(const Sphere& sphere, const Vec3& centre, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(sphere.intersect({centre, direction}, {}, hit));
    return sphere.surface(hit);
}

}  // namespace

TEST_CASE("a sphere refuses a radius that is not positive and a centre that is not finite") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double radius : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Sphere(Vec3(0.0), radius), std::invalid_argument);
    }
    CHECK_THROWS_AS(Sphere(Vec3(0.0, nan, 0.0), 1.0), std::invalid_argument);
    CHECK_THROWS_WITH(Sphere(Vec3(0.0), -2.5), "sphere: radius must be > 0 and finite, got -2.5");
}

TEST_CASE("a ray meets a sphere where it enters, or from inside where it leaves") {
    const Sphere sphere(Vec3(1.0, 2.0, 3.0), 2.0);
    PrimitiveHit hit;
    REQUIRE(sphere.intersect({Vec3(1.0, 2.0, 13.0), Vec3(0.0, 0.0, -1.0)}, {}, hit));
    CHECK(hit.t == 8.0);
    CHECK(hit.local == Vec3(0.0, 0.0, 2.0));
    REQUIRE(sphere.intersect({Vec3(1.0, 2.0, 3.0), Vec3(0.0, -4.0, 0.0)}, {}, hit));
    CHECK(hit.t == 0.5);
    const SurfacePoint at = sphere.surface(hit);
    CHECK(at.normal == Vec3(0.0, -1.0, 0.0));
    CHECK(at.point == Vec3(1.0, 0.0, 3.0));
    CHECK(!sphere.intersect({Vec3(1.0, 2.0, 13.0), Vec3(0.0, 0.0, 1.0)}, {}, hit));
    CHECK(!sphere.intersect({Vec3(4.0, 2.0, 13.0), Vec3(0.0, 0.0, -1.0)}, {}, hit));
}

TEST_CASE("the bounds of a sphere are exact where they can be, and else a step outside") {
    const Bounds exact = Sphere(Vec3(1.0, 2.0, 3.0), 2.0).bounds();
    CHECK(exact.min == Vec3(-1.0, 0.0, 1.0));
    CHECK(exact.max == Vec3(3.0, 4.0, 5.0));
    const Bounds rounded = Sphere(Vec3(1.0), 1e-20).bounds();
    CHECK(rounded.min.x < 1.0);
    CHECK(rounded.max.x > 1.0);
}

TEST_CASE("a ray that leaves a sphere's surface does not meet its own start") {
    const Sphere sphere(Vec3(0.1, 0.2, 0.3), 0.7);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Vec3 n = draws.unit();
        const SurfacePoint start = surfaceTowards(sphere, Vec3(0.1, 0.2, 0.3), n);
        Vec3 away = draws.unit();
        const double cosine = glm::dot(away, start.normal);
        if (std::fabs(cosine) < 0.01) continue;
        const double clear = 8.0 * start.error / std::fabs(cosine);
        PrimitiveHit hit;
        const bool found = sphere.intersect({start.point, away}, {clear, kInfinity}, hit);
        REQUIRE(found == (cosine < 0.0));
        if (found) CHECK(std::fabs(hit.t + 2.0 * 0.7 * cosine) <= clear);
    }
}

TEST_CASE("every law of solids holds for spheres") {
    checkLaws(drawn);
    checkNothingIsNan(Sphere(Vec3(0.0), 1.0));
    checkNothingIsNan(Sphere(Vec3(1.0, -1e160, 0.5), 1e155));
    checkNothingIsNan(Sphere(Vec3(0.0), 5e-324));
}

TEST_CASE("a sphere's texture runs upright around y, its middle towards +z") {
    const Sphere sphere(Vec3(0.0), 2.0);
    const Vec3 origin(0.0);
    CHECK(surfaceTowards(sphere, origin, Vec3(0, 0, 1)).uv == Vec2(0.5, 0.5));
    CHECK(surfaceTowards(sphere, origin, Vec3(1, 0, 0)).uv == Vec2(0.75, 0.5));
    CHECK(surfaceTowards(sphere, origin, Vec3(-1, 0, 0)).uv == Vec2(0.25, 0.5));
    CHECK(surfaceTowards(sphere, origin, Vec3(0, 1, 0)).uv == Vec2(0.5, 1.0));
    CHECK(surfaceTowards(sphere, origin, Vec3(0, -1, 0)).uv == Vec2(0.5, 0.0));
}

TEST_CASE("a sphere's derivatives are those of its parametrisation") {
    const double radius = 1.5;
    const Sphere sphere(Vec3(0.0), radius);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        Vec3 towards = draws.unit();
        if (draws.chance(0.3)) towards = glm::normalize(towards * Vec3(1e-3, 1.0, 1e-3));
        const SurfacePoint at = surfaceTowards(sphere, Vec3(0.0), towards);
        const double a = 2.0 * kPi * (at.uv.x - 0.5);
        const double b = kPi * (at.uv.y - 0.5);
        const Vec3 p =
            radius * Vec3(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
        const Vec3 du = 2.0 * kPi * radius * std::cos(b) * Vec3(std::cos(a), 0.0, -std::sin(a));
        const Vec3 dv = kPi * radius *
                        Vec3(-std::sin(b) * std::sin(a), std::cos(b), -std::sin(b) * std::cos(a));
        CHECK(glm::distance(p, at.point) <= 1e-14);
        CHECK(glm::distance(du, at.dpdu) <= 1e-13);
        CHECK(glm::distance(dv, at.dpdv) <= 1e-13);
    }
}
