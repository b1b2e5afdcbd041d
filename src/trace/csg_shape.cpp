#include "rt/trace/csg_shape.h"

#include "csg_crossings.h"
#include "scene_intersect.h"
#include "with_shape.h"

#include <algorithm>

namespace rt {
namespace {

/// A node of the expression that a line may be inside of.
struct MetNode {
    Index node = 0;
    Index parent = kNone;  ///< its place among those that are met
    Index count = 0;       ///< of its children that count where the line is walked
};

/// What is met along a line.
struct Met {
    CrossingList crossings;  ///< their leaf is a place in `nodes`
    SmallList<MetNode, 32> nodes;
};

/// The crossings that may matter in a range. What lies apart from the range by its box is outside
/// all over it.
class Gatherer {
  public:
    Gatherer(const CsgShape& csg, const Ray& ray, const SlabRay* slabs, Interval range, Met& out)
        : csg_(csg),
          ray_(ray),
          slabs_(slabs),
          from_(range.min),
          range_(widened(range)),
          out_(out) {}

    /// All of them; whether there may be any.
    bool gather() { return gather(0, kNone); }

    /// Of a union of many, those up to where the line enters one of them alone: it has entered the
    /// whole there, unless it was inside before. Where they end.
    double gatherNear() {
        double end = kInfinity;
        bool inside = false;
        const Index place = meet(0, kNone);
        visitCrowd(csg_.crowds[csg_.nodes[0].crowd], ray_, range_, [&](Index child, Interval now) {
            const std::size_t before = out_.crossings.size();
            range_.max = now.max;
            if (!gather(child, place) || csg_.nodes[child].leaf == kNone) return now.max;
            std::size_t next = before;
            while (next < out_.crossings.size() && !(out_.crossings[next].t > from_)) ++next;
            inside = inside || (next - before) % 2 == 1;
            if (inside || next == out_.crossings.size()) return now.max;
            end = std::min(end, beyond(out_.crossings[next].t));
            return std::min(now.max, beyond(end));
        });
        return end;
    }

  private:
    double beyond(double t) const { return t + coincidenceInT(ray_, t); }

    /// What counts as one with a crossing at the range's end may lie beyond it.
    Interval widened(Interval range) const {
        if (range.min > -kInfinity) range.min -= coincidenceInT(ray_, range.min);
        if (range.max < kInfinity) range.max = beyond(range.max);
        return range;
    }

    Index meet(Index node, Index parent) {
        out_.nodes.push({node, parent, csg_.nodes[node].outside});
        return static_cast<Index>(out_.nodes.size() - 1);
    }

    /// Whether the line may be inside the solid that the node stands for.
    bool gather(Index index, Index parent) {
        const CsgNode& node = csg_.nodes[index];
        if (slabs_ && !slabs_->meets(node.box, range_)) return false;
        const std::size_t before = out_.crossings.size();
        const Index place = meet(index, parent);
        if (node.leaf != kNone) {
            addLeafCrossings(csg_.leaves[node.leaf], place, ray_, out_.crossings);
        } else if (!gatherChildren(index, place)) {
            out_.crossings.shorten(before);
        }
        const bool met = out_.crossings.size() > before;
        if (!met) out_.nodes.shorten(place);
        return met;
    }

    /// False where no point of the line is inside of the node.
    bool gatherChildren(Index index, Index place) {
        const CsgNode& node = csg_.nodes[index];
        if (slabs_ && node.crowd != kNone) {
            visitCrowd(csg_.crowds[node.crowd], ray_, range_, [&](Index child, Interval now) {
                gather(child, place);
                return now.max;
            });
            return true;
        }
        for (Index child = index + 1; child < node.end; child = csg_.nodes[child].end) {
            const bool met = gather(child, place);
            if (!met && node.needsAll() && !csg_.nodes[child].negated) return false;
        }
        return true;
    }

    const CsgShape& csg_;
    const Ray& ray_;
    const SlabRay* slabs_;
    double from_;
    Interval range_;
    Met& out_;
};

/// The expression's value while a line is walked.
class Walk {
  public:
    Walk(const CsgShape& csg, Met& met) : csg_(csg), nodes_(met.nodes) {}

    /// Enters the solid of a crossing's leaf, or leaves it; whether the whole's value changed.
    bool toggle(const PrimitiveHit& hit) {
        MetNode* at = &nodes_[hit.leaf];
        bool value = (at->count ^= 1) != 0;
        while (at->parent != kNone) {
            const bool negated = csg_.nodes[at->node].negated;
            at = &nodes_[at->parent];
            const Index needed = csg_.nodes[at->node].needed;
            const bool before = at->count >= needed;
            at->count += value != negated ? 1 : Index(-1);
            value = at->count >= needed;
            if (value == before) return false;
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

    Index leafOf(const PrimitiveHit& hit) { return csg_.nodes[nodes_[hit.leaf].node].leaf; }

  private:
    bool toggleAll(const PrimitiveHit* first, const PrimitiveHit* last) {
        bool changed = false;
        for (; first != last; ++first) changed = toggle(*first) != changed;
        return changed;
    }

    /// Of the leaves that are crossed and without which the value would be the other, the first.
    const PrimitiveHit* decisive(const PrimitiveHit* first, const PrimitiveHit* last) {
        const PrimitiveHit* found = nullptr;
        for (const PrimitiveHit* hit = first; hit != last; ++hit) {
            if (found && leafOf(*hit) >= leafOf(*found)) continue;
            const auto same = [&](const PrimitiveHit& other) { return other.leaf == hit->leaf; };
            if (std::count_if(first, last, same) % 2 == 0) continue;
            if (toggle(*hit)) found = hit;
            toggle(*hit);
        }
        return found;
    }

    const CsgShape& csg_;
    SmallList<MetNode, 32>& nodes_;
};

/// The first crossing of the whole in `range` of those that begin before `end`.
bool firstChange(const CsgShape& csg, const Ray& ray, Interval range, double end, Met& met,
                 PrimitiveHit& hit) {
    Walk walk(csg, met);
    CrossingList& crossings = met.crossings;
    std::sort(crossings.begin(), crossings.end(),
              [&](const PrimitiveHit& a, const PrimitiveHit& b) {
                  return a.t != b.t ? a.t < b.t : walk.leafOf(a) < walk.leafOf(b);
              });
    for (const PrimitiveHit* first = crossings.begin(); first != crossings.end();) {
        if (!(first->t < end)) return false;
        const double reach = first->t + coincidenceInT(ray, first->t);
        const PrimitiveHit* last = first + 1;
        while (last != crossings.end() && last->t < reach) ++last;
        const PrimitiveHit* seen = nullptr;
        if (last == first + 1) {
            seen = walk.toggle(*first) ? first : nullptr;
        } else {
            seen = walk.crossTogether(first, last);
        }
        if (seen && range.contains(seen->t)) {
            hit = *seen;
            hit.leaf = walk.leafOf(*seen);
            return true;
        }
        first = last;
    }
    return false;
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
    SlabRay slabs;
    const bool made = slabs.make(ray);
    const SlabRay* const boxes = made ? &slabs : nullptr;
    if (boxes && csg.nodes[0].crowd != kNone) {
        Met met;
        const double end = Gatherer(csg, ray, boxes, range, met).gatherNear();
        if (firstChange(csg, ray, range, std::min(end, range.max), met, hit)) return true;
        if (!(end < range.max)) return false;
    }
    Met met;
    if (!Gatherer(csg, ray, boxes, range, met).gather()) return false;
    return firstChange(csg, ray, range, range.max, met, hit);
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
