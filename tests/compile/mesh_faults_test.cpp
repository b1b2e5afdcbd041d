// Bad OBJ files, as a table: what is in the file, and what must be said.
#include "rt/compile/mesh_file.h"
#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <random>

namespace {

using namespace rt;

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct Refused {
    std::string what;
    std::string text;
    std::string message;  ///< after the path
};

TEST_CASE("what is no OBJ, or names what it lacks, is refused with its line") {
    const std::string nul(1, '\0');
    const std::vector<Refused> table = {
        {"vertex out of range", kThree + "f 1 2 9\n", ":4: vertex 9 of 3"},
        {"the second of two is named", kThree + "f 1 2 3\nf 1 2 4\n", ":5: vertex 4 of 3"},
        {"index 0", kThree + "f 0 1 2\n", ":4: vertex 0: an OBJ counts from 1"},
        {"negative, too far", kThree + "f -1 -2 -4\n", ":4: vertex -4 of 3"},
        {"no wrap at 2^31", kThree + "f 1 2 2147483648\n", ":4: vertex 2147483648 of 3"},
        {"no wrap at 2^32", kThree + "f 1 2 4294967297\n", ":4: vertex 4294967297 of 3"},
        {"the mark of no index", kThree + "f 1 2 4294967296\n", ":4: vertex 4294967296 of 3"},
        {"no wrap at 2^64", kThree + "f 1 2 18446744073709551617\n",
         ":4: index out of range: \"18446744073709551617\""},
        {"smallest integer", kThree + "f 1 2 -9223372036854775808\n",
         ":4: vertex -9223372036854775808 of 3"},
        {"1e30", kThree + "f 1 2 1e30\n", ":4: an index must be a whole number (got \"1e30\")"},
        {"1.5", kThree + "f 1 2 1.5\n", ":4: an index must be a whole number (got \"1.5\")"},
        {"texture", kThree + "vt 0 0\nf 1/1 2/2 3/1\n", ":5: texture coordinate 2 of 1"},
        {"texture 0", kThree + "f 1/0 2 3\n", ":4: texture coordinate 0: an OBJ counts from 1"},
        {"normal", kThree + "f 1//1 2//1 3//1\n", ":4: normal 1 of 0"},
        {"four parts", kThree + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n",
         ":6: a corner is vertex/texture/normal at most"},
        {"nothing after the slash", kThree + "f 1 2 3/\n",
         ":4: an index must be a whole number (got \"\")"},
        {"nan", "v 0 nan 0\n", ":1: y of a vertex must be finite (got \"nan\")"},
        {"inf", "v 0 0 -inf\n", ":1: z of a vertex must be finite (got \"-inf\")"},
        {"1e999", "v 1e999 0 0\n", ":1: x of a vertex must be finite (got \"1e999\")"},
        {"long overflow", "v 0 " + std::string(400, '9') + ".5 0\n",
         ":1: y of a vertex must be finite (got \"" + std::string(37, '9') + "...\")"},
        {"hex", "v 0x1p3 0 0\n", ":1: x of a vertex must be a decimal number (got \"0x1p3\")"},
        {"comma", "v 0,5 0 0\n", ":1: x of a vertex must be a decimal number (got \"0,5\")"},
        {"two signs", "v +-1 0 0\n", ":1: x of a vertex must be a decimal number (got \"+-1\")"},
        {"a word", "v a 0 0\n", ":1: x of a vertex must be a decimal number (got \"a\")"},
        {"half a vertex", kThree + "v 1 2\nf 1 2 3\n", ":4: z of a vertex is missing"},
        {"half a normal", "vn 1\n", ":1: y of a normal is missing"},
        {"no texture", "vt\n", ":1: u of a texture coordinate is missing"},
        {"nan texture", "vt 0 nan\n", ":1: v of a texture coordinate must be finite (got \"nan\")"},
        {"ends within a face", kThree + "f 1 2", ":4: the file ends within a face"},
        {"ends within a corner", kThree + "f 1 2 3/",
         ":4: an index must be a whole number (got \"\")"},
        {"ends within a vertex", kThree + "v 1 2", ":4: z of a vertex is missing"},
        {"ends in a continuation", kThree + "f 1 2 \\\n", ":4: the file ends within a face"},
        {"gzip", "\x1f\x8b\x08 123", ": not an OBJ: it holds binary data"},
        {"binary STL", std::string(80, ' ') + std::string("\2\0\0\0", 4),
         ": not an OBJ: it holds binary data"},
        {"UTF-16", std::string("v\0 \0", 4), ": not an OBJ: it holds binary data"},
        {"text STL", "solid cow\nfacet normal 0 0 1\n",
         ":1: not an OBJ: no vertices, no faces, but \"solid\""},
        {"NUL where a statement should be", kThree + "#" + std::string(5000, '-') + "\n" + nul,
         ":5: not an OBJ: a control byte where a statement should be"},
        {"NUL in a number", "#" + std::string(5000, '-') + "\nv 1 2" + nul + " 3\n",
         ":2: y of a vertex must be a decimal number (got \"2\\x00\")"},
    };
    const test::ScratchFolder folder;
    for (const Refused& row : table) {
        CAPTURE(row.what);
        const std::string path = folder.file("cow.obj", row.text);
        Diagnostics diagnostics;
        std::string message;
        try {
            loadObj(path, {}, diagnostics);
        } catch (const SceneError& error) {
            message = error.what();
            CHECK(error.code() == ExitCode::kScene);
        }
        CHECK(message.substr(0, path.size() + row.message.size()) == path + row.message);
    }
}

struct Warned {
    std::string what;
    std::string text;
    std::size_t triangles;
    std::string warning;  ///< "" = none
};

TEST_CASE("what can be gone on with is one warning") {
    const std::string nul(1, '\0');
    const std::vector<Warned> table = {
        {"empty", "", 0, "the mesh has no faces and is skipped"},
        {"comments only", "# nothing\n\n# here", 0, "the mesh has no faces and is skipped"},
        {"no faces", kThree, 0, "the mesh has no faces and is skipped"},
        {"faces of one and two", kThree + "f 1\nf 1 2\nf 1 2 3\n", 1,
         "2 faces have fewer than 3 corners and are skipped"},
        {"late faces of two", "f 1 2\n" + kThree + "f 1 2 3\n", 1,
         "1 face has fewer than 3 corners and is skipped"},
        {"repeated vertex", kThree + "f 1 2 2\nf 1 2 3\n", 1,
         "1 triangle has no area and is dropped"},
        {"in line", "v 3 0 0\n" + kThree + "f 1 2 3\nf 2 3 4\nf 2 2 2\n", 1,
         "2 triangles have no area and are dropped"},
        {"groups and materials",
         "mtllib ../../etc/passwd\no cow\ng a \\\n b\nusemtl x\n" + kThree + "s 1\nf 1 2 3\ng c\n",
         1, "groups, materials and the like are ignored (mtllib, o, g, usemtl, s)"},
        {"what no OBJ has", kThree + "wombat 7\nf 1 2 3\n", 1,
         "statements that no OBJ has are ignored (wombat)"},
        {"negative indices", kThree + "f -3 -2 -1\n", 1, ""},
        {"a long line", kThree + "f 1 2" + std::string(3 << 20, ' ') + "3\n", 1, ""},
        {"a long comment", "#" + std::string(10 << 20, '!') + "\n" + kThree + "f 1 2 3", 1, ""},
        {"NUL in a late comment",
         kThree + "#" + std::string(5000, '-') + "\n# a" + nul + "b\nf 1 2 3\n", 1, ""},
    };
    for (const Warned& row : table) {
        CAPTURE(row.what);
        const test::ScratchFolder folder;
        Diagnostics diagnostics;
        const TriangleMesh mesh = loadObj(folder.file("cow.obj", row.text), {}, diagnostics);
        CHECK(mesh.triangles.size() == row.triangles);
        CHECK(diagnostics.total() == (row.warning.empty() ? 0 : 1));
        if (diagnostics.total() > 0) CHECK(diagnostics.shown()[0].message == row.warning);
    }
}

TEST_CASE("only regular files that can be read are meshes") {
    const test::ScratchFolder folder;
    REQUIRE(::mkfifo(folder.path("pipe.obj").c_str(), 0600) == 0);
    Diagnostics diagnostics;
    const auto refused = [&](const std::string& path, const std::string& why) {
        CHECK_THROWS_WITH_AS(loadObj(path, {}, diagnostics), (path + ": " + why).c_str(),
                             SceneError);
    };
    refused(folder.path("none.obj"), "cannot be opened: No such file or directory");
    refused(folder.path(""), "is a folder, not a file");
    refused(folder.path("pipe.obj"), "is a device or a pipe; only regular files are read");
    refused("/dev/zero", "is a device or a pipe; only regular files are read");
    if (::geteuid() != 0) {
        const std::string secret = folder.file("secret.obj", kThree);
        ::chmod(secret.c_str(), 0);
        refused(secret, "cannot be opened: Permission denied");
    }
}

TEST_CASE("a file too large for the memory limit is refused before it is read") {
    const test::ScratchFolder folder;
    const std::string path = folder.file("huge.obj", kThree);
    REQUIRE(::truncate(path.c_str(), off_t{5} << 30) == 0);
    Diagnostics diagnostics;
    CHECK_THROWS_WITH_AS(loadObj(path, {}, diagnostics),
                         (path + ": loading this mesh would need about 15.0 GiB of memory; the "
                                 "limit for one mesh is 8.0 GiB")
                             .c_str(),
                         LimitError);
}

TEST_CASE("flat and collapsed meshes are finite") {
    const test::ScratchFolder folder;
    Diagnostics diagnostics;
    const std::string thin =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    const TriangleMesh mesh = loadObj(folder.file("thin.obj", thin), {}, diagnostics);
    CHECK(mesh.triangles.size() == 4);
    CHECK(mesh.normalCorners.empty());
    const TriangleMesh point =
        loadObj(folder.file("p.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), {}, diagnostics);
    CHECK(point.triangles.empty());
}

TEST_CASE("any bytes give a mesh or an error") {
    const std::string words[] = {
        "v ",    "vn ", "vt ",   "f ",        "1",         "-1",        "/",        "//",  " ",
        "\n",    "\r",  "\\",    "\\\n",      "#",         "0.5",       "e9",       "nan", "2",
        "g x\n", "3",   "1e400", "v 0 0 0\n", "v 1 0 0\n", "v 0 1 0\n", "f 1 2 3\n"};
    const test::ScratchFolder folder;
    for (unsigned seed = 1; seed <= 1500; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::string text;
        for (int i = 0; i < 60; ++i) text += words[random() % std::size(words)];
        if (seed % 4 == 0) text[random() % text.size()] = static_cast<char>(random());
        Diagnostics diagnostics;
        try {
            const TriangleMesh mesh = loadObj(folder.file("x.obj", text), {}, diagnostics);
            for (const TriangleMesh::Corners& triangle : mesh.triangles) {
                for (const Index corner : triangle) CHECK(corner < mesh.positions.size());
            }
        } catch (const SceneError& error) {
            CHECK(std::string(error.what()).size() > 5);
        }
    }
}

}  // namespace
