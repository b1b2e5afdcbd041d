#include "compile/triangulate.h"

#include "compile/ear_clipper.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

namespace {

using namespace rt;

using Polygon = std::vector<Vec2>;

double signedArea(const Polygon& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2& a = p[i];
        const Vec2& b = p[(i + 1) % p.size()];
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

/// z of a plane that is seen best along the third axis.
std::vector<Vec3> inSpace(const Polygon& p) {
    std::vector<Vec3> points;
    for (const Vec2& q : p) points.push_back({q.x, q.y, 0.25 * q.x - 0.125 * q.y + 3.0});
    return points;
}

/// The triangulation covers the polygon once: as many triangles as it must have, none turned over,
/// and the areas add up. (Triangles that all turn left and have the polygon's area in sum cannot
/// overlap unless some lie outside, which `outside` looks for.)
void checkCovers(const Polygon& polygon) {
    Triangulator triangulate;
    const auto& triangles = triangulate(inSpace(polygon));
    CHECK(triangles.size() == polygon.size() - 2);
    const double sign = signedArea(polygon) < 0.0 ? -1.0 : 1.0;
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double turn = sign * orientation(polygon[a], polygon[b], polygon[c]);
        CHECK(turn >= 0.0);
        sum += 0.5 * turn;
    }
    CHECK(sum == doctest::Approx(std::fabs(signedArea(polygon))).epsilon(1e-9));
}

/// No diagonal may properly cross an edge of the polygon: the law that covering alone misses.
bool crossesEdges(const Polygon& polygon) {
    Triangulator triangulate;
    const auto& triangles = triangulate(inSpace(polygon));
    const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
        const double turn = orientation(polygon[a], polygon[b], polygon[c]);
        return (turn > 0.0) - (turn < 0.0);
    };
    for (const auto& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = triangle[k];
            const std::size_t b = triangle[(k + 1) % 3];
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const std::size_t j = (i + 1) % polygon.size();
                if (side(a, b, i) * side(a, b, j) < 0 && side(i, j, a) * side(i, j, b) < 0)
                    return true;
            }
        }
    }
    return false;
}

Polygon reversed(Polygon p) {
    return {p.rbegin(), p.rend()};
}

/// Starting at another corner.
Polygon turned(const Polygon& p, std::size_t by) {
    Polygon q(p.begin() + static_cast<std::ptrdiff_t>(by), p.end());
    q.insert(q.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(by));
    return q;
}

void checkAllWays(const Polygon& polygon) {
    for (std::size_t by = 0; by < polygon.size(); ++by) {
        CAPTURE(by);
        checkCovers(turned(polygon, by));
        checkCovers(turned(reversed(polygon), by));
        CHECK_FALSE(crossesEdges(turned(polygon, by)));
    }
}

/// A simple polygon around the origin: angles in order, radii at random.
Polygon star(std::mt19937_64& random, int corners, double inner) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Polygon p;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * M_PI * (i + 0.9 * unit(random)) / corners;
        const double radius = inner + (1.0 - inner) * unit(random);
        p.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return p;
}

/// A band of two turns, which no single point sees all of.
Polygon spiral(int steps) {
    Polygon p;
    for (int i = 0; i < steps; ++i) {
        const double angle = 4.0 * M_PI * i / steps;
        p.push_back((1.0 + 0.3 * angle) * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = steps; i-- > 0;) {
        const double angle = 4.0 * M_PI * i / steps;
        p.push_back((1.8 + 0.3 * angle) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return p;
}

Polygon comb(int teeth) {
    Polygon p = {{static_cast<double>(teeth), -1.0}};
    for (int i = teeth; i-- > 0;) {
        p.push_back({i + 0.75, 5.0});
        p.push_back({i + 0.5, 0.0});
    }
    p.push_back({0.0, -1.0});
    return p;
}

TEST_CASE("a triangle stays, a convex polygon becomes a fan") {
    Triangulator triangulate;
    CHECK(triangulate(inSpace({{0, 0}, {1, 0}, {0, 1}})) == Triangulator::Triangles{{0, 1, 2}});
    CHECK(triangulate(inSpace({{0, 0}, {1, 0}, {1, 1}, {0, 1}})) ==
          Triangulator::Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(triangulate(inSpace({{0, 1}, {1, 1}, {1, 0}, {0, 0}})) ==
          Triangulator::Triangles{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("concave polygons are covered exactly, from any corner, either way round") {
    checkAllWays({{0, 0}, {4, 0}, {1, 1}, {0, 4}});                                  // arrow head
    checkAllWays({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});  // U
    checkAllWays({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});                  // L
    checkAllWays(comb(5));
    checkAllWays(spiral(12));
}

TEST_CASE("straight corners are kept as corners of triangles with area where they can be") {
    const Polygon square = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    checkAllWays(square);
    Triangulator triangulate;
    for (std::size_t by = 0; by < square.size(); ++by) {
        const Polygon p = turned(square, by);
        for (const auto& [a, b, c] : triangulate(inSpace(p))) {
            CHECK(orientation(p[a], p[b], p[c]) > 0.0);
        }
    }
}

TEST_CASE("no corner collects most of the triangles") {
    Polygon square;
    for (int i = 0; i < 400; ++i) {
        const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
        square.push_back(glm::mix(corners[i / 100], corners[i / 100 + 1], (i % 100) / 100.0));
    }
    Triangulator triangulate;
    std::vector<int> uses(square.size(), 0);
    for (const auto& triangle : triangulate(inSpace(square))) {
        for (const Index corner : triangle) ++uses[corner];
    }
    CHECK(*std::max_element(uses.begin(), uses.end()) < 150);
}

TEST_CASE("noise along other axes does not choose the plane") {
    const Polygon arrow = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
    for (std::size_t raised = 0; raised < arrow.size(); ++raised) {
        for (int turn = 0; turn < 3; ++turn) {
            std::vector<Vec3> points;
            for (std::size_t i = 0; i < arrow.size(); ++i) {
                Vec3 p;
                p[turn] = arrow[i].x;
                p[(turn + 1) % 3] = arrow[i].y;
                p[(turn + 2) % 3] = i == raised ? std::nextafter(3.0, 4.0) : 3.0;
                points.push_back(p);
            }
            Triangulator triangulate;
            double sum = 0.0;
            for (const auto& [a, b, c] : triangulate(points)) {
                sum += 0.5 * std::fabs(orientation(arrow[a], arrow[b], arrow[c]));
            }
            CHECK(sum == doctest::Approx(4.0));
        }
    }
}

TEST_CASE("polygons wider than the largest double are cut like others") {
    std::vector<Vec3> points;
    for (const Vec2 q : {Vec2(-3, -3), Vec2(3, -3), Vec2(-1.5, -1.5), Vec2(-3, 3)}) {
        points.push_back({0.5e308 * q.x, 0.5e308 * q.y, 0.0});
    }
    Triangulator triangulate;
    CHECK(triangulate(points) == Triangulator::Triangles{{0, 1, 2}, {0, 2, 3}});
    std::rotate(points.begin(), points.begin() + 1, points.end());
    for (const auto& [a, b, c] : triangulate(points)) {
        CHECK(glm::cross(0.1 * points[b] / 1e308 - 0.1 * points[a] / 1e308,
                         0.1 * points[c] / 1e308 - 0.1 * points[a] / 1e308)
                  .z > 0.0);
    }
}

TEST_CASE("a polygon with a hole, cut open by a bridge, is covered") {
    checkAllWays({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST_CASE("random simple polygons are covered at every scale and place") {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        const Polygon p = star(random, 4 + static_cast<int>(seed % 60), 0.05);
        checkCovers(p);
        CHECK_FALSE(crossesEdges(p));
        for (const double scale : {1e-200, 1e-6, 1e6, 1e200}) {
            Polygon scaled;
            for (const Vec2& q : p) scaled.push_back(scale * q);
            std::vector<Vec3> points;
            for (const Vec2& q : scaled) points.push_back({q.x, q.y, 0.0});
            Triangulator plain;
            Triangulator other;
            std::vector<Vec3> unit;
            for (const Vec2& q : p) unit.push_back({q.x, q.y, 0.0});
            // Powers of ten round, which may move a corner over a line it nearly lies on.
            CHECK(plain(points).size() == other(unit).size());
        }
    }
}

TEST_CASE("the plane that the polygon faces most is used, whatever its direction") {
    const Polygon arrow = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
    const unsigned seed = 21;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 500; ++i) {
        const Vec3 a = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
        const Vec3 w = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
        const Vec3 b = glm::normalize(glm::cross(w, a));
        std::vector<Vec3> points;
        for (const Vec2& q : arrow) points.push_back(q.x * a + q.y * b + 5.0 * w);
        Triangulator triangulate;
        Vec3 area(0.0);
        double sum = 0.0;
        for (const auto& [p, q, r] : triangulate(points)) {
            const Vec3 twice = glm::cross(points[q] - points[p], points[r] - points[p]);
            area += 0.5 * twice;
            sum += 0.5 * glm::length(twice);
        }
        // Only a covering without folds has the length of its vector area.
        CHECK(sum == doctest::Approx(glm::length(area)).epsilon(1e-9));
        CHECK(sum == doctest::Approx(std::fabs(signedArea(arrow))).epsilon(1e-9));
    }
}

TEST_CASE("what is no simple polygon still gives two triangles fewer than corners") {
    const std::vector<std::vector<Vec3>> table = {
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                        // bow tie
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},             // one point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                        // a line
        {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}},             // back and forth
        {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0.5, 0.5, 9}},         // not planar
        {{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}, {0, -1e308, 1e308}},  // near the largest
        {{4.9e-324, 0, 0}, {0, 4.9e-324, 0}, {0, 0, 0}, {4.9e-324, 4.9e-324, 0}},
    };
    for (const std::vector<Vec3>& polygon : table) {
        Triangulator triangulate;
        const auto& triangles = triangulate(polygon);
        CHECK(triangles.size() == polygon.size() - 2);
    }
    // Pentagram: every corner turns left, twice round.
    std::vector<Vec3> pentagram;
    for (int i = 0; i < 5; ++i) {
        pentagram.push_back({std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i), 0.0});
    }
    Triangulator triangulate;
    CHECK(triangulate(pentagram).size() == 3);
    for (unsigned seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < 4 + seed % 40; ++i) {
            // On a coarse lattice, so that many corners coincide and lie in line.
            points.push_back({static_cast<double>(random() % 4), static_cast<double>(random() % 4),
                              static_cast<double>(random() % 2)});
        }
        const auto& triangles = triangulate(points);
        CHECK(triangles.size() == points.size() - 2);
        for (const auto& triangle : triangles) {
            for (const Index corner : triangle) CHECK(corner < points.size());
        }
    }
}

/// Of the processor, so that a busy machine changes nothing.
double secondsFor(const Polygon& polygon) {
    const std::vector<Vec3> points = inSpace(polygon);
    Triangulator triangulate;
    const std::clock_t start = std::clock();
    CHECK(triangulate(points).size() == points.size() - 2);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST_CASE("a polygon of very many corners takes seconds, not hours") {
    std::mt19937_64 random(4);
    const int many = 100000;
    Polygon convex;
    Polygon square;
    for (int i = 0; i < many; ++i) {
        const double angle = 2.0 * M_PI * i / many;
        convex.push_back({std::cos(angle), std::sin(angle)});
        const double along = 4.0 * i / many;
        const int side = static_cast<int>(along);
        const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
        square.push_back(glm::mix(corners[side], corners[side + 1], along - side));
    }
    Polygon tangle;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < many; ++i) tangle.push_back({unit(random), unit(random)});
    const Polygon wild = star(random, many, 0.5);
    const Polygon teeth = comb(many / 2);
    const std::vector<std::pair<std::string, const Polygon*>> shapes = {
        {"convex", &convex},
        {"straight corners", &square},
        {"tangle", &tangle},
        {"star", &wild},
        {"comb", &teeth}};
    for (const auto& shape : shapes) {
        CAPTURE(shape.first);
        CHECK(secondsFor(*shape.second) < 30.0);
    }
}

}  // namespace
