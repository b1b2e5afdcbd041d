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
Probe between(const Probe& like, const ColorLanes& lanes, const glm::vec3& position,
              std::uint32_t samples) {
    Probe probe = like;
    const glm::vec3 colour(lanes[0], lanes[1], lanes[2]);
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
            if (!wasSeen(cell) || cells.isUncertain(cell)) continue;
            const std::optional<SmoothPixel> found = cells.find(cell, 0.0);
            if (!found || found->squaredBias > squaredBiasLimit) continue;
            told[cell] = finePixels.empty() || !hasFinePixel(kSpacing * x - fine.corners.x0,
                                                             kSpacing * y - fine.corners.y0);
        }
    }
    return told;
}

bool CoarseLattice::isDeepAmongTold(const std::vector<bool>& told, int x, int y) const {
    const Tile& corners = lattice_.corners;
    for (int v = std::max(y - 1, corners.y0); v < std::min(y + 2, corners.y1 - 1); ++v) {
        for (int u = std::max(x - 1, corners.x0); u < std::min(x + 2, corners.x1 - 1); ++u) {
            if (!told[lattice_.offset(u, v)]) return false;
        }
    }
    return true;
}

/// The pixels of a told cell, each by its four corners of the fine lattice.
void CoarseLattice::tellPixels(const SmoothPixels& cells, int x, int y, Film& film,
                               ToldPixels& pixels) const {
    const std::size_t cell = lattice_.offset(x, y);
    const std::size_t below = cell + lattice_.stride();
    const ColorLanes a = cells.colorAt(cell);
    const ColorLanes b = cells.colorAt(cell + 1);
    const ColorLanes c = cells.colorAt(below);
    const ColorLanes d = cells.colorAt(below + 1);
    const ColorLanes correction = cells.correctionAt(cell);
    const ColorLanes corner[3][3] = {
        {a, cells.middleOfTop(cell), b},
        {cells.middleOfLeft(cell), cells.centreOf(cell), cells.middleOfLeft(cell + 1)},
        {c, cells.middleOfTop(below), d}};
    const auto bias = static_cast<float>(cells.at(cell, 0.0).squaredBias);
    for (int v = 0; v < kSpacing; ++v) {
        for (int u = 0; u < kSpacing; ++u) {
            const int px = kSpacing * x + u;
            const int py = kSpacing * y + v;
            if (px < film.area.x0 || px >= film.area.x1) continue;
            if (py < film.area.y0 || py >= film.area.y1) continue;
            // At half the distance second differences are a quarter.
            const ColorLanes value = 0.25F * (corner[v][u] + corner[v][u + 1] + corner[v + 1][u] +
                                              corner[v + 1][u + 1] - correction);
            film.at(px, py) = {asColor(value), Color(0.0), 1};
            pixels[film.offset(px, py)] = bias;
        }
    }
}

/// Puts what is told where corners of pixels are.
struct CoarseLattice::Refinement {
    Lattice& fine;
    std::vector<std::uint32_t>& ends;

    /// `probe()` is asked for only if it is wanted.
    template <class MakeProbe>
    void put(int x, int y, bool wanted, const MakeProbe& probe) {
        if (x < fine.corners.x0 || x >= fine.corners.x1) return;
        if (y < fine.corners.y0 || y >= fine.corners.y1) return;
        if (wanted) fine.probes[fine.offset(x, y)] = probe();
        ends[fine.offset(x, y)] = 0;
    }
};

CoarseLattice::Told CoarseLattice::refine(Lattice& fine, Film& film,
                                          const std::vector<bool>& finePixels,
                                          double squaredBiasLimit, std::uint32_t samples) const {
    SmoothPixels cells(lattice_);
    cells.measureAll();
    const std::vector<bool> told = toldCells(cells, fine, finePixels, squaredBiasLimit);
    Told result{std::vector<std::uint32_t>(fine.probes.size(), samples),
                ToldPixels(film.pixels.size(), kUntold)};
    Refinement refinement{fine, result.ends};
    // A line between two cells is told if both are, and as both tell it alike.
    const std::size_t stride = lattice_.stride();
    const Tile& corners = lattice_.corners;
    for (int y = corners.y0; y < corners.y1; ++y) {
        for (int x = corners.x0; x < corners.x1; ++x) {
            const std::size_t cell = lattice_.offset(x, y);
            const Probe& a = lattice_.probes[cell];
            const bool wanted = !isDeepAmongTold(told, x, y);
            refinement.put(kSpacing * x, kSpacing * y, wanted, [&] { return a; });
            if (!told[cell]) continue;
            tellPixels(cells, x, y, film, result.pixels);
            const Probe& b = lattice_.probes[cell + 1];
            const Probe& c = lattice_.probes[cell + stride];
            const Probe& d = lattice_.probes[cell + stride + 1];
            refinement.put(kSpacing * x + 1, kSpacing * y + 1, wanted, [&] {
                return between(a, cells.centreOf(cell),
                               0.25F * (a.position + b.position + c.position + d.position),
                               samples);
            });
            if (y > corners.y0 && told[cell - stride]) {
                refinement.put(kSpacing * x + 1, kSpacing * y, wanted, [&] {
                    return between(a, cells.middleOfTop(cell), 0.5F * (a.position + b.position),
                                   samples);
                });
            }
            if (x > corners.x0 && told[cell - 1]) {
                refinement.put(kSpacing * x, kSpacing * y + 1, wanted, [&] {
                    return between(a, cells.middleOfLeft(cell), 0.5F * (a.position + c.position),
                                   samples);
                });
            }
        }
    }
    return result;
}

}  // namespace rt
