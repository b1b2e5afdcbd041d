// Discs, rectangles and planes: known answers, the laws that hold for what is flat, their textures.
#include "rt/geometry/disc.h"
#include "rt/geometry/plane.h"
#include "rt/geometry/rectangle.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

/// What the models share: one crossing with y = 0.
struct Flat {
    Vec3 anchor() const { return Vec3(0.0); }
    static void cross(const QuadRay& ray, Crossings& all, Quad beyond) {
        all.doubtful(beyond);
        if (beyond <= 0) all.add(ray, -ray.origin.y / ray.direction.y, 0, QuadVec(0, 1, 0));
    }
    static QuadVec ground(const QuadRay& ray) { return ray.at(-ray.origin.y / ray.direction.y); }
};

struct DiscModel : Flat {
    double radius;

    explicit DiscModel(double r) : radius(r) {}
    Disc solid() const { return Disc(radius); }
    Vec3 centre() const { return Vec3(0.0); }
    double size() const { return radius; }
    DiscModel scaled(double by) const { return DiscModel(by * radius); }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return radius; }
    Quad distance(const QuadVec& p) const {
        const Quad over = std::max(squareRoot(p.x * p.x + p.z * p.z) - radius, Quad(0));
        return squareRoot(over * over + p.y * p.y);
    }
    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        if (ray.direction.y == 0) {
            all.doubtful(ray.origin.y);
            return all;
        }
        const QuadVec p = ground(ray);
        cross(ray, all, squareRoot(p.x * p.x + p.z * p.z) - radius);
        return all;
    }
};

struct RectangleModel : Flat {
    double width;
    double depth;

    RectangleModel(double w, double d) : width(w), depth(d) {}
    Rectangle solid() const { return Rectangle(width, depth); }
    Vec3 centre() const { return {0.5 * width, 0.0, 0.5 * depth}; }
    double size() const { return width + depth; }
    RectangleModel scaled(double by) const { return {by * width, by * depth}; }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return width + depth; }
    Quad distance(const QuadVec& p) const {
        const Quad x = std::max(std::max(-p.x, p.x - width), Quad(0));
        const Quad z = std::max(std::max(-p.z, p.z - depth), Quad(0));
        return squareRoot(x * x + p.y * p.y + z * z);
    }
    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        if (ray.direction.y == 0) {
            all.doubtful(ray.origin.y);
            return all;
        }
        const QuadVec p = ground(ray);
        cross(ray, all, std::max(std::max(-p.x, p.x - width), std::max(-p.z, p.z - depth)));
        return all;
    }
};

struct PlaneModel : Flat {
    Plane solid() const { return Plane(); }
    Vec3 centre() const { return Vec3(0.0); }
    double size() const { return 1.0; }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return 1; }
    Quad distance(const QuadVec& p) const { return magnitude(p.y); }
    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        if (ray.direction.y == 0) {
            all.doubtful(ray.origin.y);
        } else {
            cross(ray, all, -Quad(kFarthestOfPlane));
        }
        return all;
    }
};

}  // namespace

TEST_CASE("what is flat refuses sizes that are not positive") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Disc{size}, std::invalid_argument);
        CHECK_THROWS_AS(Rectangle(size, 1.0), std::invalid_argument);
        CHECK_THROWS_AS(Rectangle(1.0, size), std::invalid_argument);
    }
}

TEST_CASE("a ray meets what is flat from both sides, and not within its plane") {
    PrimitiveHit hit;
    const auto meets = [&](const auto& flat, const Vec3& origin, const Vec3& direction) {
        return flat.intersect({origin, direction}, {}, hit);
    };
    for (const double zero : {0.0, -0.0}) {
        for (const double side : {1.0, -1.0}) {
            REQUIRE(meets(Disc(2.0), {1.0, 3.0 * side, zero}, {zero, -side, zero}));
            CHECK(hit.t == 3.0);
            CHECK(hit.local == Vec3(1.0, 0.0, 0.0));
            REQUIRE(meets(Rectangle(2.0, 3.0), {1.0, 3.0 * side, 2.5}, {zero, -side, zero}));
            CHECK(hit.local == Vec3(1.0, 0.0, 2.5));
            REQUIRE(meets(Plane(), {1e9, 3.0 * side, 1.0}, {1e6, -side, zero}));
            CHECK(hit.local.x == 1e9 + 3e6);
        }
        CHECK(!meets(Disc(2.0), {2.01, 3.0, zero}, {zero, -1.0, zero}));
        CHECK(!meets(Disc(2.0), {0.0, 3.0, 0.0}, {zero, 1.0, zero}));
        CHECK(!meets(Rectangle(2.0, 3.0), {-0.01, 3.0, 1.0}, {zero, -1.0, zero}));
        CHECK(!meets(Rectangle(2.0, 3.0), {1.0, 3.0, 3.01}, {zero, -1.0, zero}));
        CHECK(!meets(Disc(2.0), {-5.0, zero, 0.0}, {1.0, zero, zero}));
        CHECK(!meets(Rectangle(2.0, 3.0), {-5.0, zero, 1.0}, {1.0, zero, zero}));
        CHECK(!meets(Plane(), {-5.0, zero, 1.0}, {1.0, zero, zero}));
        CHECK(!meets(Plane(), {-5.0, 1.0, 1.0}, {1.0, zero, zero}));
        CHECK(!meets(Plane(), {0.0, 1.0, 0.0}, {1.0, -1e-30, zero}));
    }
}

TEST_CASE("every law of solids holds for discs and rectangles") {
    checkLaws([](Draws&, double size, const Vec3&) { return DiscModel(size); });
    checkLaws([](Draws& draws, double size, const Vec3&) {
        return RectangleModel(size, size * draws.powerOfTen(-2, 1));
    });
    checkNothingIsNan(Disc(1.0));
    checkNothingIsNan(Disc(1e-300));
    checkNothingIsNan(Rectangle(1.0, 1e200));
    checkNothingIsNan(Plane());
}

TEST_CASE("a plane's crossings are the oracle's") {
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const PlaneModel model;
        const Ray ray = randomRay(model, draws);
        checkRange(model, ray);
        PrimitiveHit hit;
        const Crossings all = model.crossings(quadRay(ray, Vec3(0.0)));
        const bool expected = !all.found.empty() && all.found.front().t > 0;
        REQUIRE(model.solid().intersect(ray, {}, hit) == expected);
        if (!expected) continue;
        const QuadCrossing& right = all.found.front();
        const QuadVec p = quadRay(ray, Vec3(0.0)).at(right.t);
        const Quad size = largestOf(ray.origin) + length(p);
        CHECK(static_cast<double>(magnitude(hit.t - right.t) / right.t) <= 4.0 * kUnitRoundoff);
        CHECK(static_cast<double>(length(QuadVec(hit.local) - p) * right.cosine) <=
              4.0 * kUnitRoundoff * static_cast<double>(size));
        CHECK(model.solid().surface(hit).normal == Vec3(0.0, 1.0, 0.0));
    }
}

TEST_CASE("images lie on what is flat as seen from above, -z up") {
    const auto uv = [](const auto& flat, double x, double z) {
        PrimitiveHit hit;
        REQUIRE(flat.intersect({Vec3(x, 1.0, z), Vec3(0.0, -1.0, 0.0)}, {}, hit));
        return flat.surface(hit).uv;
    };
    CHECK(uv(Rectangle(2.0, 4.0), 0.5, 1.0) == Vec2(0.25, 0.75));
    CHECK(uv(Plane(), 0.25, -0.75) == Vec2(0.25, 0.75));
    CHECK(uv(Plane(), -3.75, 4.25) == Vec2(0.25, 0.75));
    CHECK(uv(Disc(std::sqrt(2.0)), 0.0, 0.0) == Vec2(0.5, 0.5));
    CHECK(glm::distance(uv(Disc(std::sqrt(2.0)), 0.5, -0.25), Vec2(0.75, 0.625)) < 1e-15);
}
