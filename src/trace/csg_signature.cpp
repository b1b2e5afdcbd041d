#include "csg_signature.h"

#include "csg_crossings.h"
#include "rt/sampling/random.h"
#include "scene_intersect.h"
#include "with_shape.h"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace rt {
namespace {

/// All crossings of parts in the boxes of what they are parts of. Unlike those that decide what is
/// seen, they count where another part is missed that is needed, too.
class PartCrossings {
  public:
    PartCrossings(const CsgShape& csg, const Ray& ray, Interval range)
        : csg_(csg), ray_(ray), range_(range), made_(slabs_.make(ray)) {
        gather(0);
    }

    std::uint64_t signature() {
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const PrimitiveHit& a, const PrimitiveHit& b) {
                      return a.t != b.t ? a.t < b.t : a.leaf < b.leaf;
                  });
        std::uint64_t key = 0;
        for (const PrimitiveHit& hit : crossings_) {
            const Shape& shape = csg_.leaves[hit.leaf].shape;
            const bool isMesh = std::holds_alternative<MeshPointer>(shape);
            key = subKey(key, std::uint64_t{hit.leaf} << 32 | (isMesh ? 0 : hit.part));
        }
        return key;
    }

  private:
    void gather(Index index) {
        const CsgNode& node = csg_.nodes[index];
        if (made_ && !slabs_.meets(node.box, range_)) return;
        if (node.needsAll() && !meets(node.box.bounds())) return;
        if (node.leaf != kNone) {
            addLeaf(node.leaf);
        } else if (made_ && node.crowd != kNone) {
            visitCrowd(csg_.crowds[node.crowd], ray_, range_, [&](Index child, Interval now) {
                gather(child);
                return now.max;
            });
        } else {
            for (Index child = index + 1; child < node.end; child = csg_.nodes[child].end) {
                gather(child);
            }
        }
    }

    void addLeaf(Index leaf) {
        std::size_t kept = crossings_.size();
        addLeafCrossings(csg_.leaves[leaf], leaf, ray_, crossings_);
        for (std::size_t i = kept; i < crossings_.size(); ++i) {
            const double t = crossings_[i].t;
            if (t > range_.min && t <= range_.max) crossings_[kept++] = crossings_[i];
        }
        crossings_.shorten(kept);
    }

    /// Box tests may round differently on other processors, this may not.
    bool meets(const Bounds& box) const {
        Interval rest = range_;
        for (int axis = 0; axis < 3; ++axis) {
            const double slope = ray_.direction[axis];
            const double low = box.min[axis] - ray_.origin[axis];
            const double high = box.max[axis] - ray_.origin[axis];
            if (slope == 0.0) {
                if (low > 0.0 || high < 0.0) return false;
                continue;
            }
            rest.min = std::max(rest.min, (slope > 0.0 ? low : high) / slope);
            rest.max = std::min(rest.max, (slope > 0.0 ? high : low) / slope);
        }
        return rest.min <= rest.max;
    }

    const CsgShape& csg_;
    const Ray& ray_;
    Interval range_;
    SlabRay slabs_;
    bool made_;
    CrossingList crossings_;
};

}  // namespace

std::uint64_t csgSignature(const RenderScene& scene, const Ray& ray, Interval range) {
    std::uint64_t sum = 0;
    forEachMet(scene, ray, range, [&](Index item) {
        const Instance& instance = scene.instances[item];
        const auto* csg = std::get_if<CsgPointer>(&scene.shapes[instance.shape]);
        if (!csg) return;
        inObjectSpace(instance.transform, ray, [&](const Ray& local) {
            const std::uint64_t one = PartCrossings(**csg, local, range).signature();
            if (one != 0) sum += subKey(one, item);
            return false;
        });
    });
    return sum;
}

}  // namespace rt
