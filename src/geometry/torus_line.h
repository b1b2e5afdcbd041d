// A line against one sheet of a torus: the roots of
//
//     f(s) = (rho(s) - R)^2 + z(s)^2 - r^2,     rho the distance to the axis,
//
// along p(s) = foot + s d. R < 0 selects the inner sheet (the lemon) of a spindle torus, r > |R|;
// the product of the two f is the quartic of the torus.
#pragma once

#include "rt/core/numeric.h"
#include "rt/core/vec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rt::torus {

/// f and its derivatives at s, scaled so that a step of an iteration costs one division.
struct Sample {
    double s = 0.0;
    double rho = 0.0;
    double value = 0.0;  // f
    double slope = 0.0;  // rho f' / 2
    double bend = 0.0;   // rho^3 f'' / 2
    double away = 0.0;   // rho rho'

    bool isOutside() const { return value >= 0.0; }
};

/// The line relative to the centre, in units in which R + r is about 1.
struct Line {
    Vec3 foot;
    Vec3 direction;
    double directionSquared = 0.0;
    double axialSquared = 0.0;  // dx^2 + dy^2
    double moment = 0.0;        // J = (fx dy - fy dx)^2 = rho^3 rho''

    Line(const Vec3& f, const Vec3& d, double dd) : foot(f), direction(d), directionSquared(dd) {
        axialSquared = std::fma(d.x, d.x, d.y * d.y);
        const double turn = differenceOfProducts(f.x, d.y, f.y, d.x);
        moment = turn * turn;
    }

    double axisDistanceSquared(double s) const {
        const double x = std::fma(s, direction.x, foot.x);
        const double y = std::fma(s, direction.y, foot.y);
        return std::fma(x, x, y * y);
    }

    Vec3 at(double s) const {
        return {std::fma(s, direction.x, foot.x), std::fma(s, direction.y, foot.y),
                std::fma(s, direction.z, foot.z)};
    }
};

/// The cube root to a few roundings: where f bends need not be known to the last bit, but must be
/// the same on every machine. Halley's iteration from a third of the exponent.
inline double cubeRoot(double x) {
    if (!(x > kTorusSmallestMoment)) return 0.0;
    // A third of the bit pattern plus two thirds of the exponent's offset is within 4 % of the
    // root.
    constexpr std::uint64_t kTwoThirdsOfBias = 0x2a9f7893782da1ceu;
    double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kTwoThirdsOfBias);
    for (int i = 0; i < 2; ++i) {
        const double cube = y * y * y;
        y *= std::fma(2.0, x, cube) / std::fma(2.0, cube, x);
    }
    return y;
}

inline constexpr double kNoRoot = std::numeric_limits<double>::quiet_NaN();

/// One sheet along one line.
class Sheet {
  public:
    Sheet(const Line& line, double major, double minor)
        : line_(line),
          major_(major),
          minor_(minor),
          bendAtAxis_(major * line.moment),
          scale_(minor * (std::fabs(major) + minor)) {}

    Sample sample(double s) const {
        const Vec3 p = line_.at(s);
        const Vec3& d = line_.direction;
        Sample at;
        at.s = s;
        const double rhoSquared = std::fma(p.x, p.x, std::fma(p.y, p.y, kTorusAxisGuard));
        at.rho = std::sqrt(rhoSquared);
        const double fromCircle = at.rho - major_;
        at.value = std::fma(fromCircle, fromCircle, (p.z - minor_) * (p.z + minor_));
        at.away = std::fma(p.x, d.x, p.y * d.y);
        at.slope = std::fma(fromCircle, at.away, at.rho * (p.z * d.z));
        at.bend = std::fma(line_.directionSquared * rhoSquared, at.rho, -bendAtAxis_);
        return at;
    }

    /// How far f may be off where it is small.
    double blur() const { return kTorusBlur * scale_; }

    /// Half the width of the stretch around the point nearest the axis where f is concave: there
    /// rho^3 < R J / d.d. Negative where f is convex throughout. Never so narrow that the slopes at
    /// its ends are lost in rounding: through the axis f has a kink.
    double concaveHalfWidth() const {
        const double a = line_.axialSquared;
        const double dd = line_.directionSquared;
        const double convexFrom = major_ * a;
        if (!(major_ > 0.0 && line_.moment * dd * dd < convexFrom * convexFrom * a)) return -1.0;
        const double rho = cubeRoot(bendAtAxis_ / dd);
        const double least = kTorusSlack * major_;
        return std::sqrt(std::max(least * least, std::fma(rho, rho, -line_.moment / a)) / a);
    }

    /// The s of the point nearest the axis.
    double nearestToAxis() const {
        const Vec3& f = line_.foot;
        const Vec3& d = line_.direction;
        return -std::fma(f.x, d.x, f.y * d.y) / line_.axialSquared;
    }

    /// The first root after `low`, which is outside, where a glance finds it for certain; else a
    /// NaN. On one side of the axis f is convex outwards of concave: where it falls at `low` and
    /// falls through a root in the convex part of the same side, there is no other root between
    /// them.
    double entryAfter(const Sample& low) const {
        // The parabola that touches f at `low`.
        const double half = low.slope * low.rho;
        const double discriminant = std::fma(half, half, -low.value * low.bend * low.rho);
        if (!(half < 0.0 && discriminant > 0.0)) return kNoRoot;
        double s = low.s + low.value * (low.rho * low.rho) / (std::sqrt(discriminant) - half);
        for (int i = 0; i < kTorusGlances; ++i) {
            const Sample at = sample(s);
            const bool sameSide = (low.away < 0.0) == (at.away < 0.0);
            if (!(at.slope < 0.0 && at.bend > 0.0 && sameSide)) return kNoRoot;
            const Step next = step(at);
            s = s + next.move;
            if (next.isLast) return s;
        }
        return kNoRoot;
    }

    /// The root between two samples, one of them outside. `start` is a guess.
    double rootBetween(const Sample& low, const Sample& high, double start) const {
        double from = low.s;
        double to = high.s;
        double s = start;
        for (int i = 0; i < kTorusMaxSteps; ++i) {
            if (i >= kTorusPatience || !(from < s && s < to)) s = 0.5 * (from + to);
            if (!(from < s && s < to)) break;
            const Sample at = sample(s);
            (at.isOutside() == low.isOutside() ? from : to) = s;
            if (std::fabs(at.value) <= kTorusFloor * scale_) return s;
            const Step next = step(at);
            s = s + next.move;
            if (next.isLast && from <= s && s <= to) return s;
        }
        return s;
    }

    /// Looks in a stretch where sign * f is convex, and positive at both ends, for a point where it
    /// is not; false where there is none, and so no root.
    bool findDip(Sample low, Sample high, double sign, double start, Sample& dip) const {
        if (!(sign * low.slope < 0.0 && sign * high.slope > 0.0)) return false;
        for (int i = 0; i < kTorusMaxSteps; ++i) {
            // A convex function lies above its tangents.
            const double first = low.s - 0.5 * low.value * low.rho / low.slope;
            const double last = high.s - 0.5 * high.value * high.rho / high.slope;
            if (!(first <= last)) return false;
            if (i >= kTorusPatience || !(first < start && start < last)) {
                start = 0.5 * (first + last);
            }
            const Sample at = sample(start);
            if (at.isOutside() != low.isOutside()) {
                dip = at;
                return true;
            }
            (sign * at.slope < 0.0 ? low : high) = at;
            start = at.s - at.slope * (at.rho * at.rho) / at.bend;
        }
        return false;
    }

  private:
    struct Step {
        double move;
        bool isLast;
    };

    /// Halley's: -2 f f' / (2 f'^2 - f f''). The last one is so short, and f so straight, that its
    /// error is below a rounding.
    Step step(const Sample& at) const {
        const double square = 4.0 * at.slope * at.slope * at.rho;
        const double bent = at.value * at.bend;
        const double move = -2.0 * at.value * at.slope * (at.rho * at.rho) / (square - bent);
        const double reach = kTorusHandover * std::min(at.rho, minor_);
        return {move, std::fabs(bent) <= kTorusHandover * square &&
                          move * move * line_.directionSquared <= reach * reach};
    }

    const Line& line_;
    double major_;
    double minor_;
    double bendAtAxis_;
    double scale_;  // r (R + r): f moves by twice that where a point does by R + r
};

}  // namespace rt::torus
