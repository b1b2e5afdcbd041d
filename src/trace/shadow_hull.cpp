#include "shadow_hull.h"

#include "rt/core/numeric.h"
#include "rt/math/lanes4.h"
#include "rt/sampling/warp.h"
#include "scene_intersect.h"
#include "with_shape.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {
namespace {

/// Where along the hull its slab of one axis meets [lo, hi]: 0 <= s <= 1, the radius growing with
/// s. Narrows `range`; false when nothing is left.
bool narrow(double from, double fromRadius, double along, double growth, double lo, double hi,
            Interval& range) {
    // from + along s + fromRadius + growth s >= lo, and the mirror image for hi.
    const auto keepPositive = [&](double constant, double slope) {
        if (slope > 0.0) {
            range.min = std::max(range.min, -constant / slope);
        } else if (slope < 0.0) {
            range.max = std::min(range.max, -constant / slope);
        } else if (constant < 0.0) {
            return false;
        }
        return range.min <= range.max;
    };
    return keepPositive(from + fromRadius - lo, along + growth) &&
           keepPositive(hi - from + fromRadius, growth - along);
}

/// Distance of a point (at `along` the axis of the hull, `aside` from it) to the hull of two balls.
double distanceToHull(double along, double aside, double length, double fromRadius,
                      double toRadius) {
    if (!(length > 0.0)) return std::hypot(along, aside) - std::max(fromRadius, toRadius);
    const double sine = std::clamp((toRadius - fromRadius) / length, -1.0, 1.0);
    const double cosine = std::sqrt(1.0 - sine * sine);
    // The foot of the point on the slanted side, as a place on the axis.
    const double foot = along + aside * sine / std::max(cosine, kUnitRoundoff);
    if (foot <= 0.0) return std::sqrt(along * along + aside * aside) - fromRadius;
    if (foot >= length) {
        const double beyond = along - length;
        return std::sqrt(beyond * beyond + aside * aside) - toRadius;
    }
    return aside * cosine - along * sine - fromRadius;
}

/// The hull in a frame of (p - centre) * scale.
ShadowHull scaled(const ShadowHull& hull, const Vec3& centre, double scale) {
    return {(hull.from - centre) * scale, hull.fromRadius * scale, (hull.to - centre) * scale,
            hull.toRadius * scale, hull.parallel};
}

/// The hull in the object space of a similarity.
ShadowHull inObjectSpace(const ShadowHull& hull, const Instance& instance) {
    if (instance.transform.isIdentity()) return hull;
    const Affine& map = instance.transform.toObject();
    const double scale = instance.objectScale;
    return {map.point(hull.from), hull.fromRadius * scale, map.point(hull.to),
            hull.toRadius * scale, hull.parallel};
}

/// By the bounds of the shape, which compute slowly, and are kept.
struct MeetsHull {
    const ShadowHull& hull;
    const Bounds box;

    bool operator()(const Sphere&) const {
        return hull.meetsBall(box.centre(), 0.5 * box.extent().x);
    }
    bool operator()(const Plane&) const { return hull.meetsGround(); }
    bool operator()(const MeshPointer&) const { return hull.mayMeet(box); }
    bool operator()(const CsgPointer&) const { return hull.mayMeet(box); }
    template <class Solid>
    bool operator()(const Solid&) const {
        constexpr int kAxis = Solid::kKind.axis;
        if (!hull.mayMeet(box)) return false;
        if constexpr (kAxis < 0) return true;
        constexpr int kFirst = kAxis == 0 ? 1 : 0;
        constexpr int kSecond = kAxis == 2 ? 1 : 2;
        return hull.meetsCylinder(box.centre(), 0.5 * box.extent()[kFirst], kFirst, kSecond);
    }
};

struct BehindTangentPlane {
    const PrimitiveHit& hit;

    template <class Solid>
    bool operator()(const Solid&) const {
        return Solid::kKind.convex;
    }
    bool operator()(const Torus& torus) const { return torus.isOuterHalf(hit); }
    bool operator()(const MeshPointer&) const { return false; }
    bool operator()(const CsgPointer& shape) const { return shape->convex; }
};

/// A hull against four boxes at a time: mayMeet, with the divisions done beforehand.
class HullSlabs {
  public:
    explicit HullSlabs(const ShadowHull& hull) {
        const double growth = hull.toRadius - hull.fromRadius;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = hull.to[axis] - hull.from[axis];
            low_[axis] = {hull.from[axis] + hull.fromRadius, along + growth};
            high_[axis] = {hull.fromRadius - hull.from[axis], growth - along};
        }
    }

    /// Bit i: lane i of `planes`, of a node's boxes from lane `first` on, is met.
    unsigned meet(const WideNode& node, int first) const {
        Lanes4 from = Lanes4::all(0.0);
        Lanes4 to = Lanes4::all(1.0);
        unsigned mask = 0xf;
        for (int axis = 0; axis < 3; ++axis) {
            const Lanes4 lo = Lanes4::load(node.plane[2 * axis] + first);
            const Lanes4 hi = Lanes4::load(node.plane[2 * axis + 1] + first);
            mask &= notAbove(lo, hi);
            low_[axis].narrow(Lanes4::all(low_[axis].constant) - lo, from, to, mask);
            high_[axis].narrow(hi + Lanes4::all(high_[axis].constant), from, to, mask);
        }
        return mask & notAbove(from, to);
    }

  private:
    /// Where constant + slope s >= 0.
    struct Side {
        Side() = default;
        Side(double theConstant, double slope)
            : constant(theConstant), minusReciprocal(slope != 0.0 ? -1.0 / slope : 0.0) {}

        void narrow(Lanes4 value, Lanes4& from, Lanes4& to, unsigned& mask) const {
            if (minusReciprocal < 0.0) {
                from = greater(value * Lanes4::all(minusReciprocal), from);
            } else if (minusReciprocal > 0.0) {
                to = lesser(value * Lanes4::all(minusReciprocal), to);
            } else {
                mask &= notAbove(Lanes4::all(0.0), value);
            }
        }

        double constant = 0.0;
        double minusReciprocal = 0.0;
    };

    Side low_[3];
    Side high_[3];
};

/// Calls found(item) for the leaves of the tree whose boxes the hull may meet, while it is true.
template <class Found>
void walkTree(const WideTree& tree, const ShadowHull& world, Found&& found) {
    if (tree.isEmpty()) return;
    const TreeFrame& frame = tree.frame();
    ShadowHull hull = scaled(world, frame.centre, frame.scale);
    // The planes of the boxes were rounded outwards; the hull's own rounding is far below kBoxPad.
    hull.fromRadius += kBoxPad;
    hull.toRadius += kBoxPad;
    const HullSlabs slabs(hull);
    std::uint32_t stack[(kTreeWidth - 1) * (WideTree::kMaxDepth + 1) + kTreeWidth];
    std::size_t size = 0;
    stack[size++] = ChildRef::node(0).bits();
    while (size > 0) {
        const ChildRef child = ChildRef::fromBits(stack[--size]);
        if (child.isLeaf()) {
            for (std::uint32_t k = 0; k < child.count(); ++k) {
                if (!found(tree.item(child.first() + k))) return;
            }
            continue;
        }
        const WideNode& node = tree.nodes()[child.nodeIndex()];
        static_assert(kTreeWidth == 8);
        unsigned met = slabs.meet(node, 0) | slabs.meet(node, 4) << 4;
        for (; met != 0; met &= met - 1) stack[size++] = node.child[std::countr_zero(met)];
    }
}

/// Calls found(item) for the instances that the hull may meet, while it is true.
template <class Found>
void walk(const RenderScene& scene, const ShadowHull& hull, Found&& found) {
    for (const Index item : scene.unbounded) {
        if (!found(item)) return;
    }
    walkTree(scene.tree, hull, found);
}

}  // namespace

bool ShadowHull::mayMeet(const Bounds& box) const {
    Interval range{0.0, 1.0};
    const double growth = toRadius - fromRadius;
    const Vec3 along = to - from;
    for (int axis = 0; axis < 3; ++axis) {
        if (!narrow(from[axis], fromRadius, along[axis], growth, box.min[axis], box.max[axis],
                    range)) {
            return false;
        }
    }
    return true;
}

bool ShadowHull::meetsCylinder(const Vec3& centre, double radius, int i, int j) const {
    const Vec2 axis(to[i] - from[i], to[j] - from[j]);
    const Vec2 point(centre[i] - from[i], centre[j] - from[j]);
    const double length = std::sqrt(glm::dot(axis, axis));
    // Seen along the cylinder, one ball may lie within the other: the larger one is the hull.
    if (!(length > std::fabs(toRadius - fromRadius))) {
        const bool first = fromRadius >= toRadius;
        const Vec2 offset = first ? point : point - axis;
        const double reach = radius + (first ? fromRadius : toRadius);
        return glm::dot(offset, offset) <= reach * reach;
    }
    const double along = glm::dot(point, axis) / length;
    const double aside = std::fabs(point.x * axis.y - point.y * axis.x) / length;
    return distanceToHull(along, aside, length, fromRadius, toRadius) <= radius;
}

bool ShadowHull::meetsBall(const Vec3& centre, double radius) const {
    const Vec3 axis = to - from;
    const Vec3 point = centre - from;
    const double length = glm::length(axis);
    if (!(length > std::fabs(toRadius - fromRadius))) return true;
    const double along = glm::dot(point, axis) / length;
    const double squared = glm::dot(point, point) - along * along;
    const double aside = std::sqrt(std::max(squared, 0.0));
    return distanceToHull(along, aside, length, fromRadius, toRadius) <= radius;
}

bool ShadowHull::meetsGround() const {
    // On the upper side of it, or, turned over, on the lower.
    const double side = from.y < 0.0 ? -1.0 : 1.0;
    const double least = side * from.y - fromRadius;
    const double leastThere = side * to.y - toRadius;
    if (!(least > 0.0 && leastThere > 0.0)) return true;
    return parallel && leastThere < least;
}

bool liesBehindTangentPlane(const Shape& shape, const PrimitiveHit& hit) {
    return std::visit(BehindTangentPlane{hit}, shape);
}

bool meetsHull(const RenderScene& scene, const ShadowHull& hull, Index item) {
    const Instance& instance = scene.instances[item];
    const Bounds box = scene.shapeBoxes[instance.shape].bounds();
    if (instance.objectScale > 0.0) {
        return std::visit(MeetsHull{inObjectSpace(hull, instance), box},
                          scene.shapes[instance.shape]);
    }
    if (!kindOf(scene.shapes[instance.shape]).bounded) return true;
    return hull.mayMeet(instance.transform.boundsToWorld(box));
}

Occluders occludersIn(const RenderScene& scene, const ShadowHull& hull, Index except) {
    Occluders occluders;
    walk(scene, hull, [&](Index item) {
        if (item != except && !occluders.overflow && meetsHull(scene, hull, item)) {
            occluders.add(item);
        }
        return !occluders.overflow;
    });
    return occluders;
}

bool candidatesIn(const RenderScene& scene, const ShadowHull& hull, std::size_t most,
                  std::vector<Index>& items) {
    items.clear();
    bool all = true;
    walk(scene, hull, [&](Index item) {
        if (meetsHull(scene, hull, item)) {
            all = items.size() < most;
            if (all) items.push_back(item);
        }
        return all;
    });
    return all;
}

bool anyBlocks(const RenderScene& scene, const Occluders& occluders, const Ray& ray,
               Interval range) {
    if (occluders.overflow) return anyHit(scene, ray, range);
    for (unsigned i = 0; i < occluders.count; ++i) {
        if (instanceBlocks(scene, occluders.items[i], ray, range)) return true;
    }
    return false;
}

bool oneHidesCone(const RenderScene& scene, const Occluders& occluders, const Vec3& from,
                  const Vec3& axis, double tanA, double reach) {
    if (occluders.overflow) return false;
    const Basis basis = orthonormalBasis(axis);
    for (unsigned i = 0; i < occluders.count; ++i) {
        const Index item = occluders.items[i];
        if (!kindOf(scene.shapes[scene.instances[item].shape]).convex) continue;
        bool all = true;
        for (int corner = 0; corner < 4 && all; ++corner) {
            const double a = (corner & 1) ? tanA : -tanA;
            const double b = (corner & 2) ? tanA : -tanA;
            const Vec3 w = glm::normalize(axis + a * basis.tangent + b * basis.bitangent);
            all = instanceBlocks(scene, item, {from, w}, {0.0, reach});
        }
        if (all) return true;
    }
    return false;
}

}  // namespace rt
