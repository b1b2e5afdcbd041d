// Height fields as meshes: where the heights stand, that a base closes them, and what is refused.
#include "compile/height_field.h"

#include "rt/accel/mesh_tree.h"
#include "rt/core/error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>

using namespace rt;

namespace {

const SourceLocation kHere{"scene.lua", 7};

HeightGrid gridOfSize(std::size_t columns, std::size_t rows, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(0.1, 0.9);
    HeightGrid grid{columns, rows, {}};
    for (std::size_t i = 0; i < columns * rows; ++i) grid.heights.push_back(height(random));
    return grid;
}

Vec3 normalOf(const TriangleMesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

/// By the divergence theorem, whatever the mesh's order.
double volumeOf(const TriangleMesh& mesh) {
    double six = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        six += glm::dot(mesh.positions[mesh.triangles[t][0]], normalOf(mesh, t));
    }
    return six / 6.0;
}

/// How often each directed edge occurs.
std::map<std::pair<Index, Index>, int> edgesOf(const TriangleMesh& mesh) {
    std::map<std::pair<Index, Index>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    return edges;
}

std::string failure(const HeightGrid& grid, const HeightFieldOptions& options) {
    try {
        heightFieldMesh(grid, options, kHere);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("heights stand over a square, the first row along z = 0") {
    const HeightGrid grid{3, 2, {0.0, 0.1, 0.2, 1.0, 1.1, 1.2}};
    const TriangleMesh mesh = heightFieldMesh(grid, {}, kHere);
    REQUIRE(mesh.positions.size() == 6);
    CHECK(mesh.positions[0] == Vec3(0.0, 0.0, 0.0));
    CHECK(mesh.positions[2] == Vec3(1.0, 0.2, 0.0));
    CHECK(mesh.positions[4] == Vec3(0.5, 1.1, 1.0));
    CHECK(mesh.uvs[0] == Vec2(0.0, 1.0));
    CHECK(mesh.uvs[4] == Vec2(0.5, 0.0));
    CHECK(mesh.triangles.size() == 4);
    CHECK(!mesh.closed);
    CHECK(mesh.border.size() == 4);
    for (std::size_t t = 0; t < 4; ++t) CHECK(normalOf(mesh, t).y > 0.0);
    for (const Vec3& normal : mesh.normals) {
        CHECK(glm::distance(normal, glm::normalize(Vec3(-0.2, 1.0, -1.0))) < 1e-15);
    }
    CHECK(heightFieldMesh(grid, {.base = {}, .smooth = false}, kHere).normalCorners.empty());
}

TEST_CASE("heights of an image are its grey values") {
    Image image{2, 1, 1, std::vector<std::uint8_t>{0, 255}};
    CHECK(gridOf(image).heights == std::vector<double>{0.0, 1.0});
    image.samples = std::vector<std::uint16_t>{65535, 257};
    CHECK(gridOf(image).heights == std::vector<double>{1.0, 257.0 / 65535.0});
    image.samples = std::vector<float>{0.25F, 8.0F};
    CHECK(gridOf(image).heights == std::vector<double>{0.25, 8.0});
    const Image colours{1, 2, 3, std::vector<std::uint8_t>{0, 255, 255, 51, 51, 51}};
    const HeightGrid grid = gridOf(colours);
    CHECK(grid.columns == 1);
    CHECK(grid.rows == 2);
    CHECK(grid.heights[0] == doctest::Approx(2.0 / 3.0));
    CHECK(grid.heights[1] == doctest::Approx(0.2));
}

TEST_CASE("a base closes a height field to a solid with its outside outside") {
    for (const auto& [columns, rows] :
         {std::pair<std::size_t, std::size_t>{2, 2}, {2, 5}, {7, 4}}) {
        CAPTURE(columns);
        const HeightGrid grid = gridOfSize(columns, rows, 3);
        const TriangleMesh mesh = heightFieldMesh(grid, {.base = -0.5}, kHere);
        CHECK(mesh.closed);
        CHECK(mesh.border.empty());
        CHECK(mesh.normalCorners.size() == mesh.triangles.size());
        CHECK(mesh.uvCorners.size() == mesh.triangles.size());
        const auto edges = edgesOf(mesh);
        for (const auto& [edge, count] : edges) {
            CHECK(count == 1);
            CHECK(edges.count({edge.second, edge.first}) == 1);
        }
        // Each of the cells' triangles over its half of a cell.
        double expected = 0.0;
        const auto cells = static_cast<double>((columns - 1) * (rows - 1));
        for (std::size_t t = 0; t < 2 * (columns - 1) * (rows - 1); ++t) {
            double sum = 0.0;
            for (const Index corner : mesh.triangles[t]) sum += mesh.positions[corner].y + 0.5;
            expected += sum / 3.0 / (2.0 * cells);
        }
        CHECK(volumeOf(mesh) == doctest::Approx(expected).epsilon(1e-12));
    }
}

TEST_CASE(
    "rays straight down meet the heights where they stand, and between them what lies between") {
    const HeightGrid grid = gridOfSize(9, 5, 4);
    const TriangleMesh mesh = heightFieldMesh(grid, {}, kHere);
    const MeshTree tree = MeshTree::build(mesh, 1);
    const auto heightAt = [&](double x, double z) {
        PrimitiveHit hit;
        REQUIRE(tree.closestHit({Vec3(x, 5.0, z), Vec3(0.0, -1.0, 0.0)}, {}, hit));
        return 5.0 - hit.t;
    };
    for (std::size_t j = 0; j < 5; ++j) {
        for (std::size_t i = 0; i < 9; ++i) {
            CHECK(std::fabs(heightAt(static_cast<double>(i) / 8.0, static_cast<double>(j) / 4.0) -
                            grid.heights[9 * j + i]) < 1e-14);
        }
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int k = 0; k < 400; ++k) {
        const double x = place(random);
        const double z = place(random);
        const auto i = static_cast<std::size_t>(8.0 * x);
        const auto j = static_cast<std::size_t>(4.0 * z);
        const double corners[] = {grid.heights[9 * j + i], grid.heights[9 * j + i + 1],
                                  grid.heights[9 * j + i + 9], grid.heights[9 * j + i + 10]};
        const double found = heightAt(x, z);
        CHECK(found >= *std::min_element(corners, corners + 4) - 1e-14);
        CHECK(found <= *std::max_element(corners, corners + 4) + 1e-14);
    }
}

TEST_CASE("a cell is parted along the diagonal whose ends differ less") {
    for (const auto& [heights, middle] :
         {std::pair(std::vector<double>{0.0, 1.0, 0.0, 0.2}, 0.1), {{0.0, 1.0, 0.8, 0.2}, 0.9}}) {
        const MeshTree tree =
            MeshTree::build(heightFieldMesh(HeightGrid{2, 2, heights}, {}, kHere), 1);
        PrimitiveHit hit;
        REQUIRE(tree.closestHit({Vec3(0.5, 5.0, 0.5), Vec3(0.0, -1.0, 0.0)}, {}, hit));
        CHECK(hit.t == doctest::Approx(5.0 - middle));
    }
}

TEST_CASE("height fields that are too small, too large or too low are refused with the numbers") {
    CHECK(failure({1, 4, {1, 2, 3, 4}}, {}) ==
          "scene.lua:7: gr.height_field: needs 2x2 heights or more (got 1x4)");
    CHECK(failure({5000, 5000, {}}, {}) ==
          "scene.lua:7: gr.height_field: 5000x5000 heights; 16777216 are the most");
    const HeightGrid grid{2, 2, {0.25, 0.5, 0.5, 0.5}};
    CHECK(failure(grid, {.base = 0.25}) ==
          "scene.lua:7: gr.height_field: base must lie below all heights, of which the lowest is "
          "0.25 (got 0.25)");
    CHECK(failure(grid, {.base = 0.24}) == "");
}
