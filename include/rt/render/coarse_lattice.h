// Looking through every other corner first: where the cells between those are smooth, the corners
// in between are what their neighbours say.
#pragma once

#include "rt/render/lattice.h"

#include <cstdint>
#include <vector>

namespace rt {

/// Corners of an area at twice the distance; corner (X, Y) is corner (2 X, 2 Y) of the pixels.
class CoarseLattice {
  public:
    explicit CoarseLattice(const Tile& area);

    Lattice& lattice() { return lattice_; }

    /// Puts into `fine` what the probes of the coarse lattice tell of it, and returns how many
    /// samples the corners need in which they leave something open: `samples`, or 0. A cell is told
    /// by its corners if all were looked through, it is smooth, nothing about its lights is
    /// uncertain, its squared bias is at most `squaredBiasLimit` and no pixel in it is in
    /// `finePixels`. With second differences D across a line, the corner in the middle of its ends
    /// a and b is (a + b) / 2 - D / 8, and that in the middle of the cell its mean - (D_x + D_y)
    /// / 8.
    std::vector<std::uint32_t> refine(Lattice& fine, const std::vector<bool>& finePixels,
                                      double squaredBiasLimit, std::uint32_t samples) const;

  private:
    std::vector<bool> toldCells(const SmoothPixels& cells, const Lattice& fine,
                                const std::vector<bool>& finePixels, double squaredBiasLimit) const;

    Lattice lattice_;
};

}  // namespace rt
