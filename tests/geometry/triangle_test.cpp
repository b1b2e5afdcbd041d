// One triangle: known answers, laws, and the same questions in quadruple precision.
#include "rt/geometry/triangle.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace rt;

namespace {

using Triangle = std::array<Vec3, 3>;

const Triangle kRight{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool hits(const Triangle& t, const Ray& ray, PrimitiveHit& hit, Interval range = {}) {
    return intersectTriangle(TriangleRay(ray), t[0], t[1], t[2], range, hit);
}
bool hits(const Triangle& t, const Ray& ray, Interval range = {}) {
    PrimitiveHit hit;
    return hits(t, ray, hit, range);
}

struct Draws {
    std::mt19937_64 random;
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    double magnitude(double low, double high) { return std::pow(10.0, between(low, high)); }
    Vec3 unit() {
        for (;;) {
            const Vec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            const double squared = glm::dot(v, v);
            if (squared > 0.01 && squared < 1.0) return v / std::sqrt(squared);
        }
    }
};

using Quad = __float128;
struct Quad3 {
    Quad x, y, z;
};
Quad3 exact(const Vec3& v) {
    return {v.x, v.y, v.z};
}
Quad3 operator-(const Quad3& a, const Quad3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Quad3 cross(const Quad3& a, const Quad3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Quad dot(const Quad3& a, const Quad3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
double length(const Quad3& a) {
    const Vec3 v(static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z));
    return glm::length(v);
}

/// Where the ray meets the plane of a triangle, by another way than the code: normal and volumes.
struct PlaneCrossing {
    PlaneCrossing(const Triangle& at, const Ray& ray)
        : normal(cross(exact(at[1]) - exact(at[0]), exact(at[2]) - exact(at[0]))),
          slope(dot(normal, exact(ray.direction))),
          t(dot(normal, exact(at[0]) - exact(ray.origin)) / slope) {
        const Quad3 d = exact(ray.direction);
        const Quad3 from[3] = {exact(at[0]) - exact(ray.origin), exact(at[1]) - exact(ray.origin),
                               exact(at[2]) - exact(ray.origin)};
        for (int k = 0; k < 3; ++k) {
            weight[k] = dot(d, cross(from[(k + 1) % 3], from[(k + 2) % 3])) / slope;
        }
    }
    Quad3 normal;
    Quad slope, t;
    Quad weight[3];
    /// |cosine| between ray and normal.
    double cosine(const Ray& ray) const {
        return std::fabs(static_cast<double>(slope)) / length(normal) / glm::length(ray.direction);
    }
};

double largest(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

TriangleMesh meshOf(const Triangle& t) {
    TriangleMesh mesh;
    mesh.positions.assign(t.begin(), t.end());
    mesh.triangles.push_back({0, 1, 2});
    return mesh;
}

PrimitiveHit hitAt(double b1, double b2) {
    return {1.0, Vec3(1.0 - b1 - b2, b1, b2), 0};
}

}  // namespace

TEST_CASE("a ray through a triangle finds t and the weights, from both sides") {
    for (const double side : {1.0, -1.0}) {
        PrimitiveHit hit;
        REQUIRE(hits(kRight, {{0.25, 0.5, 3.0 * side}, {0, 0, -2.0 * side}}, hit));
        CHECK(hit.t == 1.5);
        CHECK(hit.local == Vec3(0.25, 0.25, 0.5));
    }
    CHECK_FALSE(hits(kRight, {{0.75, 0.5, 3}, {0, 0, -1}}));
    CHECK_FALSE(hits(kRight, {{-0.01, 0.5, 3}, {0, 0, -1}}));
}

TEST_CASE("edges and corners belong to the triangle") {
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.5, 0, 0),
                          Vec3(0, 0.25, 0), Vec3(0.5, 0.5, 0)}) {
        CHECK(hits(kRight, {p + Vec3(0, 0, 2), {0, 0, -1}}));
        CHECK(hits(kRight, {p + Vec3(1, 2, 4), {-1, -2, -4}}));
    }
}

TEST_CASE("the interval of a triangle test is open, and may lie behind the origin") {
    const Ray ray{{0.25, 0.25, 2}, {0, 0, -1}};
    CHECK(hits(kRight, ray, {1.5, 2.5}));
    CHECK_FALSE(hits(kRight, ray, {2.0, 3.0}));
    CHECK_FALSE(hits(kRight, ray, {1.0, 2.0}));
    CHECK(hits(kRight, {{0.25, 0.25, -2}, {0, 0, -1}}, {-3.0, 0.0}));
}

TEST_CASE("a triangle seen edge-on, or a ray that is none, is missed") {
    CHECK_FALSE(hits(kRight, {{-1, 0.25, 0}, {1, 0, 0}}));
    CHECK_FALSE(hits(kRight, {{-1, 0.25, 1}, {1, 0, 0}}));
    CHECK_FALSE(hits(kRight, {{0.25, 0.25, 1}, {0, 0, 0}}));
    for (const double bad : {kNan, kInfinity}) {
        CHECK_FALSE(hits(kRight, {{0.25, 0.25, 1}, {bad, 0, -1}}));
        CHECK_FALSE(hits(kRight, {{0.25, bad, 1}, {0, 0, -1}}));
    }
}

TEST_CASE("zero, negative zero and denormal components of the direction are as good as any") {
    for (const double small : {0.0, -0.0, 1e-310, -1e-310}) {
        CHECK(hits(kRight, {{0.25, 0.25, 1}, {small, small, -1}}));
        CHECK(hits(kRight, {{0.0, 0.0, 1}, {small, -small, -1}}) == (small == 0.0));
    }
    CHECK(hits(kRight, {{0.25, 0.25, 1}, {0, 0, -1e-307}}));
}

TEST_CASE("two triangles never let a ray through the edge or the corner that they share") {
    constexpr unsigned kSeed = 21;
    CAPTURE(kSeed);
    Draws draws{std::mt19937_64(kSeed)};
    for (int i = 0; i < 20000; ++i) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 offset = i % 3 == 0 ? Vec3(0.0) : size * draws.magnitude(0, 6) * draws.unit();
        // A closed fan about a corner, seen from above.
        const int count = 3 + i % 5;
        std::vector<Vec3> ring;
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * 3.141592653589793 * k / count;
            ring.push_back(offset +
                           size * Vec3(std::cos(angle), std::sin(angle), draws.between(-0.2, 0.2)));
        }
        const Vec3 apex = offset + size * Vec3(0, 0, 0.3);
        const Vec3 target = i % 2 == 0 ? apex : apex + draws.between(0, 0.9) * (ring[0] - apex);
        const Vec3 origin =
            target + size * draws.between(1, 100) * (Vec3(0, 0, 1) + 0.3 * draws.unit());
        const Ray ray{origin, target - origin};
        int found = 0;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            found += hits({apex, ring[k], ring[(k + 1) % ring.size()]}, ray);
        }
        CHECK(found > 0);
    }
}

TEST_CASE("powers of two scale a hit exactly") {
    Draws draws{std::mt19937_64(22)};
    for (int i = 0; i < 2000; ++i) {
        const Triangle t{draws.unit(), draws.unit(), draws.unit()};
        const Ray ray{3.0 * draws.unit(), draws.unit()};
        for (const double by : {0x1p-40, 0x1p-3, 0x1p50}) {
            PrimitiveHit a, b;
            const bool hit = hits(t, ray, a);
            REQUIRE(hits({by * t[0], by * t[1], by * t[2]}, {by * ray.origin, ray.direction}, b) ==
                    hit);
            if (!hit) continue;
            CHECK(b.t == by * a.t);
            CHECK(b.local == a.local);
        }
    }
}

TEST_CASE("t agrees with quadruple precision to a few roundings of the input, at all scales") {
    constexpr unsigned kSeed = 23;
    CAPTURE(kSeed);
    Draws draws{std::mt19937_64(kSeed)};
    int judged = 0;
    for (int i = 0; i < 40000; ++i) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 at = size * (i % 4 == 0 ? draws.magnitude(0, 4) : 1.0) * draws.unit();
        Triangle t{at + size * draws.unit(), at + size * draws.unit(), at + size * draws.unit()};
        if (i % 3 == 0) t[2] = 0.5 * (t[0] + t[1]) + size * draws.magnitude(-8, 0) * draws.unit();
        const Vec3 target =
            t[0] + draws.between(-0.2, 1) * (t[1] - t[0]) + draws.between(-0.2, 1) * (t[2] - t[0]);
        const double away = size * draws.magnitude(0, i % 5 == 0 ? 9 : 2);
        const Ray ray{target + away * draws.unit(), {}};
        const Ray aimed{ray.origin, draws.magnitude(-3, 3) * (target - ray.origin)};
        const PlaneCrossing truth(t, aimed);
        const double noise = kUnitRoundoff * (largest(aimed.origin) + largest(at) + size);
        // Distance of the crossing to the nearest edge line, as the ray sees it.
        double margin = kInfinity;
        for (int k = 0; k < 3; ++k) {
            const Vec3 edge =
                t[static_cast<std::size_t>((k + 2) % 3)] - t[static_cast<std::size_t>((k + 1) % 3)];
            const double seen = glm::length(glm::cross(edge, glm::normalize(aimed.direction)));
            const double area = length(truth.normal) * truth.cosine(aimed);
            margin =
                std::min(margin, std::fabs(static_cast<double>(truth.weight[k])) * area / seen);
        }
        if (!(margin > 64.0 * noise)) continue;
        ++judged;
        const bool inside = truth.weight[0] > 0 && truth.weight[1] > 0 && truth.weight[2] > 0;
        PrimitiveHit hit;
        REQUIRE(hits(t, aimed, hit, {-kInfinity, kInfinity}) == inside);
        if (!inside) continue;
        const double off = std::fabs(static_cast<double>(hit.t - truth.t));
        const double reach = std::fabs(hit.t) * glm::length(aimed.direction);
        CHECK(off * glm::length(aimed.direction) * truth.cosine(aimed) <=
              4.0 * (noise + kUnitRoundoff * reach));
    }
    CHECK(judged > 20000);
}

TEST_CASE("the surface point of a flat triangle is plain") {
    const SurfacePoint s = triangleSurface(meshOf(kRight), 0, hitAt(0.25, 0.5));
    CHECK(s.point == Vec3(0.25, 0.5, 0));
    CHECK(s.normal == Vec3(0, 0, 1));
    CHECK(s.shadingNormal == s.normal);
    CHECK(s.shadowOrigin == s.point);
    CHECK(s.uv == Vec2(0.0));
    CHECK(s.dpdu == Vec3(0.0));
    CHECK(s.dpdv == Vec3(0.0));
}

TEST_CASE("corner normals are interpolated, and stand aside where they cancel or are missing") {
    TriangleMesh mesh = meshOf(kRight);
    mesh.normals = {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, -1)};
    mesh.normalCorners = {{0, 1, 0}};
    const SurfacePoint even = triangleSurface(mesh, 0, hitAt(0.5, 0.25));
    CHECK(even.shadingNormal.x == doctest::Approx(std::sqrt(0.5)));
    CHECK(even.shadingNormal.z == doctest::Approx(std::sqrt(0.5)));
    CHECK(even.normal == Vec3(0, 0, 1));
    mesh.normalCorners = {{0, 2, 0}};
    CHECK(triangleSurface(mesh, 0, hitAt(0.5, 0.25)).shadingNormal == Vec3(0, 0, 1));
    mesh.normalCorners = {{1, kNone, kNone}};
    CHECK(triangleSurface(mesh, 0, hitAt(0.5, 0.5)).shadingNormal == Vec3(0, 0, 1));
}

TEST_CASE("on a smooth bulge shadow rays start above the flat triangle, never below") {
    TriangleMesh mesh = meshOf(kRight);
    const double s = std::sqrt(1.0 / 3.0);
    mesh.normals = {Vec3(-s, -s, s), Vec3(s, -s, s), Vec3(-s, s, s)};
    mesh.normalCorners = {{0, 1, 2}};
    const SurfacePoint middle = triangleSurface(mesh, 0, hitAt(0.3, 0.3));
    CHECK(middle.shadowOrigin.z > 0.05);
    CHECK(middle.shadowOrigin.z < 0.5);
    CHECK(triangleSurface(mesh, 0, hitAt(1.0, 0.0)).shadowOrigin == Vec3(1, 0, 0));
    mesh.normals = {Vec3(s, s, s), Vec3(-s, s, s), Vec3(s, -s, s)};
    CHECK(triangleSurface(mesh, 0, hitAt(0.3, 0.3)).shadowOrigin.z == 0.0);
}

TEST_CASE("texture coordinates are interpolated, with the derivatives of the point by them") {
    TriangleMesh mesh = meshOf({Vec3(1, 1, 1), Vec3(3, 1, 1), Vec3(1, 1, 5)});
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 2), Vec2(2, 2)};
    mesh.uvCorners = {{0, 1, 2}};
    const SurfacePoint s = triangleSurface(mesh, 0, hitAt(0.5, 0.25));
    CHECK(s.uv == Vec2(0.5, 0.5));
    CHECK(s.dpdu == Vec3(2, 0, 0));
    CHECK(s.dpdv == Vec3(0, 0, 2));
    mesh.uvCorners = {{kNone, 1, 2}};
    CHECK(triangleSurface(mesh, 0, hitAt(0.5, 0.25)).uv == Vec2(0.5, 0.5));
    mesh.uvCorners = {{3, 3, 3}};
    const SurfacePoint flat = triangleSurface(mesh, 0, hitAt(0.5, 0.25));
    CHECK(flat.uv == Vec2(2, 2));
    CHECK(flat.dpdu == Vec3(0.0));
    CHECK(flat.dpdv == Vec3(0.0));
}

TEST_CASE("the normal of any triangle, slivers included, is right to a few roundings") {
    constexpr unsigned kSeed = 24;
    CAPTURE(kSeed);
    Draws draws{std::mt19937_64(kSeed)};
    for (int i = 0; i < 20000; ++i) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 at = size * draws.magnitude(-2, 4) * draws.unit();
        Triangle t{at + size * draws.unit(), at + size * draws.unit(), at + size * draws.unit()};
        if (i % 2 == 0) t[2] = 0.5 * (t[0] + t[1]) + size * draws.magnitude(-6, 0) * draws.unit();
        const Quad3 truth = cross(exact(t[1]) - exact(t[0]), exact(t[2]) - exact(t[0]));
        const double area = length(truth);
        if (!(area > 1e-10 * size * size)) continue;
        const Vec3 n = triangleSurface(meshOf(t), 0, hitAt(0.25, 0.25)).normal;
        const Quad3 wrong = cross(truth, exact(n));
        CHECK(length(wrong) <= 8.0 * kUnitRoundoff * area);
        CHECK(static_cast<double>(dot(truth, exact(n))) > 0.0);
        CHECK(std::fabs(glm::length(n) - 1.0) <= 4.0 * kUnitRoundoff);
    }
}

TEST_CASE("the stated error holds the distance of the point to the plane, and is not wasteful") {
    constexpr unsigned kSeed = 25;
    CAPTURE(kSeed);
    Draws draws{std::mt19937_64(kSeed)};
    for (int i = 0; i < 20000; ++i) {
        const double size = draws.magnitude(-6, 6);
        const Vec3 at = size * draws.magnitude(-2, 6) * draws.unit();
        const Triangle t{at + size * draws.unit(), at + size * draws.unit(),
                         at + size * draws.unit()};
        const double b1 = draws.between(0, 1);
        const double b2 = draws.between(0, 1 - b1);
        const SurfacePoint s = triangleSurface(meshOf(t), 0, hitAt(b1, b2));
        const Quad3 normal = cross(exact(t[1]) - exact(t[0]), exact(t[2]) - exact(t[0]));
        const Quad off = dot(normal, exact(s.point) - exact(t[0]));
        CHECK(std::fabs(static_cast<double>(off)) <= s.error * length(normal));
        CHECK(s.error <= 32.0 * kUnitRoundoff * (largest(at) + size));
    }
}
