// Meshes and hostile rays for the tests of the trees.
#pragma once

#include "rt/core/ray.h"
#include "rt/geometry/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace rt::test {

struct Draws {
    std::mt19937_64 random;

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    std::size_t below(std::size_t count) { return random() % count; }
    double magnitude(double low, double high) { return std::pow(10.0, between(low, high)); }
    Vec3 unit() {
        for (;;) {
            const Vec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            const double squared = glm::dot(v, v);
            if (squared > 0.01 && squared < 1.0) return v / std::sqrt(squared);
        }
    }
};

/// Separate triangles in a ball of radius `size` about `at`: round, thin, flat and alike.
inline TriangleMesh triangleSoup(Draws& draws, std::size_t count, double size, const Vec3& at) {
    TriangleMesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 centre = at + size * draws.unit();
        Vec3 corner[3];
        for (Vec3& c : corner) c = centre + 0.4 * size * draws.unit();
        switch (draws.below(5)) {
            case 0:
                corner[2] = corner[1] + size * 1e-5 * draws.unit();
                break;
            case 1:
                corner[0].x = corner[1].x = corner[2].x;
                break;
            case 2:
                corner[1] = corner[0] + 3.0 * size * draws.unit();
                break;
            default:
                break;
        }
        const auto first = static_cast<Index>(mesh.positions.size());
        for (const Vec3& c : corner) mesh.positions.push_back(c);
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (draws.below(10) == 0) mesh.triangles.push_back({first + 1, first + 2, first});
    }
    return mesh;
}

/// A closed, bumpy ball: an octahedron cut `levels` times, its corners pushed to about radius 1,
/// then scaled and moved.
inline TriangleMesh closedBall(Draws& draws, int levels, double scale, const Vec3& move) {
    TriangleMesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto key = std::minmax(a, b);
            const auto [place, isNew] = middles.try_emplace({key.first, key.second}, 0);
            if (isNew) {
                place->second = static_cast<Index>(mesh.positions.size());
                mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
            }
            return place->second;
        };
        std::vector<TriangleMesh::Corners> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    for (Vec3& p : mesh.positions) {
        p = glm::normalize(p) * draws.between(0.98, 1.0);
        p = p * scale + move;
    }
    mesh.closed = true;
    return mesh;
}

/// A ray at a mesh: from near or far, at corners, edges, insides or past it, along axes, or lying
/// in the plane of a triangle.
inline Ray hostileRay(Draws& draws, const TriangleMesh& mesh, double size) {
    const TriangleMesh::Corners& at = mesh.triangles[draws.below(mesh.triangles.size())];
    const Vec3 a = mesh.positions[at[0]], b = mesh.positions[at[1]], c = mesh.positions[at[2]];
    const double u = static_cast<double>(draws.below(5)) / 4.0;
    const double v = draws.below(2) == 0 ? 0.0 : draws.between(-0.2, 1.2 - u);
    const Vec3 target = draws.below(3) == 0 ? a : a + u * (b - a) + v * (c - a);
    constexpr double kSmall[] = {0.0, -0.0, 1e-310, -1e-310, 1e-40, -1e-20};
    Ray ray;
    switch (draws.below(5)) {
        case 0: {  // along an axis, or nearly
            for (int k = 0; k < 3; ++k) ray.direction[k] = kSmall[draws.below(6)];
            ray.direction[static_cast<int>(draws.below(3))] = draws.below(2) == 0 ? 1.0 : -1.0;
            if (draws.below(3) == 0) {
                ray.direction[static_cast<int>(draws.below(3))] = draws.between(-1, 1);
            }
            ray.origin = target - size * draws.between(-1, 8) * ray.direction;
            break;
        }
        case 1:  // in the plane of the triangle
            ray.direction = draws.between(-1, 1) * (b - a) + draws.between(-1, 1) * (c - a);
            ray.origin = target - draws.between(-1, 8) * ray.direction;
            break;
        case 2:  // from far away
            ray.origin = target + size * draws.magnitude(1, 9) * draws.unit();
            ray.direction = target - ray.origin;
            break;
        case 3:  // from a surface
            ray.origin = target;
            ray.direction = draws.magnitude(-3, 3) * draws.unit();
            break;
        default:
            ray.origin = target + size * draws.between(0, 3) * draws.unit();
            ray.direction = draws.magnitude(-3, 3) * (target - ray.origin);
    }
    return ray;
}

}  // namespace rt::test
