// Pixel filters by importance sampling: points are drawn with the density |f| of the filter about
// the pixel's centre, and each carries the sign of f, so that a pixel needs only its own samples
// (Ernst, Stamminger and Greiner, Filter Importance Sampling, IEEE Symp. Interactive Ray Tracing,
// 2006). Where f has both signs, the square's last 1/16 along x goes to the negative parts and the
// rest to the positive ones, each in proportion to |f|: 2^m >= 16 points of a net have exactly
// their share of either sign, so that their weights add up to 2^m, and each sign's points are a
// net. Filters are products of one function of each axis, x in pixels from the centre:
//
//   box               1                                                     |x| <= 1/2
//   gaussian          exp(-2 x^2) - exp(-2 1.5^2), that is sigma 1/2        |x| <= 3/2
//   mitchell          (7 |x|^3 - 12 |x|^2 + 16/3) / 6 below 1, then
//                     (-7/3 |x|^3 + 12 |x|^2 - 20 |x| + 32/3) / 6           |x| <= 2
//                     (Mitchell and Netravali, Reconstruction Filters in Computer Graphics,
//                     SIGGRAPH 1988, B = C = 1/3); negative beyond 8/7
//   blackman-harris   0.35875 + 0.48829 cos t + 0.14128 cos 2t + 0.01168 cos 3t,
//                     t = 2 pi x / 3 (Harris, On the Use of Windows, Proc. IEEE 66, 1978)
//                                                                           |x| <= 3/2
#pragma once

#include "rt/core/vec.h"
#include "rt/sampling/sampler_kind.h"

#include <array>
#include <cstddef>

namespace rt {

/// A place in the image plane and what the light found there counts for.
struct FilterSample {
    Vec2 offset{0.0};     ///< from the pixel's centre, in pixels
    double weight = 1.0;  ///< f over the density of the points, f having the integral 1
};

class PixelFilter {
  public:
    explicit PixelFilter(FilterKind kind);

    /// The one filter of a kind, built when it is first asked for.
    static const PixelFilter& of(FilterKind kind);

    /// Beyond this distance along an axis the filter is 0.
    double radius() const { return radius_; }

    /// f along one axis, with the integral 1.
    double value(double x) const;

    /// The sample for a point of the unit square, with the density |f|: without negative parts
    /// rising with u along each axis. The share of |f|'s integral up to any place is met to 3e-9.
    FilterSample sample(const Vec2& u) const;

  private:
    static constexpr std::size_t kCells = 128;
    static constexpr std::size_t kGuides = 256;

    void addCells(double from, double to, std::size_t count);
    void normalize();
    FilterSample sampleSigned(const Vec2& u) const;
    double within(double u) const;
    double beyond(double u) const;
    double distance(double share) const;

    FilterKind kind_;
    double radius_;
    double scale_ = 1.0;           ///< of the formula above, to make the integral 1
    double negativeFrom_ = 0.0;    ///< beyond this distance f is negative
    double within_ = 1.0;          ///< share of |f|'s integral along an axis up to there
    double positiveWeight_ = 1.0;  ///< of samples
    double negativeWeight_ = 0.0;
    double corners_ = 0.0;  ///< share of the places beyond along both axes in the positive parts
    std::size_t cells_ = 0;
    std::array<double, kCells + 1> knot_{};     ///< distances from the centre
    std::array<double, kCells + 1> share_{};    ///< of |f|'s integral up to the knot
    std::array<double, kCells + 1> density_{};  ///< derivative of the share
    std::array<std::size_t, kGuides> guide_{};  ///< a cell at or before the share i / kGuides
};

}  // namespace rt
