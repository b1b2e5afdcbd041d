#include "build_presplit.h"

#include "build_wide_tree.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rt {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 14;

/// Refs that splitting may add, as a part of the triangles.
constexpr double kBudget = 0.5;
/// Splitting has to bring the areas of all boxes below this part of what they were.
constexpr double kWorthwhile = 0.5;
/// No triangle falls into more pieces.
constexpr double kMostPieces = 1024.0;

template <class Run>
void forEachChunk(std::size_t count, int threads, Run&& run) {
    forEachIndex((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, int) {
        run(chunk, chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
    });
}

struct Corners {
    Vec3 a, b, c;
};

Corners cornersInFrame(const TriangleMesh& mesh, const TreeFrame& frame, std::size_t triangle) {
    const TriangleMesh::Corners& at = mesh.triangles[triangle];
    return {(mesh.positions[at[0]] - frame.centre) * frame.scale,
            (mesh.positions[at[1]] - frame.centre) * frame.scale,
            (mesh.positions[at[2]] - frame.centre) * frame.scale};
}

double halfArea(const Vec3& extent) {
    return extent.x * extent.y + extent.y * extent.z + extent.z * extent.x;
}

/// Half the area of a triangle's box, and of infinitely many boxes that follow it: the sum of its
/// three projections. What lies between can be gained by splitting.
struct BoxWaste {
    explicit BoxWaste(const Corners& t) {
        const Vec3 extent = glm::max(glm::max(t.a, t.b), t.c) - glm::min(glm::min(t.a, t.b), t.c);
        const Vec3 doubled = glm::abs(glm::cross(t.b - t.a, t.c - t.a));
        box = halfArea(extent);
        least = std::min(box, 0.5 * (doubled.x + doubled.y + doubled.z));
    }
    double box, least;
    /// The number of pieces that minimises the sum of (waste / pieces) is proportional to this.
    double weight() const { return std::sqrt(box - least); }
};

struct WasteSums {
    double box = 0.0;
    double least = 0.0;
    double weight = 0.0;

    void add(const WasteSums& other) {
        box += other.box;
        least += other.least;
        weight += other.weight;
    }
};

WasteSums measure(const TriangleMesh& mesh, const TreeFrame& frame, int threads) {
    const std::size_t count = mesh.triangles.size();
    std::vector<WasteSums> parts((count + kChunk - 1) / kChunk);
    forEachChunk(count, threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const BoxWaste waste(cornersInFrame(mesh, frame, i));
            parts[chunk].add({waste.box, waste.least, waste.weight()});
        }
    });
    WasteSums sums;
    for (const WasteSums& part : parts) sums.add(part);
    return sums;
}

/// Pieces for one unit of weight; 0 where splitting is not worth its while.
double piecesPerWeight(const WasteSums& sums, std::size_t count) {
    if (!(sums.weight > 0.0)) return 0.0;
    const double pieces = (1.0 + kBudget) * static_cast<double>(count);
    const double after = sums.least + sums.weight * sums.weight / pieces;
    return after < kWorthwhile * sums.box ? pieces / sums.weight : 0.0;
}

std::uint32_t piecesOf(const Corners& triangle, double perWeight) {
    const double pieces = BoxWaste(triangle).weight() * perWeight;
    return static_cast<std::uint32_t>(std::clamp(pieces, 1.0, kMostPieces));
}

/// A convex part of a triangle. Each clip adds at most one corner.
class Piece {
  public:
    explicit Piece(const Corners& t) : corners_{t.a, t.b, t.c}, size_(3) {}

    Bounds bounds() const {
        Bounds box;
        for (int i = 0; i < size_; ++i) box.unite(corners_[static_cast<std::size_t>(i)]);
        return box;
    }

    /// The part on one side of the plane (side -1: below); what is on it belongs to both.
    Piece clipped(int axis, double plane, double side) const {
        Piece result;
        for (int i = 0; i < size_; ++i) {
            const Vec3& from = corners_[static_cast<std::size_t>(i)];
            const Vec3& to = corners_[static_cast<std::size_t>((i + 1) % size_)];
            const double a = side * (from[axis] - plane);
            const double b = side * (to[axis] - plane);
            if (a >= 0.0) result.add(from);
            if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) {
                Vec3 crossing = from + (a / (a - b)) * (to - from);
                crossing[axis] = plane;
                result.add(crossing);
            }
        }
        return result;
    }
    bool isFull() const { return size_ == kMostCorners; }

  private:
    static constexpr int kMostCorners = 24;

    Piece() = default;
    void add(const Vec3& corner) {
        if (size_ < kMostCorners) corners_[static_cast<std::size_t>(size_++)] = corner;
    }

    std::array<Vec3, kMostCorners> corners_;
    int size_ = 0;
};

/// The plane in ]low, high[ that is a multiple of the largest power of two: triangles side by side
/// are cut by the same planes, which the build can then part them at.
double coarsestPlane(double low, double high) {
    double step = std::exp2(std::ilogb(high - low) + 2);
    for (int level = 0; level < 4; ++level, step *= 0.5) {
        const double plane = step * (std::floor(low / step) + 1.0);
        if (low < plane && plane < high) return plane;
    }
    return 0.5 * low + 0.5 * high;
}

template <class Emit>
void splitPiece(const Piece& piece, std::uint32_t pieces, const Emit& emit) {
    const Bounds box = piece.bounds();
    const Vec3 extent = box.extent();
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    // Below the resolution of the boxes nothing is gained.
    constexpr double kLeastExtent = 0x1p-20;
    if (pieces < 2 || piece.isFull() || !(extent[axis] > kLeastExtent)) {
        emit(box);
        return;
    }
    const double plane = coarsestPlane(box.min[axis], box.max[axis]);
    const double share = (plane - box.min[axis]) / extent[axis];
    const auto left =
        std::clamp(static_cast<std::uint32_t>(std::lround(share * pieces)), 1u, pieces - 1);
    splitPiece(piece.clipped(axis, plane, -1.0), left, emit);
    splitPiece(piece.clipped(axis, plane, 1.0), pieces - left, emit);
}

BoxRef refTo(std::size_t triangle, const Bounds& boxInFrameAlready) {
    BoxRef ref;
    ref.box = boxInFrame(TreeFrame{}, boxInFrameAlready);
    ref.setItem(static_cast<Index>(triangle));
    return ref;
}

}  // namespace

RefArray triangleRefs(const TriangleMesh& mesh, const TreeFrame& frame, int threads) {
    const std::size_t count = mesh.triangles.size();
    const double perWeight = piecesPerWeight(measure(mesh, frame, threads), count);
    const auto writePieces = [&](std::size_t i, std::uint32_t pieces, auto&& put) {
        splitPiece(Piece(cornersInFrame(mesh, frame, i)), pieces,
                   [&](const Bounds& box) { put(refTo(i, box)); });
    };
    std::vector<std::vector<BoxRef>> parts((count + kChunk - 1) / kChunk);
    std::vector<std::size_t> first(parts.size() + 1, 0);
    if (perWeight > 0.0) {
        forEachChunk(count, threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t pieces = piecesOf(cornersInFrame(mesh, frame, i), perWeight);
                writePieces(i, pieces, [&](const BoxRef& ref) { parts[chunk].push_back(ref); });
            }
            first[chunk + 1] = parts[chunk].size();
        });
        for (std::size_t i = 0; i < parts.size(); ++i) first[i + 1] += first[i];
    } else {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            first[i + 1] = std::min(count, (i + 1) * kChunk);
        }
    }
    RefArray result{LargeArray<BoxRef>(first.back()), first.back()};
    forEachChunk(count, threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        BoxRef* to = result.refs.data() + first[chunk];
        if (perWeight > 0.0) {
            std::copy(parts[chunk].begin(), parts[chunk].end(), to);
            return;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const Corners t = cornersInFrame(mesh, frame, i);
            *to++ =
                refTo(i, {glm::min(glm::min(t.a, t.b), t.c), glm::max(glm::max(t.a, t.b), t.c)});
        }
    });
    return result;
}

}  // namespace rt
