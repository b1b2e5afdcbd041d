#include "csg_builder.h"

#include "csg_parts.h"
#include "flatten.h"

#include <algorithm>
#include <string>
#include <utility>

namespace rt {
namespace {

double largest(const Bounds& bounds) {
    const Vec3 v = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    return std::max({v.x, v.y, v.z});
}

/// What the nodes above have said, from the whole downwards.
struct Above {
    Affine toWhole;
    AppearanceDesc appearance;
    Affine appearanceToWhole;
    std::optional<double> reflection;
    std::size_t depth = 0;
};

bool hasColor(const AppearanceDesc& appearance) {
    return appearance.material != kNone || appearance.texture != kNone;
}

Affine inverseOf(const Affine& map) {
    Transform transform;
    return Transform::make(map, transform) ? transform.toObject() : Affine{};
}

class Builder {
  public:
    Builder(const CsgSources& sources, Index node)
        : sources_(sources),
          scene_(sources.scene),
          whole_(scene_.nodes[node]),
          operation_(std::get<CsgDesc>(geometryOf(whole_)).operation) {}

    BuiltCsg build() {
        const CsgPart whole = csgGathered(combined(whole_, operation_, {}));
        BuiltCsg built;
        if (whole.isEmpty()) {
            sources_.diagnostics.warn("empty-solid", whole_.where,
                                      called() + " is empty and is skipped: " + why());
            return built;
        }
        keepUsed(whole);
        auto shape = std::make_shared<CsgShape>();
        shape->name = nameOf(operation_);
        shape->leaves = std::move(leaves_);
        addNode(*shape, whole, false);
        shape->bounds = whole.bounds;
        shape->rounding = whole.rounding;
        shape->convex = isConvex(whole, *shape);
        shape->thickness = thickness(whole, *shape);
        shape->partThickness = kInfinity;
        for (const CsgLeaf& leaf : shape->leaves) {
            shape->partThickness = std::min(shape->partThickness, leafThickness(leaf));
        }
        built.shape = std::move(shape);
        built.looks = std::move(looks_);
        return built;
    }

  private:
    static const char* nameOf(CsgOperation operation) {
        switch (operation) {
            case CsgOperation::kUnion:
                return "union";
            case CsgOperation::kIntersection:
                return "intersection";
            default:
                return "difference";
        }
    }

    const GeometryShape& geometryOf(const NodeDesc& node) const {
        return scene_.geometries[node.geometry].shape;
    }

    static std::string quoted(const NodeDesc& node) { return "'" + printable(node.name, 80) + "'"; }
    std::string called() const {
        return std::string("gr.") + nameOf(operation_) + ": " + quoted(whole_);
    }
    std::string why() const {
        return operation_ == CsgOperation::kUnion ? "there is no solid in it"
                                                  : "its solids have no room in common";
    }

    [[noreturn]] void refuse(const NodeDesc& node, const std::string& why) const {
        throw SceneError(called() + " cannot use " + quoted(node) + " of line " +
                             std::to_string(node.where.line) + ", " + why,
                         whole_.where);
    }

    void count(std::size_t depth) {
        if (++nodes_ > kMostCsgNodes) {
            throw LimitError(called() + " combines more than " + std::to_string(kMostCsgNodes) +
                                 " nodes; place some of them beside it, as children of a node",
                             whole_.where);
        }
        if (depth > kMostCsgDepth) {
            throw LimitError(called() + " has solids within solids more than " +
                                 std::to_string(kMostCsgDepth) +
                                 " deep; one call takes any number of them",
                             whole_.where);
        }
    }

    CsgPart combined(const NodeDesc& node, CsgOperation operation, const Above& above) {
        std::vector<CsgPart> parts;
        for (const Index operand : node.operands) parts.push_back(reached(operand, {}, above));
        if (operation == CsgOperation::kUnion) return csgUnion(std::move(parts));
        if (operation == CsgOperation::kDifference) {
            for (auto part = parts.begin() + 1; part != parts.end(); ++part) part->negated = true;
        }
        return csgIntersection(std::move(parts));
    }

    /// A node with all that hangs under it.
    CsgPart reached(Index index, const AppearanceDesc& edge, const Above& above) {
        count(above.depth);
        const NodeDesc& node = scene_.nodes[index];
        const NodeState& state = node.at(sources_.render);
        if (state.motion.moves()) {
            refuse(node, "which moves by itself: let the whole move, with its own node:move");
        }
        Above here = above;
        here.toWhole = compose(above.toWhole, state.transform);
        ++here.depth;
        std::vector<CsgPart> parts;
        if (node.geometry != kNone) parts.push_back(solid(index, edge, here));
        for (const EdgeDesc& child : state.children) {
            parts.push_back(reached(child.child, child.appearance, here));
        }
        return csgUnion(std::move(parts));
    }

    CsgPart solid(Index index, const AppearanceDesc& edge, Above here) {
        const NodeDesc& node = scene_.nodes[index];
        const NodeState& state = node.at(sources_.render);
        if (state.refraction || state.absorption != Color(0.0)) {
            sources_.diagnostics.warn(
                "unused-refraction", node.where,
                "node " + quoted(node) + " is a part of " + quoted(whole_) +
                    ", and light shines through the whole or not at all: give that "
                    "set_refraction and set_absorption");
        }
        const AppearanceDesc own = over(edge, state.appearance);
        if (!hasColor(here.appearance) && hasColor(own)) here.appearanceToWhole = here.toWhole;
        here.appearance = over(here.appearance, own);
        if (!here.reflection) here.reflection = state.reflection;
        const auto* csg = std::get_if<CsgDesc>(&geometryOf(node));
        return csg ? combined(node, csg->operation, here) : leaf(index, here);
    }

    CsgPart leaf(Index index, const Above& here) {
        const NodeDesc& node = scene_.nodes[index];
        const Shape* shape = sources_.shape(node.geometry);
        Transform transform;
        if (!shape || !sources_.place(node, here.toWhole, transform)) return {};
        const SolidKind kind = kindOf(*shape);
        if (!kind.closed || !kind.bounded) {
            const bool isMesh = std::holds_alternative<std::shared_ptr<const MeshShape>>(*shape);
            refuse(node, isMesh ? "an open mesh, which bounds no solid: each edge must belong to "
                                  "two triangles"
                                : std::string("a ") + rt::nameOf(*shape) +
                                      ", which bounds no solid: a box that is large enough does");
        }
        const Bounds local = boundsOf(*shape);
        const Vec3 reach = glm::max(glm::abs(local.min), glm::abs(local.max));
        const bool boxed = !(transform.condition() > kBoxedCondition);
        const double rounding =
            boxed ? largest(transform.boundsToWorld({-reach, reach})) : kInfinity;
        const auto number = static_cast<Index>(leaves_.size());
        const Bounds bounds = transform.boundsToWorld(local);
        leaves_.push_back({*shape, transform});
        looks_.push_back(
            {index, here.appearance, inverseOf(here.appearanceToWhole), here.reflection});
        return csgLeaf(number, bounds, rounding);
    }

    /// Forgets the leaves that the expression does without.
    void keepUsed(const CsgPart& whole) {
        std::vector<Index> used;
        addLeaves(whole, used);
        std::sort(used.begin(), used.end());
        std::vector<CsgLeaf> leaves;
        std::vector<CsgLeafLook> looks;
        numbers_.assign(leaves_.size(), kNone);
        for (const Index old : used) {
            numbers_[old] = static_cast<Index>(leaves.size());
            leaves.push_back(std::move(leaves_[old]));
            looks.push_back(looks_[old]);
        }
        leaves_ = std::move(leaves);
        looks_ = std::move(looks);
    }

    static void addLeaves(const CsgPart& part, std::vector<Index>& leaves) {
        if (part.leaf != kNone) leaves.push_back(part.leaf);
        for (const CsgPart& child : part.children) addLeaves(child, leaves);
    }

    void addNode(CsgShape& shape, const CsgPart& part, bool insideOut) const {
        const auto index = static_cast<Index>(shape.nodes.size());
        CsgNode node;
        node.box = PaddedBox(part.bounds, part.rounding);
        node.negated = part.negated;
        if (part.kind == CsgPart::Kind::kAll)
            node.needed = static_cast<Index>(part.children.size());
        for (const CsgPart& child : part.children) node.outside += child.negated ? 1 : 0;
        if (part.leaf != kNone) {
            node.leaf = numbers_[part.leaf];
            shape.leaves[node.leaf].insideOut = insideOut;
        }
        shape.nodes.push_back(node);
        for (const CsgPart& child : part.children) {
            addNode(shape, child, insideOut != child.negated);
        }
        shape.nodes[index].end = static_cast<Index>(shape.nodes.size());
        if (part.isCrowd()) addCrowd(shape, index);
    }

    /// A tree over a node's children; none where it would leave one out that has no finite box.
    static void addCrowd(CsgShape& shape, Index parent) {
        CsgCrowd crowd;
        std::vector<Bounds> boxes;
        for (Index child = parent + 1; child < shape.nodes[parent].end;
             child = shape.nodes[child].end) {
            crowd.children.push_back(child);
            boxes.push_back(shape.nodes[child].box.bounds());
        }
        crowd.tree = WideTree::build(boxes, {});
        if (crowd.tree.itemCount() < boxes.size()) return;
        shape.nodes[parent].crowd = static_cast<Index>(shape.crowds.size());
        shape.crowds.push_back(std::move(crowd));
    }

    bool isConvex(const CsgPart& part, const CsgShape& shape) const {
        if (part.negated || part.kind == CsgPart::Kind::kAny) return false;
        if (part.leaf != kNone) return kindOf(shape.leaves[numbers_[part.leaf]].shape).convex;
        return std::all_of(part.children.begin(), part.children.end(),
                           [&](const CsgPart& child) { return isConvex(child, shape); });
    }

    /// Of what is cut nothing is known.
    double thickness(const CsgPart& part, const CsgShape& shape) const {
        if (part.kind == CsgPart::Kind::kAll) return 0.0;
        if (part.leaf != kNone) return leafThickness(shape.leaves[numbers_[part.leaf]]);
        double least = kInfinity;
        for (const CsgPart& child : part.children) {
            least = std::min(least, thickness(child, shape));
        }
        return least;
    }

    static double leafThickness(const CsgLeaf& leaf) {
        if (std::holds_alternative<std::shared_ptr<const MeshShape>>(leaf.shape)) return kInfinity;
        if (std::holds_alternative<Quadric>(leaf.shape)) return 0.0;
        const double scale = leaf.transform.similarityToObject();
        const Vec3 size = boundsOf(leaf.shape).extent();
        return scale > 0.0 ? std::min({size.x, size.y, size.z}) / scale : 0.0;
    }

    const CsgSources& sources_;
    const SceneDesc& scene_;
    const NodeDesc& whole_;
    CsgOperation operation_;
    std::size_t nodes_ = 0;
    std::vector<CsgLeaf> leaves_;
    std::vector<CsgLeafLook> looks_;
    std::vector<Index> numbers_;  ///< of the leaves that are kept
};

}  // namespace

BuiltCsg buildCsg(const CsgSources& sources, Index node) {
    return Builder(sources, node).build();
}

}  // namespace rt
