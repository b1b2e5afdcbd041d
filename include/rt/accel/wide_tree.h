// A tree of boxes with eight children a node, over anything that has Bounds.
//
// Boxes are single precision, relative to the frame of the whole tree (centre and a power-of-two
// scale that brings everything into [-1, 1]^3) and rounded outwards; traverse.h adds what rays
// need. The tree is built by the surface area heuristic with binning (Wald, "On fast construction
// of SAH-based bounding volume hierarchies", 2007), the same for any number of threads.
#pragma once

#include "rt/accel/large_array.h"
#include "rt/core/bounds.h"
#include "rt/core/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rt {

inline constexpr int kTreeWidth = 8;

/// What a node's lane leads to: another node, or a run of items.
class ChildRef {
  public:
    static constexpr std::uint32_t kMaxCount = 16;
    static constexpr std::uint32_t kMaxFirst = (1u << 27) - 1;

    static ChildRef node(std::uint32_t index) { return ChildRef(index); }
    static ChildRef leaf(std::uint32_t first, std::uint32_t count) {
        return ChildRef(kLeafBit | (count - 1) << kCountShift | first);
    }
    static ChildRef fromBits(std::uint32_t bits) { return ChildRef(bits); }

    bool isLeaf() const { return (bits_ & kLeafBit) != 0; }
    std::uint32_t nodeIndex() const { return bits_; }
    std::uint32_t first() const { return bits_ & kMaxFirst; }
    std::uint32_t count() const { return (bits_ >> kCountShift & (kMaxCount - 1)) + 1; }
    std::uint32_t bits() const { return bits_; }

    ChildRef() = default;

  private:
    static constexpr std::uint32_t kLeafBit = 1u << 31;
    static constexpr int kCountShift = 27;
    explicit ChildRef(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

/// Eight boxes side by side. Planes are min x, max x, min y, max y, min z, max z; unused lanes hold
/// [+infinity, -infinity] and are met by no ray.
struct alignas(32) WideNode {
    float plane[6][kTreeWidth];
    std::uint32_t child[kTreeWidth];  ///< ChildRef::bits
};

/// Maps world boxes into [-1, 1]^3: (p - centre) * scale.
struct TreeFrame {
    Vec3 centre{0.0};
    double scale = 1.0;  ///< a power of two
};

class WideTree {
  public:
    struct Settings {
        std::uint32_t maxLeafItems = 1;
        int threads = 1;
    };

    /// No node lies deeper than this, whatever the input; it bounds the stack of a traversal.
    static constexpr int kMaxDepth = 64;

    WideTree() = default;
    /// A tree over `boxes`, whose items are their positions. Empty boxes and boxes that are not
    /// finite are left out: no ray meets them. Throws std::length_error beyond 2^27 boxes.
    static WideTree build(std::span<const Bounds> boxes, const Settings& settings);

    bool isEmpty() const { return nodes_.size() == 0; }
    const TreeFrame& frame() const { return frame_; }
    const WideNode* nodes() const { return nodes_.data(); }
    std::size_t nodeCount() const { return nodes_.size(); }
    /// Position in `boxes` of what slot `slot` of a leaf's run holds.
    Index item(std::size_t slot) const { return items_[slot]; }
    const Index* items() const { return items_.data(); }
    std::size_t itemCount() const { return items_.size(); }
    Bounds bounds() const { return bounds_; }
    std::size_t bytes() const { return nodes_.bytes() + items_.bytes(); }

  private:
    friend class WideTreeBuilder;

    TreeFrame frame_;
    Bounds bounds_;
    LargeArray<WideNode> nodes_;  ///< the root first; a tree always has one unless it is empty
    LargeArray<Index> items_;
};

}  // namespace rt
