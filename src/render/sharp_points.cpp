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

/// The points of a rim whose tangents meet (x, z), relative to its centre; none from inside.
void addTangentPoints(const Rim& rim, double x, double z, std::vector<Vec3>& points) {
    const double distance = std::sqrt(x * x + z * z);
    if (!(distance > rim.radius)) return;
    // The radius to a tangent point makes this angle with the way to where the tangents meet.
    const double cosine = rim.radius / distance;
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
            addTangentPoints(rim, eye.x - middle.x, eye.z - middle.z, points);
        }
    }

    void operator()(const Cone& cone) const {
        const Bounds b = cone.bounds();
        const Vec3 middle = 0.5 * (b.min + b.max);
        const Vec3 apex(middle.x, b.min.y, middle.z);
        const double above = eye.y - apex.y;
        if (above == 0.0) return;
        // Planes that touch the side pass through the line from the eye to the apex.
        const double stretch = (b.max.y - b.min.y) / above;
        const Rim rim{{middle.x, b.max.y, middle.z}, 0.5 * (b.max.x - b.min.x)};
        addTangentPoints(rim, (eye.x - apex.x) * stretch, (eye.z - apex.z) * stretch, points);
    }

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
