#include "rt/sampling/pixel_filter.h"

#include "rt/math/portable.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr double kMitchellRoot = 8.0 / 7.0;
/// One strip of so many is for negative places: near their share of |f|, and a power of two, so
/// that the points of nets split exactly.
constexpr double kStrips = 16.0;
/// Newton's method is quadratic inside a cell; only where the filter ends does it need more.
constexpr int kNewtonSteps = 8;
/// The error that follows a step of this share of a cell is below 2^-24 of the cell.
constexpr double kNewtonEnough = 0x1p-12;

double radiusOf(FilterKind kind) {
    switch (kind) {
        case FilterKind::kBox:
            return 0.5;
        case FilterKind::kMitchell:
            return 2.0;
        default:
            return 1.5;
    }
}

double gaussian(double x) {
    return portable::exp(-2.0 * x * x) - portable::exp(-4.5);
}

double mitchell(double x) {
    if (x < 1.0) return ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0;
    // The second polynomial, factored: no rounding can make its root at 2 a sign change.
    return 7.0 / 18.0 * (x - 2.0) * (x - 2.0) * (kMitchellRoot - x);
}

double blackmanHarris(double x) {
    const double t = 2.0 * kPi / 3.0 * x;
    return 0.35875 + 0.48829 * portable::cos(t) + 0.14128 * portable::cos(2.0 * t) +
           0.01168 * portable::cos(3.0 * t);
}

/// The formulas of the header for a distance x within the radius.
double formula(FilterKind kind, double x) {
    switch (kind) {
        case FilterKind::kGaussian:
            return gaussian(x);
        case FilterKind::kMitchell:
            return mitchell(x);
        case FilterKind::kBlackmanHarris:
            return blackmanHarris(x);
        case FilterKind::kBox:
            break;
    }
    return 1.0;
}

/// Integral over [a, b] by Gauss and Legendre's rule with four points.
template <class Function>
double integral(Function f, double a, double b) {
    constexpr double kNear = 0.33998104358485626;
    constexpr double kFar = 0.86113631159405258;
    constexpr double kNearWeight = 0.65214515486254614;
    constexpr double kFarWeight = 0.34785484513745386;
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    const double near = f(middle - kNear * half) + f(middle + kNear * half);
    const double far = f(middle - kFar * half) + f(middle + kFar * half);
    return half * (kNearWeight * near + kFarWeight * far);
}

}  // namespace

PixelFilter::PixelFilter(FilterKind kind)
    : kind_(kind), radius_(radiusOf(kind)), negativeFrom_(radius_) {
    if (kind == FilterKind::kMitchell) {
        // Cells end where the polynomial changes and where |f| has its kink.
        negativeFrom_ = kMitchellRoot;
        addCells(0.0, 1.0, 64);
        addCells(1.0, kMitchellRoot, 16);
        addCells(kMitchellRoot, radius_, kCells - 80);
    } else {
        addCells(0.0, radius_, kCells);
    }
    normalize();
}

void PixelFilter::addCells(double from, double to, std::size_t count) {
    const auto density = [this](double x) { return std::fabs(formula(kind_, x)); };
    knot_[cells_] = from;
    density_[cells_] = density(from);
    for (std::size_t i = 1; i <= count; ++i, ++cells_) {
        const double end =
            i == count ? to
                       : from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
        knot_[cells_ + 1] = end;
        density_[cells_ + 1] = density(end);
        share_[cells_ + 1] = share_[cells_] + integral(density, knot_[cells_], end);
    }
}

void PixelFilter::normalize() {
    const double half = share_[cells_];
    double negative = 0.0;
    for (std::size_t i = 0; i <= cells_; ++i) {
        if (knot_[i] == negativeFrom_) negative = half - share_[i];
    }
    const double signedHalf = half - 2.0 * negative;
    scale_ = 0.5 / signedHalf;
    within_ = (half - negative) / half;
    // Integrals of |f| within and beyond along one axis, that of f being 1.
    const double inside = (half - negative) / signedHalf;
    const double outside = negative / signedHalf;
    if (negative > 0.0) {
        const double positive = inside * inside + outside * outside;
        positiveWeight_ = positive * kStrips / (kStrips - 1.0);
        negativeWeight_ = -2.0 * inside * outside * kStrips;
        corners_ = outside * outside / positive;
    }
    for (std::size_t i = 0; i <= cells_; ++i) {
        share_[i] /= half;
        density_[i] /= half;
    }
    std::size_t cell = 0;
    for (std::size_t i = 0; i < kGuides; ++i) {
        const double start = static_cast<double>(i) / static_cast<double>(kGuides);
        while (cell + 1 < cells_ && share_[cell + 1] <= start) ++cell;
        guide_[i] = cell;
    }
}

const PixelFilter& PixelFilter::of(FilterKind kind) {
    static const PixelFilter filters[] = {
        PixelFilter(FilterKind::kBox), PixelFilter(FilterKind::kGaussian),
        PixelFilter(FilterKind::kMitchell), PixelFilter(FilterKind::kBlackmanHarris)};
    return filters[static_cast<std::size_t>(kind)];
}

double PixelFilter::value(double x) const {
    const double distance = std::fabs(x);
    return distance <= radius_ ? scale_ * formula(kind_, distance) : 0.0;
}

/// The distance from the centre within which the given share of |f|'s integral lies: the share
/// is a cubic in each cell that has the right values and slopes at its ends.
double PixelFilter::distance(double share) const {
    const auto first = static_cast<std::size_t>(share * static_cast<double>(kGuides));
    std::size_t cell = guide_[std::min(first, kGuides - 1)];
    while (cell + 1 < cells_ && share_[cell + 1] <= share) ++cell;

    const double width = knot_[cell + 1] - knot_[cell];
    const double rise = share_[cell + 1] - share_[cell];
    const double c1 = density_[cell] * width;
    const double endSlope = density_[cell + 1] * width;
    const double c2 = 3.0 * rise - 2.0 * c1 - endSlope;
    const double c3 = c1 + endSlope - 2.0 * rise;
    const double target = std::clamp(share - share_[cell], 0.0, rise);
    double low = 0.0;
    double high = 1.0;
    double s = target / rise;
    for (int i = 0; i < kNewtonSteps; ++i) {
        const double excess = ((c3 * s + c2) * s + c1) * s - target;
        (excess > 0.0 ? high : low) = s;
        double next = s - excess / ((3.0 * c3 * s + 2.0 * c2) * s + c1);
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const double step = std::fabs(next - s);
        s = next;
        if (step < kNewtonEnough) break;
    }
    return knot_[cell] + width * s;
}

/// From 0 to 1 across the part of an axis where f is not negative.
double PixelFilter::within(double u) const {
    const double centred = 2.0 * u - 1.0;
    return std::copysign(distance(std::fabs(centred) * within_), centred);
}

/// From 0 to 1 across the two parts where it is.
double PixelFilter::beyond(double u) const {
    const double centred = 2.0 * u - 1.0;
    return std::copysign(distance(within_ + std::fabs(centred) * (1.0 - within_)), centred);
}

/// f is negative within along one axis and beyond along the other.
FilterSample PixelFilter::sampleSigned(const Vec2& u) const {
    const double strip = kStrips * u.x;
    const double before = kStrips - 1.0;
    if (strip >= before) {
        const double place = 2.0 * (strip - before);
        if (place < 1.0) return {Vec2(beyond(place), within(u.y)), negativeWeight_};
        return {Vec2(within(u.y), beyond(place - 1.0)), negativeWeight_};
    }
    const double place = strip / before;
    const double middle = 1.0 - corners_;
    if (place < middle) return {Vec2(within(place / middle), within(u.y)), positiveWeight_};
    return {Vec2(beyond((place - middle) / corners_), beyond(u.y)), positiveWeight_};
}

FilterSample PixelFilter::sample(const Vec2& u) const {
    if (kind_ == FilterKind::kBox) return {u - 0.5, 1.0};
    if (negativeWeight_ < 0.0) return sampleSigned(u);
    return {Vec2(within(u.x), within(u.y)), 1.0};
}

}  // namespace rt
