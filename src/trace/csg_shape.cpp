#include "rt/trace/csg_shape.h"

#include "csg_crossings.h"
#include "scene_intersect.h"
#include "with_shape.h"

#include <algorithm>

namespace rt {
namespace {

/// The crossings that may matter in a range. What lies apart from the range by its box is outside
/// all over it.
class Gatherer {
  public:
    Gatherer(const CsgShape& csg, const Ray& ray, const SlabRay* slabs, Interval range,
             CrossingList& out)
        : csg_(csg), ray_(ray), slabs_(slabs), range_(range), out_(out) {}

    /// Whether the line may be inside the solid that the node stands for.
    bool gather(Index index) const {
        const CsgNode& node = csg_.nodes[index];
        if (slabs_ && !slabs_->meets(node.box, range_)) return false;
        if (node.leaf != kNone) return addLeafCrossings(csg_, node.leaf, ray_, out_);
        const std::size_t before = out_.size();
        bool any = false;
        for (Index child = index + 1; child < node.end; child = csg_.nodes[child].end) {
            const bool met = gather(child);
            if (csg_.nodes[child].negated) continue;
            if (!met && node.needsAll()) {
                out_.shorten(before);
                return false;
            }
            any = any || met;
        }
        return any;
    }

  private:
    const CsgShape& csg_;
    const Ray& ray_;
    const SlabRay* slabs_;
    Interval range_;
    CrossingList& out_;
};

/// The expression's value while a line is walked.
class Walk {
  public:
    explicit Walk(const CsgShape& csg) : csg_(csg) { counts_.assign(csg.outside); }

    /// Enters the leaf's solid, or leaves it; whether the whole's value changed.
    bool toggle(Index leaf) {
        Index index = csg_.leaves[leaf].node;
        bool value = (counts_[index] ^= 1) != 0;
        while (index != 0) {
            const CsgNode& node = csg_.nodes[index];
            const Index needed = csg_.nodes[node.parent].needed;
            Index& count = counts_[node.parent];
            const bool before = count >= needed;
            count += value != node.negated ? 1 : Index(-1);
            value = count >= needed;
            if (value == before) return false;
            index = node.parent;
        }
        return true;
    }

    /// Crosses surfaces that are one; the crossing that is seen, nullptr where the value is the
    /// same before and after.
    const PrimitiveHit* crossTogether(const PrimitiveHit* first, const PrimitiveHit* last) {
        if (!toggleAll(first, last)) return nullptr;
        const PrimitiveHit* seen = decisive(first, last);
        if (seen) return seen;
        toggleAll(first, last);
        seen = decisive(first, last);
        toggleAll(first, last);
        return seen ? seen : first;
    }

  private:
    bool toggleAll(const PrimitiveHit* first, const PrimitiveHit* last) {
        bool changed = false;
        for (; first != last; ++first) changed = toggle(first->leaf) != changed;
        return changed;
    }

    /// Of the leaves that are crossed and without which the value would be the other, the first.
    const PrimitiveHit* decisive(const PrimitiveHit* first, const PrimitiveHit* last) {
        const PrimitiveHit* found = nullptr;
        for (const PrimitiveHit* hit = first; hit != last; ++hit) {
            if (found && hit->leaf >= found->leaf) continue;
            const auto same = [&](const PrimitiveHit& other) { return other.leaf == hit->leaf; };
            if (std::count_if(first, last, same) % 2 == 0) continue;
            if (toggle(hit->leaf)) found = hit;
            toggle(hit->leaf);
        }
        return found;
    }

    const CsgShape& csg_;
    SmallList<Index, 48> counts_;
};

bool gatherCrossings(const CsgShape& csg, const Ray& ray, Interval range, CrossingList& out) {
    // What counts as one with a crossing at the range's end may lie beyond it.
    if (range.min > -kInfinity) range.min -= coincidenceInT(ray, range.min);
    if (range.max < kInfinity) range.max += coincidenceInT(ray, range.max);
    SlabRay slabs;
    const bool made = slabs.make(ray);
    if (!Gatherer(csg, ray, made ? &slabs : nullptr, range, out).gather(0)) return false;
    std::sort(out.begin(), out.end(), [](const PrimitiveHit& a, const PrimitiveHit& b) {
        return a.t != b.t ? a.t < b.t : a.leaf < b.leaf;
    });
    return true;
}

SurfacePoint placed(const SurfacePoint& surface, const Transform& transform) {
    const Affine& map = transform.toWorld();
    SurfacePoint out = surface;
    out.point = map.point(surface.point);
    out.error = transform.errorToWorld(surface.point, surface.error);
    out.normal = transform.normalToWorld(surface.normal);
    const bool smooth = surface.shadingNormal != surface.normal;
    out.shadingNormal = smooth ? transform.normalToWorld(surface.shadingNormal) : out.normal;
    const bool lifted = surface.shadowOrigin != surface.point;
    out.shadowOrigin = lifted ? map.point(surface.shadowOrigin) : out.point;
    out.dpdu = map.vector(surface.dpdu);
    out.dpdv = map.vector(surface.dpdv);
    return out;
}

}  // namespace

bool intersectCsg(const CsgShape& csg, const Ray& ray, Interval range, PrimitiveHit& hit) {
    CrossingList crossings;
    if (!gatherCrossings(csg, ray, range, crossings)) return false;
    Walk walk(csg);
    const PrimitiveHit* const end = crossings.end();
    for (const PrimitiveHit* first = crossings.begin(); first != end;) {
        if (!(first->t < range.max)) return false;
        const double reach = first->t + coincidenceInT(ray, first->t);
        const PrimitiveHit* last = first + 1;
        while (last != end && last->t < reach) ++last;
        const PrimitiveHit* seen = nullptr;
        if (last == first + 1) {
            seen = walk.toggle(first->leaf) ? first : nullptr;
        } else {
            seen = walk.crossTogether(first, last);
        }
        if (seen && range.contains(seen->t)) {
            hit = *seen;
            return true;
        }
        first = last;
    }
    return false;
}

SurfacePoint csgSurface(const CsgShape& csg, const PrimitiveHit& hit, SurfaceDetail detail) {
    const CsgLeaf& leaf = csg.leaves[hit.leaf];
    SurfacePoint surface = withShape(leaf.shape, SurfaceOfShape{hit, detail});
    if (!leaf.transform.isIdentity()) surface = placed(surface, leaf.transform);
    if (leaf.insideOut) {
        surface.normal = -surface.normal;
        surface.shadingNormal = -surface.shadingNormal;
        // From its inside a rounded surface bulges the other way.
        surface.shadowOrigin = surface.point;
    }
    return surface;
}

}  // namespace rt
