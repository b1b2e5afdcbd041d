// The corners of an area's pixels, each looked through once. Where the four corners of a pixel see
// the same surfaces, and nothing but smooth shading between them, the pixel needs no samples of its
// own: neighbours share their corners, so an even area costs one probe a pixel.
#pragma once

#include "rt/render/tiles.h"
#include "rt/trace/probe.h"
#include "rt/trace/trace_kernel.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rt {

/// Row-major probes of the corners of `area`; corner (x, y) is the upper left one of pixel (x, y).
struct Lattice {
    explicit Lattice(const Tile& area)
        : corners{area.x0, area.y0, area.x1 + 1, area.y1 + 1},
          probes(static_cast<std::size_t>(corners.width()) *
                 static_cast<std::size_t>(corners.height())) {}

    std::size_t stride() const { return static_cast<std::size_t>(corners.width()); }
    std::size_t offset(int x, int y) const {
        return static_cast<std::size_t>(y - corners.y0) * stride() +
               static_cast<std::size_t>(x - corners.x0);
    }

    Tile corners;
    std::vector<Probe> probes;
    int spacing = 1;  ///< pixels from one corner to the next
};

/// Of each pixel of an area the squared bias that is left, or kUntold.
using ToldPixels = std::vector<float>;
inline constexpr float kUntold = -1.0F;

/// A pixel's mean by its corners.
struct SmoothPixel {
    glm::vec3 value{0.0F};
    double squaredBias = 0.0;  ///< what is estimated to be left, mean over the channels
    bool isBiased = false;     ///< whether that is beyond what noise could feign
};

/// Pixels as their corners tell them.
///
/// With f at the corners, and second differences f_xx, f_yy there, the mean over a pixel is
/// mean f - (mean f_xx + mean f_yy) / 12: the trapezoid rule with its first correction (Davis and
/// Rabinowitz, Methods of Numerical Integration, 1984, section 2.9). Of lights that had to be
/// sampled the differences are noise, and count as bias instead of being taken off.
///
/// A step between the corners hides from that mean: its second differences on both sides are +1 and
/// -1 of it. Where they change by T from one corner to the next, T / 2 may be a step, whose place
/// within the pixel is unknown: T^2 / 48 is its squared error, that of a uniform number in [0,
/// T/2].
class SmoothPixels {
  public:
    explicit SmoothPixels(const Lattice& lattice);

    /// Takes the second differences about every corner that has neighbours on its surface.
    void measure();
    /// The same again at one corner, whose probe or neighbours have changed.
    void measure(std::size_t corner);

    /// The pixel with this upper left corner, if it is smooth: all corners met the same surfaces,
    /// on one side of each sharp shadow, their surface does not bend away between them, and
    /// neighbours tell the differences both ways. `noise` is the variance of a corner's colour.
    std::optional<SmoothPixel> find(std::size_t corner, double noise) const;
    /// The same of a pixel that is known to be smooth.
    SmoothPixel at(std::size_t corner, double noise) const {
        return at(corner, noise, correction(corner));
    }
    /// The correction (f_xx + f_yy) / 12 of a pixel, and the second differences along the line from
    /// its corner to the right, and down, in the mean of what is known.
    glm::vec3 correctionAt(std::size_t corner) const { return correction(corner).value; }
    glm::vec3 across(std::size_t corner) const;
    glm::vec3 down(std::size_t corner) const;
    /// Whether a light had to be sampled at any of its corners.
    bool isUncertain(std::size_t corner) const;

  private:
    struct Difference {
        glm::vec3 value{0.0F};  ///< 0 where it is not known
        bool known = false;
    };
    struct Bend {
        Difference across;
        Difference down;
    };
    struct Correction {
        glm::vec3 value{0.0F};
        float squaredChange = 0.0F;  ///< sum over the channels
        bool known = false;

        /// One line of two corners.
        void addLine(const Difference& first, const Difference& second, glm::vec3& sum, int& count);
    };

    static glm::vec3 meanOfKnown(const Difference& a, const Difference& b);
    Difference difference(std::size_t corner, std::size_t step) const;
    Correction correction(std::size_t corner) const;
    bool isOfOnePiece(std::size_t corner) const;
    SmoothPixel at(std::size_t corner, double noise, const Correction& off) const;

    const Lattice& lattice_;
    std::vector<Bend> bends_;
};

}  // namespace rt
