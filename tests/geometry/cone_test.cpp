// Cone: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/cone.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kPi = 3.14159265358979323846;
enum Part : Index { kSide, kCap };

struct Model {
    Vec3 apex;
    double height;
    double radius;

    Cone solid() const { return Cone(apex, height, radius); }
    Vec3 anchor() const { return apex; }
    Vec3 centre() const { return apex + Vec3(0.0, 0.5 * height, 0.0); }
    double size() const { return height + radius; }
    Model scaled(double by) const { return {by * apex, by * height, by * radius}; }
    Quad sharpest(const QuadCrossing& crossing, const QuadRay& ray) const {
        const QuadVec p = ray.at(crossing.t);
        return crossing.part == kCap ? Quad(radius) : squareRoot(p.x * p.x + p.z * p.z);
    }

    Quad distance(const QuadVec& p) const {
        const Quad rho = squareRoot(p.x * p.x + p.z * p.z);
        const Quad slant = squareRoot(Quad(height) * height + Quad(radius) * radius);
        const Quad along = (rho * radius + p.y * height) / slant;
        const Quad held = std::min(std::max(along, Quad(0)), slant);
        const Quad sideX = rho - held * radius / slant;
        const Quad sideY = p.y - held * height / slant;
        const Quad capX = std::max(rho - radius, Quad(0));
        const Quad capY = p.y - height;
        return std::min(squareRoot(sideX * sideX + sideY * sideY),
                        squareRoot(capX * capX + capY * capY));
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const QuadVec& o = ray.origin;
        const QuadVec& d = ray.direction;
        const Quad k = Quad(radius) / height;
        const Quad a = d.x * d.x + d.z * d.z - k * k * d.y * d.y;
        const Quad b = o.x * d.x + o.z * d.z - k * k * o.y * d.y;
        const Quad c = o.x * o.x + o.z * o.z - k * k * o.y * o.y;
        if (a != 0) {
            const QuadVec p = ray.at(-b / a);
            const Quad rho = squareRoot(p.x * p.x + p.z * p.z);
            all.doubtful((rho - k * magnitude(p.y)) / squareRoot(1 + k * k));
        }
        for (const Quad t : quadraticRoots(a, b, c)) {
            const QuadVec p = ray.at(t);
            all.doubtful(p.y);
            all.doubtful(p.y - height);
            if (p.y >= 0 && p.y <= height) all.add(ray, t, kSide, QuadVec(p.x, -k * k * p.y, p.z));
        }
        if (d.y == 0) {
            all.doubtful(o.y - height);
            return all;
        }
        const Quad t = (height - o.y) / d.y;
        const QuadVec p = ray.at(t);
        const Quad over = squareRoot(p.x * p.x + p.z * p.z) - radius;
        all.doubtful(over);
        if (over <= 0) all.add(ray, t, kCap, QuadVec(0, 1, 0));
        return all;
    }
};

Model drawn(Draws& draws, double size, const Vec3& centre) {
    const double flatness = draws.chance(0.2) ? draws.powerOfTen(-2, 2) : 1.0;
    return {centre, size * flatness * draws.uniform(0.4, 3.0), size * draws.uniform(0.3, 1.0)};
}

SurfacePoint surfaceFrom(const Cone& cone, const Vec3& origin, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(cone.intersect({origin, direction}, {}, hit));
    return cone.surface(hit);
}

}  // namespace

TEST_CASE("a cone refuses sizes that are not positive and an apex that is not finite") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Cone(Vec3(0.0), size, 1.0), std::invalid_argument);
        CHECK_THROWS_AS(Cone(Vec3(0.0), 1.0, size), std::invalid_argument);
    }
    CHECK_THROWS_AS(Cone(Vec3(0.0, nan, 0.0), 1.0, 1.0), std::invalid_argument);
    CHECK_THROWS_WITH(Cone(Vec3(0.0), 1.0, -3.0), "cone: radius must be > 0 and finite, got -3");
}

TEST_CASE("a ray meets a cone's side and cap, and never the mirror half below the apex") {
    const Cone cone(Vec3(1.0, 2.0, 3.0), 4.0, 4.0);
    PrimitiveHit hit;
    for (const double zero : {0.0, -0.0}) {
        REQUIRE(cone.intersect({Vec3(11.0, 4.0, 3.0), Vec3(-2.0, zero, zero)}, {}, hit));
        CHECK(hit.t == 4.0);
        CHECK(hit.part == kSide);
        CHECK(hit.local == Vec3(2.0, 2.0, 0.0));
        REQUIRE(cone.intersect({Vec3(1.0, 10.0, 3.5), Vec3(zero, -1.0, zero)}, {}, hit));
        CHECK(hit.t == 4.0);
        CHECK(hit.part == kCap);
        CHECK(cone.surface(hit).normal == Vec3(0.0, 1.0, 0.0));
        REQUIRE(cone.intersect({Vec3(1.0, 5.0, 3.5), Vec3(zero, -1.0, zero)}, {}, hit));
        CHECK(hit.t == 2.5);
        CHECK(hit.part == kSide);
        CHECK(!cone.intersect({Vec3(11.0, 0.0, 3.0), Vec3(-2.0, zero, zero)}, {}, hit));
        CHECK(!cone.intersect({Vec3(11.0, 6.5, 3.0), Vec3(-2.0, zero, zero)}, {}, hit));
        CHECK(!cone.intersect({Vec3(1.0, 1.0, 3.0), Vec3(zero, -1.0, zero)}, {}, hit));
        REQUIRE(cone.intersect({Vec3(1.0, 1.0, 3.5), Vec3(zero, 1.0, zero)}, {}, hit));
        CHECK(hit.t == 1.5);
    }
    const Vec3 normal = surfaceFrom(cone, Vec3(11.0, 4.0, 3.0), Vec3(-1.0, 0.0, 0.0)).normal;
    CHECK(glm::distance(normal, std::sqrt(0.5) * Vec3(1.0, -1.0, 0.0)) <= 2.0 * kUnitRoundoff);
    CHECK(cone.bounds().min == Vec3(-3.0, 2.0, -1.0));
    CHECK(cone.bounds().max == Vec3(5.0, 6.0, 7.0));
}

TEST_CASE("a ray parallel to a cone's side meets the other side and the cap") {
    const Cone cone(Vec3(0.0), 1.0, 1.0);
    PrimitiveHit hit;
    REQUIRE(cone.intersect({Vec3(-2.0, -1.5, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kSide);
    CHECK(hit.t == 1.75);
    REQUIRE(cone.intersect({Vec3(0.0, 0.5, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kCap);
    CHECK(hit.t == 0.5);
    REQUIRE(cone.intersect({Vec3(0.0, 0.5, 0.0), Vec3(-1.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kSide);
    CHECK(hit.t == 0.25);
    CHECK(!cone.intersect({Vec3(0.0, -0.5, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(!cone.intersect({Vec3(5.0, 4.5, 0.0), Vec3(-1.0, -1.0, 0.0)}, {}, hit));
}

TEST_CASE("the surface at a cone's apex is finite and has a normal") {
    const Cone cone(Vec3(0.0), 2.0, 1.0);
    const SurfacePoint at = cone.surface({0.0, Vec3(0.0), kSide});
    CHECK(at.point == Vec3(0.0));
    CHECK(std::fabs(glm::length(at.normal) - 1.0) <= 4.0 * kUnitRoundoff);
    CHECK(at.normal.y < 0.0);
    CHECK(at.uv == Vec2(0.5, 0.0));
    CHECK(at.dpdu == Vec3(0.0));
    CHECK(at.dpdv == Vec3(0.0, 2.0, 1.0));
}

TEST_CASE("no ray slips between a cone's side and its cap") {
    const Cone cone(Vec3(0.1, 0.2, 0.3), 1.3, 0.7);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const double a = draws.uniform(0, 2.0 * kPi);
        const Vec3 rim(0.1 + 0.7 * std::cos(a), 1.5, 0.3 + 0.7 * std::sin(a));
        const Vec3 origin = draws.inBall(Vec3(0.1, 1.2, 0.3), 0.2);
        PrimitiveHit hit;
        CHECK(cone.intersect({origin, rim - origin}, {}, hit));
    }
}

TEST_CASE("every law of solids holds for cones") {
    checkLaws(drawn, 8.0);
    checkNothingIsNan(Cone(Vec3(0.0), 1.0, 1.0));
    checkNothingIsNan(Cone(Vec3(1.0, -1e160, 0.5), 1e155, 1e-300));
}

TEST_CASE("a cone's derivatives are those of its parametrisation, and its texture is upright") {
    const double height = 1.25;
    const double radius = 0.75;
    const Cone cone(Vec3(0.0), height, radius);
    CHECK(surfaceFrom(cone, Vec3(0, 1, 5), Vec3(0, 0, -1)).uv == Vec2(0.5, 0.8));
    CHECK(surfaceFrom(cone, Vec3(5, 1, 0), Vec3(-1, 0, 0)).uv.x == 0.75);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Vec3 within = draws.inBall(Vec3(0.0, 0.9, 0.0), 0.3);
        PrimitiveHit hit;
        REQUIRE(cone.intersect({within, draws.unit()}, {}, hit));
        const SurfacePoint at = cone.surface(hit);
        const double a = 2.0 * kPi * (at.uv.x - 0.5);
        const Vec3 out(std::sin(a), 0.0, std::cos(a));
        Vec3 p, du, dv;
        if (hit.part == kSide) {
            p = at.uv.y * (radius * out + Vec3(0.0, height, 0.0));
            du = 2.0 * kPi * radius * at.uv.y * Vec3(std::cos(a), 0.0, -std::sin(a));
            dv = radius * out + Vec3(0.0, height, 0.0);
        } else {
            const double side = std::sqrt(2.0) * radius;
            p = Vec3(side * (at.uv.x - 0.5), height, -side * (at.uv.y - 0.5));
            p.x += side * std::round((at.point.x - p.x) / side);
            p.z += side * std::round((at.point.z - p.z) / side);
            du = Vec3(side, 0.0, 0.0);
            dv = Vec3(0.0, 0.0, -side);
        }
        CHECK(glm::distance(p, at.point) <= 1e-14);
        CHECK(glm::distance(du, at.dpdu) <= 1e-13);
        CHECK(glm::distance(dv, at.dpdv) <= 1e-13);
    }
}
