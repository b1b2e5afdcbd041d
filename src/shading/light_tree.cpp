#include "rt/shading/light_tree.h"

#include "rt/core/bounds.h"
#include "rt/core/numeric.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// Of lights at the horizon of the shading normal: highlights and floors of brightness may show.
constexpr double kLeastFacing = 1.0 / 16;

double brightest(const Color& c) {
    return std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
}

Bounds boundsOf(std::span<const Light> lights, std::span<const Index> items) {
    Bounds bounds;
    for (const Index item : items) bounds.unite(lights[item].position);
    return bounds;
}

int widestAxis(const Vec3& extent) {
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// The greatest cosine between the normal and the directions to a ball.
double greatestCosine(const Vec3& normal, const Vec3& toCentre, double distance, double radius) {
    if (distance <= radius) return 1.0;
    const double cosine = glm::dot(normal, toCentre) / distance;
    const double sine = radius / distance;
    const double cosineOfBall = std::sqrt((1.0 - sine) * (1.0 + sine));
    if (cosine >= cosineOfBall) return 1.0;
    return cosine * cosineOfBall + std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) * sine;
}

}  // namespace

LightTree::LightTree(std::span<const Light> lights) {
    std::vector<Index> placed;
    for (Index i = 0; i < lights.size(); ++i) {
        (lights[i].kind == LightKind::kSun ? suns_ : placed).push_back(i);
    }
    if (placed.empty()) return;
    nodes_.reserve(2 * placed.size() - 1);
    build(lights, placed);
}

Index LightTree::build(std::span<const Light> lights, std::span<Index> items) {
    const Index index = static_cast<Index>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    const Bounds bounds = boundsOf(lights, items);
    node.centre = bounds.centre();
    for (const Index item : items) {
        const Light& light = lights[item];
        const double power = brightest(light.intensity);
        node.radius =
            std::max(node.radius, glm::length(light.position - node.centre) + light.radius);
        node.power += power;
        node.c0 += power * light.c0;
        node.c1 += power * light.c1;
        node.c2 += power * light.c2;
    }
    if (node.power > 0.0) {
        node.c0 /= node.power;
        node.c1 /= node.power;
        node.c2 /= node.power;
    }
    if (items.size() == 1) {
        node.light = items.front();
    } else {
        const int axis = widestAxis(bounds.extent());
        const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
        std::nth_element(items.begin(), middle, items.end(), [&](Index a, Index b) {
            const double x = lights[a].position[axis];
            const double y = lights[b].position[axis];
            return x < y || (x == y && a < b);
        });
        build(lights, {items.begin(), middle});
        node.right = build(lights, {middle, items.end()});
    }
    nodes_[index] = node;
    return index;
}

double LightTree::importance(const Node& node, const Vec3& from, const Vec3& geometricNormal,
                             const Vec3& normal) const {
    const Vec3 toCentre = node.centre - from;
    const double distance = glm::length(toCentre);
    const double rounding = kUnitDotError + kCoincidence;
    if (greatestCosine(geometricNormal, toCentre, distance, node.radius) < -rounding) return 0.0;
    const double cosine = greatestCosine(normal, toCentre, distance, node.radius);
    const double facing = kLeastFacing + (1.0 - kLeastFacing) * std::max(cosine, 0.0);
    const double d = std::max(distance, node.radius);
    const double falloff = node.c0 + d * (node.c1 + d * node.c2);
    return falloff > 0.0 ? node.power * facing / falloff : node.power * facing;
}

/// Nodes wider than this share of their distance are looked into before anything is chosen.
constexpr double kWide = 0.4;
/// The most that are kept apart.
constexpr int kMostApart = 512;

/// The choices on their way down: [begin, end) of them have come to a node, to which the part
/// [low, low + width) of the unit interval leads.
struct LightTree::Descent {
    const LightTree& tree;
    const Vec3& from;
    const Vec3& geometricNormal;
    const Vec3& normal;
    int count;
    double shift;
    Choice choice{};

    /// Nodes that are small beside their distance, or lights, in the tree's order, with their
    /// importance.
    struct Part {
        Index node;
        double importance;
    };
    std::array<Part, kMostApart> parts{};
    int partCount = 0;
    double total = 0.0;

    void lookInto(Index index, int pending) {
        const double found = of(index);
        if (!(found > 0.0)) return;
        const Node& node = tree.nodes_[index];
        const double distance = glm::length(node.centre - from);
        if (node.light != kNone || node.radius <= kWide * distance ||
            partCount + pending + 2 > kMostApart) {
            parts[static_cast<std::size_t>(partCount++)] = {index, found};
            total += found;
            return;
        }
        lookInto(index + 1, pending + 1);
        lookInto(node.right, pending);
    }

    void run() {
        lookInto(0, 0);
        double low = 0.0;
        int begin = 0;
        for (int k = 0; k < partCount; ++k) {
            const Part& part = parts[static_cast<std::size_t>(k)];
            const double width = part.importance / total;
            int end = k + 1 < partCount ? begin : count;
            while (end < count && place(end) < low + width) ++end;
            to(part.node, begin, end, low, width);
            begin = end;
            low += width;
        }
    }

    double place(int i) const { return (i + shift) / count; }

    void to(Index index, int begin, int end, double low, double width) {
        while (begin < end) {
            const Node& node = tree.nodes_[index];
            if (node.light != kNone) {
                const double expected = count * width;
                choice.lights[static_cast<std::size_t>(choice.count++)] = {
                    node.light, (end - begin) / expected};
                return;
            }
            const Index left = index + 1;
            const double a = of(left);
            const double b = of(node.right);
            if (!(a + b > 0.0)) return;
            const double share = a / (a + b);
            const double leftWidth = share * width;
            int middle = begin;
            if (share == 1.0) middle = end;
            while (middle < end && place(middle) < low + leftWidth) ++middle;
            if (share > 0.0) to(left, begin, middle, low, leftWidth);
            if (share == 1.0) return;
            begin = share > 0.0 ? middle : begin;
            index = node.right;
            low += leftWidth;
            width -= leftWidth;
        }
    }

    double of(Index node) const {
        return tree.importance(tree.nodes_[node], from, geometricNormal, normal);
    }
};

LightTree::Choice LightTree::choose(const Vec3& from, const Vec3& geometricNormal,
                                    const Vec3& normal, int count, double shift) const {
    Descent descent{*this, from, geometricNormal, normal, count, shift};
    if (!isEmpty()) descent.run();
    return descent.choice;
}

}  // namespace rt
