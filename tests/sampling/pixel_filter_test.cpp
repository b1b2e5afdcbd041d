#include "rt/sampling/pixel_filter.h"

#include <doctest/doctest.h>

#include "rt/sampling/random.h"
#include "rt/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr double kPi = 3.141592653589793;

struct Known {
    FilterKind kind;
    std::string name;
    double radius;
    double (*shape)(double);  ///< the published formula, not normalised
};

double box(double x) {
    return std::fabs(x) <= 0.5 ? 1.0 : 0.0;
}

double gaussian(double x) {
    return std::fabs(x) <= 1.5 ? std::exp(-2 * x * x) - std::exp(-4.5) : 0.0;
}

/// Mitchell and Netravali's equation (8) with its two parameters.
double mitchell(double x) {
    const double b = 1.0 / 3.0;
    const double c = 1.0 / 3.0;
    const double d = std::fabs(x);
    if (d < 1) {
        return ((12 - 9 * b - 6 * c) * d * d * d + (-18 + 12 * b + 6 * c) * d * d + (6 - 2 * b)) /
               6;
    }
    if (d > 2) return 0.0;
    return ((-b - 6 * c) * d * d * d + (6 * b + 30 * c) * d * d + (-12 * b - 48 * c) * d +
            (8 * b + 24 * c)) /
           6;
}

/// Harris' window over n = 0 .. 1, from edge to edge.
double blackmanHarris(double x) {
    if (std::fabs(x) > 1.5) return 0.0;
    const double t = 2 * kPi * (x + 1.5) / 3.0;
    return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
}

const std::vector<Known>& filters() {
    static const std::vector<Known> all = {
        {FilterKind::kBox, "box", 0.5, box},
        {FilterKind::kGaussian, "gaussian", 1.5, gaussian},
        {FilterKind::kMitchell, "mitchell", 2.0, mitchell},
        {FilterKind::kBlackmanHarris, "blackman-harris", 1.5, blackmanHarris},
    };
    return all;
}

/// Integral of g from a to b by the midpoint rule on a fine grid.
template <class Function>
double integral(Function g, double a, double b) {
    constexpr int kSteps = 100000;
    const double step = (b - a) / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) sum += g(a + (i + 0.5) * step);
    return sum * step;
}

}  // namespace

TEST_CASE("filters are the published functions, scaled to the integral 1") {
    for (const Known& f : filters()) {
        CAPTURE(f.name);
        const PixelFilter& filter = PixelFilter::of(f.kind);
        CHECK(filter.radius() == f.radius);
        const double whole = integral(f.shape, -f.radius, f.radius);
        for (double x = -2.2; x <= 2.2; x += 0.013) {
            CAPTURE(x);
            CHECK(filter.value(x) == doctest::Approx(f.shape(x) / whole).epsilon(1e-9).scale(1.0));
        }
    }
    CHECK(PixelFilter::of(FilterKind::kMitchell).value(0.0) == doctest::Approx(8.0 / 9.0));
    CHECK(PixelFilter::of(FilterKind::kMitchell).value(1.0) == doctest::Approx(1.0 / 18.0));
    CHECK(PixelFilter::of(FilterKind::kMitchell).value(1.5) < 0.0);
}

TEST_CASE("the share of samples up to a place is the share of the filter's absolute integral") {
    constexpr std::size_t kSteps = 400000;
    for (const Known& f : filters()) {
        if (f.kind == FilterKind::kMitchell) continue;  // not one axis by itself
        CAPTURE(f.name);
        const PixelFilter& filter = PixelFilter::of(f.kind);
        const double step = 2.0 * f.radius / kSteps;
        std::vector<double> upTo(kSteps + 1, 0.0);
        for (std::size_t i = 0; i < kSteps; ++i) {
            const double middle = -f.radius + (static_cast<double>(i) + 0.5) * step;
            upTo[i + 1] = upTo[i] + std::fabs(f.shape(middle)) * step;
        }
        constexpr int kPlaces = 5000;
        for (int i = 0; i <= kPlaces; ++i) {
            // Squeezed towards both ends, where the filters vanish.
            const double t = static_cast<double>(i) / kPlaces;
            const double u = t * t * (3.0 - 2.0 * t);
            const double x = filter.sample({u, 0.5}).offset.x;
            REQUIRE(std::fabs(x) <= f.radius);
            const double at = (x + f.radius) / step;
            const std::size_t cell = std::min(static_cast<std::size_t>(at), kSteps - 1);
            const double part = at - static_cast<double>(cell);
            const double share = upTo[cell] + (upTo[cell + 1] - upTo[cell]) * part;
            CAPTURE(u);
            REQUIRE(std::fabs(share / upTo[kSteps] - u) < 3e-9);
        }
    }
}

TEST_CASE(
    "offsets rise with the square's coordinates, each axis by itself, and mirror about the "
    "centre") {
    for (const Known& f : filters()) {
        if (f.kind == FilterKind::kMitchell) continue;
        CAPTURE(f.name);
        const PixelFilter& filter = PixelFilter::of(f.kind);
        double last = -f.radius - 1.0;
        constexpr int kSteps = 40000;
        for (int i = 0; i <= kSteps; ++i) {
            const double u = static_cast<double>(i) / kSteps;
            const FilterSample s = filter.sample({u, 0.25});
            REQUIRE(s.offset.x >= last);
            last = s.offset.x;
            REQUIRE(s.offset.y == filter.sample({0.7, 0.25}).offset.y);
            REQUIRE(filter.sample({0.25, u}).offset.y == s.offset.x);
            REQUIRE(filter.sample({1.0 - u, 0.25}).offset.x ==
                    doctest::Approx(-s.offset.x).epsilon(1e-9).scale(1.0));
        }
        CHECK(last == doctest::Approx(f.radius));
    }
}

TEST_CASE("weights are 1 for filters without negative lobes, and carry the sign of the others") {
    for (const Known& f : filters()) {
        CAPTURE(f.name);
        const PixelFilter& filter = PixelFilter::of(f.kind);
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const FilterSample s =
                filter.sample({toUnit(mixBits(2 * i + 1)), toUnit(mixBits(2 * i + 2))});
            const double product = filter.value(s.offset.x) * filter.value(s.offset.y);
            if (f.kind != FilterKind::kMitchell) REQUIRE(s.weight == 1.0);
            if (std::fabs(product) > 1e-6) REQUIRE((s.weight > 0.0) == (product > 0.0));
        }
    }
}

TEST_CASE("weights of both signs fill every part of the plane with the filter's integral over it") {
    // Of a fine grid over the square, the weights that fall into each cell of a grid over the
    // filter's support, against a product of integrals; the two signs by themselves.
    constexpr int kCells = 14;
    constexpr int kGrid = 4096;
    const PixelFilter& filter = PixelFilter::of(FilterKind::kMitchell);
    // Cells of 2/7, so that some end where the filter changes its sign.
    const auto cellOf = [](double x) {
        return std::clamp(static_cast<int>(std::floor((x + 2.0) * 3.5)), 0, kCells - 1);
    };
    std::vector<double> found(kCells * kCells, 0.0);
    for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
            const FilterSample s = filter.sample({(i + 0.5) / kGrid, (j + 0.5) / kGrid});
            found[static_cast<std::size_t>(cellOf(s.offset.y) * kCells + cellOf(s.offset.x))] +=
                s.weight / kGrid / kGrid;
        }
    }
    const double whole = integral(mitchell, -2.0, 2.0);
    for (int i = 0; i < kCells; ++i) {
        const double across = integral(mitchell, i / 3.5 - 2.0, (i + 1) / 3.5 - 2.0) / whole;
        for (int j = 0; j < kCells; ++j) {
            const double down = integral(mitchell, j / 3.5 - 2.0, (j + 1) / 3.5 - 2.0) / whole;
            CAPTURE(i);
            CAPTURE(j);
            const double value = found[static_cast<std::size_t>(j * kCells + i)];
            REQUIRE(std::fabs(value - across * down) < 2e-4);
        }
    }
}

TEST_CASE("of points of a net exactly one in sixteen is negative, and their weights add up to 1") {
    const PixelFilter& filter = PixelFilter::of(FilterKind::kMitchell);
    for (std::uint64_t pixel = 0; pixel < 50; ++pixel) {
        for (std::uint32_t count = 16; count <= 1024; count *= 2) {
            double sum = 0.0;
            std::uint32_t negative = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const UnitPoint p = sobolPair(i, SobolPair::kPixel, mixBits(pixel));
                const double weight = filter.sample({p.x, p.y}).weight;
                sum += weight;
                negative += weight < 0.0;
            }
            CHECK(negative == count / 16);
            CHECK(std::fabs(sum / count - 1.0) < 1e-12);
        }
    }
}

TEST_CASE("weighted means of samples are the filtered image") {
    // Images of the form g(x) h(y), whose filtered value is a product of two integrals.
    const auto wave = [](double x) { return std::cos(2.3 * x + 0.4); };
    const auto ramp = [](double x) { return 1.0 + 0.5 * x + 0.2 * x * x; };
    constexpr int kGrid = 512;
    for (const Known& f : filters()) {
        CAPTURE(f.name);
        const PixelFilter& filter = PixelFilter::of(f.kind);
        const double whole = integral(f.shape, -f.radius, f.radius);
        const double expected =
            integral([&](double x) { return f.shape(x) * wave(x); }, -f.radius, f.radius) / whole *
            integral([&](double x) { return f.shape(x) * ramp(x); }, -f.radius, f.radius) / whole;
        double sum = 0.0;
        double weights = 0.0;
        for (int i = 0; i < kGrid; ++i) {
            for (int j = 0; j < kGrid; ++j) {
                const FilterSample s = filter.sample({(i + 0.5) / kGrid, (j + 0.5) / kGrid});
                sum += s.weight * wave(s.offset.x) * ramp(s.offset.y);
                weights += s.weight;
            }
        }
        // A grid resolves the steps of signed weights to about 1/kGrid for each of their eight
        // sides.
        const double tolerance = f.kind == FilterKind::kMitchell ? 8.0 / kGrid : 1e-4;
        CHECK(sum / (kGrid * kGrid) == doctest::Approx(expected).epsilon(tolerance));
        CHECK(weights / (kGrid * kGrid) == doctest::Approx(1.0).epsilon(tolerance));
    }
}
