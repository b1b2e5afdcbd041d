// Half of a ball: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/hemisphere.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kPi = 3.14159265358979323846;
enum Part : Index { kDome, kBase };

struct Model {
    Vec3 middle;
    double radius;

    Hemisphere solid() const { return Hemisphere(middle, radius); }
    Vec3 anchor() const { return middle; }
    Vec3 centre() const { return middle + Vec3(0.0, 0.5 * radius, 0.0); }
    double size() const { return 1.2 * radius; }
    Model scaled(double by) const { return {by * middle, by * radius}; }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return radius; }

    Quad distance(const QuadVec& p) const {
        const Quad rho = squareRoot(p.x * p.x + p.z * p.z);
        const Quad over = std::max(rho - radius, Quad(0));
        const Quad toBase = squareRoot(over * over + p.y * p.y);
        const Quad toDome = p.y >= 0 ? magnitude(length(p) - radius)
                                     : squareRoot((rho - radius) * (rho - radius) + p.y * p.y);
        return std::min(toBase, toDome);
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const QuadVec& o = ray.origin;
        const QuadVec& d = ray.direction;
        const Quad a = dot(d, d);
        const Quad b = dot(o, d);
        const Quad c = dot(o, o) - Quad(radius) * radius;
        all.doubtful(length(ray.at(-b / a)) - radius);
        for (const Quad t : quadraticRoots(a, b, c)) {
            const QuadVec p = ray.at(t);
            all.doubtful(p.y);
            if (p.y >= 0) all.add(ray, t, kDome, p);
        }
        if (d.y == 0) {
            all.doubtful(o.y);
            return all;
        }
        const QuadVec p = ray.at(-o.y / d.y);
        const Quad over = length(p) - radius;
        all.doubtful(over);
        if (over <= 0) all.add(ray, -o.y / d.y, kBase, QuadVec(0, -1, 0));
        return all;
    }
};

Model drawn(Draws&, double size, const Vec3& centre) {
    return {centre, size};
}

}  // namespace

TEST_CASE("a hemisphere refuses a radius that is not positive and a centre out of range") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double radius : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Hemisphere(Vec3(0.0), radius), std::invalid_argument);
    }
    CHECK_THROWS_AS(Hemisphere(Vec3(nan, 0.0, 0.0), 1.0), std::invalid_argument);
}

TEST_CASE("a ray meets a hemisphere's dome and its base, and nothing below") {
    const Hemisphere half(Vec3(1.0, 2.0, 3.0), 5.0);
    PrimitiveHit hit;
    for (const double zero : {0.0, -0.0}) {
        REQUIRE(half.intersect({Vec3(1.0, 12.0, 3.0), Vec3(zero, -2.0, zero)}, {}, hit));
        CHECK(hit.t == 2.5);
        CHECK(hit.part == kDome);
        CHECK(half.surface(hit).normal == Vec3(0.0, 1.0, 0.0));
        REQUIRE(half.intersect({Vec3(1.0, 0.0, 7.0), Vec3(zero, 1.0, zero)}, {}, hit));
        CHECK(hit.t == 2.0);
        CHECK(hit.part == kBase);
        CHECK(half.surface(hit).normal == Vec3(0.0, -1.0, 0.0));
        REQUIRE(half.intersect({Vec3(11.0, 5.0, 3.0), Vec3(-1.0, zero, zero)}, {}, hit));
        CHECK(hit.t == 6.0);
        CHECK(!half.intersect({Vec3(11.0, 1.0, 3.0), Vec3(-1.0, zero, zero)}, {}, hit));
    }
    CHECK(half.bounds().min == Vec3(-4.0, 2.0, -2.0));
    CHECK(half.bounds().max == Vec3(6.0, 7.0, 8.0));
}

TEST_CASE("no ray slips between a hemisphere's dome and its base") {
    const Hemisphere half(Vec3(0.1, 0.2, 0.3), 0.7);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const double a = draws.uniform(0, 2.0 * kPi);
        const Vec3 rim(0.1 + 0.7 * std::cos(a), 0.2, 0.3 + 0.7 * std::sin(a));
        const Vec3 origin = draws.inBall(Vec3(0.1, 0.5, 0.3), 0.2);
        PrimitiveHit hit;
        CHECK(half.intersect({origin, rim - origin}, {}, hit));
    }
}

TEST_CASE("every law of solids holds for hemispheres") {
    checkLaws(drawn);
    checkNothingIsNan(Hemisphere(Vec3(0.0), 1.0));
    checkNothingIsNan(Hemisphere(Vec3(1.0, -1e160, 0.5), 1e-200));
}

TEST_CASE("a hemisphere's derivatives are those of its parametrisation") {
    const double radius = 0.75;
    const Hemisphere half(Vec3(0.0), radius);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        PrimitiveHit hit;
        REQUIRE(half.intersect({draws.inBall(Vec3(0.0, 0.3, 0.0), 0.2), draws.unit()}, {}, hit));
        if (hit.part != kDome || hit.local.y > 0.999 * radius) continue;
        const SurfacePoint at = half.surface(hit);
        const double a = 2.0 * kPi * (at.uv.x - 0.5);
        const double b = 0.5 * kPi * at.uv.y;
        const Vec3 out(std::sin(a), 0.0, std::cos(a));
        CHECK(glm::distance(radius * (std::cos(b) * out + Vec3(0.0, std::sin(b), 0.0)), at.point) <=
              1e-14);
        CHECK(glm::distance(2.0 * kPi * radius * std::cos(b) * Vec3(std::cos(a), 0.0, -std::sin(a)),
                            at.dpdu) <= 1e-13);
        CHECK(glm::distance(0.5 * kPi * radius * (Vec3(0.0, std::cos(b), 0.0) - std::sin(b) * out),
                            at.dpdv) <= 1e-12);
    }
}
