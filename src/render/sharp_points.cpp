#include "sharp_points.h"

#include <cmath>
#include <memory>
#include <variant>

namespace rt {
namespace {

/// A mesh of more vertices is taken to be round: most of them lie within its outline.
constexpr std::size_t kFewVertices = 64;

/// A horizontal circle.
struct Rim {
    Vec3 centre;
    double radius;
};

/// The points of a rim at which planes through the eye touch the surface of revolution that it is
/// part of: at (x, z) from the rim's centre the eye is as high as where the straight side would
/// have the radius `atEye`. None from inside.
void addTangentPoints(const Rim& rim, double x, double z, double atEye, std::vector<Vec3>& points) {
    const double distance = std::sqrt(x * x + z * z);
    if (!(distance > std::fabs(atEye))) return;
    // n . (eye - p) = 0 with n = (cos a, -slope, sin a).
    const double cosine = atEye / distance;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const Vec3 towards(x / distance, 0.0, z / distance);
    const Vec3 across(-towards.z, 0.0, towards.x);
    for (const double side : {-sine, sine}) {
        points.push_back(rim.centre + rim.radius * (cosine * towards + side * across));
    }
}

struct Adder {
    const Vec3& eye;
    std::vector<Vec3>& points;

    void operator()(const Sphere&) const {}
    void operator()(const Torus&) const {}
    void operator()(const Disc&) const {}
    void operator()(const Plane&) const {}

    void operator()(const Rectangle& rectangle) const {
        const Bounds b = rectangle.bounds();
        for (const double x : {b.min.x, b.max.x}) {
            for (const double z : {b.min.z, b.max.z}) points.push_back({x, 0.0, z});
        }
    }

    void operator()(const Box& box) const {
        const Bounds b = box.bounds();
        for (unsigned i = 0; i < 8; ++i) {
            points.push_back(
                {i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z});
        }
    }

    void operator()(const Cylinder& cylinder) const {
        const Bounds b = cylinder.bounds();
        const Vec3 middle = 0.5 * (b.min + b.max);
        const double radius = 0.5 * (b.max.x - b.min.x);
        for (const double y : {b.min.y, b.max.y}) {
            const Rim rim{{middle.x, y, middle.z}, radius};
            addTangentPoints(rim, eye.x - middle.x, eye.z - middle.z, radius, points);
        }
    }

    void operator()(const Frustum& frustum) const {
        const Vec3& c = frustum.base();
        const double slope = (frustum.topRadius() - frustum.baseRadius()) / frustum.height();
        const double atEye = frustum.baseRadius() + slope * (eye.y - c.y);
        for (const bool top : {false, true}) {
            const Rim rim{c + Vec3(0.0, top ? frustum.height() : 0.0, 0.0),
                          top ? frustum.topRadius() : frustum.baseRadius()};
            addTangentPoints(rim, eye.x - c.x, eye.z - c.z, atEye, points);
        }
    }

    void operator()(const Hemisphere& half) const {
        const Bounds b = half.bounds();
        const Vec3 middle = 0.5 * (b.min + b.max);
        const Rim rim{{middle.x, b.min.y, middle.z}, 0.5 * (b.max.x - b.min.x)};
        addTangentPoints(rim, eye.x - middle.x, eye.z - middle.z, rim.radius, points);
    }

    void operator()(const Cone& cone) const {
        const Bounds b = cone.bounds();
        const Vec3 middle = 0.5 * (b.min + b.max);
        const Vec3 apex(middle.x, b.min.y, middle.z);
        const Rim rim{{middle.x, b.max.y, middle.z}, 0.5 * (b.max.x - b.min.x)};
        const double atEye = rim.radius * (eye.y - apex.y) / (b.max.y - b.min.y);
        addTangentPoints(rim, eye.x - apex.x, eye.z - apex.z, atEye, points);
    }

    // Its parts have theirs, but corners of pixels tell where those meet.
    void operator()(const std::shared_ptr<const CsgShape>&) const {}
    // Of these all pixels are fine.
    void operator()(const Quadric&) const {}

    void operator()(const std::shared_ptr<const MeshShape>& shape) const {
        const std::vector<Vec3>& positions = shape->mesh.positions;
        if (positions.size() > kFewVertices) return;
        points.insert(points.end(), positions.begin(), positions.end());
    }
};

}  // namespace

void addSharpPoints(const Shape& shape, const Vec3& eye, std::vector<Vec3>& points) {
    std::visit(Adder{eye, points}, shape);
}

}  // namespace rt
