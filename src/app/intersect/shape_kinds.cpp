#include "shape_kinds.h"

#include "described_shapes.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace rt {
namespace {

constexpr Index kMostFanTriangles = 1'000'000;

Shape readSphere(Words& in) {
    const Vec3 centre = in.vec();
    return Sphere(centre, in.number());
}

Shape readBox(Words& in) {
    const Vec3 lo = in.vec();
    return Box(lo, in.vec());
}

/// Cylinders, cones and tori: an anchor and two lengths.
template <class Solid>
Shape readRound(Words& in) {
    const Vec3 anchor = in.vec();
    const double first = in.number();
    return Solid(anchor, first, in.number());
}

Shape readFrustum(Words& in) {
    const Vec3 base = in.vec();
    const double height = in.number();
    const double baseRadius = in.number();
    return Frustum(base, height, baseRadius, in.number());
}

Shape readQuadric(Words& in) {
    QuadricCoefficients k;
    for (double* coefficient : {&k.xx, &k.yy, &k.zz, &k.xy, &k.yz, &k.zx, &k.x, &k.y, &k.z, &k.c}) {
        *coefficient = in.number();
    }
    const Vec3 lo = in.vec();
    return Quadric(k, lo, in.vec());
}

Shape readHemisphere(Words& in) {
    const Vec3 centre = in.vec();
    return Hemisphere(centre, in.number());
}

Shape readRectangle(Words& in) {
    const double width = in.number();
    return Rectangle(width, in.number());
}

Shape meshShape(TriangleMesh mesh) {
    auto shape = std::make_shared<MeshShape>();
    shape->mesh = std::move(mesh);
    shape->tree = MeshTree::build(shape->mesh, 1);
    return std::shared_ptr<const MeshShape>(std::move(shape));
}

Shape readTriangle(Words& in) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(in.vec());
    mesh.triangles.push_back({0, 1, 2});
    return meshShape(std::move(mesh));
}

Shape readFan(Words& in) {
    const Index triangles = in.count("triangles", 1, kMostFanTriangles);
    TriangleMesh mesh;
    for (Index i = 0; i <= triangles; ++i) mesh.positions.push_back(in.vec());
    for (Index i = 0; i < triangles; ++i) {
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % triangles});
    }
    return meshShape(std::move(mesh));
}

constexpr ShapeKind kKinds[] = {
    {"sphere", readSphere, true},
    {"box", readBox, true},
    {"cylinder", readRound<Cylinder>, true},
    {"cone", readRound<Cone>, true},
    {"torus", readRound<Torus>, true},
    {"frustum", readFrustum, true},
    {"hemisphere", readHemisphere, true},
    {"quadric", readQuadric, true},
    {"disc", [](Words& in) -> Shape { return Disc(in.number()); }, true},
    {"rectangle", readRectangle, true},
    {"plane", [](Words&) -> Shape { return Plane(); }, true},
    {"triangle", readTriangle, true},
    {"fan", readFan, false},
    {"mesh", readMesh, true},
    {"height_field", readHeightField, true},
    {"csg", readCombined, true},
};

}  // namespace

std::span<const ShapeKind> shapeKinds() {
    return kKinds;
}

const ShapeKind* shapeKindNamed(const std::string& name) {
    const auto* const kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                          [&](const ShapeKind& k) { return name == k.name; });
    return kind == std::end(kKinds) ? nullptr : kind;
}

}  // namespace rt
