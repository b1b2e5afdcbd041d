#include "rt/render/coarse_lattice.h"

#include <algorithm>

namespace rt {
namespace {

constexpr int kSpacing = 2;

int halved(int x) {
    return x >> 1;
}

/// Cells whose corners cover all corners of the area.
Tile coarseArea(const Tile& area) {
    return {halved(area.x0), halved(area.y0), halved(area.x1 + 1), halved(area.y1 + 1)};
}

/// A probe between others: with the evidence of `like`.
Probe between(const Probe& like, const glm::vec3& colour, const glm::vec3& position,
              std::uint32_t samples) {
    Probe probe = like;
    probe.samples = samples;
    probe.sum = colour * static_cast<float>(samples);
    probe.half = colour * static_cast<float>(samples / 2);
    probe.position = position;
    return probe;
}

}  // namespace

CoarseLattice::CoarseLattice(const Tile& area) : lattice_(coarseArea(area)) {
    lattice_.spacing = kSpacing;
}

std::vector<bool> CoarseLattice::toldCells(const SmoothPixels& cells, const Lattice& fine,
                                           const std::vector<bool>& finePixels,
                                           double squaredBiasLimit) const {
    const Tile& corners = lattice_.corners;
    std::vector<bool> told(lattice_.probes.size());
    const int width = fine.corners.width() - 1;
    const int height = fine.corners.height() - 1;
    const auto hasFinePixel = [&](int x, int y) {
        for (int v = std::max(y, 0); v < std::min(y + kSpacing, height); ++v) {
            for (int u = std::max(x, 0); u < std::min(x + kSpacing, width); ++u) {
                if (finePixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(u)]) {
                    return true;
                }
            }
        }
        return false;
    };
    const auto wasSeen = [&](std::size_t cell) {
        const std::size_t below = cell + lattice_.stride();
        return lattice_.probes[cell].samples > 0 && lattice_.probes[cell + 1].samples > 0 &&
               lattice_.probes[below].samples > 0 && lattice_.probes[below + 1].samples > 0;
    };
    for (int y = corners.y0; y + 1 < corners.y1; ++y) {
        for (int x = corners.x0; x + 1 < corners.x1; ++x) {
            const std::size_t cell = lattice_.offset(x, y);
            if (!wasSeen(cell) || !cells.isSmooth(cell) || cells.isUncertain(cell)) continue;
            if (cells.at(cell, 0.0).squaredBias > squaredBiasLimit) continue;
            told[cell] = finePixels.empty() || !hasFinePixel(kSpacing * x - fine.corners.x0,
                                                             kSpacing * y - fine.corners.y0);
        }
    }
    return told;
}

std::vector<std::uint32_t> CoarseLattice::refine(Lattice& fine, const std::vector<bool>& finePixels,
                                                 double squaredBiasLimit,
                                                 std::uint32_t samples) const {
    SmoothPixels cells(lattice_);
    cells.measure();
    const std::vector<bool> told = toldCells(cells, fine, finePixels, squaredBiasLimit);
    std::vector<std::uint32_t> ends(fine.probes.size(), samples);
    const auto put = [&](int x, int y, const Probe& probe) {
        if (x < fine.corners.x0 || x >= fine.corners.x1) return;
        if (y < fine.corners.y0 || y >= fine.corners.y1) return;
        fine.probes[fine.offset(x, y)] = probe;
        ends[fine.offset(x, y)] = 0;
    };
    // A line between two cells is told if both are, and as both tell it alike.
    const std::size_t stride = lattice_.stride();
    const Tile& corners = lattice_.corners;
    for (int y = corners.y0; y < corners.y1; ++y) {
        for (int x = corners.x0; x < corners.x1; ++x) {
            const std::size_t cell = lattice_.offset(x, y);
            const Probe& a = lattice_.probes[cell];
            put(kSpacing * x, kSpacing * y, a);
            if (!told[cell]) continue;
            const Probe& b = lattice_.probes[cell + 1];
            const Probe& c = lattice_.probes[cell + stride];
            const Probe& d = lattice_.probes[cell + stride + 1];
            const glm::vec3 bend = 12.0F * cells.correctionAt(cell);
            put(kSpacing * x + 1, kSpacing * y + 1,
                between(a, 0.25F * (a.mean() + b.mean() + c.mean() + d.mean()) - bend / 8.0F,
                        0.25F * (a.position + b.position + c.position + d.position), samples));
            const auto putMiddle = [&](int u, int v, const Probe& from, const Probe& to,
                                       const glm::vec3& difference) {
                put(u, v,
                    between(from, 0.5F * (from.mean() + to.mean()) - difference / 8.0F,
                            0.5F * (from.position + to.position), samples));
            };
            if (y > corners.y0 && told[cell - stride]) {
                putMiddle(kSpacing * x + 1, kSpacing * y, a, b, cells.across(cell));
            }
            if (x > corners.x0 && told[cell - 1]) {
                putMiddle(kSpacing * x, kSpacing * y + 1, a, c, cells.down(cell));
            }
        }
    }
    return ends;
}

}  // namespace rt
