// The first crossing of a line with one sheet of a torus, in a range.
#pragma once

#include "rt/core/ray.h"
#include "torus_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::torus {

/// Which s may be answered. Rounding is monotone: where the t of one s is out of range on one
/// side, so are those of all s beyond.
struct Window {
    double tFoot;
    double unit;
    Interval range;

    double start() const { return (range.min - tFoot) / unit; }
    double startMagnitude() const { return std::fabs(range.min / unit); }
    double t(double s) const { return std::fma(s, unit, tFoot); }
    bool contains(double s) const { return range.contains(t(s)); }
    bool endsBefore(double s) const { return !(t(s) < range.max); }
    bool startsAfter(double s) const { return !(t(s) > range.min); }
};

class Search {
  public:
    Search(const Sheet& sheet, const Window& window) : sheet_(sheet), window_(window) {}

    /// Whether the sheet is crossed in the window between `from` and `to`, both outside it.
    bool between(double from, double to) {
        const Sample low = window_.startsAfter(from) ? start() : sheet_.sample(from);
        if (low.isOutside()) {
            root_ = sheet_.entryAfter(low);
            if (!window_.startsAfter(root_)) return window_.contains(root_);
        }
        return onSheet(low, sheet_.sample(to));
    }

    /// Where, when it is.
    double root() const { return root_; }

  private:
    /// The line where the range starts. Within the roundings of a root the start counts as that
    /// root, and only the way it leaves tells on which side it is.
    Sample start() const {
        Sample at = sheet_.sample(window_.start());
        const double half = std::fabs(at.slope) / at.rho;
        const double blur = sheet_.blur() + 2.0 * half * kTorusSway * window_.startMagnitude();
        if (!(std::fabs(at.value) <= blur)) return at;
        const bool leaves = at.slope >= 0.0;
        const Sample beyond = sheet_.sample(at.s + blur / half);
        if (std::fabs(beyond.value) > blur && beyond.isOutside() == leaves) return beyond;
        at.value = std::copysign(std::numeric_limits<double>::min(), at.slope);
        return at;
    }

    /// Convex, concave around the point nearest the axis, convex again. `high` is outside.
    bool onSheet(const Sample& low, const Sample& high) {
        const double halfWidth = sheet_.concaveHalfWidth();
        if (!(halfWidth >= 0.0)) return onStretch(low, high, 1.0);
        const double axis = sheet_.nearestToAxis();
        const double bendsDown = axis - halfWidth;
        const double bendsUp = axis + halfWidth;
        if (!(bendsDown < high.s && bendsUp > low.s)) return onStretch(low, high, 1.0);

        Sample from = low;
        if (bendsDown > low.s) {
            from = sheet_.sample(bendsDown);
            if (!window_.startsAfter(bendsDown) && onStretch(low, from, 1.0)) return true;
            if (window_.endsBefore(bendsDown)) return false;
        }
        const Sample to = bendsUp < high.s ? sheet_.sample(bendsUp) : high;
        if (!window_.startsAfter(to.s) && onStretch(from, to, -1.0)) return true;
        return to.s < high.s && onStretch(to, high, 1.0);
    }

    /// On a stretch where sign * f is convex there are at most two roots.
    bool onStretch(const Sample& low, const Sample& high, double sign) {
        if (low.isOutside() != high.isOutside()) {
            return accept(sheet_.rootBetween(low, high, parabolaRoot(low, high)));
        }
        if (low.isOutside() != (sign > 0.0)) return false;
        Sample dip;
        if (!sheet_.findDip(low, high, sign, secantMinimum(low, high), dip)) return false;
        // The parabola that touches f at the dip.
        const double half = dip.slope * dip.rho;
        const double square = std::fma(half, half, -dip.value * dip.bend * dip.rho);
        const double root = std::sqrt(std::max(0.0, square)) * sign;
        const double scale = dip.rho / dip.bend;
        if (!window_.startsAfter(dip.s) &&
            accept(sheet_.rootBetween(low, dip, dip.s - (half + root) * scale))) {
            return true;
        }
        return accept(sheet_.rootBetween(dip, high, dip.s - (half - root) * scale));
    }

    bool accept(double root) {
        root_ = root;
        return window_.contains(root);
    }

    /// Where the parabola through an outside and an inside sample, with the tangent of the outside
    /// one, is zero.
    static double parabolaRoot(const Sample& low, const Sample& high) {
        const Sample& outside = low.isOutside() ? low : high;
        const Sample& inside = low.isOutside() ? high : low;
        const double width = inside.s - outside.s;
        const double half = outside.slope / outside.rho;
        const double bend = (inside.value - outside.value - 2.0 * half * width) / (width * width);
        const double root = std::sqrt(std::max(0.0, half * half - outside.value * bend));
        return outside.s + outside.value / (std::copysign(root, width) - half);
    }

    /// Where f' would be zero, were f'' constant between the two.
    static double secantMinimum(const Sample& low, const Sample& high) {
        const double a = low.slope * high.rho;
        const double b = high.slope * low.rho;
        return (low.s * b - high.s * a) / (b - a);
    }

    const Sheet& sheet_;
    const Window& window_;
    double root_ = kNoRoot;
};

}  // namespace rt::torus
