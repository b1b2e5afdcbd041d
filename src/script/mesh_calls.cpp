#include "call_table.h"

#include <algorithm>
#include <cctype>

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Parameter kName{"name", Kind::kText, "What messages call the node."};
constexpr Parameter kFile{"file", Kind::kText,
                          "The OBJ file; section \"Files\" says where it may lie."};
constexpr Parameter kOptions{
    "options",
    Kind::kTable,
    "{smooth = true | false | degrees}: within which angle faces are smoothed.",
    {},
    true,
    {},
    "{ smooth?: boolean|number }"};

constexpr Range kSmoothAngle{0.0, 180.0, false, false};
constexpr Range kCornerNumbers{0.0, static_cast<double>(kNone) - 1.0, false, false};

/// `smooth = true` smooths as the run says; false keeps faces flat.
std::optional<double> readSmooth(const Arguments& in, int slot, const Label& label) {
    if (lua_type(in.state(), slot) == LUA_TNUMBER) return in.number(slot, label, kSmoothAngle);
    if (lua_type(in.state(), slot) == LUA_TBOOLEAN) {
        return in.boolean(slot, label) ? std::optional<double>() : 0.0;
    }
    in.builder().fail("smooth must be true, false or degrees (got " + valueText(in.state(), slot) +
                      ")");
}

std::optional<double> smoothAngle(const Call& call, std::size_t i) {
    std::optional<double> angle;
    if (!call.given(i)) return angle;
    const Arguments& in = call.arguments();
    for (const std::string& name : in.fieldNames(Call::slot(i), {"options"})) {
        if (name != "smooth") {
            call.scene.fail("unknown option '" + printable(name, 64) + "'" +
                            didYouMean(name, {"smooth"}) + " (known: smooth)");
        }
        in.field(Call::slot(i), name,
                 [&](int value) { angle = readSmooth(in, value, {"smooth"}); });
    }
    return angle;
}

bool endsInObj(const std::string& text) {
    const std::string ending = ".obj";
    if (text.size() < ending.size()) return false;
    return std::equal(ending.begin(), ending.end(), text.end() - 4, [](char a, char b) {
        return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
    });
}

CallResult meshNode(Call& call, const std::string& name, const std::string& file) {
    return call.scene.addNode(name, call.scene.meshFile(file, smoothAngle(call, 2)));
}

CallResult meshFromFile(Call& call) {
    return meshNode(call, call.text(0), call.text(1));
}

CallResult meshFromFileFirst(Call& call) {
    return meshNode(call, call.text(1), call.text(0));
}

bool fileIsFirst(const Arguments& in) {
    if (!in.isString(1) || !in.isString(2)) return false;
    return endsInObj(in.text(1, {"file"})) && !endsInObj(in.text(2, {"name"}));
}

bool hasTables(const Arguments& in) {
    return in.isTable(2);
}

std::vector<Vec3> readVertices(const Arguments& in, int slot) {
    std::vector<Vec3> vertices;
    const Label label{"vertices"};
    const std::size_t count = in.length(slot);
    in.builder().charge(count * sizeof(Vec3));
    vertices.reserve(count);
    for (std::size_t i = 1; i <= count; ++i) {
        in.element(slot, i,
                   [&](int vertex) { vertices.push_back(in.tuple(vertex, label.at(i), Range{})); });
    }
    return vertices;
}

Index readCorner(const Arguments& in, int slot, const Label& label, std::size_t vertexCount) {
    const double corner = in.wholeNumber(slot, label, kCornerNumbers);
    if (corner < static_cast<double>(vertexCount)) return static_cast<Index>(corner);
    in.builder().fail(label.text() + " is vertex " + numberText(corner) + " of " +
                      std::to_string(vertexCount) + " (they count from 0)");
}

void readFace(const Arguments& in, int face, const Label& label, MeshTableDesc& mesh) {
    in.requireTable(face, label, "a table of vertex numbers");
    const std::size_t size = in.length(face);
    if (size < 3) {
        in.builder().warnOnce("short-face", label.text() + " has " + std::to_string(size) +
                                                " corners and is skipped");
        return;
    }
    in.builder().charge((size + 1) * sizeof(Index));
    for (std::size_t k = 1; k <= size; ++k) {
        in.element(face, k, [&](int corner) {
            mesh.corners.push_back(readCorner(in, corner, label.at(k), mesh.vertices.size()));
        });
    }
    mesh.faceSizes.push_back(static_cast<Index>(size));
}

CallResult meshFromTables(Call& call) {
    const Arguments& in = call.arguments();
    MeshTableDesc mesh;
    mesh.vertices = readVertices(in, Call::slot(1));
    const Label label{"faces"};
    for (std::size_t i = 1; i <= in.length(Call::slot(2)); ++i) {
        in.element(Call::slot(2), i, [&](int face) { readFace(in, face, label.at(i), mesh); });
    }
    if (mesh.faceSizes.empty()) {
        call.scene.warn("empty-mesh", "'" + printable(call.text(0), 64) + "' has no faces");
    }
    mesh.smoothAngle = smoothAngle(call, 3);
    return call.scene.addNode(call.text(0), call.scene.addGeometry(std::move(mesh)));
}

}  // namespace

std::vector<CallRow> meshCalls() {
    const Parameter vertices{"vertices", Kind::kTable, "A table of points {x,y,z}.", {}, false,
                             {},         "gr.tuple[]"};
    const Parameter faces{"faces",
                          Kind::kTable,
                          "A table of polygons of any length, each a table of vertex numbers that "
                          "count from 0.",
                          {},
                          false,
                          {},
                          "integer[][]"};
    return {{"mesh",
             "A polygon mesh, from an OBJ file or from tables. Of two strings the one that ends in "
             ".obj is the file.",
             {{{kName, vertices, faces, kOptions}, meshFromTables, hasTables},
              {{kFile, kName, kOptions}, meshFromFileFirst, fileIsFirst},
              {{kName, kFile, kOptions}, meshFromFile}},
             "gr.node"}};
}

}  // namespace rt
