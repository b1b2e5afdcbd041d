#include "triangulate.h"

#include "ear_clipper.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// Twice the area vector: sum of p_i x p_(i+1).
Vec3 newellNormal(std::span<const Vec3> points) {
    Vec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += glm::cross(points[i], points[i + 1]);
    return sum;
}

}  // namespace

void Triangulator::centre(std::span<const Vec3> polygon) {
    double reach = 0.0;
    offsets_.resize(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        // Halves, because the difference of two doubles may overflow.
        offsets_[i] = 0.5 * polygon[i] - 0.5 * polygon[0];
        const Vec3& o = offsets_[i];
        reach = std::max({reach, std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
    }
    if (!(reach > 0.0)) return;
    // A power of two rounds nothing.
    const double unit = std::ldexp(1.0, std::clamp(-std::ilogb(reach), -1022, 1022));
    for (Vec3& offset : offsets_) offset *= unit;
}

void Triangulator::flatten() {
    const Vec3 normal = newellNormal(offsets_);
    const Vec3 size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
    const int dropped = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int first = (dropped + 1) % 3;
    int second = (dropped + 2) % 3;
    if (normal[dropped] < 0.0) std::swap(first, second);
    points_.resize(offsets_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i] = {offsets_[i][first], offsets_[i][second]};
    }
}

bool Triangulator::isFanOfLeftTurns() const {
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
        if (!(orientation(points_[0], points_[i], points_[i + 1]) > 0.0)) return false;
    }
    return true;
}

const Triangulator::Triangles& Triangulator::operator()(std::span<const Vec3> polygon) {
    triangles_.clear();
    if (polygon.size() == 3) {
        triangles_.push_back({0, 1, 2});
        return triangles_;
    }
    centre(polygon);
    flatten();
    if (!isFanOfLeftTurns()) {
        EarClipper(points_).clip(triangles_);
        return triangles_;
    }
    for (Index i = 1; i + 1 < static_cast<Index>(points_.size()); ++i) {
        triangles_.push_back({0, i, i + 1});
    }
    return triangles_;
}

}  // namespace rt
