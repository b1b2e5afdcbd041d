#include "rt/compile/mesh_normals.h"

#include "normal_tree.h"
#include "rt/core/numeric.h"
#include "rt/core/parallel.h"
#include "rt/math/portable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rt {
namespace {

double largestComponent(const Vec3& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

// Between these sizes of two vectors, their products and the squares of those neither overflow nor
// lose bits.
constexpr double kSmall = 0x1p-200;
constexpr double kLarge = 0x1p200;

/// v, times a power of two where its size would be trouble; 0 and what is not finite stay as is.
Vec3 scaledNearOne(const Vec3& v) {
    const double largest = largestComponent(v);
    if ((kSmall <= largest && largest <= kLarge) || !(largest > 0.0 && largest < kInfinity))
        return v;
    return v * std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022));
}

/// b - a without overflow, times a power of two.
Vec3 edgeDirection(const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a;
    if (largestComponent(edge) < kInfinity) return scaledNearOne(edge);
    return scaledNearOne(0.5 * b - 0.5 * a);
}

Vec3 accurateCross(const Vec3& a, const Vec3& b) {
    return {differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
            differenceOfProducts(a.x, b.y, a.y, b.x)};
}

double length(const Vec3& v) {
    return std::sqrt(glm::dot(v, v));
}

class VertexSmoother {
  public:
    VertexSmoother(TriangleMesh& mesh, std::span<const Vec3> faceNormals, double angleDegrees)
        : mesh_(mesh),
          faceNormals_(faceNormals),
          cosLimit_(portable::cosDegrees(angleDegrees) - kUnitDotError),
          cosHalf_(portable::cosDegrees(0.5 * angleDegrees) + 2.0 * kUnitDotError) {}

    /// Gives the corners of one vertex their normals, numbered on from those of the mesh.
    void smooth(std::span<const Index> corners);

    std::vector<Vec3> normals;

  private:
    struct Result {
        NormalSum sum;
        Index normal;
    };

    Index& slot(Index corner) { return mesh_.normalCorners[corner / 3][corner % 3]; }
    bool gather(std::span<const Index> corners);
    NormalSum sumAround(const Vec3& normal) const;
    bool areAllNear() const;
    Index store(const NormalSum& sum);

    TriangleMesh& mesh_;
    std::span<const Vec3> faceNormals_;
    double cosLimit_;
    double cosHalf_;  ///< normals within this of one are within the limit of each other
    std::vector<WeightedNormal> shares_;
    std::vector<Index> corners_;
    std::vector<Result> results_;
    NormalTree tree_;
};

// From this many faces on, a tree is searched instead of every pair compared.
constexpr std::size_t kManyFaces = 48;

double angleAt(const TriangleMesh& mesh, Index corner) {
    const TriangleMesh::Corners& triangle = mesh.triangles[corner / 3];
    const Vec3& apex = mesh.positions[triangle[corner % 3]];
    const Vec3 e = edgeDirection(apex, mesh.positions[triangle[(corner + 1) % 3]]);
    const Vec3 f = edgeDirection(apex, mesh.positions[triangle[(corner + 2) % 3]]);
    return portable::atan2(length(accurateCross(e, f)), glm::dot(e, f));
}

/// Fills shares_ and corners_; false if every corner here has its normal.
bool VertexSmoother::gather(std::span<const Index> corners) {
    shares_.clear();
    corners_.clear();
    bool wanted = false;
    for (const Index corner : corners) {
        const Vec3& normal = faceNormals_[corner / 3];
        if (normal == Vec3(0.0)) continue;
        wanted = wanted || slot(corner) == kNone;
        shares_.push_back({normal, 0.0});
        corners_.push_back(corner);
    }
    if (!wanted) return false;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        shares_[i].weight = angleAt(mesh_, corners_[i]);
    }
    return true;
}

NormalSum VertexSmoother::sumAround(const Vec3& normal) const {
    if (shares_.size() >= kManyFaces) return tree_.sumWithin(normal, cosLimit_);
    NormalSum sum;
    for (const WeightedNormal& share : shares_) {
        if (glm::dot(normal, share.normal) >= cosLimit_) sum.add(share);
    }
    return sum;
}

Index VertexSmoother::store(const NormalSum& sum) {
    const double size = length(sum.vector);
    // What is left after cancellation to rounding has no direction.
    if (!(size > gamma(4) * static_cast<double>(sum.count) * sum.weight)) return kNone;
    normals.push_back(sum.vector / size);
    return static_cast<Index>(mesh_.normals.size() + normals.size() - 1);
}

/// Whether all corners have the same sum: a tree may add up in another order.
bool VertexSmoother::areAllNear() const {
    if (shares_.size() >= kManyFaces) return false;
    const Vec3& first = shares_[0].normal;
    return std::all_of(shares_.begin(), shares_.end(), [&](const WeightedNormal& share) {
        return glm::dot(first, share.normal) >= cosHalf_;
    });
}

void VertexSmoother::smooth(std::span<const Index> corners) {
    if (!gather(corners)) return;
    if (areAllNear()) {
        const NormalSum sum = sumAround(shares_[0].normal);
        if (sum.allEqual) return;
        const Index normal = store(sum);
        for (const Index corner : corners_) {
            if (slot(corner) == kNone) slot(corner) = normal;
        }
        return;
    }
    if (shares_.size() >= kManyFaces) tree_.build(shares_);
    results_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (slot(corners_[i]) != kNone) continue;
        const NormalSum sum = sumAround(shares_[i].normal);
        if (sum.allEqual) continue;
        // Most vertices are smooth all round or have a few creases: the last results come again.
        const std::size_t looked = std::min(results_.size(), kManyFaces);
        const auto same =
            std::find_if(results_.end() - static_cast<std::ptrdiff_t>(looked), results_.end(),
                         [&](const Result& known) { return known.sum.vector == sum.vector; });
        if (same == results_.end()) {
            results_.push_back({sum, store(sum)});
            slot(corners_[i]) = results_.back().normal;
        } else {
            slot(corners_[i]) = same->normal;
        }
    }
}

/// Chunks of vertices, whatever the threads; their normals follow one another in the mesh.
void smoothVertices(TriangleMesh& mesh, const MeshTopology& topology,
                    std::span<const Vec3> faceNormals, double angleDegrees, int threads) {
    constexpr std::size_t kChunk = std::size_t{1} << 14;
    const std::size_t vertices = topology.vertexCount();
    const std::size_t chunks = (vertices + kChunk - 1) / kChunk;
    const auto given = static_cast<Index>(mesh.normals.size());
    std::vector<std::vector<Vec3>> normals(chunks);
    const auto eachVertex = [&](std::size_t chunk, auto&& use) {
        const std::size_t end = std::min(vertices, (chunk + 1) * kChunk);
        for (std::size_t v = chunk * kChunk; v < end; ++v) {
            use(topology.cornersAt(static_cast<Index>(v)));
        }
    };
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        VertexSmoother smoother(mesh, faceNormals, angleDegrees);
        eachVertex(chunk, [&](std::span<const Index> corners) { smoother.smooth(corners); });
        normals[chunk] = std::move(smoother.normals);
    });
    std::vector<std::size_t> first(chunks + 1, 0);
    for (std::size_t i = 0; i < chunks; ++i) first[i + 1] = first[i] + normals[i].size();
    mesh.normals.resize(given + first[chunks]);
    forEachIndex(chunks, threads, [&](std::size_t chunk, int) {
        std::copy(normals[chunk].begin(), normals[chunk].end(),
                  mesh.normals.begin() + static_cast<std::ptrdiff_t>(given + first[chunk]));
        eachVertex(chunk, [&](std::span<const Index> corners) {
            for (const Index corner : corners) {
                Index& normal = mesh.normalCorners[corner / 3][corner % 3];
                const bool isNew = normal >= given && normal < kGeometricNormal;
                if (isNew) normal += static_cast<Index>(first[chunk]);
            }
        });
    });
}

/// Turns the marks into kNone; true if some corner has a normal.
bool settleMarks(TriangleMesh& mesh) {
    bool any = false;
    for (TriangleMesh::Corners& corners : mesh.normalCorners) {
        for (Index& corner : corners) {
            if (corner == kGeometricNormal) corner = kNone;
            any = any || corner != kNone;
        }
    }
    return any;
}

}  // namespace

Vec3 normalizedOrZero(const Vec3& v) {
    const Vec3 scaled = scaledNearOne(v);
    const double size = length(scaled);
    return size > 0.0 && size < kInfinity ? scaled / size : Vec3(0.0);
}

Vec3 unitFaceNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 e = edgeDirection(a, b);
    const Vec3 f = edgeDirection(a, c);
    const Vec3 across = accurateCross(e, f);
    // |across| = |e| |f| sin.
    const double least = kNoAreaSine * kNoAreaSine * glm::dot(e, e) * glm::dot(f, f);
    if (!(glm::dot(across, across) > least)) return Vec3(0.0);
    return normalizedOrZero(across);
}

void smoothNormals(TriangleMesh& mesh, const MeshTopology& topology,
                   std::span<const Vec3> faceNormals, double smoothAngleDegrees, int threads) {
    if (mesh.normalCorners.empty()) {
        mesh.normalCorners.assign(mesh.triangles.size(), {kNone, kNone, kNone});
    }
    if (smoothAngleDegrees > 0.0) {
        smoothVertices(mesh, topology, faceNormals, smoothAngleDegrees, threads);
    }
    if (!settleMarks(mesh)) mesh.normalCorners = {};
}

}  // namespace rt
