// Meshes and rays for the benchmark of the tree: made here, so that it needs no files.
#pragma once

#include "rt/accel/mesh_tree.h"
#include "rt/geometry/triangle_mesh.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rt::bench {

inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vec3 unitVector(std::mt19937_64& random) {
    for (;;) {
        const Vec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        const double squared = glm::dot(v, v);
        if (squared > 0.01 && squared < 1.0) return v / std::sqrt(squared);
    }
}

inline Vec3 displaced(const Vec3& p) {
    const Vec3 n = glm::normalize(p);
    double r = 1.0;
    for (int octave = 0; octave < 4; ++octave) {
        const double f = 4.0 * std::exp2(octave);
        r += 0.4 / f * std::sin(f * n.x + 1.0) * std::sin(f * n.y + 2.0) * std::sin(f * n.z + 3.0);
    }
    return n * r;
}

/// An icosahedron, each face cut into f^2, pushed out to a bumpy sphere: 20 f^2 triangles, closed.
class Icosphere {
  public:
    static TriangleMesh make(Index f) { return Icosphere(f).mesh_; }

  private:
    explicit Icosphere(Index f) : f_(f) {
        const double g = std::numbers::phi;
        const Vec3 corners[12] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                  {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                  {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
        const Index faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
        std::copy(corners, corners + 12, corners_);
        for (const auto& face : faces) addFace(face);
        mesh_.closed = true;
    }

    /// The grid point j steps towards the second and k towards the third corner of a face.
    Index point(const Index (&face)[3], Index j, Index k) {
        const std::array<std::pair<Index, Index>, 3> parts{
            std::pair{face[0], f_ - j - k}, std::pair{face[1], j}, std::pair{face[2], k}};
        std::map<Index, Index> weights;  // by corner, so that both faces of an edge sum alike
        for (const auto& [corner, weight] : parts) {
            if (weight > 0) weights[corner] = weight;
        }
        if (weights.size() == 3) return add(weights);
        const std::vector<std::pair<Index, Index>> key(weights.begin(), weights.end());
        const auto [place, isNew] = shared_.try_emplace(key, 0);
        if (isNew) place->second = add(weights);
        return place->second;
    }

    Index add(const std::map<Index, Index>& weights) {
        Vec3 sum(0.0);
        for (const auto& [corner, weight] : weights) sum += double(weight) * corners_[corner];
        mesh_.positions.push_back(displaced(sum));
        return static_cast<Index>(mesh_.positions.size() - 1);
    }

    void addFace(const Index (&face)[3]) {
        std::vector<Index> row, next;
        for (Index k = 0; k <= f_; ++k) row.push_back(point(face, 0, k));
        for (Index j = 1; j <= f_; ++j) {
            next.clear();
            for (Index k = 0; k + j <= f_; ++k) next.push_back(point(face, j, k));
            for (Index k = 0; k + j <= f_; ++k) {
                mesh_.triangles.push_back({row[k], next[k], row[k + 1]});
                if (k + j < f_) mesh_.triangles.push_back({next[k], next[k + 1], row[k + 1]});
            }
            std::swap(row, next);
        }
    }

    Index f_;
    Vec3 corners_[12];
    std::map<std::vector<std::pair<Index, Index>>, Index> shared_;
    TriangleMesh mesh_;
};

/// A hall of 40 x 12 x 24 with columns, cables, slats, railings and balls: many triangles are
/// hundreds of times as long as wide, and lie across the axes.
class Room {
  public:
    static TriangleMesh make() { return Room().mesh_; }

  private:
    Room() {
        floorTiles();
        for (int i = 0; i < 160; ++i) {
            const Vec3 foot(uniform(random_, -19, 19), 0.0, uniform(random_, -11, 11));
            tube(foot, foot + Vec3(0.0, 12.0, 0.0), uniform(random_, 0.05, 0.3), 96);
        }
        for (int i = 0; i < 700; ++i) {
            const Vec3 from(uniform(random_, -19, 19), uniform(random_, 7, 12),
                            uniform(random_, -11, 11));
            const Vec3 by(uniform(random_, -12, 12), uniform(random_, -2, 2),
                          uniform(random_, -12, 12));
            tube(from, from + by, uniform(random_, 0.005, 0.04), 16);
        }
        for (int i = 0; i < 3000; ++i) slat(i);
        for (int i = 0; i < 1500; ++i) {
            const double at = -19.0 + 38.0 * i / 1500.0;
            const Vec3 foot(at, 3.0 + 0.15 * at, 6.0 + 0.1 * at);
            tube(foot, foot + Vec3(0.1, 1.0, 0.05), 0.006, 12);
        }
        for (int i = 0; i < 50; ++i) {
            const Vec3 centre(uniform(random_, -18, 18), uniform(random_, 0.3, 3),
                              uniform(random_, -10, 10));
            ball(centre, uniform(random_, 0.1, 0.6));
        }
    }

    Index add(const Vec3& p) {
        mesh_.positions.push_back(p);
        return static_cast<Index>(mesh_.positions.size() - 1);
    }
    void quad(Index a, Index b, Index c, Index d) {
        mesh_.triangles.push_back({a, b, c});
        mesh_.triangles.push_back({a, c, d});
    }

    void floorTiles() {
        for (int i = 0; i < 80; ++i) {
            for (int j = 0; j < 48; ++j) {
                const double x = -20 + 0.5 * i, z = -12 + 0.5 * j;
                quad(add({x, 0, z}), add({x, 0, z + 0.5}), add({x + 0.5, 0, z + 0.5}),
                     add({x + 0.5, 0, z}));
            }
        }
        const Vec3 lo(-20, 0, -12), hi(20, 12, 12);
        quad(add(lo), add({hi.x, lo.y, lo.z}), add({hi.x, hi.y, lo.z}), add({lo.x, hi.y, lo.z}));
        quad(add({lo.x, lo.y, hi.z}), add({hi.x, lo.y, hi.z}), add(hi), add({lo.x, hi.y, hi.z}));
        quad(add(lo), add({lo.x, lo.y, hi.z}), add({lo.x, hi.y, hi.z}), add({lo.x, hi.y, lo.z}));
        quad(add({hi.x, lo.y, lo.z}), add({hi.x, lo.y, hi.z}), add(hi), add({hi.x, hi.y, lo.z}));
        quad(add({lo.x, hi.y, lo.z}), add({hi.x, hi.y, lo.z}), add(hi), add({lo.x, hi.y, hi.z}));
    }

    void tube(const Vec3& from, const Vec3& to, double radius, int sides) {
        const Vec3 along = glm::normalize(to - from);
        const Vec3 other = std::fabs(along.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const Vec3 u = glm::normalize(glm::cross(along, other));
        const Vec3 v = glm::cross(along, u);
        const auto first = static_cast<Index>(mesh_.positions.size());
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / sides;
            const Vec3 out = radius * (std::cos(angle) * u + std::sin(angle) * v);
            add(from + out);
            add(to + out);
        }
        for (Index i = 0; i < static_cast<Index>(sides); ++i) {
            const Index a = first + 2 * i, b = first + 2 * ((i + 1) % static_cast<Index>(sides));
            quad(a, b, b + 1, a + 1);
        }
    }

    void slat(int i) {
        const Vec3 middle(-18.0 + 36.0 * (i % 50) / 50.0, 1.0 + 0.15 * (i / 50), -11.5);
        const Vec3 half(0.33, 0.0, 0.0), up(0.0, 0.03, 0.05), thick(0.0, 0.002, -0.001);
        for (const double side : {-1.0, 1.0}) {
            const Vec3 m = middle + side * thick;
            quad(add(m - half - up), add(m + half - up), add(m + half + up), add(m - half + up));
        }
    }

    void ball(const Vec3& centre, double radius) {
        constexpr Index kRings = 24, kSides = 40;
        const auto first = static_cast<Index>(mesh_.positions.size());
        for (Index i = 0; i <= kRings; ++i) {
            for (Index j = 0; j < kSides; ++j) {
                const double a = std::numbers::pi * i / kRings;
                const double b = 2.0 * std::numbers::pi * j / kSides;
                add(centre + radius * Vec3(std::sin(a) * std::cos(b), std::cos(a),
                                           std::sin(a) * std::sin(b)));
            }
        }
        for (Index i = 0; i < kRings; ++i) {
            for (Index j = 0; j < kSides; ++j) {
                const Index a = first + i * kSides, next = (j + 1) % kSides;
                const bool atPole = i == 0, atFoot = i + 1 == kRings;
                if (!atPole) mesh_.triangles.push_back({a + j, a + next, a + kSides + next});
                if (!atFoot) mesh_.triangles.push_back({a + j, a + kSides + next, a + kSides + j});
            }
        }
    }

    std::mt19937_64 random_{7};
    TriangleMesh mesh_;
};

struct RaySet {
    std::string name;
    bool anyHit = false;
    std::vector<Ray> rays;
    double tMin = 0.0;
    double tMax = kInfinity;
};

/// Pixel number i of a picture that is taken in squares of 4 x 4, as (column, row).
inline std::pair<int, int> pixelAt(int i, int size) {
    constexpr int kSquare = 4;
    const int square = i / (kSquare * kSquare), within = i % (kSquare * kSquare);
    const int squares = size / kSquare;
    return {kSquare * (square % squares) + within % kSquare,
            kSquare * (square / squares) + within / kSquare};
}

/// Primary rays of a size x size picture (a multiple of 4); from what they hit, shadow rays to a
/// light and mirror rays; and rays between random points of the box.
inline std::vector<RaySet> makeRays(const TriangleMesh& mesh, const MeshTree& tree, const Ray& view,
                                    int size) {
    const Bounds box = tree.bounds();
    const double reach = glm::length(box.extent());
    const double gap = 1e-4 * reach;
    RaySet primary{"primary", false, {}, 0.0, kInfinity};
    RaySet shadow{"shadow", true, {}, gap / reach, 1.0};
    RaySet mirror{"reflection", false, {}, gap, kInfinity};
    RaySet random{"random", false, {}, 0.0, kInfinity};
    const Vec3 forward = glm::normalize(view.direction);
    const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0)));
    const Vec3 up = glm::cross(right, forward);
    const Vec3 light = view.origin + 0.2 * reach * up + 0.15 * reach * right;
    for (int i = 0; i < size * size; ++i) {
        const auto [column, row] = pixelAt(i, size);
        const double x = (2.0 * column + 1.0) / size - 1.0;
        const double y = 1.0 - (2.0 * row + 1.0) / size;
        const Ray ray{view.origin, glm::normalize(forward + 0.5 * (x * right + y * up))};
        primary.rays.push_back(ray);
        PrimitiveHit hit;
        if (!tree.closestHit(ray, {}, hit)) continue;
        const auto& corners = mesh.triangles[hit.part];
        const Vec3 a = mesh.positions[corners[0]];
        const Vec3 n = glm::normalize(
            glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a));
        const Vec3 p = ray.at(hit.t);
        shadow.rays.push_back({p, light - p});
        mirror.rays.push_back({p, ray.direction - 2.0 * glm::dot(n, ray.direction) * n});
    }
    std::mt19937_64 generator(11);
    for (int i = 0; i < size * size; ++i) {
        const Vec3 at(uniform(generator, 0, 1), uniform(generator, 0, 1), uniform(generator, 0, 1));
        random.rays.push_back({box.min + at * box.extent(), unitVector(generator)});
    }
    return {primary, shadow, mirror, random};
}

}  // namespace rt::bench
