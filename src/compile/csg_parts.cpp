#include "csg_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rt {
namespace {

Bounds common(const Bounds& a, const Bounds& b) {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

/// A single part stands for itself.
CsgPart simplified(CsgPart whole) {
    if (whole.children.size() != 1) return whole;
    CsgPart only = std::move(whole.children.front());
    return only;
}

void append(std::vector<CsgPart>& to, std::vector<CsgPart>&& from, bool negate) {
    for (CsgPart& part : from) {
        part.negated = part.negated != negate;
        to.push_back(std::move(part));
    }
}

}  // namespace

CsgPart csgLeaf(Index leaf, const Bounds& bounds, double rounding) {
    CsgPart part;
    part.kind = CsgPart::Kind::kLeaf;
    part.leaf = leaf;
    part.bounds = bounds;
    part.rounding = rounding;
    return part;
}

CsgPart csgUnion(std::vector<CsgPart> parts) {
    CsgPart whole;
    for (CsgPart& part : parts) {
        whole.bounds.unite(part.bounds);
        whole.rounding = std::max(whole.rounding, part.rounding);
        if (part.kind == CsgPart::Kind::kAny) {
            append(whole.children, std::move(part.children), false);
        } else {
            whole.children.push_back(std::move(part));
        }
    }
    return simplified(std::move(whole));
}

CsgPart csgIntersection(std::vector<CsgPart> parts) {
    CsgPart whole;
    whole.kind = CsgPart::Kind::kAll;
    whole.bounds = {Vec3(-kInfinity), Vec3(kInfinity)};
    for (const CsgPart& part : parts) {
        if (part.negated) continue;
        whole.bounds = common(whole.bounds, part.bounds);
        whole.rounding = std::max(whole.rounding, part.rounding);
    }
    if (whole.bounds.isEmpty()) return {};
    for (CsgPart& part : parts) {
        // What lies apart takes nothing away.
        if (part.negated && common(whole.bounds, part.bounds).isEmpty()) continue;
        const auto alike = part.negated ? CsgPart::Kind::kAny : CsgPart::Kind::kAll;
        if (part.kind == alike) {
            append(whole.children, std::move(part.children), part.negated);
        } else {
            whole.children.push_back(std::move(part));
        }
    }
    std::stable_partition(whole.children.begin(), whole.children.end(),
                          [](const CsgPart& part) { return !part.negated; });
    return simplified(std::move(whole));
}

CsgPart csgGathered(CsgPart whole) {
    std::vector<CsgPart>& children = whole.children;
    for (CsgPart& child : children) child = csgGathered(std::move(child));
    const auto taken = std::find_if(children.begin(), children.end(),
                                    [](const CsgPart& part) { return part.negated; });
    if (static_cast<std::size_t>(children.end() - taken) <= kFewParts) return whole;
    std::vector<CsgPart> away(std::make_move_iterator(taken),
                              std::make_move_iterator(children.end()));
    children.erase(taken, children.end());
    for (CsgPart& part : away) part.negated = false;
    children.push_back(csgUnion(std::move(away)));
    children.back().negated = true;
    return whole;
}

}  // namespace rt
