// Transforms: known answers, then the laws of an affine map and its inverse, then an oracle in
// quadruple precision.
#include "rt/core/transform.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "rt/core/numeric.h"

using namespace rt;

namespace {

using Quad = __float128;

constexpr int kMaps = 4000;

class Draws {
  public:
    explicit Draws(unsigned seed) : random_(seed) {}

    double uniform(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random_);
    }
    Vec3 vec(double size) {
        return Vec3(uniform(-size, size), uniform(-size, size), uniform(-size, size));
    }
    Affine turn() {
        return compose(
            Affine::rotate(0, uniform(-180, 180)),
            compose(Affine::rotate(1, uniform(-180, 180)), Affine::rotate(2, uniform(-180, 180))));
    }
    Affine scale(double decades) {
        const auto factor = [&] {
            return std::pow(10.0, uniform(-decades, decades)) * (uniform(0, 1) < 0.3 ? -1.0 : 1.0);
        };
        const double x = factor();
        const double y = factor();
        return Affine::scale(Vec3(x, y, factor()));
    }
    /// Turn, uneven scale, turn and shift.
    Affine map(double decades) {
        return compose(Affine::translate(vec(10.0)),
                       compose(turn(), compose(scale(decades), turn())));
    }

  private:
    std::mt19937 random_;
};

Transform made(const Affine& map) {
    Transform transform;
    REQUIRE(Transform::make(map, transform));
    return transform;
}

struct QuadVec {
    Quad v[3];
};

QuadVec exactImage(const Affine& map, const Vec3& p) {
    QuadVec image;
    for (int r = 0; r < 3; ++r) {
        image.v[r] = map.translation[r];
        for (int c = 0; c < 3; ++c) image.v[r] += Quad(map.linear[c][r]) * p[c];
    }
    return image;
}

/// linear^-1 v by Cramer's rule.
QuadVec exactSolution(const Mat3& m, const QuadVec& v) {
    Quad cofactor[3][3];
    Quad determinant = 0;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            const int c1 = (c + 1) % 3, c2 = (c + 2) % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3;
            cofactor[c][r] = Quad(m[c1][r1]) * m[c2][r2] - Quad(m[c1][r2]) * m[c2][r1];
        }
    }
    for (int r = 0; r < 3; ++r) determinant += cofactor[0][r] * m[0][r];
    QuadVec solution;
    for (int c = 0; c < 3; ++c) {
        solution.v[c] = 0;
        for (int r = 0; r < 3; ++r) solution.v[c] += cofactor[c][r] * v.v[r] / determinant;
    }
    return solution;
}

double largest(const Vec3& v) {
    return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

double furthest(const Vec3& a, const QuadVec& b) {
    double most = 0.0;
    for (int i = 0; i < 3; ++i) {
        most = std::max(most, std::fabs(static_cast<double>(Quad(a[i]) - b.v[i])));
    }
    return most;
}

}  // namespace

TEST_CASE("turns are right-handed and exact at multiples of 90 degrees") {
    CHECK(Affine::rotate(0, 90).vector(Vec3(0, 1, 0)) == Vec3(0, 0, 1));
    CHECK(Affine::rotate(1, 90).vector(Vec3(0, 0, 1)) == Vec3(1, 0, 0));
    CHECK(Affine::rotate(2, 90).vector(Vec3(1, 0, 0)) == Vec3(0, 1, 0));
    for (int axis = 0; axis < 3; ++axis) {
        for (int quarters = -9; quarters <= 9; ++quarters) {
            Affine turned;
            for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) {
                turned = compose(Affine::rotate(axis, 90), turned);
            }
            CHECK(Affine::rotate(axis, 90.0 * quarters).linear == turned.linear);
        }
        CHECK(Affine::rotate(axis, 360).isIdentity());
        CHECK(!Affine::rotate(axis, 1).isIdentity());
    }
}

TEST_CASE("maps compose from the right") {
    const Affine map = compose(Affine::translate(Vec3(1, 0, 0)), Affine::scale(Vec3(2, 3, 4)));
    CHECK(map.point(Vec3(1, 1, 1)) == Vec3(3, 3, 4));
    CHECK(map.vector(Vec3(1, 1, 1)) == Vec3(2, 3, 4));
    const Affine other = compose(Affine::scale(Vec3(2, 3, 4)), Affine::translate(Vec3(1, 0, 0)));
    CHECK(other.point(Vec3(1, 1, 1)) == Vec3(4, 3, 4));
}

TEST_CASE("the identity changes nothing, and says so") {
    const Transform transform = made(Affine{});
    CHECK(transform.isIdentity());
    CHECK(!transform.flips());
    const Ray ray{Vec3(0.1, 1e300, -0.3), Vec3(0.0, -0.0, 1e-300)};
    CHECK(transform.toObject(ray).origin == ray.origin);
    CHECK(transform.toObject(ray).direction == ray.direction);
    CHECK(transform.errorToWorld(Vec3(1e3), 1e-5) == 1e-5);
    CHECK(transform.normalToWorld(Vec3(0, 0, 1e200)) == Vec3(0, 0, 1));
    const Bounds box{Vec3(0.1), Vec3(0.3)};
    CHECK(transform.boundsToWorld(box).min == box.min);
    CHECK(!made(Affine::translate(Vec3(1e-300, 0, 0))).isIdentity());
}

TEST_CASE("maps that have no finite inverse are refused, and leave the transform alone") {
    Transform transform = made(Affine::scale(Vec3(2.0)));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    Affine parallel;
    parallel.linear = Mat3(1, 2, 3, 2, 4, 6, 0, 0, 1);
    Affine notFinite;
    notFinite.translation.y = infinity;
    const Affine turned = compose(Affine::rotate(1, 33), Affine::rotate(0, 21));
    const Affine refused[] = {
        Affine::scale(Vec3(1, 0, 1)),
        Affine::scale(Vec3(1, nan, 1)),
        Affine::scale(Vec3(1, infinity, 1)),
        Affine::scale(Vec3(1, 1e-310, 1)),
        compose(Affine::scale(Vec3(1e-200)), Affine::scale(Vec3(1e-200))),
        compose(Affine::scale(Vec3(1e200)), Affine::scale(Vec3(1e200))),
        compose(turned, compose(Affine::scale(Vec3(1, 0, 1)), turned)),
        compose(turned, compose(Affine::scale(Vec3(1, 1e-17, 1)), turned)),
        compose(Affine::scale(Vec3(1e-300)), Affine::translate(Vec3(1e308))),
        parallel,
        notFinite,
    };
    for (std::size_t i = 0; i + 3 < std::size(refused); ++i) {
        CAPTURE(i);
        CHECK(!Transform::make(refused[i], transform));
    }
    CHECK(!Transform::make(parallel, transform));
    CHECK(!Transform::make(notFinite, transform));
    CHECK(transform.toWorld().linear == Mat3(2.0));
}

TEST_CASE("determinants beyond the range of double do not matter") {
    for (const double scale : {1e-150, 1e-100, 1e100, 1e150, 1e300}) {
        CAPTURE(scale);
        const Transform transform =
            made(compose(Affine::rotate(2, 30), Affine::scale(Vec3(scale, -scale, scale))));
        CHECK(transform.flips());
        CHECK(!transform.isIdentity());
        const Vec3 normal = transform.normalToWorld(Vec3(1, 0, 0));
        CHECK(glm::distance(normal, Vec3(std::sqrt(0.75), 0.5, 0.0)) <= 4.0 * kUnitRoundoff);
        const Ray ray = transform.toObject({scale * Vec3(0, 0, 2), scale * Vec3(0, 0, -1)});
        CHECK(glm::distance(ray.origin, Vec3(0, 0, 2)) <= 8.0 * kUnitRoundoff);
        CHECK(glm::distance(ray.direction, Vec3(0, 0, -1)) <= 8.0 * kUnitRoundoff);
    }
    CHECK(made(Affine::scale(Vec3(1e-150, 1.0, 1e150))).toObject().linear[0].x == 1e150);
}

TEST_CASE("the inverse is right to a rounding or two, whatever lies between the turns") {
    for (unsigned seed = 1; seed <= kMaps; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Affine map = draws.map(seed % 2 == 0 ? 6.0 : 1.0);
        const Transform transform = made(map);
        const Mat3& inverse = transform.toObject().linear;
        for (int c = 0; c < 3; ++c) {
            QuadVec unit{{0, 0, 0}};
            unit.v[c] = 1;
            const QuadVec exact = exactSolution(map.linear, unit);
            for (int r = 0; r < 3; ++r) {
                const double off = static_cast<double>(Quad(inverse[c][r]) - exact.v[r]);
                CHECK(std::fabs(off) <= 2.0 * kUnitRoundoff * std::fabs(inverse[c][r]));
            }
        }
    }
}

TEST_CASE("a ray in object space is off by a rounding of itself") {
    for (unsigned seed = 1; seed <= kMaps; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Affine map = seed % 3 == 0 ? compose(draws.turn(), Affine::scale(Vec3(3.0)))
                                         : draws.map(seed % 3 == 1 ? 4.0 : 1.0);
        const Transform transform = made(map);
        const double distance = seed % 5 == 0 ? 1e9 : 10.0;
        const Ray world{draws.vec(distance), draws.vec(1.0)};
        const Ray object = transform.toObject(world);
        QuadVec fromTranslation;
        for (int i = 0; i < 3; ++i) {
            fromTranslation.v[i] = Quad(world.origin[i]) - map.translation[i];
        }
        const QuadVec origin = exactSolution(map.linear, fromTranslation);
        const QuadVec direction =
            exactSolution(map.linear, {{world.direction.x, world.direction.y, world.direction.z}});
        const double roundings = 2.0 * kUnitRoundoff;
        CHECK(furthest(object.origin, origin) <= roundings * largest(object.origin));
        CHECK(furthest(object.direction, direction) <= roundings * largest(object.direction));
    }
}

TEST_CASE("the error bound covers the way to the world, and back") {
    double tightest = kInfinity;
    for (unsigned seed = 1; seed <= kMaps; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Affine map = draws.map(seed % 2 == 0 ? 3.0 : 0.5);
        const Transform transform = made(map);
        const Vec3 p = draws.vec(seed % 7 == 0 ? 1e6 : 2.0);
        const Vec3 image = map.point(p);
        const double bound = transform.errorToWorld(p, 0.0);
        CHECK(std::sqrt(3.0) * furthest(image, exactImage(map, p)) <= bound);
        const Vec3 back = transform.toObject({image, Vec3(1, 0, 0)}).origin;
        const QuadVec again = exactImage(map, back);
        CHECK(std::sqrt(3.0) * furthest(image, again) <= bound);
        tightest = std::min(tightest, bound / (kUnitRoundoff * (largest(image) + 10.0)));

        const double error = 1e-3 * largest(p);
        const Vec3 moved = p + error * glm::normalize(draws.vec(1.0));
        CHECK(glm::distance(map.point(moved), image) <= transform.errorToWorld(p, error));
    }
    CHECK(tightest <= 64.0);
    // A scale along the axes stretches an error by no more than the scale.
    const Transform scaled = made(Affine::scale(Vec3(4.0, 2.0, 1.0)));
    CHECK(scaled.errorToWorld(Vec3(0.0), 1.0) <= 4.0 * (1.0 + 64.0 * kUnitRoundoff));
    CHECK(scaled.errorToWorld(Vec3(0.0), 1.0) >= 4.0);
}

TEST_CASE("normals are unit, stand on mapped tangents, and point outwards under mirroring too") {
    for (unsigned seed = 1; seed <= kMaps; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        Affine map = draws.map(seed % 2 == 0 ? 3.0 : 0.5);
        if (seed % 3 == 0) {
            Affine shear;
            shear.linear[1].x = draws.uniform(-5, 5);
            map = compose(map, shear);
        }
        const Transform transform = made(map);
        const Vec3 n = glm::normalize(draws.vec(1.0));
        const Vec3 u = glm::normalize(glm::cross(n, draws.vec(1.0)));
        const Vec3 v = glm::cross(n, u);
        const Vec3 normal = transform.normalToWorld(std::pow(10.0, draws.uniform(-3, 3)) * n);
        CHECK(std::fabs(glm::length(normal) - 1.0) <= 4.0 * kUnitRoundoff);
        // The tangents are perpendicular to n only to a rounding, which the map may stretch.
        double stretch = 0.0;
        for (int c = 0; c < 3; ++c) stretch = std::max(stretch, largest(map.linear[c]));
        const double roundings = 64.0 * kUnitRoundoff * stretch;
        CHECK(std::fabs(glm::dot(normal, map.vector(u))) <= roundings);
        CHECK(std::fabs(glm::dot(normal, map.vector(v))) <= roundings);
        CHECK(glm::dot(normal, map.vector(n)) > 0.0);
        const double determinant =
            glm::dot(map.linear[0], glm::cross(map.linear[1], map.linear[2]));
        CHECK(transform.flips() == (determinant < 0.0));
    }
}

TEST_CASE("normals keep their unit length at extreme scales") {
    for (const double scale : {1e-150, 1e-6, 1e6, 1e150}) {
        for (const double length : {1e-200, 1.0, 1e200}) {
            CAPTURE(scale);
            CAPTURE(length);
            const Transform transform = made(Affine::scale(scale * Vec3(1.0, 2.0, 4.0)));
            const Vec3 normal = transform.normalToWorld(length * Vec3(1.0, 2.0, -4.0));
            CHECK(glm::distance(normal, glm::normalize(Vec3(1.0, 1.0, -1.0))) <=
                  4.0 * kUnitRoundoff);
        }
    }
}

TEST_CASE("the bounds of an image contain every mapped point, and are no wider than roundings") {
    for (unsigned seed = 1; seed <= kMaps; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const Affine map = draws.map(seed % 2 == 0 ? 6.0 : 1.0);
        const Transform transform = made(map);
        Bounds box;
        box.unite(draws.vec(1e3));
        box.unite(draws.vec(1e3));
        const Bounds image = transform.boundsToWorld(box);
        Bounds corners;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p((corner & 1) != 0 ? box.max.x : box.min.x,
                         (corner & 2) != 0 ? box.max.y : box.min.y,
                         (corner & 4) != 0 ? box.max.z : box.min.z);
            const QuadVec exact = exactImage(map, p);
            corners.unite(map.point(p));
            for (int i = 0; i < 3; ++i) {
                CHECK(Quad(image.min[i]) <= exact.v[i]);
                CHECK(Quad(image.max[i]) >= exact.v[i]);
            }
        }
        for (int i = 0; i < 3; ++i) {
            double size = std::fabs(map.translation[i]);
            for (int c = 0; c < 3; ++c) {
                size += std::fabs(map.linear[c][i]) *
                        std::max(std::fabs(box.min[c]), std::fabs(box.max[c]));
            }
            CHECK(corners.min[i] - image.min[i] <= 16.0 * kUnitRoundoff * size);
            CHECK(image.max[i] - corners.max[i] <= 16.0 * kUnitRoundoff * size);
        }
    }
    CHECK(made(Affine::scale(Vec3(2.0))).boundsToWorld(Bounds{}).isEmpty());
}

TEST_CASE("a transform stays small: a scene may hold a million") {
    CHECK(sizeof(Transform) <= 2 * sizeof(Affine) + 8 * sizeof(double));
}
