#include "rt/render/fine_pixels.h"

#include "sharp_points.h"

#include "rt/math/portable.h"
#include "rt/trace/csg_shape.h"
#include "rt/trace/probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <variant>

namespace rt {
namespace {

/// In pixels; such a tube is seen from so near that it is not narrow.
constexpr double kLongestTube = 1 << 20;

constexpr double kTurn = 6.283185307179586;

/// A corner of an outline may show in the pixel next to its own.
constexpr double kAroundCorner = 0.5;

/// Longer triangles than this, in pixels, show in enough corners.
constexpr double kLeafPixels = 16.0;

/// This many to a pixel fill it.
constexpr std::size_t kLeavesInPixel = 4;

/// Nothing nearer than this share of its distance to the eye's plane is projected.
constexpr double kNearest = 0x1p-20;

/// A point of an instance on the image plane; false where it lies beside or behind the eye.
bool project(const Camera& camera, const Instance& instance, const Vec3& point, Vec2& image) {
    const Vec3 world = instance.transform.toWorld().point(point);
    const Camera::Projection at = camera.project(world);
    image = {at.x, at.y};
    return at.depth > kNearest * glm::length(world - camera.eye());
}

/// The corners of a box of an instance on the image plane; false where some lie beside or behind
/// the eye.
bool project(const Camera& camera, const Instance& instance, const Bounds& box,
             std::array<Vec2, 8>& points) {
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3 corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                          i & 4 ? box.max.z : box.min.z);
        if (!project(camera, instance, corner, points[i])) return false;
    }
    return true;
}

/// A strip of the plane: |n . p - middle| <= half, n a unit vector.
struct Strip {
    Vec2 normal{0.0};
    double low = kInfinity;
    double high = -kInfinity;

    double width() const { return high - low; }
    void cover(std::span<const Vec2> points) {
        for (const Vec2& p : points) {
            low = std::min(low, glm::dot(normal, p));
            high = std::max(high, glm::dot(normal, p));
        }
    }
};

const Strip kEverywhere{Vec2(0.0), -kInfinity, kInfinity};

/// The narrowest strip over the points among those along the lines between two of them: a convex
/// hull is narrowest across one of its sides.
Strip narrowest(std::span<const Vec2> points) {
    Strip best;
    double width = kInfinity;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const Vec2 side = points[j] - points[i];
            const double length = std::sqrt(glm::dot(side, side));
            Strip strip{length > 0.0 ? Vec2(-side.y, side.x) / length : Vec2(1.0, 0.0)};
            strip.cover(points);
            if (strip.width() < width) {
                width = strip.width();
                best = strip;
            }
        }
    }
    return best;
}

/// The pixels in the bounds of the points.
Tile pixelsAround(std::span<const Vec2> points, const Tile& area) {
    Vec2 low(kInfinity);
    Vec2 high(-kInfinity);
    for (const Vec2& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const auto from = [](double v, int least, int most) {
        return static_cast<int>(std::clamp(std::floor(v), double(least), double(most)));
    };
    return {from(low.x, area.x0, area.x1), from(low.y, area.y0, area.y1),
            from(high.x + 1.0, area.x0, area.x1), from(high.y + 1.0, area.y0, area.y1)};
}

/// Marks the pixels in the bounds of the points that meet the strip.
void mark(std::span<const Vec2> points, const Strip& strip, const Tile& area,
          std::vector<bool>& fine) {
    const auto [x0, y0, x1, y1] = pixelsAround(points, area);
    const double reach = 0.5 * (std::fabs(strip.normal.x) + std::fabs(strip.normal.y));
    for (int y = y0; y < y1; ++y) {
        const auto row =
            static_cast<std::size_t>(y - area.y0) * static_cast<std::size_t>(area.width());
        for (int x = x0; x < x1; ++x) {
            const double at = glm::dot(strip.normal, Vec2(x + 0.5, y + 0.5));
            if (at < strip.low - reach || at > strip.high + reach) continue;
            fine[row + static_cast<std::size_t>(x - area.x0)] = true;
        }
    }
}

/// Marks the pixels along the tube of a torus that is as narrow, though its box is not.
void markNarrowTube(const RenderScene& scene, const Instance& instance, const Torus& torus,
                    const Tile& area, std::vector<bool>& fine) {
    if (!(instance.objectScale > 0.0)) return;
    const double pixelsPerLength = 1.0 / (instance.objectScale * scene.camera.pixelSize());
    const Affine& toWorld = instance.transform.toWorld();
    const Camera::Projection middle = scene.camera.project(toWorld.point(torus.centre()));
    const double ring = torus.majorRadius() / instance.objectScale;
    // Where it is nearer the tube looks wider, the ring longer.
    const double nearest = middle.depth - ring;
    if (!(nearest > 0.0)) return;
    const double width = 2.0 * torus.minorRadius() * pixelsPerLength / middle.depth;
    const double length = kTurn * torus.majorRadius() * pixelsPerLength / nearest;
    if (width >= kNarrowPixels || length > kLongestTube) return;
    const double reach =
        0.5 * torus.minorRadius() * pixelsPerLength / nearest + kNarrowPixels / 2.0;
    const int steps = static_cast<int>(std::ceil(length)) + 1;
    for (int i = 0; i < steps; ++i) {
        const double degrees = 360.0 * i / steps;
        const Vec3 onRing(torus.majorRadius() * portable::cosDegrees(degrees),
                          torus.majorRadius() * portable::sinDegrees(degrees), 0.0);
        const Camera::Projection at = scene.camera.project(toWorld.point(torus.centre() + onRing));
        const std::array<Vec2, 2> square = {Vec2(at.x - reach, at.y - reach),
                                            Vec2(at.x + reach, at.y + reach)};
        mark(square, kEverywhere, area, fine);
    }
}

/// Marks the pixels of the small triangles at the border of an open mesh: leaves, of which the next
/// one's tip may lie between corners. More triangles than pixels are not looked at one by one.
void markLeaves(const RenderScene& scene, const Instance& instance, const TriangleMesh& mesh,
                std::span<const Vec2> box, const Tile& area, std::vector<bool>& fine) {
    const Tile around = pixelsAround(box, area);
    const std::size_t pixels =
        static_cast<std::size_t>(around.width()) * static_cast<std::size_t>(around.height());
    if (mesh.border.size() > kLeavesInPixel * pixels) return mark(box, kEverywhere, area, fine);
    for (const Index triangle : mesh.border) {
        std::array<Vec2, 3> corners;
        bool isSmall = true;
        for (std::size_t i = 0; i < 3 && isSmall; ++i) {
            isSmall = project(scene.camera, instance, mesh.positions[mesh.triangles[triangle][i]],
                              corners[i]) &&
                      glm::distance(corners[i], corners[0]) < kLeafPixels;
        }
        if (isSmall) mark(corners, narrowest(corners), area, fine);
    }
}

/// The narrow end of a cone or a frustum about y: what is `height` away from it has the other
/// radius.
struct Tip {
    Vec3 end;
    double height;  ///< below 0 where the wide end is below
    double narrow;
    double wide;
};

Tip tipOf(const Cone& cone) {
    const Bounds whole = cone.bounds();
    const Vec3 middle = 0.5 * (whole.min + whole.max);
    return {{middle.x, whole.min.y, middle.z},
            whole.max.y - whole.min.y,
            0.0,
            0.5 * (whole.max.x - whole.min.x)};
}

Tip tipOf(const Frustum& frustum) {
    if (frustum.baseRadius() < frustum.topRadius()) {
        return {frustum.base(), frustum.height(), frustum.baseRadius(), frustum.topRadius()};
    }
    return {frustum.base() + Vec3(0.0, frustum.height(), 0.0), -frustum.height(),
            frustum.topRadius(), frustum.baseRadius()};
}

/// Marks the pixels about a narrow end across which it is as narrow.
void markTip(const Camera& camera, const Instance& instance, const Tip& tip, const Tile& area,
             std::vector<bool>& fine) {
    Vec2 image;
    if (!project(camera, instance, tip.end, image)) return;
    const double depth = camera.project(instance.transform.toWorld().point(tip.end)).depth;
    const double pixel = camera.pixelSize() * depth * instance.objectScale;
    const double radius = std::min(0.5 * kNarrowPixels * pixel, tip.wide);
    if (radius < tip.narrow) return;
    const double along = tip.height * (radius - tip.narrow) / (tip.wide - tip.narrow);
    Bounds box{tip.end - Vec3(radius, 0.0, radius), tip.end + Vec3(radius, 0.0, radius)};
    box.unite(tip.end + Vec3(0.0, along, 0.0));
    std::array<Vec2, 8> points;
    if (project(camera, instance, box, points)) mark(points, narrowest(points), area, fine);
}

/// Marks the pixels about the corners of an outline, which may lie between the corners of pixels.
void markSharpPoints(const RenderScene& scene, const Shape& shape, const Instance& instance,
                     const Tile& area, std::vector<bool>& fine) {
    std::vector<Vec3> sharp;
    addSharpPoints(shape, instance.transform.toObject().point(scene.camera.eye()), sharp);
    for (const Vec3& point : sharp) {
        Vec2 at;
        if (!project(scene.camera, instance, point, at)) continue;
        const std::array<Vec2, 2> square = {at - kAroundCorner, at + kAroundCorner};
        mark(square, kEverywhere, area, fine);
    }
}

void markCombined(const RenderScene& scene, const Instance& instance, const CsgShape& csg,
                  const Tile& area, std::vector<bool>& fine);

/// Of a shape with the place of an instance.
void markShape(const RenderScene& scene, const Shape& shape, const Instance& instance,
               const Tile& area, std::vector<bool>& fine) {
    if (const auto* csg = std::get_if<std::shared_ptr<const CsgShape>>(&shape)) {
        return markCombined(scene, instance, **csg, area, fine);
    }
    markSharpPoints(scene, shape, instance, area, fine);
    if (const auto* cone = std::get_if<Cone>(&shape)) {
        markTip(scene.camera, instance, tipOf(*cone), area, fine);
    } else if (const auto* frustum = std::get_if<Frustum>(&shape)) {
        markTip(scene.camera, instance, tipOf(*frustum), area, fine);
    }
    std::array<Vec2, 8> points;
    if (!project(scene.camera, instance, boundsOf(shape), points)) return;
    // What a box leaves of a quadric may be as narrow as it likes.
    if (std::holds_alternative<Quadric>(shape)) return mark(points, kEverywhere, area, fine);
    const Strip strip = narrowest(points);
    if (strip.width() < kNarrowPixels) {
        mark(points, strip, area, fine);
    } else if (const auto* torus = std::get_if<Torus>(&shape)) {
        markNarrowTube(scene, instance, *torus, area, fine);
    } else if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape)) {
        markLeaves(scene, instance, (*mesh)->mesh, points, area, fine);
    }
}

/// What its parts alone hide between corners, seen or not; where parts begin, end and change
/// places the corners tell (csg_signature.h).
void markCombined(const RenderScene& scene, const Instance& instance, const CsgShape& csg,
                  const Tile& area, std::vector<bool>& fine) {
    std::array<Vec2, 8> points;
    for (const CsgNode& node : csg.nodes) {
        const bool inView = project(scene.camera, instance, node.box.bounds(), points);
        if (node.leaf == kNone) {
            if (!inView) continue;
            const Strip strip = narrowest(points);
            if (strip.width() < kNarrowPixels) mark(points, strip, area, fine);
            continue;
        }
        const CsgLeaf& leaf = csg.leaves[node.leaf];
        Instance placed = instance;
        if (Transform::make(compose(instance.transform.toWorld(), leaf.transform.toWorld()),
                            placed.transform)) {
            placed.objectScale = placed.transform.similarityToObject();
            markShape(scene, leaf.shape, placed, area, fine);
        } else if (inView) {
            mark(points, kEverywhere, area, fine);
        }
    }
}

}  // namespace

std::vector<bool> finePixels(const RenderScene& scene, const Tile& area) {
    std::vector<bool> fine(static_cast<std::size_t>(area.width()) *
                           static_cast<std::size_t>(area.height()));
    for (const Instance& instance : scene.instances) {
        markShape(scene, scene.shapes[instance.shape], instance, area, fine);
    }
    return fine;
}

}  // namespace rt
