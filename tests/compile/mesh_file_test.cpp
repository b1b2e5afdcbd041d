#include "rt/compile/mesh_file.h"

#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <charconv>
#include <clocale>
#include <cstring>
#include <random>
#include <sstream>

namespace {

using namespace rt;

struct Loaded {
    TriangleMesh mesh;
    Diagnostics diagnostics;
};

Loaded load(std::string_view text, const MeshOptions& options = {}) {
    const test::ScratchFolder folder;
    Loaded loaded;
    loaded.mesh = loadObj(folder.file("mesh.obj", text), options, loaded.diagnostics);
    return loaded;
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// Corners 0 .. 7 by the bits of x, y, z; faces outward.
const std::string kCube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

MeshOptions smooth(double degrees) {
    MeshOptions options;
    options.smoothAngleDegrees = degrees;
    return options;
}

double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        sum += 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
    }
    return sum;
}

TEST_CASE("a triangle is read as it is written") {
    const Loaded loaded = load("v 1 2 3\nv -4.5 5e1 .25\nv 7. +8 -9E-2\nf 1 2 3\n");
    CHECK(loaded.mesh.positions == std::vector<Vec3>{{1, 2, 3}, {-4.5, 50, 0.25}, {7, 8, -0.09}});
    CHECK(loaded.mesh.triangles == std::vector<TriangleMesh::Corners>{{0, 1, 2}});
    CHECK(loaded.mesh.normalCorners.empty());
    CHECK(loaded.mesh.uvCorners.empty());
    CHECK_FALSE(loaded.mesh.closed);
    CHECK(loaded.diagnostics.total() == 0);
}

TEST_CASE("every form of corner is read, mixed in one face") {
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .25 .5\nvt 1\nvn 0 0 2\nvn 1 0 0\n";
    const TriangleMesh mesh = load(head + "f 1 2/2 3/1/1\nf 1//2 2/1/2 -1/-1/-2\n").mesh;
    CHECK(mesh.triangles == std::vector<TriangleMesh::Corners>{{0, 1, 2}, {0, 1, 2}});
    CHECK(mesh.uvs == std::vector<Vec2>{{0.25, 0.5}, {1, 0}});
    CHECK(mesh.uvCorners == std::vector<TriangleMesh::Corners>{{kNone, 1, 0}, {kNone, 0, 1}});
    CHECK(mesh.normals[0] == Vec3(0, 0, 1));
    CHECK(mesh.normalCorners[0][2] == 0);
    CHECK(mesh.normalCorners[1] == TriangleMesh::Corners{1, 1, 0});
}

TEST_CASE("faces without texture coordinates before and after one with them have none") {
    const TriangleMesh mesh = load(kSquare + "vt 0 0\nf 1 2 3\nf 1/1 2/1 3/1\nf 1 3 4\n").mesh;
    CHECK(mesh.uvCorners == std::vector<TriangleMesh::Corners>{
                                {kNone, kNone, kNone}, {0, 0, 0}, {kNone, kNone, kNone}});
}

TEST_CASE("a face may name vertices that follow it") {
    const TriangleMesh mesh = load("v 0 0 0\nf 1 2 3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh;
    CHECK(mesh.triangles.size() == 2);
}

TEST_CASE("line ends, continuations, comments and blanks do not matter") {
    const TriangleMesh plain = load(kSquare + "f 1 2 3 4\n").mesh;
    for (const std::string& text : {
             std::string("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n"),
             std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4"),
             std::string(
                 "# C:\\cow\\\nv 0 0 0 # origin\n\n  v\t1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4"),
             std::string("v \\\n0 0 0\nv 1 \\\r\n 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n3 \\\n 4\n"),
             std::string("\xef\xbb\xbfv 0 0 0 1.0\nv 1 0 0 1 1 1\nv 1 1 0\nv 0 1 0\n\nf 1 2 3 4  "),
             std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n\r\n\r#"),
         }) {
        CAPTURE(text);
        const TriangleMesh mesh = load(text).mesh;
        CHECK(mesh.positions == plain.positions);
        CHECK(mesh.triangles == plain.triangles);
    }
}

TEST_CASE("errors name the line, whatever ends the lines") {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text = "v 0 0 0|v 1 0 \\|0|v 1 1 0|# x|f 1 2 oops|";
        for (std::size_t at; (at = text.find('|')) != std::string::npos;) text.replace(at, 1, end);
        const test::ScratchFolder folder;
        const std::string path = folder.file("m.obj", text);
        Diagnostics diagnostics;
        CHECK_THROWS_WITH_AS(loadObj(path, {}, diagnostics),
                             (path + ":6: an index must be a whole number (got \"oops\")").c_str(),
                             SceneError);
    }
}

TEST_CASE("line ends and continuations work where blocks of the file meet") {
    // Comments of growing length move the seam over all characters of the statements.
    const test::ScratchFolder folder;
    Diagnostics diagnostics;
    const std::string tail = "v 0 0 0\\\r\n\r\nv 1 0 0\r\nv 1 1\\\r\n 0\r\nf 1 2 3\r\n";
    for (std::size_t shift = 0; shift <= tail.size(); ++shift) {
        const std::size_t length = (std::size_t{1} << 20) - 1 - tail.size() + shift - 2;
        const std::string text = "#" + std::string(length, 'x') + "\n" + tail;
        CAPTURE(shift);
        const TriangleMesh mesh = load(text).mesh;
        const std::string broken = folder.file("broken.obj", text + "f 0");
        CHECK_THROWS_WITH_AS(loadObj(broken, {}, diagnostics),
                             (broken + ":8: vertex 0: an OBJ counts from 1").c_str(), SceneError);
        CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
        CHECK(mesh.triangles.size() == 1);
    }
}

TEST_CASE("numbers are correctly rounded") {
    const unsigned seed = 20180403;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::ostringstream text;
    std::vector<double> expected;
    for (int i = 0; i < 3000; ++i) {
        const int exponent = static_cast<int>(random() % 600) - 300;
        std::ostringstream word;
        word << (random() % 2 ? "-" : "") << random() % 1000000 << "." << random() << "e"
             << exponent;
        text << (i % 3 == 0 ? "\nv " : " ") << word.str();
        expected.push_back(std::strtod(word.str().c_str(), nullptr));
    }
    const Loaded loaded = load(text.str() + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n");
    REQUIRE(loaded.mesh.positions.size() == 1003);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(loaded.mesh.positions[i / 3][static_cast<int>(i % 3)] == expected[i]);
    }
}

TEST_CASE("numbers below the range of double are zero") {
    const std::string zeros(500, '0');
    const TriangleMesh mesh = load("v 1e-400 -0." + zeros + "1 1" + zeros + "e-900\nv 0." + zeros +
                                   "1e501 1 0\nv 0 4.9e-324 9\nf 1 2 3")
                                  .mesh;
    CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {0, 4.9e-324, 9}});
}

TEST_CASE("numbers have a point in every locale") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
        if (std::setlocale(LC_ALL, name) != nullptr) break;
    }
    CHECK(load("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").mesh.positions[0].x == 0.5);
    std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("a cube of quads is closed, flat at its edges, and whole") {
    const Loaded loaded = load(kCube);
    CHECK(loaded.mesh.triangles.size() == 12);
    CHECK(loaded.mesh.closed);
    CHECK(loaded.mesh.normalCorners.empty());
    CHECK(area(loaded.mesh) == doctest::Approx(6.0));
    CHECK_FALSE(load(kCube.substr(0, kCube.rfind("f "))).mesh.closed);
}

TEST_CASE("a cube whose faces have vertices of their own is closed too") {
    std::ostringstream text;
    const TriangleMesh cube = load(kCube).mesh;
    for (const TriangleMesh::Corners& triangle : cube.triangles) {
        for (const Index corner : triangle) {
            // -0 and 0 are one place.
            const Vec3 p = cube.positions[corner];
            text << "v " << (p.x == 0.0 && corner % 2 ? "-0" : std::to_string(p.x)) << " "
                 << (p.y == 0.0 ? "-0.0" : "1") << " " << p.z << "\n";
        }
        text << "f -3 -2 -1\n";
    }
    const TriangleMesh mesh = load(text.str()).mesh;
    CHECK(mesh.positions.size() == 36);
    CHECK(mesh.closed);
}

TEST_CASE("an edge of four triangles, and a triangle twice, are not closed") {
    CHECK_FALSE(load(kCube + "f 1 3 4\n").mesh.closed);
    CHECK_FALSE(load(kCube + "f 1 3 4\nf 1 3 4\n").mesh.closed);
}

TEST_CASE("a triangle without area is dropped and opens no hole") {
    // A straight corner on the edge from 1 to 2 of the cube, met by a thin triangle.
    std::string text = kCube;
    text.replace(text.find("f 1 2 6 5"), 9, "v .5 0 0\nf 1 9 6 5\nf 9 2 6\nf 1 2 9");
    const Loaded loaded = load(text);
    CHECK(loaded.mesh.closed);
    CHECK(loaded.mesh.triangles.size() == 13);
    CHECK(loaded.diagnostics.countByKind().at("mesh-degenerate") == 1);
}

TEST_CASE("triangles with a repeated vertex count at no edge") {
    CHECK(load(kCube + "f 1 2 1\nf 1 1 2\nf 2 1 1\n").mesh.closed);
}

TEST_CASE("normals and texture coordinates stay with their faces when others are dropped") {
    const TriangleMesh mesh = load(kSquare +
                                   "v 2 0 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 1 0 0\n"
                                   "f 1/1/1 1/1/1 2/1/1\nf 1/2/2 2/2/2 3/2/2\n"
                                   "f 1/1/1 2/1/1 5/1/1\nf 1/3/2 3/3/2 4/3/1\n")
                                  .mesh;
    CHECK(mesh.triangles == std::vector<TriangleMesh::Corners>{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh.uvCorners == std::vector<TriangleMesh::Corners>{{1, 1, 1}, {2, 2, 2}});
    CHECK(mesh.normalCorners == std::vector<TriangleMesh::Corners>{{1, 1, 1}, {1, 1, 0}});
}

TEST_CASE("a straight corner in a polygon opens no hole either") {
    std::string text = kCube;
    text.replace(text.find("f 1 2 6 5"), 9, "v .5 0 0\nf 1 9 2 6 5");
    text.replace(text.find("f 1 3 4 2"), 9, "f 1 3 4 2 9");
    const Loaded loaded = load(text);
    CHECK(loaded.mesh.closed);
    CHECK(loaded.mesh.triangles.size() == 14);
    CHECK(loaded.diagnostics.total() == 0);
}

TEST_CASE("given normals are normalised at every scale, and those of length zero geometric") {
    const Loaded loaded = load(kSquare +
                               "vn 0 0 1e-300\nvn 3e300 0 4e300\nvn 0 0 0\n"
                               "f 1//1 2//2 3//3\nf 1//1 3//3 4//1\n");
    CHECK(loaded.mesh.normals[0] == Vec3(0, 0, 1));
    CHECK(loaded.mesh.normals[1].x == doctest::Approx(0.6).epsilon(1e-15));
    CHECK(loaded.mesh.normals[1].z == doctest::Approx(0.8).epsilon(1e-15));
    CHECK(loaded.mesh.normalCorners[0] == TriangleMesh::Corners{0, 1, kNone});
    CHECK(loaded.mesh.normalCorners[1] == TriangleMesh::Corners{0, kNone, 0});
    REQUIRE(loaded.diagnostics.shown().size() == 1);
    CHECK(loaded.diagnostics.shown()[0].message ==
          "2 corners have a normal of length zero; the face's own is used there");
}

TEST_CASE("corners without a normal beside given ones get the computed one") {
    // Two faces of a roof, 30 degrees apart; the second brings normals.
    const std::string roof =
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -.8660254037844386 0 -.5\nvn 0 1 0\n"
        "f 1 3 2\nf 1//1 2//1 4//1\n";
    const TriangleMesh mesh = load(roof).mesh;
    CHECK(mesh.normalCorners[1] == TriangleMesh::Corners{0, 0, 0});
    const Index computed = mesh.normalCorners[0][0];
    REQUIRE(computed != kNone);
    // Equal angles at the ridge: the normal halves the angle between the faces.
    CHECK(mesh.normals[computed].x == doctest::Approx(-std::sin(15.0 * M_PI / 180)));
    CHECK(mesh.normals[computed].z == doctest::Approx(std::cos(15.0 * M_PI / 180)));
}

TEST_CASE("a normal of length zero means the face's own, not a computed one") {
    const std::string ridge = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -.87 0 -.5\nvn 0 0 0\n";
    const TriangleMesh mesh = load(ridge + "f 1//1 3 2\nf 1 2 4\n").mesh;
    CHECK(mesh.normalCorners[0][0] == kNone);
    CHECK(mesh.normalCorners[0][2] != kNone);
}

TEST_CASE("polygons from tables become the mesh that the file gives") {
    const TriangleMesh cube = load(kCube, smooth(180)).mesh;
    const std::vector<Index> corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                        2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    const std::vector<Index> sizes(6, 4);
    Diagnostics diagnostics;
    const TriangleMesh mesh =
        meshFromPolygons(cube.positions, corners, sizes, smooth(180), {"s.lua", 3}, diagnostics);
    CHECK(mesh.positions == cube.positions);
    CHECK(mesh.triangles == cube.triangles);
    CHECK(mesh.normals == cube.normals);
    CHECK(mesh.closed);
}

TEST_CASE("tables that are wrong are refused at the script's line") {
    const std::vector<Vec3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const SourceLocation where{"s.lua", 7};
    Diagnostics diagnostics;
    const auto build = [&](std::vector<Vec3> vertices, std::vector<Index> corners,
                           std::vector<Index> sizes) {
        return meshFromPolygons(vertices, corners, sizes, {}, where, diagnostics);
    };
    CHECK_THROWS_WITH_AS(build(triangle, {0, 1, 3}, {3}),
                         "s.lua:7: face 0: vertex 3 of 3, counted from 0", SceneError);
    CHECK_THROWS_WITH_AS(build(triangle, {0, 1, 2}, {3, 3}),
                         "s.lua:7: face 1 has more corners than there are", SceneError);
    CHECK_THROWS_WITH_AS(build(triangle, {0, 1, 2, 0}, {3}),
                         "s.lua:7: there are corners of no face", SceneError);
    CHECK_THROWS_WITH_AS(build({{0, 0, 0}, {1, NAN, 0}}, {}, {}),
                         "s.lua:7: vertex 1 must be finite", SceneError);
    CHECK(diagnostics.total() == 0);
    CHECK(build(triangle, {0, 1, 0, 1, 2}, {2, 3}).triangles.size() == 1);
    CHECK(diagnostics.shown().at(0).message == "1 face has fewer than 3 corners and is skipped");
    CHECK(build(triangle, {}, {}).triangles.empty());
}

}  // namespace
