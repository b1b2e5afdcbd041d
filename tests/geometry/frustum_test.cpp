// Frustum: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/frustum.h"

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
    double baseRadius;
    double topRadius;

    Frustum solid() const { return Frustum(base, height, baseRadius, topRadius); }
    Vec3 anchor() const { return base; }
    Vec3 centre() const { return base + Vec3(0.0, 0.5 * height, 0.0); }
    double widest() const { return std::max(baseRadius, topRadius); }
    double size() const { return height + widest(); }
    Model scaled(double by) const {
        return {by * base, by * height, by * baseRadius, by * topRadius};
    }
    Quad slope() const { return (Quad(topRadius) - baseRadius) / height; }
    Quad sharpest(const QuadCrossing& crossing, const QuadRay& ray) const {
        const QuadVec p = ray.at(crossing.t);
        return crossing.part == kSide ? squareRoot(p.x * p.x + p.z * p.z) : Quad(widest());
    }

    /// To the outline of the solid's half plane: two caps and a slanted side.
    Quad distance(const QuadVec& p) const {
        const Quad rho = squareRoot(p.x * p.x + p.z * p.z);
        const Quad dx = Quad(topRadius) - baseRadius;
        const Quad share =
            ((rho - baseRadius) * dx + p.y * height) / (dx * dx + Quad(height) * height);
        const Quad held = std::min(std::max(share, Quad(0)), Quad(1));
        const Quad sideX = rho - baseRadius - held * dx;
        const Quad sideY = p.y - held * height;
        const auto cap = [&](Quad y, Quad radius) {
            const Quad over = std::max(rho - radius, Quad(0));
            return squareRoot(over * over + (p.y - y) * (p.y - y));
        };
        return std::min(squareRoot(sideX * sideX + sideY * sideY),
                        std::min(cap(0, baseRadius), cap(height, topRadius)));
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const QuadVec& o = ray.origin;
        const QuadVec& d = ray.direction;
        const Quad k = slope();
        const Quad q = baseRadius + k * o.y;
        const Quad a = d.x * d.x + d.z * d.z - k * k * d.y * d.y;
        const Quad b = o.x * d.x + o.z * d.z - q * k * d.y;
        const Quad c = o.x * o.x + o.z * o.z - q * q;
        if (a != 0) {
            const QuadVec p = ray.at(-b / a);
            const Quad rho = squareRoot(p.x * p.x + p.z * p.z);
            all.doubtful((rho - magnitude(baseRadius + k * p.y)) / squareRoot(1 + k * k));
        }
        for (const Quad t : quadraticRoots(a, b, c)) {
            const QuadVec p = ray.at(t);
            all.doubtful(p.y);
            all.doubtful(p.y - height);
            if (p.y >= 0 && p.y <= height) {
                all.add(ray, t, kSide, QuadVec(p.x, -k * (baseRadius + k * p.y), p.z));
            }
        }
        for (const Part part : {kBase, kTop}) {
            const Quad y = part == kTop ? height : 0;
            if (d.y == 0) {
                all.doubtful(o.y - y);
                continue;
            }
            const QuadVec p = ray.at((y - o.y) / d.y);
            const Quad over =
                squareRoot(p.x * p.x + p.z * p.z) - (part == kTop ? topRadius : baseRadius);
            all.doubtful(over);
            if (over <= 0)
                all.add(ray, (y - o.y) / d.y, part, QuadVec(0, part == kTop ? 1 : -1, 0));
        }
        return all;
    }
};

Model drawn(Draws& draws, double size, const Vec3& centre) {
    const double flatness = draws.chance(0.2) ? draws.powerOfTen(-2, 2) : 1.0;
    const double base = size * draws.uniform(0.3, 1.0);
    // Some are nearly cylinders, some nearly cones.
    const double top = draws.chance(0.2)   ? base * (1.0 + draws.powerOfTen(-9, -2))
                       : draws.chance(0.2) ? base * draws.powerOfTen(-3, -1)
                                           : size * draws.uniform(0.3, 1.0);
    const bool upsideDown = draws.chance(0.5);
    return {centre, size * flatness * draws.uniform(0.4, 3.0), upsideDown ? top : base,
            upsideDown ? base : top};
}

SurfacePoint surfaceFrom(const Frustum& frustum, const Vec3& origin, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(frustum.intersect({origin, direction}, {}, hit));
    return frustum.surface(hit);
}

}  // namespace

TEST_CASE("a frustum refuses sizes that are not positive, equal radii, and a base out of range") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Frustum(Vec3(0.0), size, 1.0, 2.0), std::invalid_argument);
        CHECK_THROWS_AS(Frustum(Vec3(0.0), 1.0, size, 2.0), std::invalid_argument);
        CHECK_THROWS_AS(Frustum(Vec3(0.0), 1.0, 2.0, size), std::invalid_argument);
    }
    CHECK_THROWS_AS(Frustum(Vec3(0.0), 1.0, 2.0, 2.0), std::invalid_argument);
    CHECK_THROWS_AS(Frustum(Vec3(0.0, nan, 0.0), 1.0, 1.0, 2.0), std::invalid_argument);
}

TEST_CASE("a ray meets a frustum's side and both caps") {
    const Frustum frustum(Vec3(1.0, 2.0, 3.0), 2.0, 3.0, 1.0);
    PrimitiveHit hit;
    REQUIRE(frustum.intersect({Vec3(11.0, 3.0, 3.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(hit.t == 4.0);
    CHECK(hit.part == kSide);
    CHECK(hit.local == Vec3(2.0, 1.0, 0.0));
    REQUIRE(frustum.intersect({Vec3(1.5, 10.0, 3.0), Vec3(0.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 6.0);
    CHECK(hit.part == kTop);
    REQUIRE(frustum.intersect({Vec3(3.0, 10.0, 3.0), Vec3(0.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 7.0);
    CHECK(hit.part == kSide);
    REQUIRE(frustum.intersect({Vec3(3.5, -1.0, 3.0), Vec3(0.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 3.0);
    CHECK(hit.part == kBase);
    // Above the top there is a cone's tip no more.
    CHECK(!frustum.intersect({Vec3(11.0, 4.5, 3.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(!frustum.intersect({Vec3(1.0, 8.0, 11.0), Vec3(0.0, 0.0, -1.0)}, {}, hit));
    const Vec3 normal = surfaceFrom(frustum, Vec3(11.0, 3.0, 3.0), Vec3(-1.0, 0.0, 0.0)).normal;
    CHECK(glm::distance(normal, std::sqrt(0.5) * Vec3(1.0, 1.0, 0.0)) <= 2.0 * kUnitRoundoff);
    CHECK(frustum.bounds().min == Vec3(-2.0, 2.0, 0.0));
    CHECK(frustum.bounds().max == Vec3(4.0, 4.0, 6.0));
}

TEST_CASE("a ray parallel to a frustum's side meets what else is in its way") {
    const Frustum frustum(Vec3(0.0), 1.0, 1.0, 2.0);
    PrimitiveHit hit;
    REQUIRE(frustum.intersect({Vec3(0.0, 0.5, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kTop);
    CHECK(hit.t == 0.5);
    REQUIRE(frustum.intersect({Vec3(0.0, 0.5, 0.0), Vec3(-1.0, -1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kBase);
    CHECK(!frustum.intersect({Vec3(1.5, -0.2, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    REQUIRE(frustum.intersect({Vec3(-3.0, -1.5, 0.0), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.part == kSide);
}

TEST_CASE("no ray slips between a frustum's side and its caps") {
    const Frustum frustum(Vec3(0.1, 0.2, 0.3), 1.3, 0.7, 0.45);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const double a = draws.uniform(0, 2.0 * kPi);
        const bool top = draws.chance(0.5);
        const double r = top ? 0.45 : 0.7;
        const Vec3 rim(0.1 + r * std::cos(a), top ? 1.5 : 0.2, 0.3 + r * std::sin(a));
        const Vec3 origin = draws.inBall(Vec3(0.1, 0.9, 0.3), 0.2);
        PrimitiveHit hit;
        CHECK(frustum.intersect({origin, rim - origin}, {}, hit));
    }
}

TEST_CASE("every law of solids holds for frustums") {
    checkLaws(drawn, 8.0);
    checkNothingIsNan(Frustum(Vec3(0.0), 1.0, 1.0, 0.5));
    checkNothingIsNan(Frustum(Vec3(1.0, -1e160, 0.5), 1e155, 1e-300, 1e-200));
}

TEST_CASE("a frustum's derivatives are those of its parametrisation, and its texture is upright") {
    const double height = 1.25;
    const Frustum frustum(Vec3(0.0), height, 0.75, 0.5);
    CHECK(surfaceFrom(frustum, Vec3(0, 1, 5), Vec3(0, 0, -1)).uv == Vec2(0.5, 0.8));
    CHECK(surfaceFrom(frustum, Vec3(5, 1, 0), Vec3(-1, 0, 0)).uv.x == 0.75);
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        PrimitiveHit hit;
        REQUIRE(frustum.intersect({draws.inBall(Vec3(0.0, 0.6, 0.0), 0.3), draws.unit()}, {}, hit));
        const SurfacePoint at = frustum.surface(hit);
        if (hit.part != kSide) continue;
        const double a = 2.0 * kPi * (at.uv.x - 0.5);
        const Vec3 out(std::sin(a), 0.0, std::cos(a));
        const double r = 0.75 - 0.25 * at.uv.y;
        const Vec3 p = r * out + Vec3(0.0, at.uv.y * height, 0.0);
        CHECK(glm::distance(p, at.point) <= 1e-14);
        CHECK(glm::distance(2.0 * kPi * r * Vec3(std::cos(a), 0.0, -std::sin(a)), at.dpdu) <=
              1e-13);
        CHECK(glm::distance(Vec3(0.0, height, 0.0) - 0.25 * out, at.dpdv) <= 1e-13);
    }
}
