// One triangle against one ray, and what shading wants to know of a point on it.
//
// The ray is sheared to (0, 0, t): with z its longest axis, x' = x - (dx/dz) z and the same for y,
// relative to the origin (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1),
// 2013). The edge functions U = Cx By - Cy Bx, ... of the sheared corners are differences of
// products with 1.5 roundings of the result (Kahan; Jeannerod, Louvet, Muller 2013), so that their
// signs are exact: two triangles that share an edge agree on its side, and no line slips between
// them. The hit is at b0 A + b1 B + b2 C with the b proportional to U, V, W.
#pragma once

#include "rt/core/numeric.h"
#include "rt/core/ray.h"
#include "rt/geometry/hit.h"
#include "rt/geometry/triangle_mesh.h"

#include <cmath>

namespace rt {

/// A ray prepared for triangle tests. A direction of zero, or one that is not finite, hits nothing.
struct TriangleRay {
    TriangleRay() = default;
    explicit TriangleRay(const Ray& ray);

    Vec3 origin;
    int x, y, z;            ///< axes; z is the direction's longest
    double shearX, shearY;  ///< dx/dz, dy/dz
    double dz;
};

/// Edge functions of a triangle around the ray; the barycentric weights before division.
struct TriangleWeights {
    double u, v, w;

    double sum() const { return u + v + w; }
    /// The ray passes within the triangle or through its border; a triangle seen edge-on is missed
    /// (its neighbours are hit).
    bool inside() const {
        return ((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)) &&
               sum() != 0.0;
    }
};

/// A corner relative to the ray: sheared x and y, and z in units of the longest axis.
struct ShearedCorner {
    double x, y, z;
};

inline TriangleRay::TriangleRay(const Ray& ray) : origin(ray.origin) {
    const Vec3& d = ray.direction;
    const Vec3 size(std::fabs(d.x), std::fabs(d.y), std::fabs(d.z));
    z = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    x = z == 2 ? 0 : z + 1;
    y = x == 2 ? 0 : x + 1;
    dz = d[z];
    shearX = d[x] / dz;
    shearY = d[y] / dz;
}

inline ShearedCorner shear(const TriangleRay& ray, const Vec3& corner) {
    const double z = corner[ray.z] - ray.origin[ray.z];
    return {std::fma(-ray.shearX, z, corner[ray.x] - ray.origin[ray.x]),
            std::fma(-ray.shearY, z, corner[ray.y] - ray.origin[ray.y]), z};
}

inline TriangleWeights triangleWeights(const ShearedCorner& a, const ShearedCorner& b,
                                       const ShearedCorner& c) {
    return {differenceOfProducts(c.x, b.y, c.y, b.x), differenceOfProducts(a.x, c.y, a.y, c.x),
            differenceOfProducts(b.x, a.y, b.y, a.x)};
}

/// t of the weighted corner depths; NaN where the arithmetic failed.
inline double triangleDistance(double dz, const TriangleWeights& weights, double za, double zb,
                               double zc) {
    const double depth = std::fma(weights.u, za, std::fma(weights.v, zb, weights.w * zc));
    return depth / weights.sum() / dz;
}

/// The crossing of the ray with triangle (a, b, c) in `range`, if any. `hit.t` and `hit.local` (the
/// weights of a, b, c) are set, `hit.part` is not.
[[nodiscard]] inline bool intersectTriangle(const TriangleRay& ray, const Vec3& a, const Vec3& b,
                                            const Vec3& c, Interval range, PrimitiveHit& hit) {
    const ShearedCorner sa = shear(ray, a);
    const ShearedCorner sb = shear(ray, b);
    const ShearedCorner sc = shear(ray, c);
    const TriangleWeights weights = triangleWeights(sa, sb, sc);
    // Opposite signs settle most misses; a product that underflows is left to the full test.
    if (weights.u * weights.v < 0.0) return false;
    if (!weights.inside()) return false;
    const double t = triangleDistance(ray.dz, weights, sa.z, sb.z, sc.z);
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = Vec3(weights.u, weights.v, weights.w) / weights.sum();
    return true;
}

/// The surface at a hit with `triangle`: a + b1 (b - a) + b2 (c - a) with the hit's weights, the
/// unit normal of (b - a) x (c - a), the corner normals interpolated and made unit (the geometric
/// normal where there are none or they cancel), texture coordinates, and the derivatives of the
/// point by them (zero where there are none or they are degenerate).
SurfacePoint triangleSurface(const TriangleMesh& mesh, Index triangle, const PrimitiveHit& hit);

}  // namespace rt
