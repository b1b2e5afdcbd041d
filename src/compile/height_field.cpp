#include "height_field.h"

#include "rt/core/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace rt {
namespace {

std::string sizeText(const HeightGrid& grid) {
    return std::to_string(grid.columns) + "x" + std::to_string(grid.rows);
}

std::string numberText(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return digits;
}

void checkSize(const HeightGrid& grid, const SourceLocation& where) {
    if (grid.columns < 2 || grid.rows < 2) {
        throw SceneError("gr.height_field: needs 2x2 heights or more (got " + sizeText(grid) + ")",
                         where);
    }
    if (grid.columns > kMostHeights / grid.rows) {
        throw LimitError("gr.height_field: " + sizeText(grid) + " heights; " +
                             std::to_string(kMostHeights) + " are the most",
                         where);
    }
}

void checkBase(const HeightGrid& grid, double base, const SourceLocation& where) {
    const double lowest = *std::min_element(grid.heights.begin(), grid.heights.end());
    if (base < lowest) return;
    throw SceneError("gr.height_field: base must lie below all heights, of which the lowest is " +
                         numberText(lowest) + " (got " + numberText(base) + ")",
                     where);
}

class Maker {
  public:
    Maker(const HeightGrid& grid, TriangleMesh& out) : grid_(grid), out_(out) {}

    void addTop() {
        for (std::size_t j = 0; j < grid_.rows; ++j) {
            for (std::size_t i = 0; i < grid_.columns; ++i) {
                out_.positions.emplace_back(x(i), height(i, j), z(j));
                out_.uvs.emplace_back(x(i), 1.0 - z(j));
            }
        }
        for (std::size_t j = 0; j + 1 < grid_.rows; ++j) {
            for (std::size_t i = 0; i + 1 < grid_.columns; ++i) addCell(i, j);
        }
    }

    void addNormals() {
        for (std::size_t j = 0; j < grid_.rows; ++j) {
            for (std::size_t i = 0; i < grid_.columns; ++i) out_.normals.push_back(normal(i, j));
        }
        out_.normalCorners = out_.triangles;
    }

    /// Triangles at the rim: with a side that belongs to no other.
    void addBorder() {
        for (Index t = 0; t < out_.triangles.size(); ++t) {
            const auto cell = t / 2;
            const std::size_t i = cell % (grid_.columns - 1);
            const std::size_t j = cell / (grid_.columns - 1);
            const bool atRim = i == 0 || j == 0 || i + 2 == grid_.columns || j + 2 == grid_.rows;
            if (atRim) out_.border.push_back(t);
        }
    }

    /// Walls and bottom, as flat as they are.
    void close(double base) {
        const std::vector<Index> rim = rimOfTop();
        const auto first = static_cast<Index>(out_.positions.size());
        const auto count = static_cast<Index>(rim.size());
        for (const Index corner : rim) {
            const Vec3 top = out_.positions[corner];
            out_.positions.emplace_back(top.x, base, top.z);
            out_.uvs.push_back(out_.uvs[corner]);
        }
        const Index middle = first + count;
        out_.positions.emplace_back(0.5, base, 0.5);
        out_.uvs.emplace_back(0.5, 0.5);
        for (Index k = 0; k < count; ++k) {
            const Index next = k + 1 < count ? k + 1 : 0;
            addFlat({rim[k], rim[next], first + next});
            addFlat({rim[k], first + next, first + k});
            addFlat({first + k, first + next, middle});
        }
        out_.closed = true;
    }

  private:
    double x(std::size_t i) const {
        return static_cast<double>(i) / static_cast<double>(grid_.columns - 1);
    }
    double z(std::size_t j) const {
        return static_cast<double>(j) / static_cast<double>(grid_.rows - 1);
    }
    double height(std::size_t i, std::size_t j) const {
        return grid_.heights[j * grid_.columns + i];
    }
    Index corner(std::size_t i, std::size_t j) const {
        return static_cast<Index>(j * grid_.columns + i);
    }

    /// Facing +y.
    void addCell(std::size_t i, std::size_t j) {
        const Index a = corner(i, j);
        const Index b = corner(i + 1, j);
        const Index c = corner(i + 1, j + 1);
        const Index d = corner(i, j + 1);
        const double falling = std::fabs(height(i, j) - height(i + 1, j + 1));
        const double rising = std::fabs(height(i + 1, j) - height(i, j + 1));
        if (falling <= rising) {
            add({a, c, b});
            add({a, d, c});
        } else {
            add({a, d, b});
            add({b, d, c});
        }
    }

    void add(const TriangleMesh::Corners& corners) {
        out_.triangles.push_back(corners);
        out_.uvCorners.push_back(corners);
    }

    void addFlat(const TriangleMesh::Corners& corners) {
        add(corners);
        if (!out_.normalCorners.empty()) out_.normalCorners.push_back({kNone, kNone, kNone});
    }

    Vec3 normal(std::size_t i, std::size_t j) const {
        const std::size_t west = i > 0 ? i - 1 : 0;
        const std::size_t east = std::min(i + 1, grid_.columns - 1);
        const std::size_t north = j > 0 ? j - 1 : 0;
        const std::size_t south = std::min(j + 1, grid_.rows - 1);
        const double alongX = (height(east, j) - height(west, j)) / (x(east) - x(west));
        const double alongZ = (height(i, south) - height(i, north)) / (z(south) - z(north));
        const double largest = std::max({1.0, std::fabs(alongX), std::fabs(alongZ)});
        return glm::normalize(Vec3(-alongX, 1.0, -alongZ) / largest);
    }

    /// The vertices around the top, in the order in which walls outside of them face outwards.
    std::vector<Index> rimOfTop() const {
        std::vector<Index> rim;
        const std::size_t right = grid_.columns - 1;
        const std::size_t front = grid_.rows - 1;
        for (std::size_t i = 0; i < right; ++i) rim.push_back(corner(i, 0));
        for (std::size_t j = 0; j < front; ++j) rim.push_back(corner(right, j));
        for (std::size_t i = right; i > 0; --i) rim.push_back(corner(i, front));
        for (std::size_t j = front; j > 0; --j) rim.push_back(corner(0, j));
        return rim;
    }

    const HeightGrid& grid_;
    TriangleMesh& out_;
};

/// What a sample of 1 is stored as.
template <class Sample>
constexpr double kWhole = std::is_same_v<Sample, float>          ? 1.0
                          : std::is_same_v<Sample, std::uint8_t> ? 255.0
                                                                 : 65535.0;

}  // namespace

HeightGrid gridOf(const Image& image) {
    HeightGrid grid;
    grid.columns = static_cast<std::size_t>(image.width);
    grid.rows = static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    grid.heights.reserve(grid.columns * grid.rows);
    std::visit(
        [&](const auto& samples) {
            using Sample = typename std::decay_t<decltype(samples)>::value_type;
            for (std::size_t first = 0; first < samples.size(); first += channels) {
                double sum = 0.0;
                for (std::size_t k = 0; k < channels; ++k) {
                    sum += static_cast<double>(samples[first + k]);
                }
                grid.heights.push_back(sum / (static_cast<double>(channels) * kWhole<Sample>));
            }
        },
        image.samples);
    return grid;
}

TriangleMesh heightFieldMesh(const HeightGrid& grid, const HeightFieldOptions& options,
                             const SourceLocation& where) {
    checkSize(grid, where);
    if (options.base) checkBase(grid, *options.base, where);
    TriangleMesh mesh;
    const std::size_t cells = (grid.columns - 1) * (grid.rows - 1);
    const std::size_t rim = options.base ? 2 * (grid.columns + grid.rows) : 0;
    mesh.positions.reserve(grid.heights.size() + rim);
    mesh.uvs.reserve(grid.heights.size() + rim);
    mesh.triangles.reserve(2 * cells + 3 * rim);
    mesh.uvCorners.reserve(2 * cells + 3 * rim);
    Maker maker(grid, mesh);
    maker.addTop();
    if (options.smooth) maker.addNormals();
    if (options.base) {
        maker.close(*options.base);
    } else {
        maker.addBorder();
    }
    return mesh;
}

}  // namespace rt
