#include "described_shapes.h"

#include "rt/compile/compile.h"
#include "shape_kinds.h"

#include <optional>
#include <type_traits>
#include <utility>

namespace rt {
namespace {

constexpr Index kMostOperands = 1000;
constexpr int kMostDepth = 100;
constexpr Index kMostCorners = 1'000'000;
constexpr Index kMostSide = 1000;

std::optional<CsgOperation> operationNamed(const std::string& name) {
    if (name == "union") return CsgOperation::kUnion;
    if (name == "intersection") return CsgOperation::kIntersection;
    if (name == "difference") return CsgOperation::kDifference;
    return std::nullopt;
}

GeometryShape meshTable(Words& in) {
    MeshTableDesc table;
    const Index corners = in.count("corners", 3, kMostCorners);
    const Index triangles = in.count("triangles", 1, kMostCorners);
    for (Index i = 0; i < corners; ++i) table.vertices.push_back(in.vec());
    for (Index i = 0; i < 3 * triangles; ++i) {
        table.corners.push_back(in.count("a corner", 0, corners - 1));
    }
    table.faceSizes.assign(triangles, 3);
    return table;
}

GeometryShape heightField(Words& in) {
    HeightFieldDesc field;
    field.grid.columns = in.count("columns", 2, kMostSide);
    field.grid.rows = in.count("rows", 2, kMostSide);
    for (std::size_t i = 0; i < field.grid.columns * field.grid.rows; ++i) {
        field.grid.heights.push_back(in.number());
    }
    if (in.count("closed", 0, 1) == 1) field.base = in.number();
    return field;
}

/// A scene as a script would describe it.
class Description {
  public:
    Index add(GeometryShape geometry) {
        const auto node = static_cast<Index>(scene_.nodes.size());
        const auto number = static_cast<Index>(scene_.geometries.size());
        scene_.geometries.push_back({std::move(geometry), {}});
        scene_.nodes.emplace_back("solid", number, SourceLocation{});
        return node;
    }

    Index readSolid(Words& in, int depth) {
        if (depth > kMostDepth) throw std::invalid_argument("solids within solids too deep");
        const std::string name = in.word();
        if (name == "at") {
            const Affine map = in.map();
            const Index node = readSolid(in, depth + 1);
            NodeState& state = scene_.nodes[node].edit(0);
            state.transform = compose(map, state.transform);
            return node;
        }
        if (name == "mesh") return add(meshTable(in));
        if (name == "height_field") return add(heightField(in));
        if (const auto operation = operationNamed(name)) {
            return readOperands(*operation, in, depth);
        }
        const ShapeKind* const kind = shapeKindNamed(name);
        if (!kind) throw std::invalid_argument("not a solid: " + name);
        return add(described(kind->read(in)));
    }

    /// The root's shape, as a render would have it.
    Shape compiled(Index root) {
        scene_.materials.emplace_back();
        scene_.nodes[root].edit(0).appearance.material = 0;
        RenderDesc render;
        render.root = root;
        render.width = render.height = 1;
        scene_.renders.push_back(std::move(render));
        AssetCache assets(1);
        Diagnostics diagnostics;
        const RenderScene scene = compileScene(scene_, 0, {}, assets, diagnostics);
        if (scene.instances.empty()) throw std::invalid_argument("nothing is left of the solid");
        return scene.shapes[scene.instances.front().shape];
    }

  private:
    Index readOperands(CsgOperation operation, Words& in, int depth) {
        const Index count = in.count("operands", 1, kMostOperands);
        std::vector<Index> operands;
        for (Index i = 0; i < count; ++i) operands.push_back(readSolid(in, depth + 1));
        const auto whole = static_cast<Index>(scene_.nodes.size());
        add(CsgDesc{operation, whole});
        scene_.nodes[whole].operands = std::move(operands);
        return whole;
    }

    static GeometryShape described(const Shape& shape) {
        return std::visit(
            [](const auto& solid) -> GeometryShape {
                if constexpr (std::is_constructible_v<GeometryShape, decltype(solid)>) {
                    return solid;
                } else {
                    throw std::invalid_argument("no part of a solid");
                }
            },
            shape);
    }

    SceneDesc scene_;
};

Shape compiledAlone(GeometryShape geometry) {
    Description description;
    const Index root = description.add(std::move(geometry));
    return description.compiled(root);
}

}  // namespace

Shape readMesh(Words& in) {
    return compiledAlone(meshTable(in));
}

Shape readHeightField(Words& in) {
    return compiledAlone(heightField(in));
}

Shape readCombined(Words& in) {
    Description description;
    const Index root = description.readSolid(in, 0);
    return description.compiled(root);
}

}  // namespace rt
