// Where a point of a repeated image lies among its texels.
#pragma once

#include "rt/core/vec.h"

#include <cmath>
#include <cstddef>

namespace rt {

/// x - floor(x), in [0,1); 0 for what is not finite.
inline double repeated(double x) {
    const double part = x - std::floor(x);
    // A tiny negative x rounds to 1.
    return part < 1.0 ? part : 0.0;
}

/// The four texels around a point, and its place between their centres.
struct TexelCell {
    std::size_t left, right;   ///< columns
    std::size_t upper, lower;  ///< rows
    double f, g;               ///< from left to right, from upper to lower

    /// `at` in [0,1] x [0,1] from the top left. Beyond the border lies the other side of the image,
    /// or with `held` what lies at the border.
    TexelCell(const Vec2& at, int width, int height, bool held = false) {
        f = place(at.x, width, held, left, right);
        g = place(at.y, height, held, upper, lower);
    }

    /// In this form a constant stays itself to the bit.
    double blend(double upperLeft, double upperRight, double lowerLeft, double lowerRight) const {
        const double above = upperLeft + f * (upperRight - upperLeft);
        const double below = lowerLeft + f * (lowerRight - lowerLeft);
        return above + g * (below - above);
    }

  private:
    static double place(double part, int count, bool held, std::size_t& before,
                        std::size_t& after) {
        const double x = part * count - 0.5;
        const double cell = std::floor(x);
        const int i = static_cast<int>(cell);
        const int first = held ? 0 : count - 1;
        const int last = held ? count - 1 : 0;
        before = static_cast<std::size_t>(i < 0 ? first : i);
        after = static_cast<std::size_t>(i + 1 < count ? i + 1 : last);
        return x - cell;
    }
};

}  // namespace rt
