// Quadric: known answers first, then the laws of all solids, then its texture and its curvature.
#include "rt/geometry/quadric.h"

#include "rt/geometry/curvature.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

enum Part : Index { kSurface, kLowX, kHighX, kLowY, kHighY, kLowZ, kHighZ };

/// In quadruple precision, by the formula as it is written.
struct Model {
    QuadricCoefficients k;
    Vec3 lo;
    Vec3 hi;
    double flattest;  ///< least radius of curvature

    Quadric solid() const { return Quadric(k, lo, hi); }
    Vec3 anchor() const { return solid().anchor(); }
    Vec3 centre() const { return 0.5 * lo + 0.5 * hi; }
    double size() const { return largestOf(hi - lo); }
    Model scaled(double by) const {
        Model other = *this;
        for (double* square :
             {&other.k.xx, &other.k.yy, &other.k.zz, &other.k.xy, &other.k.yz, &other.k.zx}) {
            *square = *square / by / by;
        }
        for (double* linear : {&other.k.x, &other.k.y, &other.k.z}) *linear /= by;
        other.lo *= by;
        other.hi *= by;
        other.flattest *= by;
        return other;
    }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return flattest; }

    QuadVec gradient(const QuadVec& p) const {
        return {2 * k.xx * p.x + k.xy * p.y + k.zx * p.z + k.x,
                2 * k.yy * p.y + k.xy * p.x + k.yz * p.z + k.y,
                2 * k.zz * p.z + k.yz * p.y + k.zx * p.x + k.z};
    }
    /// The terms of second order.
    Quad form(const QuadVec& p) const {
        return k.xx * p.x * p.x + k.yy * p.y * p.y + k.zz * p.z * p.z + k.xy * p.x * p.y +
               k.yz * p.y * p.z + k.zx * p.z * p.x;
    }
    Quad value(const QuadVec& p) const { return form(p) + k.x * p.x + k.y * p.y + k.z * p.z + k.c; }
    QuadVec absolute(const QuadVec& local) const { return local + QuadVec(anchor()); }
    static Quad at(const QuadVec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

    /// To the nearer of the quadric (to first order) and the faces.
    Quad distance(const QuadVec& local) const {
        const QuadVec p = absolute(local);
        Quad least = magnitude(value(p)) / length(gradient(p));
        for (int axis = 0; axis < 3; ++axis) {
            least = std::min(least, magnitude(at(p, axis) - lo[axis]));
            least = std::min(least, magnitude(at(p, axis) - hi[axis]));
        }
        return least;
    }

    bool isInBox(const QuadVec& p, int except) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == except) continue;
            if (at(p, axis) < lo[axis] || at(p, axis) > hi[axis]) return false;
        }
        return true;
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        const QuadVec o = absolute(ray.origin);
        const QuadVec& d = ray.direction;
        const auto doubtfulInBox = [&](const QuadVec& p, int except) {
            for (int axis = 0; axis < 3; ++axis) {
                if (axis == except) continue;
                all.doubtful(at(p, axis) - lo[axis]);
                all.doubtful(at(p, axis) - hi[axis]);
            }
        };
        const Quad a = form(d);
        const Quad b = dot(gradient(o), d) / 2;
        const Quad c = value(o);
        if (a != 0) {
            const QuadVec p = o + (-b / a) * d;
            all.doubtful(value(p) / length(gradient(p)));
        }
        for (const Quad t : quadraticRoots(a, b, c)) {
            const QuadVec p = o + t * d;
            doubtfulInBox(p, -1);
            if (isInBox(p, -1)) all.add(ray, t, kSurface, gradient(p));
        }
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool high : {false, true}) {
                const Quad face = high ? hi[axis] : lo[axis];
                if (at(d, axis) == 0) {
                    all.doubtful(at(o, axis) - face);
                    continue;
                }
                const Quad t = (face - at(o, axis)) / at(d, axis);
                const QuadVec p = o + t * d;
                doubtfulInBox(p, axis);
                all.doubtful(value(p) / length(gradient(p)));
                if (!isInBox(p, axis) || value(p) > 0) continue;
                QuadVec normal(0, 0, 0);
                (axis == 0 ? normal.x : axis == 1 ? normal.y : normal.z) = high ? 1 : -1;
                all.add(ray, t, static_cast<Index>(1 + 2 * axis + (high ? 1 : 0)), normal);
            }
        }
        return all;
    }
};

/// Coefficients about `centre`, in units of `size`, moved to the origin by exact steps.
Model about(QuadricCoefficients k, const Vec3& centre, double size, const Vec3& halfBox,
            double flattest) {
    const double u = std::exp2(std::round(std::log2(size)));
    for (double* square : {&k.xx, &k.yy, &k.zz, &k.xy, &k.yz, &k.zx}) *square /= u * u;
    for (double* linear : {&k.x, &k.y, &k.z}) *linear /= u;
    QuadricCoefficients moved = k;
    const Vec3& m = centre;
    moved.x = k.x - 2 * k.xx * m.x - k.xy * m.y - k.zx * m.z;
    moved.y = k.y - 2 * k.yy * m.y - k.xy * m.x - k.yz * m.z;
    moved.z = k.z - 2 * k.zz * m.z - k.yz * m.y - k.zx * m.x;
    moved.c = k.xx * m.x * m.x + k.yy * m.y * m.y + k.zz * m.z * m.z + k.xy * m.x * m.y +
              k.yz * m.y * m.z + k.zx * m.z * m.x - k.x * m.x - k.y * m.y - k.z * m.z + k.c;
    return {moved, centre - u * halfBox, centre + u * halfBox, u * flattest};
}

/// Ellipsoids, hyperboloids, paraboloids, cylinders and pairs of planes, turned by mixed terms.
Model drawn(Draws& draws, double size, const Vec3& centre) {
    QuadricCoefficients k;
    const auto some = [&] { return draws.uniform(0.5, 2.0); };
    k.xx = some();
    k.yy = draws.chance(0.3) ? -some() : some();
    k.zz = draws.chance(0.2) ? 0.0 : some();
    if (draws.chance(0.5)) k.xy = draws.uniform(-0.6, 0.6);
    if (draws.chance(0.5)) k.yz = draws.uniform(-0.6, 0.6);
    if (draws.chance(0.3)) k.zx = draws.uniform(-0.6, 0.6);
    if (draws.chance(0.5)) k.y = draws.uniform(-1.0, 1.0);
    if (k.zz == 0.0) k.z = draws.chance(0.5) ? 0.0 : some();
    k.c = -some();
    const Vec3 half(draws.uniform(0.5, 1.5), draws.uniform(0.5, 1.5), draws.uniform(0.5, 1.5));
    // So far away coefficients about the origin say little of what is there.
    const Vec3 near = largestOf(centre) > 10.0 * size ? Vec3(0.0) : centre;
    return about(k, near, size, half, 0.1);
}

const QuadricCoefficients kBall{.xx = 1, .yy = 1, .zz = 1, .c = -1};
const QuadricCoefficients kBowl{.xx = 1, .zz = 1, .y = -1};

SurfacePoint surfaceFrom(const Quadric& quadric, const Vec3& origin, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(quadric.intersect({origin, direction}, {}, hit));
    return quadric.surface(hit);
}

}  // namespace

TEST_CASE("a quadric refuses what is not finite, boxes without room, and a constant") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Vec3 one(1.0);
    for (const double bad : {kInfinity, nan}) {
        CHECK_THROWS_AS(Quadric({.xx = bad}, -one, one), std::invalid_argument);
        CHECK_THROWS_AS(Quadric({.yz = bad}, -one, one), std::invalid_argument);
        CHECK_THROWS_AS(Quadric({.xx = 1, .z = bad}, -one, one), std::invalid_argument);
        CHECK_THROWS_AS(Quadric({.xx = 1, .c = bad}, -one, one), std::invalid_argument);
        CHECK_THROWS_AS(Quadric(kBall, Vec3(-1.0, bad, -1.0), one), std::invalid_argument);
        CHECK_THROWS_AS(Quadric(kBall, -one, Vec3(bad, 1.0, 1.0)), std::invalid_argument);
    }
    CHECK_THROWS_AS(Quadric(kBall, one, one), std::invalid_argument);
    CHECK_THROWS_AS(Quadric(kBall, one, -one), std::invalid_argument);
    CHECK_THROWS_AS(Quadric({.c = -1}, -one, one), std::invalid_argument);
    CHECK_THROWS_AS(Quadric({.xx = 1e300}, Vec3(-1e10), Vec3(1e10)), std::invalid_argument);
}

TEST_CASE("a ray meets a quadric's surface and the faces that close it") {
    const Quadric bowl(kBowl, Vec3(-2.0, -1.0, -2.0), Vec3(2.0, 4.0, 2.0));
    PrimitiveHit hit;
    REQUIRE(bowl.intersect({Vec3(1.0, -9.0, 0.0), Vec3(0.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 10.0);
    CHECK(hit.part == kSurface);
    REQUIRE(bowl.intersect({Vec3(1.0, -9.0, 0.0), Vec3(0.0, 1.0, 0.0)}, {10.0, kInfinity}, hit));
    CHECK(hit.t == 13.0);
    CHECK(hit.part == kHighY);
    REQUIRE(bowl.intersect({Vec3(9.0, 1.0, 0.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(hit.t == 4.0);
    CHECK(!bowl.intersect({Vec3(9.0, -0.5, 0.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(!bowl.intersect({Vec3(9.0, 4.5, 0.0), Vec3(-2.0, 0.0, 0.0)}, {}, hit));
    CHECK(surfaceFrom(bowl, Vec3(0.0, -9.0, 0.0), Vec3(0.0, 1.0, 0.0)).normal ==
          Vec3(0.0, -1.0, 0.0));
    CHECK(bowl.bounds().min == Vec3(-2.0, -1.0, -2.0));
    CHECK(bowl.bounds().max == Vec3(2.0, 4.0, 2.0));
}

TEST_CASE("a line meets up to four pieces of a quadric: both sheets and what lies between them") {
    // z^2 - x^2 - y^2 >= 1/4, whose two bowls open towards the faces.
    const Quadric sheets({.xx = 1, .yy = 1, .zz = -1, .c = 0.25}, Vec3(-1.0), Vec3(1.0));
    const Ray ray{Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, -1.0)};
    const double expected[] = {2.0, 2.5, 3.5, 4.0};
    Interval rest;
    PrimitiveHit hit;
    for (const double t : expected) {
        REQUIRE(sheets.intersect(ray, rest, hit));
        CHECK(hit.t == t);
        rest.min = hit.t;
    }
    CHECK(!sheets.intersect(ray, rest, hit));
}

TEST_CASE("every law of solids holds for quadrics") {
    checkLaws(drawn, 8.0);
    checkNothingIsNan(Quadric(kBall, Vec3(-1.0), Vec3(1.0)));
    checkNothingIsNan(Quadric({.xx = 1, .yy = -1, .zz = 1}, Vec3(-1.0), Vec3(1.0)));
    checkNothingIsNan(Quadric({.xy = 1e-200}, Vec3(-1e30), Vec3(1e90)));
    checkNothingIsNan(Quadric({.x = 1}, Vec3(-1.0), Vec3(1.0)));
}

TEST_CASE("rays nearly along an asymptote of a quadric meet it as exactly as others") {
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Model model{{.xx = 1, .yy = -1, .zz = draws.uniform(0.5, 2.0), .y = 0.3, .c = -0.4},
                          Vec3(-1.5),
                          Vec3(1.5, 1.2, 1.5),
                          0.1};
        const double off = draws.powerOfTen(-12, -2);
        const Vec3 d(1.0, draws.chance(0.5) ? 1.0 + off : -1.0 - off, off * draws.uniform(-1, 1));
        const Vec3 aim = draws.inBall(Vec3(0.0), 1.5);
        checkAgainstOracle(model, {aim - draws.uniform(1.0, 5.0) * d, d}, 8.0);
    }
}

TEST_CASE("a quadric that is far from the origin is as exact as its coefficients are") {
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const QuadricCoefficients ball{.xx = 1, .yy = 0.7, .zz = 1.4, .xy = 0.2, .c = -1};
        const Vec3 far = draws.powerOfTen(2, 5) * draws.unit();
        Model model = about(ball, far, 1.0, Vec3(1.0), 0.3);
        model.lo += Vec3(0.37, -0.23, 0.11);
        model.hi += Vec3(0.31, 0.43, -0.17);
        const Vec3 d = draws.unit();
        checkAgainstOracle(model, {draws.inBall(far, 0.9) - 4.0 * d, d}, 8.0);
    }
}

TEST_CASE("near a cone's apex a point is as exact as elsewhere, wherever the box's middle is") {
    const Quadric cone({.xx = 1, .yy = -1, .zz = 1}, Vec3(-1.3, -0.7, -0.2), Vec3(0.9, 1.1, 1.7));
    for (double h = 0.5; h > 1e-9; h *= 0.37) {
        CAPTURE(h);
        PrimitiveHit hit;
        REQUIRE(cone.intersect({Vec3(0.6 * h, h, 1.0), Vec3(0.0, 0.0, -1.0)}, {}, hit));
        CHECK(std::fabs(hit.t - (1.0 - 0.8 * h)) <= 4.0 * kUnitRoundoff);
        const Vec3 expected = Vec3(0.6, -1.0, 0.8) / std::sqrt(2.0);
        CHECK(glm::length(cone.surface(hit).normal - expected) <= 8.0 * kUnitRoundoff / h);
    }
}

TEST_CASE("a ray along one of two planes meets the other as exactly as any") {
    // x = z / 2 and x = -z / 2.
    const Quadric planes({.xx = 1, .zz = -0.25}, Vec3(-1.4, 0.2, -1.5), Vec3(1.7, 2.5, 1.1));
    for (double off = 1e-3; off > 1e-12; off *= 0.23) {
        CAPTURE(off);
        const Ray ray{Vec3(-0.4 + 0.4 * off, 0.95, -0.8), Vec3(0.5 + off, 0.55, 1.0)};
        const Vec3& o = ray.origin;
        const Vec3& d = ray.direction;
        const double expected = -(o.x + 0.5 * o.z) / (d.x + 0.5 * d.z);
        double nearest = kInfinity;
        Interval rest;
        PrimitiveHit hit;
        while (planes.intersect(ray, rest, hit)) {
            nearest = std::min(nearest, std::fabs(hit.t - expected));
            rest.min = hit.t;
        }
        CHECK(nearest <= 4.0 * kUnitRoundoff);
    }
}

TEST_CASE("at a quadric's singular point there is a normal, and the error says how near it is") {
    const Quadric cone({.xx = 1, .yy = -1, .zz = 1}, Vec3(-1.0), Vec3(1.0));
    PrimitiveHit hit;
    REQUIRE(cone.intersect({Vec3(0.0, 0.0, 5.0), Vec3(0.0, 0.0, -1.0)}, {}, hit));
    const SurfacePoint at = cone.surface(hit);
    CHECK(std::fabs(glm::length(at.normal) - 1.0) < 1e-15);
    CHECK(glm::length(at.point) < 1e-7);
    CHECK(at.error < 1e-7);
}

TEST_CASE("a quadric's texture is that of a sphere about the middle, and of a box's faces") {
    const Quadric ball(kBall, Vec3(-2.0), Vec3(2.0));
    CHECK(surfaceFrom(ball, Vec3(0, 0, 5), Vec3(0, 0, -1)).uv == Vec2(0.5, 0.5));
    CHECK(surfaceFrom(ball, Vec3(5, 0, 0), Vec3(-1, 0, 0)).uv == Vec2(0.75, 0.5));
    CHECK(surfaceFrom(ball, Vec3(0, 5, 0), Vec3(0, -1, 0)).uv.y == 1.0);
    const Quadric half({.y = 1}, Vec3(-1.0), Vec3(1.0));
    CHECK(surfaceFrom(half, Vec3(0.5, -5, 0.5), Vec3(0, 1, 0)).uv == Vec2(0.75, 0.75));

    // A step along dpdu changes u alone, by as much.
    const Quadric egg({.xx = 1, .yy = 0.5, .zz = 2, .xy = 0.3, .c = -1}, Vec3(-3.0), Vec3(3.0));
    for (unsigned seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Vec3 d = draws.unit();
        const SurfacePoint at = surfaceFrom(egg, 5.0 * d, -d);
        if (std::fabs(d.y) > 0.95 || at.uv.x < 0.01 || at.uv.x > 0.99) continue;
        const double step = 1e-6;
        for (const bool alongU : {true, false}) {
            const Vec3 moved = at.point + step * (alongU ? at.dpdu : at.dpdv);
            const Vec2 change = (surfaceFrom(egg, 2.0 * moved, -moved).uv - at.uv) / step;
            CHECK(std::fabs(change.x - (alongU ? 1.0 : 0.0)) < 1e-4);
            CHECK(std::fabs(change.y - (alongU ? 0.0 : 1.0)) < 1e-4);
        }
    }
}

TEST_CASE("a quadric's normal turns as its curvature says") {
    const Quadric saddle({.xx = 1, .yy = -1, .zz = 0.4, .xy = 0.3, .y = 0.2, .c = -0.5}, Vec3(-1.0),
                         Vec3(1.0));
    int checked = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Vec3 direction = draws.unit();
        const Ray ray{draws.inBall(Vec3(0.0), 0.8) - 3.0 * direction, direction};
        PrimitiveHit hit;
        if (!saddle.intersect(ray, {}, hit) || hit.part != kSurface) continue;
        const SurfacePoint at = saddle.surface(hit);
        const Vec3 across = glm::normalize(glm::cross(at.normal, draws.unit()));
        const double step = 1e-6;
        PrimitiveHit moved = hit;
        moved.local += step * across;
        const Vec3 expected = (saddle.surface(moved).normal - at.normal) / step;
        CHECK(glm::distance(expected, normalChange(saddle, hit, across)) < 1e-4);
        ++checked;
    }
    CHECK(checked > 20);
}
