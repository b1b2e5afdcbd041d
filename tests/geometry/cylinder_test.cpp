// Cylinder: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/cylinder.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kPi = 3.14159265358979323846;
enum Part : Index { kSide, kBase, kTop };

struct Model {
    Vec3 base;
    double height;
    double radius;

    Cylinder solid() const { return Cylinder(base, height, radius); }
    Vec3 anchor() const { return base; }
    Vec3 centre() const { return base + Vec3(0.0, 0.5 * height, 0.0); }
    double size() const { return height + radius; }
    Model scaled(double by) const { return {by * base, by * height, by * radius}; }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return radius; }

    Quad distance(const QuadVec& p) const {
        const Quad across = squareRoot(p.x * p.x + p.z * p.z) - radius;
        const Quad up = std::max(-p.y, p.y - height);
        if (across > 0 && up > 0) return squareRoot(across * across + up * up);
        if (across > 0 || up > 0) return std::max(across, up);
        return std::min(magnitude(across), magnitude(up));
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const QuadVec& o = ray.origin;
        const QuadVec& d = ray.direction;
        const Quad a = d.x * d.x + d.z * d.z;
        const Quad b = o.x * d.x + o.z * d.z;
        const Quad c = o.x * o.x + o.z * o.z - Quad(radius) * radius;
        const QuadVec closest = a > 0 ? ray.at(-b / a) : o;
        all.doubtful(squareRoot(closest.x * closest.x + closest.z * closest.z) - radius);
        for (const Quad t : quadraticRoots(a, b, c)) {
            const QuadVec p = ray.at(t);
            all.doubtful(p.y);
            all.doubtful(p.y - height);
            if (p.y >= 0 && p.y <= height) all.add(ray, t, kSide, QuadVec(p.x, 0, p.z));
        }
        for (const Part part : {kBase, kTop}) {
            const Quad y = part == kTop ? height : 0;
            if (d.y == 0) {
                all.doubtful(o.y - y);
                continue;
            }
            const QuadVec p = ray.at((y - o.y) / d.y);
            const Quad over = squareRoot(p.x * p.x + p.z * p.z) - radius;
            all.doubtful(over);
            if (over <= 0)
                all.add(ray, (y - o.y) / d.y, part, QuadVec(0, part == kTop ? 1 : -1, 0));
        }
        return all;
    }
};

Model drawn(Draws& draws, double size, const Vec3& centre) {
    const double flatness = draws.chance(0.2) ? draws.powerOfTen(-3, 3) : 1.0;
    return {centre, size * flatness * draws.uniform(0.4, 3.0), size * draws.uniform(0.3, 1.0)};
}

SurfacePoint surfaceFrom(const Cylinder& cylinder, const Vec3& origin, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(cylinder.intersect({origin, direction}, {}, hit));
    return cylinder.surface(hit);
}

}  // namespace

TEST_CASE("a cylinder refuses sizes that are not positive and a base that is not finite") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Cylinder(Vec3(0.0), size, 1.0), std::invalid_argument);
        CHECK_THROWS_AS(Cylinder(Vec3(0.0), 1.0, size), std::invalid_argument);
    }
    CHECK_THROWS_AS(Cylinder(Vec3(0.0, nan, 0.0), 1.0, 1.0), std::invalid_argument);
    CHECK_THROWS_WITH(Cylinder(Vec3(0.0), 0.0, 1.0),
                      "cylinder: height must be > 0 and finite, got 0");
}

TEST_CASE("a ray meets a cylinder's side, base and top") {
    const Cylinder cylinder(Vec3(1.0, 2.0, 3.0), 4.0, 2.0);
    PrimitiveHit hit;
    REQUIRE(cylinder.intersect({Vec3(11.0, 4.0, 3.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(hit.t == 4.0);
    CHECK(hit.part == kSide);
    CHECK(hit.local == Vec3(2.0, 2.0, 0.0));
    CHECK(cylinder.surface(hit).normal == Vec3(1.0, 0.0, 0.0));
    REQUIRE(cylinder.intersect({Vec3(1.0, 10.0, 3.5), Vec3(0.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 4.0);
    CHECK(hit.part == kTop);
    CHECK(hit.local == Vec3(0.0, 4.0, 0.5));
    CHECK(cylinder.surface(hit).normal == Vec3(0.0, 1.0, 0.0));
    REQUIRE(cylinder.intersect({Vec3(1.0, 5.0, 3.5), Vec3(0.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 3.0);
    CHECK(hit.part == kBase);
    CHECK(cylinder.surface(hit).normal == Vec3(0.0, -1.0, 0.0));
    CHECK(cylinder.surface(hit).point == Vec3(1.0, 2.0, 3.5));
    for (const double zero : {0.0, -0.0}) {
        CHECK(!cylinder.intersect({Vec3(11.0, 6.5, 3.0), Vec3(-2.0, zero, zero)}, {}, hit));
        CHECK(!cylinder.intersect({Vec3(3.5, 10.0, 3.0), Vec3(zero, -1.0, zero)}, {}, hit));
    }
    CHECK(cylinder.bounds().min == Vec3(-1.0, 2.0, 1.0));
    CHECK(cylinder.bounds().max == Vec3(3.0, 6.0, 5.0));
}

TEST_CASE("no ray slips between a cylinder's side and its caps") {
    const Cylinder cylinder(Vec3(0.1, 0.2, 0.3), 1.3, 0.7);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const double a = draws.uniform(0, 2.0 * kPi);
        const double y = draws.chance(0.5) ? 0.2 : 1.5;
        const Vec3 rim(0.1 + 0.7 * std::cos(a), y, 0.3 + 0.7 * std::sin(a));
        const Vec3 origin = draws.inBall(Vec3(0.1, 0.85, 0.3), 0.6);
        PrimitiveHit hit;
        CHECK(cylinder.intersect({origin, rim - origin}, {}, hit));
    }
}

TEST_CASE("every law of solids holds for cylinders") {
    checkLaws(drawn);
    checkNothingIsNan(Cylinder(Vec3(0.0), 1.0, 1.0));
    checkNothingIsNan(Cylinder(Vec3(1.0, -1e160, 0.5), 1e155, 1e-300));
}

TEST_CASE("a cylinder's derivatives are those of its parametrisation, and its texture is upright") {
    const double height = 1.25;
    const double radius = 0.75;
    const Cylinder cylinder(Vec3(0.0), height, radius);
    CHECK(surfaceFrom(cylinder, Vec3(0, 1, 5), Vec3(0, 0, -1)).uv == Vec2(0.5, 0.8));
    CHECK(surfaceFrom(cylinder, Vec3(5, 1, 0), Vec3(-1, 0, 0)).uv.x == 0.75);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Vec3 within = draws.inBall(Vec3(0.0, 0.6, 0.0), 0.5);
        PrimitiveHit hit;
        REQUIRE(cylinder.intersect({within, draws.unit()}, {}, hit));
        const SurfacePoint at = cylinder.surface(hit);
        const double a = 2.0 * kPi * (at.uv.x - 0.5);
        Vec3 p, du, dv;
        if (hit.part == kSide) {
            p = Vec3(radius * std::sin(a), height * at.uv.y, radius * std::cos(a));
            du = 2.0 * kPi * radius * Vec3(std::cos(a), 0.0, -std::sin(a));
            dv = Vec3(0.0, height, 0.0);
        } else {
            const double side = std::sqrt(2.0) * radius;
            const double up = hit.part == kTop ? 1.0 : -1.0;
            p = Vec3(side * (at.uv.x - 0.5), hit.part == kTop ? height : 0.0,
                     -up * side * (at.uv.y - 0.5));
            p.x += side * std::round((at.point.x - p.x) / side);
            p.z += side * std::round((at.point.z - p.z) / side);
            du = Vec3(side, 0.0, 0.0);
            dv = Vec3(0.0, 0.0, -up * side);
        }
        CHECK(glm::distance(p, at.point) <= 1e-14);
        CHECK(glm::distance(du, at.dpdu) <= 1e-13);
        CHECK(glm::distance(dv, at.dpdv) <= 1e-13);
    }
}

TEST_CASE("a cap shows the whole image once in the square inscribed in it") {
    const Cylinder cylinder(Vec3(0.0), 1.0, 1.0);
    const double corner = std::sqrt(0.5) - 1e-9;
    // From above, -z is up; from below, +z.
    const Vec2 top = surfaceFrom(cylinder, Vec3(corner, 5, -corner), Vec3(0, -1, 0)).uv;
    const Vec2 base = surfaceFrom(cylinder, Vec3(corner, -5, corner), Vec3(0, 1, 0)).uv;
    for (const Vec2& uv : {top, base}) {
        CHECK(std::fabs(uv.x - 1.0) < 1e-8);
        CHECK(std::fabs(uv.y - 1.0) < 1e-8);
    }
    CHECK(surfaceFrom(cylinder, Vec3(0, 5, 0), Vec3(0, -1, 0)).uv == Vec2(0.5));
    CHECK(surfaceFrom(cylinder, Vec3(0.9, 5, 0), Vec3(0, -1, 0)).uv.x < 0.25);
}
