// Box: known answers first, then the laws of all solids, then its texture.
#include "rt/geometry/box.h"

#include <limits>
#include <stdexcept>

#include "geometry/solid_laws.h"

using namespace rt;
using namespace rt::test;

namespace {

struct Model {
    Vec3 lo;
    Vec3 sides;

    Box solid() const { return Box(lo, sides); }
    Vec3 anchor() const { return lo + 0.5 * sides; }
    Vec3 centre() const { return anchor(); }
    double size() const { return glm::length(sides); }
    Model scaled(double by) const { return {by * lo, by * sides}; }
    Quad sharpest(const QuadCrossing&, const QuadRay&) const { return size(); }

    static Quad& part(QuadVec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
    static Quad part(const QuadVec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
    Quad face(int axis, bool high) const {
        return Quad(lo[axis]) - anchor()[axis] + (high ? Quad(sides[axis]) : Quad(0));
    }

    /// Of points outside, and of points within to the nearest face.
    Quad distance(const QuadVec& p) const {
        Quad outside = 0;
        Quad inside = 1e300;
        for (int axis = 0; axis < 3; ++axis) {
            const Quad below = face(axis, false) - part(p, axis);
            const Quad above = part(p, axis) - face(axis, true);
            const Quad over = std::max(below, above);
            if (over > 0) outside += over * over;
            inside = std::min(inside, magnitude(over));
        }
        return outside > 0 ? squareRoot(outside) : inside;
    }

    Crossings crossings(const QuadRay& ray) const {
        Crossings all;
        for (int axis = 0; axis < 3; ++axis) {
            const Quad d = part(ray.direction, axis);
            for (const bool high : {false, true}) {
                const Quad away = face(axis, high) - part(ray.origin, axis);
                if (d == 0) {
                    all.doubtful(away);
                    continue;
                }
                const Quad t = away / d;
                const QuadVec p = ray.at(t);
                bool within = true;
                for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
                    for (const bool end : {false, true}) {
                        all.doubtful(part(p, other) - face(other, end));
                    }
                    within = within && part(p, other) >= face(other, false) &&
                             part(p, other) <= face(other, true);
                }
                QuadVec normal(0, 0, 0);
                part(normal, axis) = high ? 1 : -1;
                if (within) all.add(ray, t, static_cast<Index>(2 * axis + (high ? 1 : 0)), normal);
            }
        }
        return all;
    }
};

Model drawn(Draws& draws, double size, const Vec3& centre) {
    const Vec3 sides = size * Vec3(draws.uniform(0.3, 1.5), draws.uniform(0.3, 1.5),
                                   draws.chance(0.2) ? 1e-4 : draws.uniform(0.3, 1.5));
    return {centre - 0.5 * sides, sides};
}

SurfacePoint surfaceFrom(const Box& box, const Vec3& origin, const Vec3& direction) {
    PrimitiveHit hit;
    REQUIRE(box.intersect({origin, direction}, {}, hit));
    return box.surface(hit);
}

}  // namespace

TEST_CASE("a box refuses sides that are not positive and a corner that is not finite") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double side : {0.0, -1.0, kInfinity, nan}) {
        CHECK_THROWS_AS(Box(Vec3(0.0), Vec3(1.0, side, 1.0)), std::invalid_argument);
    }
    CHECK_THROWS_AS(Box(Vec3(0.0, nan, 0.0), Vec3(1.0)), std::invalid_argument);
    CHECK_THROWS_WITH(Box(Vec3(kInfinity, 0.0, 0.0), Vec3(1.0)),
                      "box: corner must be finite, got (inf, 0, 0)");
}

TEST_CASE("a ray meets each face of a box from outside and from inside") {
    const Box box(Vec3(1.0, 2.0, 3.0), Vec3(2.0, 4.0, 8.0));
    const Vec3 centre(2.0, 4.0, 7.0);
    const Vec3 half(1.0, 2.0, 4.0);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Vec3 way(0.0);
            way[axis] = sign;
            const Index part = static_cast<Index>(2 * axis + (sign > 0.0 ? 1 : 0));
            PrimitiveHit hit;
            REQUIRE(box.intersect({centre, way}, {}, hit));
            CHECK(hit.t == half[axis]);
            CHECK(hit.part == part);
            CHECK(hit.local == way * half);
            CHECK(box.surface(hit).normal == way);
            CHECK(box.surface(hit).point == centre + way * half);
            REQUIRE(box.intersect({centre + 10.0 * way, -2.0 * way}, {}, hit));
            CHECK(hit.t == 0.5 * (10.0 - half[axis]));
            CHECK(hit.part == part);
            CHECK(!box.intersect({centre + 10.0 * way, way}, {}, hit));
        }
    }
    CHECK(box.bounds().min == Vec3(1.0, 2.0, 3.0));
    CHECK(box.bounds().max == Vec3(3.0, 6.0, 11.0));
}

TEST_CASE("a ray in the plane of a face, or through an edge or a corner, meets the box") {
    const Box box(Vec3(0.0), Vec3(1.0));
    PrimitiveHit hit;
    for (const double zero : {0.0, -0.0}) {
        REQUIRE(box.intersect({Vec3(-1.0, 0.0, 0.5), Vec3(1.0, zero, zero)}, {}, hit));
        CHECK(hit.t == 1.0);
        REQUIRE(box.intersect({Vec3(2.0, 1.0, 0.5), Vec3(-1.0, zero, zero)}, {}, hit));
        CHECK(hit.t == 1.0);
        CHECK(!box.intersect({Vec3(-1.0, 1.5, 0.5), Vec3(1.0, zero, zero)}, {}, hit));
        CHECK(!box.intersect({Vec3(-1.0, -0.5, 0.5), Vec3(1.0, zero, zero)}, {}, hit));
    }
    REQUIRE(box.intersect({Vec3(-1.0, -1.0, 0.5), Vec3(1.0, 1.0, 0.0)}, {}, hit));
    CHECK(hit.t == 1.0);
    REQUIRE(box.intersect({Vec3(-1.0), Vec3(1.0)}, {}, hit));
    CHECK(hit.t == 1.0);
}

TEST_CASE("a box no wider than the spacing of its coordinates has two faces") {
    const double step = std::nextafter(1.0, 2.0) - 1.0;
    for (const double lo : {1.0, 1.0 + step}) {
        const Box box(Vec3(lo, 0.0, 0.0), Vec3(step, 1.0, 1.0));
        PrimitiveHit hit;
        REQUIRE(box.intersect({Vec3(0.0, 0.5, 0.5), Vec3(1.0, 0.0, 0.0)}, {}, hit));
        CHECK(hit.part == 0);
        REQUIRE(box.intersect({Vec3(3.0, 0.5, 0.5), Vec3(-1.0, 0.0, 0.0)}, {}, hit));
        CHECK(hit.part == 1);
    }
}

TEST_CASE("every law of solids holds for boxes") {
    checkLaws(drawn);
    checkNothingIsNan(Box(Vec3(0.0), Vec3(1.0)));
    checkNothingIsNan(Box(Vec3(-1e160, 0.0, 0.0), Vec3(1e155, 1.0, 1e-300)));
}

TEST_CASE("each face of a box shows one image, upright from outside") {
    const Vec3 lo(1.0, 2.0, 3.0);
    const Vec3 size(2.0, 4.0, 8.0);
    const Box box(lo, size);
    struct Face {
        Vec3 outward, u, v;
    };
    const Face faces[] = {
        {Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0)},
        {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)},
        {Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)},
        {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, -1)},
        {Vec3(0, 0, -1), Vec3(-1, 0, 0), Vec3(0, 1, 0)},
        {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)},
    };
    const Vec3 centre = lo + 0.5 * size;
    for (const Face& face : faces) {
        // A quarter to the right and an eighth up from the middle.
        const Vec3 target = centre + size * (0.5 * face.outward + 0.25 * face.u + 0.125 * face.v);
        const SurfacePoint at = surfaceFrom(box, target + 5.0 * face.outward, -face.outward);
        CHECK(at.uv == Vec2(0.75, 0.625));
        CHECK(at.dpdu == size * face.u);
        CHECK(at.dpdv == size * face.v);
    }
}
