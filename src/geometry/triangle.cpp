#include "rt/geometry/triangle.h"

#include <algorithm>
#include <array>

namespace rt {
namespace {

/// a - b as high + low, exactly (Knuth's TwoSum; Higham 2002, section 4.3).
struct ExactDifference {
    ExactDifference(double a, double b) : high(a - b) {
        const double negated = high - a;
        low = (a - (high - negated)) - (b + negated);
    }
    double high, low;
};

struct ExactEdge {
    ExactEdge(const Vec3& to, const Vec3& from)
        : x(to.x, from.x), y(to.y, from.y), z(to.z, from.z) {}
    ExactDifference x, y, z;

    Vec3 rounded() const { return {x.high, y.high, z.high}; }
};

/// a d - b c of exact differences: the leading product without cancellation, and the mixed terms
/// that matter on slivers, where the leading ones nearly cancel.
double minorOf(const ExactDifference& a, const ExactDifference& b, const ExactDifference& c,
               const ExactDifference& d) {
    const double mixed = differenceOfProducts(a.high, d.low, b.high, c.low) +
                         differenceOfProducts(a.low, d.high, b.low, c.high);
    return differenceOfProducts(a.high, d.high, b.high, c.high) + mixed;
}

/// `v` made unit, without overflow or underflow of its squares; `fallback` where it has no length.
Vec3 unitOr(const Vec3& v, const Vec3& fallback) {
    const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(size > 0.0 && size < kInfinity)) return fallback;
    const Vec3 scaled = v / size;
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

Vec3 geometricNormal(const ExactEdge& p, const ExactEdge& q) {
    const Vec3 normal(minorOf(p.y, p.z, q.y, q.z), minorOf(p.z, p.x, q.z, q.x),
                      minorOf(p.x, p.y, q.x, q.y));
    return unitOr(normal, Vec3(0.0, 0.0, 1.0));
}

using CornerNormals = std::array<Vec3, 3>;

CornerNormals cornerNormals(const TriangleMesh& mesh, Index triangle, const Vec3& geometric) {
    CornerNormals normals;
    for (std::size_t k = 0; k < 3; ++k) {
        const Index corner = mesh.normalCorners[triangle][k];
        normals[k] = corner == kNone ? geometric : mesh.normals[corner];
    }
    return normals;
}

Vec3 shadingNormal(const CornerNormals& normals, const Vec3& weights, const Vec3& geometric) {
    const Vec3 sum = weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2];
    // Corner normals are units: what little is left of opposed ones is rounding, not a direction.
    if (!(glm::dot(sum, sum) > gamma(8) * gamma(8))) return geometric;
    return unitOr(sum, geometric);
}

/// Whether the normals turn apart along an edge, as on a surface that bulges to their side.
bool bulges(const TriangleMesh& mesh, Index triangle, const CornerNormals& normals) {
    const TriangleMesh::Corners& corners = mesh.triangles[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const Vec3 edge = mesh.positions[corners[next]] - mesh.positions[corners[k]];
        if (glm::dot(normals[next] - normals[k], edge) > 0.0) return true;
    }
    return false;
}

/// The point lifted to the corners' tangent planes where it lies below them, in the weights' mean.
/// Normals that lean but do not bulge pretend no other surface, and lift nothing.
Vec3 liftedPoint(const Vec3& point, const TriangleMesh& mesh, Index triangle,
                 const CornerNormals& normals, const Vec3& weights) {
    if (!bulges(mesh, triangle, normals)) return point;
    Vec3 lifted = point;
    for (int k = 0; k < 3; ++k) {
        const auto corner = static_cast<std::size_t>(k);
        const Vec3& position = mesh.positions[mesh.triangles[triangle][corner]];
        const double above = glm::dot(point - position, normals[corner]);
        lifted -= weights[k] * std::min(0.0, above) * normals[corner];
    }
    return lifted;
}

/// Texture coordinates at the hit, and the solution of (e1, e2) = (dpdu, dpdv) (uv1, uv2).
void addTexture(const TriangleMesh& mesh, Index triangle, const Vec3& weights, const Vec3& e1,
                const Vec3& e2, SurfacePoint& surface) {
    if (mesh.uvCorners.empty()) return;
    const auto at = [&](std::size_t k) {
        const Index corner = mesh.uvCorners[triangle][k];
        return corner == kNone ? Vec2(0.0) : mesh.uvs[corner];
    };
    const Vec2 base = at(0);
    const Vec2 a = at(1) - base;
    const Vec2 b = at(2) - base;
    surface.uv = base + weights[1] * a + weights[2] * b;
    const double determinant = differenceOfProducts(a.x, b.y, a.y, b.x);
    const Vec3 dpdu = (b.y * e1 - a.y * e2) / determinant;
    const Vec3 dpdv = (a.x * e2 - b.x * e1) / determinant;
    const double size = glm::dot(dpdu, dpdu) + glm::dot(dpdv, dpdv);
    if (!(size < kInfinity)) return;
    surface.dpdu = dpdu;
    surface.dpdv = dpdv;
}

}  // namespace

SurfacePoint triangleSurface(const TriangleMesh& mesh, Index triangle, const PrimitiveHit& hit) {
    const TriangleMesh::Corners& corners = mesh.triangles[triangle];
    const Vec3& a = mesh.positions[corners[0]];
    const ExactEdge ab(mesh.positions[corners[1]], a);
    const ExactEdge ac(mesh.positions[corners[2]], a);
    const Vec3 e1 = ab.rounded();
    const Vec3 e2 = ac.rounded();
    const Vec3& weights = hit.local;

    SurfacePoint surface;
    surface.point = a + (weights[1] * e1 + weights[2] * e2);
    const Vec3 reach = std::fabs(weights[1]) * glm::abs(e1) + std::fabs(weights[2]) * glm::abs(e2);
    // Edges, products, their sum, and weights that add up to a little more than 1: 6 roundings of
    // the way from a; the last sum: one of the point.
    const Vec3 error = gamma(8) * reach + gamma(2) * glm::abs(surface.point);
    surface.error = std::sqrt(glm::dot(error, error));
    surface.normal = geometricNormal(ab, ac);
    surface.shadingNormal = surface.normal;
    surface.shadowOrigin = surface.point;
    if (!mesh.normalCorners.empty()) {
        const CornerNormals normals = cornerNormals(mesh, triangle, surface.normal);
        surface.shadingNormal = shadingNormal(normals, weights, surface.normal);
        surface.shadowOrigin = liftedPoint(surface.point, mesh, triangle, normals, weights);
    }
    addTexture(mesh, triangle, weights, e1, e2, surface);
    return surface;
}

}  // namespace rt
