// Pixels that are what their corners are.
#pragma once

#include "rt/render/lattice.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rt {

/// A colour in four lanes, the last of them 0.
using ColorLanes = float __attribute__((vector_size(16)));

inline Color asColor(const ColorLanes& lanes) {
    return Color(glm::vec3(lanes[0], lanes[1], lanes[2]));
}

/// A pixel's mean by its corners.
struct SmoothPixel {
    ColorLanes value{};
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

    /// Takes the colour of a corner, and the second differences about it where it has neighbours on
    /// its surface; all corners' colours come first.
    void readColor(std::size_t corner);
    void measure(std::size_t corner);
    /// Both for all corners.
    void measureAll();

    /// The pixel with this upper left corner, if it is smooth: all corners met the same surfaces,
    /// on one side of each sharp shadow, their surface does not bend away between them, and
    /// neighbours tell the differences both ways. `noise` is the variance of a corner's colour.
    std::optional<SmoothPixel> find(std::size_t corner, double noise) const;
    /// The same of a pixel that was found smooth. Later looks may prove shadows sharper than that,
    /// and then the differences are unknown: as much as the corners differ may be a step.
    SmoothPixel at(std::size_t corner, double noise) const {
        return at(corner, noise, correction(corner));
    }
    /// The correction (f_xx + f_yy) / 12 of a pixel.
    ColorLanes correctionAt(std::size_t corner) const { return correction(corner).value; }
    /// f in the middle of a pixel, of its upper side and of its left one: with second differences
    /// D across a line, in the middle of its ends a and b it is (a + b) / 2 - D / 8.
    ColorLanes centreOf(std::size_t corner) const;
    ColorLanes middleOfTop(std::size_t corner) const;
    ColorLanes middleOfLeft(std::size_t corner) const;
    ColorLanes colorAt(std::size_t corner) const { return corners_[corner].color; }
    /// Whether a light had to be sampled at any of its corners.
    bool isUncertain(std::size_t corner) const;

    /// The mean of a pixel's corners, that of the 16 corners of it and its neighbours, and the
    /// squared difference of the two, mean over the channels.
    ColorLanes meanOfCorners(std::size_t corner) const;
    ColorLanes wideMean(std::size_t corner) const;
    float squaredStepToWide(std::size_t corner) const;

  private:
    struct Corner {
        ColorLanes color{};
        ColorLanes across{};  ///< second differences, 0 where they are not known
        ColorLanes down{};
        bool knowsAcross = false;
        bool knowsDown = false;
    };
    struct Correction {
        ColorLanes value{};
        float squaredChange = 0.0F;  ///< sum over the channels
        bool known = false;
    };
    /// The second differences at two corners in one line, summed, and their squared change.
    struct Line;

    static Line lineOf(const ColorLanes& first, bool knowsFirst, const ColorLanes& second,
                       bool knowsSecond);
    static ColorLanes middle(const Corner& a, const Corner& b, const Line& line);
    bool difference(std::size_t corner, std::size_t step, ColorLanes& found) const;
    Correction correction(std::size_t corner) const;
    double squaredSpanOfCorners(std::size_t corner) const;
    bool isOfOnePiece(std::size_t corner) const;
    SmoothPixel at(std::size_t corner, double noise, const Correction& off) const;

    const Lattice& lattice_;
    ZeroedArray<Corner> corners_;
};

}  // namespace rt
