#include "csg_crossings.h"

#include "scene_intersect.h"
#include "with_shape.h"

#include <cmath>
#include <vector>

namespace rt {
namespace {

constexpr Interval kWholeLine{-kInfinity, kInfinity};

/// Any directions, but none that lie along faces that people model.
constexpr Vec3 kAskew[] = {Vec3(0.5377, 0.7311, -0.4201), Vec3(-0.3119, 0.2773, 0.9087),
                           Vec3(0.8713, -0.4637, 0.1607), Vec3(-0.1931, -0.6373, -0.7459)};

/// A mesh hit in its border between triangles is hit in several of them, from one side to the other
/// or not.
bool areApart(const Ray& ray, const std::vector<PrimitiveHit>& hits) {
    for (std::size_t i = 1; i < hits.size(); ++i) {
        if (hits[i].t - hits[i - 1].t < coincidenceInT(ray, hits[i - 1].t)) return false;
    }
    return true;
}

/// By the parity of crossings on a way out that meets no border.
bool isInside(const MeshShape& shape, const Vec3& point) {
    std::vector<PrimitiveHit> hits;
    for (const Vec3& direction : kAskew) {
        const Ray ray{point, direction};
        shape.tree.allHits(ray, {}, hits);
        if (areApart(ray, hits)) break;
    }
    return hits.size() % 2 == 1;
}

class LeafCrossings {
  public:
    LeafCrossings(const Ray& ray, Index label, CrossingList& out)
        : ray_(ray), label_(label), out_(out) {}

    template <class Solid>
    void operator()(const Solid& solid) const {
        const std::size_t first = out_.size();
        Interval rest = kWholeLine;
        PrimitiveHit hit;
        while (solid.intersect(ray_, rest, hit)) {
            add(hit);
            rest.min = hit.t;
            if (Solid::kKind.convex && out_.size() - first == 2) return;
        }
        if ((out_.size() - first) % 2 == 1) dropTouch(solid, first);
    }

    void operator()(const MeshPointer& shape) const {
        std::vector<PrimitiveHit> hits;
        shape->tree.allHits(ray_, kWholeLine, hits);
        if (hits.size() % 2 == 0 && areApart(ray_, hits)) [[likely]] {
            for (const PrimitiveHit& hit : hits) add(hit);
        } else {
            addChanges(*shape, hits);
        }
    }

    /// A leaf is no combined solid.
    void operator()(const CsgPointer&) const {}

  private:
    void add(PrimitiveHit hit) const {
        hit.leaf = label_;
        out_.push(hit);
    }

    /// Of an odd number of crossings the one that is most along the surface does not cross it.
    template <class Solid>
    void dropTouch(const Solid& solid, std::size_t first) const {
        std::size_t touch = first;
        double least = kInfinity;
        for (std::size_t i = first; i < out_.size(); ++i) {
            const Vec3 normal = solid.surface(out_[i], SurfaceDetail::kShape).normal;
            const double slope = std::fabs(glm::dot(normal, ray_.direction));
            if (slope < least) {
                least = slope;
                touch = i;
            }
        }
        for (std::size_t i = touch + 1; i < out_.size(); ++i) out_[i - 1] = out_[i];
        out_.shorten(out_.size() - 1);
    }

    /// Of hits that are one, a crossing where the line is inside on one side of them alone.
    void addChanges(const MeshShape& shape, const std::vector<PrimitiveHit>& hits) const {
        bool inside = false;
        for (std::size_t i = 0; i < hits.size();) {
            const double reach = hits[i].t + coincidenceInT(ray_, hits[i].t);
            std::size_t next = i + 1;
            double last = hits[i].t;
            for (; next < hits.size() && hits[next].t < reach; ++next) last = hits[next].t;
            const bool insideNext =
                next < hits.size() && isInside(shape, ray_.at(0.5 * last + 0.5 * hits[next].t));
            if (insideNext != inside) add(hits[i]);
            inside = insideNext;
            i = next;
        }
    }

    const Ray& ray_;
    Index label_;
    CrossingList& out_;
};

}  // namespace

bool addLeafCrossings(const CsgLeaf& leaf, Index label, const Ray& ray, CrossingList& crossings) {
    const std::size_t before = crossings.size();
    return inObjectSpace(leaf.transform, ray, [&](const Ray& local) {
        withShape(leaf.shape, LeafCrossings(local, label, crossings));
        return crossings.size() > before;
    });
}

}  // namespace rt
