// Looking through every other corner first: where the cells between those are smooth, the corners
// in between are what their neighbours say.
#pragma once

#include "rt/render/film.h"
#include "rt/render/smooth_pixels.h"

#include <cstdint>
#include <vector>

namespace rt {

/// Corners of an area at twice the distance; corner (X, Y) is corner (2 X, 2 Y) of the pixels.
class CoarseLattice {
  public:
    explicit CoarseLattice(const Tile& area);

    Lattice& lattice() { return lattice_; }

    /// What the coarse lattice tells.
    struct Told {
        std::vector<std::uint32_t> ends;  ///< samples that the corners of pixels need
        ToldPixels pixels;
    };

    /// Puts into `fine` and `film` what the probes of the coarse lattice tell of them. Corners of
    /// which they leave something open need `samples`, others 0. A cell is told
    /// by its corners if all were looked through, it is smooth, nothing about its lights is
    /// uncertain, its squared bias is at most `squaredBiasLimit` and no pixel in it is in
    /// `finePixels`. Corners that only told pixels have, or are next to, are left out.
    Told refine(Lattice& fine, Film& film, const std::vector<bool>& finePixels,
                double squaredBiasLimit, std::uint32_t samples) const;

  private:
    struct Refinement;

    std::vector<bool> toldCells(const SmoothPixels& cells, const Lattice& fine,
                                const std::vector<bool>& finePixels, double squaredBiasLimit) const;
    bool isDeepAmongTold(const std::vector<bool>& told, int x, int y) const;
    void tellPixels(const SmoothPixels& cells, int x, int y, Film& film, ToldPixels& pixels) const;

    Lattice lattice_;
};

}  // namespace rt
