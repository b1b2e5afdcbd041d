// What the surfaces of solids share: where a point lies, and how images are laid around it.
#pragma once

#include "rt/math/portable.h"
#include "solid_frame.h"

namespace rt {

inline constexpr double kTurn = 6.28318530717958647692;  // 2 pi
inline constexpr double kSquareRootOf2 = 1.41421356237309504880;

inline double clampToUnit(double x) {
    return x >= 0.0 ? (x <= 1.0 ? x : 1.0) : 0.0;
}

/// The angle from +z towards +x as a fraction of a turn, 1/2 at +z.
inline double turnFraction(const Radial& direction) {
    return clampToUnit(0.5 + portable::atan2(direction.x, direction.z) * (1.0 / kTurn));
}

/// The angle above the equator as a fraction of a half turn, 1/2 on the equator, of the unit vector
/// with these parts up and across. The smaller of the two decides: there asin loses nothing.
inline double latitudeFraction(double up, double across) {
    if (std::fabs(up) <= across) return 0.5 + portable::asin(up) * (2.0 / kTurn);
    const double fromPole = portable::asin(across) * (2.0 / kTurn);
    return up > 0.0 ? 1.0 - fromPole : fromPole;
}

/// Fills in all that a solid's point and normal decide.
inline void placeSurface(SurfacePoint& surface, const Vec3& anchor, const Vec3& local,
                         const Vec3& normal) {
    surface.point = Vec3(anchor.x + local.x, anchor.y + local.y, anchor.z + local.z);
    surface.shadowOrigin = surface.point;
    surface.normal = normal;
    surface.shadingNormal = normal;
}

/// Bound on what the sum of anchor and local point is rounded by.
inline double placementError(const Vec3& point) {
    return gamma(2) * (std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z));
}

/// The cap of a cylinder or cone at a point (x, z) of the disc, whose outside is `up` (1 or -1):
/// the image fills the inscribed square and repeats around it.
inline void layOnCap(SurfacePoint& surface, double x, double z, double radius, double up) {
    const double side = kSquareRootOf2 * radius;
    const double u = 0.5 + x / side;
    const double v = 0.5 - up * (z / side);
    surface.uv = Vec2(u - std::floor(u), v - std::floor(v));
    surface.dpdu = Vec3(side, 0.0, 0.0);
    surface.dpdv = Vec3(0.0, 0.0, -up * side);
}

/// Where u and v run on a face: an axis each, and whether against it.
struct FaceTexture {
    int uAxis;
    bool uDown;
    int vAxis;
    bool vDown;
};

inline constexpr FaceTexture kFaces[6] = {
    {2, false, 1, false}, {2, true, 1, false},  // -x +x
    {0, false, 2, false}, {0, false, 2, true},  // -y +y
    {0, true, 1, false},  {0, false, 1, false}  // -z +z
};

/// A face of a box at a point of it, both relative to the same anchor: -x +x -y +y -z +z.
inline void layOnBoxFace(SurfacePoint& surface, const Vec3& local, const Vec3& lo, const Vec3& size,
                         Index part) {
    const FaceTexture& face = kFaces[part];
    const auto fraction = [&](int i) { return clampToUnit((local[i] - lo[i]) / size[i]); };
    const double u = fraction(face.uAxis);
    const double v = fraction(face.vAxis);
    surface.uv = Vec2(face.uDown ? 1.0 - u : u, face.vDown ? 1.0 - v : v);
    surface.dpdu[face.uAxis] = face.uDown ? -size[face.uAxis] : size[face.uAxis];
    surface.dpdv[face.vAxis] = face.vDown ? -size[face.vAxis] : size[face.vAxis];
}

}  // namespace rt
