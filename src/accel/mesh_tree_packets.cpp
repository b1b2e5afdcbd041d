// Packets of rays that share their walk through a mesh tree: a frustum around them passes over
// boxes, one lane a ray tells who meets the boxes that are left, and few rays go on by themselves.
// Leaves are tested ray by ray, as single rays do, so that answers are theirs to the bit.
#include "block_test.h"
#include "ray_packet.h"
#include "rt/accel/mesh_tree.h"
#include "rt/accel/traverse.h"
#include "rt/geometry/triangle.h"

#include <algorithm>
#include <bit>

namespace rt {

#if defined(__AVX2__)

namespace {

/// Rays up to this number go on by themselves.
constexpr int kFewRays = 2;
/// So few of a packet with the same signs are no bundle.
constexpr int kFewAlike = 4;

/// A walk of one packet. `Query` answers visit(ray, block) -> bool whether the ray has had enough,
/// and rangeMax(ray), the end of its range.
template <class Query>
class PacketWalk {
  public:
    PacketWalk(const WideTree& tree, const LargeArray<TriangleBlock>& blocks, Query& query)
        : tree_(tree), blocks_(blocks), query_(query) {}

    void run(std::span<const Ray> rays, std::span<const Interval> ranges) {
        unsigned odd;
        unsigned left = packet_.set(tree_.frame(), rays, ranges, odd);
        for (; odd != 0; odd &= odd - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(odd));
            BoxRay boxRay;
            if (BoxRay::make(tree_.frame(), rays[ray], boxRay)) {
                walkAlone(ChildRef::node(0), static_cast<int>(ray), boxRay,
                          boxRay.tau.below(ranges[ray].min));
            }
        }
        while (left != 0) {
            const unsigned group = packet_.alike(left);
            alive_ = group;
            walkFrom(group);
            left &= ~group;
        }
    }

  private:
    static constexpr int kStackSize = (kTreeWidth - 1) * (WideTree::kMaxDepth + 1) + kTreeWidth;

    void walkFrom(unsigned rays) {
        if (std::popcount(rays) <= kFewAlike) {
            walkSingly(ChildRef::node(0), rays);
            return;
        }
        const PacketFrustum frustum(packet_, rays);
        findEnd();
        int size = 0;
        std::uint32_t current = ChildRef::node(0).bits();
        for (;;) {
            const ChildRef child = ChildRef::fromBits(current);
            if (child.isLeaf())
                visitLeaf(child, rays);
            else if (std::popcount(rays) <= kFewRays)
                walkSingly(child, rays);
            else
                size = pushChildren(frustum, tree_.nodes()[child.nodeIndex()], rays, size);
            do {
                if (size == 0) return;
                --size;
                rays = rays_[size] & alive_ & packet_.reach(entries_[size]);
            } while (rays == 0);
            current = children_[size];
        }
    }

    /// Far ones first.
    int pushChildren(const PacketFrustum& frustum, const WideNode& node, unsigned rays, int size) {
        alignas(32) float entry[kTreeWidth];
        int order[kTreeWidth];
        int count = 0;
        for (unsigned met = frustum.meet(node, tauEnd_, entry); met != 0; met &= met - 1) {
            const int lane = std::countr_zero(met);
            int place = count++;
            for (; place > 0 && entry[order[place - 1]] < entry[lane]; --place) {
                order[place] = order[place - 1];
            }
            order[place] = lane;
        }
        for (int i = 0; i < count; ++i) {
            const unsigned met = rays & packet_.meet(node, order[i], frustum.nearPlane,
                                                     frustum.farPlane, entries_[size]);
            if (met == 0) continue;
            rays_[size] = met;
            children_[size] = node.child[order[i]];
            ++size;
        }
        return size;
    }

    void visitLeaf(ChildRef leaf, unsigned rays) {
        bool changed = false;
        for (; rays != 0; rays &= rays - 1) {
            const int ray = std::countr_zero(rays);
            const double before = query_.rangeMax(ray);
            for (std::uint32_t k = 0; k < leaf.count(); ++k) {
                if (!query_.visit(ray, blocks_[leaf.first() + k])) continue;
                alive_ &= ~(1u << ray);
                break;
            }
            changed = takeEnd(ray, before) || changed;
        }
        if (changed) findEnd();
    }

    void walkSingly(ChildRef from, unsigned rays) {
        for (; rays != 0; rays &= rays - 1) {
            const int ray = std::countr_zero(rays);
            const double before = query_.rangeMax(ray);
            walkAlone(from, ray, packet_.single(ray), packet_.tauMin[ray]);
            takeEnd(ray, before);
        }
    }

    void walkAlone(ChildRef from, int ray, const BoxRay& boxRay, float tauMin) {
        LeafWalk walk(tree_, boxRay, blocks_.data(), sizeof(TriangleBlock));
        walk.run(
            tauMin, boxRay.tau.above(query_.rangeMax(ray)),
            [&](ChildRef leaf, float& tauMax) __attribute__((always_inline)) {
                const double before = query_.rangeMax(ray);
                for (std::uint32_t k = 0; k < leaf.count(); ++k) {
                    if (!query_.visit(ray, blocks_[leaf.first() + k])) continue;
                    alive_ &= ~(1u << ray);
                    return true;
                }
                if (query_.rangeMax(ray) < before) tauMax = boxRay.tau.above(query_.rangeMax(ray));
                return false;
            },
            from);
    }

    bool takeEnd(int ray, double before) {
        const double now = query_.rangeMax(ray);
        if (!(now < before)) return false;
        packet_.endAt(ray, now);
        return true;
    }

    /// No ray that is alive goes on beyond this.
    void findEnd() {
        if (alive_ != 0) tauEnd_ = packet::greatest(packet_.tauMax, alive_);
    }

    const WideTree& tree_;
    const LargeArray<TriangleBlock>& blocks_;
    Query& query_;
    RayPacket packet_;
    unsigned alive_ = 0;
    float tauEnd_ = 0.0f;
    alignas(64) float entries_[kStackSize][packet::kRays];
    std::uint32_t children_[kStackSize];
    unsigned rays_[kStackSize];
};

/// What the rays of a packet bring to the blocks.
class PacketRays {
  public:
    PacketRays(std::span<const Ray> rays, std::span<const Interval> ranges) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            triangleRays_[i] = TriangleRay(rays[i]);
            ranges_[i] = ranges[i];
        }
    }
    double rangeMax(int ray) const { return ranges_[ray].max; }

  protected:
    TriangleRay triangleRays_[packet::kRays];
    Interval ranges_[packet::kRays];
};

class ClosestQuery : public PacketRays {
  public:
    ClosestQuery(std::span<const Ray> rays, std::span<const Interval> ranges)
        : PacketRays(rays, ranges) {
        for (std::size_t i = 0; i < rays.size(); ++i) nearest_[i] = NearestInBlocks(ranges[i]);
    }
    [[gnu::always_inline]] bool visit(int ray, const TriangleBlock& block) {
        BlockTester(triangleRays_[ray]).nearest(block, ranges_[ray], nearest_[ray]);
        return false;
    }
    void take(std::span<PrimitiveHit> hits) const {
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (!nearest_[i].take(hits[i])) hits[i] = {.part = kNone};
        }
    }

  private:
    NearestInBlocks nearest_[packet::kRays];
};

class AnyQuery : public PacketRays {
  public:
    AnyQuery(std::span<const Ray> rays, std::span<const Interval> ranges)
        : PacketRays(rays, ranges) {}
    [[gnu::always_inline]] bool visit(int ray, const TriangleBlock& block) {
        const bool found = BlockTester(triangleRays_[ray]).any(block, ranges_[ray]);
        met_ |= (found ? 1u : 0u) << ray;
        return found;
    }
    void take(std::span<bool> met) const {
        for (std::size_t i = 0; i < met.size(); ++i) met[i] = (met_ >> i & 1) != 0;
    }

  private:
    unsigned met_ = 0;
};

template <class Query, class Answer>
void askInPackets(const WideTree& tree, const LargeArray<TriangleBlock>& blocks,
                  std::span<const Ray> rays, std::span<const Interval> ranges,
                  std::span<Answer> answers) {
    for (std::size_t first = 0; first < rays.size(); first += packet::kRays) {
        const std::size_t count = std::min<std::size_t>(packet::kRays, rays.size() - first);
        const auto some = rays.subspan(first, count);
        const auto someRanges = ranges.subspan(first, count);
        Query query(some, someRanges);
        if (!tree.isEmpty()) {
            PacketWalk<Query> walk(tree, blocks, query);
            walk.run(some, someRanges);
        }
        query.take(answers.subspan(first, count));
    }
}

}  // namespace

void MeshTree::closestHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                           std::span<PrimitiveHit> hits) const {
    askInPackets<ClosestQuery>(tree_, blocks_, rays, ranges, hits);
}

void MeshTree::anyHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                       std::span<bool> met) const {
    askInPackets<AnyQuery>(tree_, blocks_, rays, ranges, met);
}

#else

void MeshTree::closestHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                           std::span<PrimitiveHit> hits) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!closestHit(rays[i], ranges[i], hits[i])) hits[i] = {.part = kNone};
    }
}

void MeshTree::anyHits(std::span<const Ray> rays, std::span<const Interval> ranges,
                       std::span<bool> met) const {
    for (std::size_t i = 0; i < rays.size(); ++i) met[i] = anyHit(rays[i], ranges[i]);
}

#endif

}  // namespace rt
