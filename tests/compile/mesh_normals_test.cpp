#include "rt/compile/mesh_normals.h"

#include "rt/compile/mesh_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

namespace {

using namespace rt;

struct Polygons {
    std::vector<Vec3> vertices;
    std::vector<Index> corners;
    std::vector<Index> sizes;

    void add(std::initializer_list<Index> face) {
        corners.insert(corners.end(), face);
        sizes.push_back(static_cast<Index>(face.size()));
    }
    TriangleMesh mesh(double smoothAngle, int threads = 1) const {
        Diagnostics diagnostics;
        MeshOptions options;
        options.smoothAngleDegrees = smoothAngle;
        options.threads = threads;
        return meshFromPolygons(vertices, corners, sizes, options, {}, diagnostics);
    }
};

Vec3 faceNormal(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return glm::normalize(
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
}

/// The normal that a corner is shaded with.
Vec3 normalAt(const TriangleMesh& mesh, std::size_t triangle, std::size_t corner) {
    const Index index = mesh.normalCorners.empty() ? kNone : mesh.normalCorners[triangle][corner];
    return index == kNone ? faceNormal(mesh, triangle) : mesh.normals[index];
}

/// Runs over (triangle, corner).
void forEachCorner(const TriangleMesh& mesh,
                   const std::function<void(std::size_t, std::size_t)>& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) visit(t, k);
    }
}

/// The definition itself, with every corner of the mesh compared with every other.
Vec3 expectedNormal(const TriangleMesh& mesh, std::size_t triangle, std::size_t corner,
                    double degrees) {
    const Vec3 place = mesh.positions[mesh.triangles[triangle][corner]];
    const Vec3 own = faceNormal(mesh, triangle);
    Vec3 sum(0.0);
    forEachCorner(mesh, [&](std::size_t t, std::size_t k) {
        if (mesh.positions[mesh.triangles[t][k]] != place) return;
        const Vec3 other = faceNormal(mesh, t);
        const double angle = std::acos(std::clamp(glm::dot(own, other), -1.0, 1.0));
        if (angle * 180.0 / M_PI > degrees + 1e-6) return;
        const Vec3 e = glm::normalize(mesh.positions[mesh.triangles[t][(k + 1) % 3]] - place);
        const Vec3 f = glm::normalize(mesh.positions[mesh.triangles[t][(k + 2) % 3]] - place);
        sum += std::acos(std::clamp(glm::dot(e, f), -1.0, 1.0)) * other;
    });
    return glm::normalize(sum);
}

Polygons cube() {
    Polygons cube;
    for (int i = 0; i < 8; ++i) {
        cube.vertices.push_back({i & 1, (i >> 1) & 1, i >> 2});
    }
    for (const std::initializer_list<Index> face : {std::initializer_list<Index>{0, 2, 3, 1},
                                                    {4, 5, 7, 6},
                                                    {0, 1, 5, 4},
                                                    {2, 6, 7, 3},
                                                    {0, 4, 6, 2},
                                                    {1, 3, 7, 5}}) {
        cube.add(face);
    }
    return cube;
}

/// Longitudes and latitudes of a unit sphere, with `sides` quads around.
Polygons sphere(Index sides) {
    Polygons ball;
    ball.vertices = {{0, 1, 0}, {0, -1, 0}};
    const Index rings = sides / 2 - 1;
    for (Index r = 0; r < rings; ++r) {
        const double polar = M_PI * (r + 1) / (rings + 1);
        for (Index s = 0; s < sides; ++s) {
            const double turn = 2.0 * M_PI * s / sides;
            ball.vertices.push_back({std::sin(polar) * std::cos(turn), std::cos(polar),
                                     -std::sin(polar) * std::sin(turn)});
        }
    }
    const auto at = [sides](Index ring, Index side) { return 2 + ring * sides + side % sides; };
    for (Index s = 0; s < sides; ++s) {
        ball.add({0, at(0, s), at(0, s + 1)});
        for (Index r = 0; r + 1 < rings; ++r) {
            ball.add({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        ball.add({1, at(rings - 1, s + 1), at(rings - 1, s)});
    }
    return ball;
}

TEST_CASE("a cube keeps its edges below 90 degrees and loses them from there on") {
    for (const double degrees : {0.0, 1.0, 40.0, 89.9}) {
        CHECK(cube().mesh(degrees).normalCorners.empty());
        CHECK(cube().mesh(degrees).normals.empty());
    }
    for (const double degrees : {90.0, 120.0, 180.0}) {
        const TriangleMesh mesh = cube().mesh(degrees);
        forEachCorner(mesh, [&](std::size_t t, std::size_t k) {
            const Vec3 outward = mesh.positions[mesh.triangles[t][k]] - Vec3(0.5);
            // However a face was cut into triangles, it weighs by its right angle.
            CHECK(glm::length(normalAt(mesh, t, k) - glm::normalize(outward)) < 1e-14);
        });
        CHECK(mesh.normals.size() == 8);
    }
}

TEST_CASE("the limit is met by equal angles, in spite of rounding") {
    for (const Index sides : {5u, 6u, 8u, 9u, 10u, 12u, 15u, 18u, 20u, 24u, 36u, 72u}) {
        CAPTURE(sides);
        Polygons prism;
        for (Index s = 0; s < sides; ++s) {
            const double turn = 2.0 * M_PI * s / sides;
            prism.vertices.push_back({std::cos(turn), 0, -std::sin(turn)});
            prism.vertices.push_back({std::cos(turn), 1, -std::sin(turn)});
        }
        for (Index s = 0; s < sides; ++s) {
            const Index next = (s + 1) % sides;
            prism.add({2 * s, 2 * next, 2 * next + 1, 2 * s + 1});
        }
        const double bend = 360.0 / sides;
        CHECK(prism.mesh(bend - 1e-6).normalCorners.empty());
        const TriangleMesh mesh = prism.mesh(bend);
        forEachCorner(mesh, [&](std::size_t t, std::size_t k) {
            Vec3 outward = mesh.positions[mesh.triangles[t][k]];
            outward.y = 0.0;
            CHECK(glm::length(normalAt(mesh, t, k) - glm::normalize(outward)) < 1e-13);
        });
        CHECK(mesh.normals.size() == 2 * sides);
    }
}

TEST_CASE("a sphere becomes round, with one normal a vertex") {
    const TriangleMesh mesh = sphere(48).mesh(40.0);
    CHECK(mesh.closed);
    CHECK(mesh.normals.size() == mesh.positions.size());
    forEachCorner(mesh, [&](std::size_t t, std::size_t k) {
        const Vec3& outward = mesh.positions[mesh.triangles[t][k]];
        CHECK(glm::length(normalAt(mesh, t, k) - outward) < 0.01);
    });
}

TEST_CASE("normals agree with the definition, however crumpled the mesh") {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        const double scale = std::pow(10.0, static_cast<double>(seed % 13) - 6.0);
        Polygons crumpled = seed % 3 == 0 ? cube() : sphere(seed % 2 ? 8 : 14);
        for (Vec3& v : crumpled.vertices) {
            v = scale * (v + 0.15 * Vec3(normal(random), normal(random), normal(random)));
        }
        for (const double degrees : {0.5, 20.0, 40.0, 75.0, 120.0, 180.0}) {
            CAPTURE(degrees);
            const TriangleMesh mesh = crumpled.mesh(degrees);
            double worst = 0.0;
            forEachCorner(mesh, [&](std::size_t t, std::size_t k) {
                const Vec3 difference = normalAt(mesh, t, k) - expectedNormal(mesh, t, k, degrees);
                worst = std::max(worst, glm::length(difference));
            });
            CHECK(worst < 1e-7);
        }
    }
}

TEST_CASE("the normals of many vertices are the same for any number of threads") {
    const Polygons ball = sphere(400);
    const TriangleMesh one = ball.mesh(30.0);
    double worst = 0.0;
    forEachCorner(one, [&](std::size_t t, std::size_t k) {
        const Vec3& outward = one.positions[one.triangles[t][k]];
        worst = std::max(worst, glm::length(normalAt(one, t, k) - outward));
    });
    CHECK(worst < 0.01);
    for (const int threads : {2, 5}) {
        const TriangleMesh other = ball.mesh(30.0, threads);
        CHECK(other.normals == one.normals);
        CHECK(other.normalCorners == one.normalCorners);
    }
}

TEST_CASE("normals agree with the definition where very many faces meet") {
    // A crumpled cone of 600 faces: its apex goes through the tree.
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Polygons cone;
    cone.vertices.push_back({0, 0, 0});
    const Index sides = 600;
    for (Index s = 0; s < sides; ++s) {
        const double turn = 2.0 * M_PI * s / sides;
        cone.vertices.push_back({std::cos(turn), 0.3 + 0.01 * unit(random), std::sin(turn)});
    }
    for (Index s = 0; s < sides; ++s) cone.add({0, 1 + s, 1 + (s + 1) % sides});
    for (const double degrees : {0.1, 5.0, 40.0, 90.0, 180.0}) {
        CAPTURE(degrees);
        const TriangleMesh mesh = cone.mesh(degrees);
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 7) {
            CHECK(glm::length(normalAt(mesh, t, 0) - expectedNormal(mesh, t, 0, degrees)) < 1e-7);
        }
    }
}

TEST_CASE("a fan of a hundred thousand faces at one vertex takes no quadratic time") {
    Polygons fan;
    fan.vertices.push_back({0, 0, 0});
    const Index sides = 100000;
    for (Index s = 0; s < sides; ++s) {
        const double turn = 2.0 * M_PI * s / sides;
        fan.vertices.push_back({std::cos(turn), 2.0 + 0.5 * std::sin(40.0 * turn), std::sin(turn)});
    }
    for (Index s = 0; s < sides; ++s) fan.add({0, 1 + s, 1 + (s + 1) % sides});
    CHECK(fan.mesh(40.0).triangles.size() == sides);
}

TEST_CASE("opposite faces back to back cancel to their own normals") {
    Polygons sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    sheet.add({0, 1, 2});
    sheet.add({0, 2, 1});
    const TriangleMesh mesh = sheet.mesh(180.0);
    CHECK(mesh.normalCorners.empty());
}

TEST_CASE("what cancels but for rounding is no normal") {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        Polygons sheet;
        sheet.vertices = {point(), point(), point()};
        sheet.vertices.push_back(glm::mix(sheet.vertices[1], sheet.vertices[2], 0.37));
        sheet.add({0, 1, 2});
        sheet.add({0, 2, 3});
        sheet.add({0, 3, 1});
        sheet.add({3, 2, 1});
        const TriangleMesh mesh = sheet.mesh(180.0);
        if (!mesh.normalCorners.empty()) CHECK(mesh.normalCorners[0][0] == kNone);
    }
}

TEST_CASE("a triangle without area bends no normal") {
    Polygons roof;
    roof.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0, 1, 0.2}, {1, -1, 0.1}};
    roof.add({0, 1, 3});
    roof.add({0, 4, 1});
    const TriangleMesh plain = roof.mesh(120.0);
    roof.add({0, 2, 1});
    const TriangleMesh with = roof.mesh(120.0);
    CHECK(with.triangles == plain.triangles);
    CHECK(with.normals == plain.normals);
    CHECK(with.normalCorners == plain.normalCorners);
}

TEST_CASE("vertices at equal positions are smoothed as one") {
    const Polygons shared = sphere(12);
    Polygons split;
    for (const Index corner : shared.corners) {
        split.corners.push_back(static_cast<Index>(split.vertices.size()));
        split.vertices.push_back(shared.vertices[corner]);
    }
    split.sizes = shared.sizes;
    const TriangleMesh a = shared.mesh(40.0);
    const TriangleMesh b = split.mesh(40.0);
    CHECK(b.closed);
    CHECK(b.normals.size() == a.normals.size());
    forEachCorner(
        a, [&](std::size_t t, std::size_t k) { CHECK(normalAt(a, t, k) == normalAt(b, t, k)); });
}

TEST_CASE("face normals are right at every scale, and 0 for what has no area") {
    for (const double scale : {1e-300, 1e-150, 1e-6, 1.0, 1e6, 1e150, 1e300}) {
        const Vec3 a = scale * Vec3(1, 2, 3);
        CHECK(glm::length(unitFaceNormal(a, a + scale * Vec3(1, 0, 0), a + scale * Vec3(0, 1, 0)) -
                          Vec3(0, 0, 1)) < 1e-14);
        CHECK(unitFaceNormal(a, 2.0 * a, 4.0 * a) == Vec3(0.0));
        CHECK(unitFaceNormal(a, a, 2.0 * a) == Vec3(0.0));
        // A thousand times wider than the rounding of its sides.
        const Vec3 thin = unitFaceNormal(scale * Vec3(0, 0, 0), scale * Vec3(1, 0, 0),
                                         scale * Vec3(0.3, 1e-13, 0));
        CHECK(glm::length(thin - Vec3(0, 0, 1)) < 1e-14);
    }
    // Sides of very different lengths, and beyond the range of their difference.
    CHECK(unitFaceNormal({0, 0, 0}, {1e-200, 0, 0}, {0, 1e200, 0}) == Vec3(0, 0, 1));
    CHECK(unitFaceNormal({-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}) == Vec3(0, 0, 1));
    CHECK(unitFaceNormal({0, 0, 0}, {4.9e-324, 0, 0}, {0, 4.9e-324, 0}) == Vec3(0, 0, 1));
}

TEST_CASE("normalising is right at every scale") {
    for (const double scale : {4.9e-324, 1e-300, 1.0, 1e300}) {
        const Vec3 n = normalizedOrZero(scale * Vec3(0, 1, -1));
        CHECK(n.y == doctest::Approx(std::sqrt(0.5)).epsilon(1e-15));
        CHECK(n.z == -n.y);
    }
    CHECK(normalizedOrZero(Vec3(0.0)) == Vec3(0.0));
}

}  // namespace
