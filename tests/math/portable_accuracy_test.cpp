// The bounds of portable.h against quadruple precision (libquadmath), which shares no code with it.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "portable_functions.h"

extern "C" {
__float128 sinq(__float128);
__float128 cosq(__float128);
__float128 tanq(__float128);
__float128 asinq(__float128);
__float128 acosq(__float128);
__float128 atanq(__float128);
__float128 atan2q(__float128, __float128);
__float128 expq(__float128);
__float128 logq(__float128);
__float128 log2q(__float128);
__float128 log10q(__float128);
__float128 powq(__float128, __float128);
__float128 cbrtq(__float128);
__float128 hypotq(__float128, __float128);
__float128 sinhq(__float128);
__float128 coshq(__float128);
__float128 tanhq(__float128);
__float128 fmodq(__float128, __float128);
__float128 fabsq(__float128);
__float128 ldexpq(__float128, int);
}

using namespace rt;
using namespace rt::test;

namespace {

using Quad = __float128;

constexpr std::uint64_t kSeed = 20260101;
constexpr int kArguments = 10000;

Quad exp2q(Quad x) {
    return powq(2, x);
}

Quad radians(Quad degrees) {
    const Quad pi = 4 * atanq(1);
    return fmodq(degrees, 360) * pi / 180;
}
Quad sinDegreesq(Quad x) {
    return sinq(radians(x));
}
Quad cosDegreesq(Quad x) {
    return cosq(radians(x));
}

/// |got - exact| in units of the last place that a double of exact's magnitude has.
double errorInUlp(double got, Quad exact) {
    const auto nearest = static_cast<double>(exact);
    if (std::isnan(got) || std::isnan(nearest)) {
        return std::isnan(got) == std::isnan(nearest) ? 0.0 : HUGE_VAL;
    }
    if (std::isinf(got) || std::isinf(nearest)) return got == nearest ? 0.0 : HUGE_VAL;
    const int exponent = nearest == 0.0 ? -1074 : std::max(std::ilogb(nearest) - 52, -1074);
    return static_cast<double>(ldexpq(fabsq(static_cast<Quad>(got) - exact), -exponent));
}

struct UnaryBound {
    const char* name;
    Quad (*exact)(Quad);
    double bound;
};

constexpr UnaryBound kUnary[] = {
    {"sin", sinq, 0.85},
    {"cos", cosq, 0.85},
    {"sincos.sin", sinq, 0.85},
    {"sincos.cos", cosq, 0.85},
    {"tan", tanq, 1.0},
    {"sinDegrees", sinDegreesq, 0.85},
    {"cosDegrees", cosDegreesq, 0.85},
    {"asin", asinq, 0.72},
    {"acos", acosq, 0.72},
    {"atan", atanq, 0.51},
    {"exp", expq, 0.52},
    {"exp2", exp2q, 0.52},
    {"log", logq, 0.52},
    {"log2", log2q, 0.51},
    {"log10", log10q, 0.51},
    {"cbrt", cbrtq, 0.51},
    {"sinh", sinhq, 0.55},
    {"cosh", coshq, 0.55},
    {"tanh", tanhq, 0.55},
};

/// Where the result is below 2^-1022, rounding to double and rounding to its grid may add up.
struct BinaryBound {
    const char* name;
    Quad (*exact)(Quad, Quad);
    double bound;
    double subnormalBound;
};

constexpr BinaryBound kBinary[] = {
    {"atan2", atan2q, 0.51, 1.0},
    {"pow", powq, 0.52, 0.52},
    {"hypot", hypotq, 0.51, 0.76},
};

template <class Bound, std::size_t N>
const Bound& boundOf(const Bound (&bounds)[N], const std::string& name) {
    const auto row = std::find_if(std::begin(bounds), std::end(bounds),
                                  [&](const Bound& b) { return b.name == name; });
    REQUIRE(row != std::end(bounds));
    return *row;
}

}  // namespace

TEST_CASE("portable functions of one argument stay within their bounds") {
    CAPTURE(kSeed);
    SplitMix random(kSeed);
    for (const UnaryFunction& f : unaryFunctions()) {
        CAPTURE(f.name);
        const UnaryBound& bound = boundOf(kUnary, f.name);
        double worst = 0.0;
        double at = 0.0;
        for (const Range& range : f.ranges) {
            for (int i = 0; i < kArguments; ++i) {
                const double x = range.draw(random);
                const double error = errorInUlp(f.function(x), bound.exact(x));
                if (!(error <= worst)) {
                    worst = error;
                    at = x;
                }
            }
        }
        MESSAGE(f.name << ": " << worst << " ulp of " << bound.bound);
        CAPTURE(at);
        CHECK(worst <= bound.bound);
        CHECK(worst > 0.45);
    }
}

TEST_CASE("portable functions of two arguments stay within their bounds") {
    CAPTURE(kSeed);
    SplitMix random(kSeed);
    for (const BinaryFunction& f : binaryFunctions()) {
        if (f.name == "powUnit") continue;
        CAPTURE(f.name);
        const BinaryBound& bound = boundOf(kBinary, f.name);
        double worst = 0.0;
        double worstSubnormal = 0.0;
        for (const auto& [first, second] : f.ranges) {
            for (int i = 0; i < kArguments; ++i) {
                const double x = first.draw(random);
                const double y = second.draw(random);
                const double value = f.function(x, y);
                const double error = errorInUlp(value, bound.exact(x, y));
                CAPTURE(x);
                CAPTURE(y);
                const bool subnormal = std::fabs(value) < 0x1p-1022;
                REQUIRE(error <= (subnormal ? bound.subnormalBound : bound.bound));
                double& record = subnormal ? worstSubnormal : worst;
                record = std::max(record, error);
            }
        }
        MESSAGE(f.name << ": " << worst << " ulp of " << bound.bound << "; subnormal results "
                       << worstSubnormal << " of " << bound.subnormalBound);
        CHECK(worst > 0.45);
    }
}

TEST_CASE("powUnit stays within the bound that grows with the logarithm of the power") {
    SplitMix random(kSeed);
    for (const BinaryFunction& f : binaryFunctions()) {
        if (f.name != "powUnit") continue;
        double worst = 0.0;
        double worstVisible = 0.0;
        for (const auto& [first, second] : f.ranges) {
            for (int i = 0; i < kArguments; ++i) {
                const double x = first.draw(random);
                const double p = second.draw(random);
                const double value = f.function(x, p);
                const Quad exact = powq(x, p);
                CAPTURE(x);
                CAPTURE(p);
                if (exact < 0x1p-1021) {
                    REQUIRE(value <= 0x1p-1020);
                    continue;
                }
                const double error = errorInUlp(value, exact);
                REQUIRE(error <= 0.55 - static_cast<double>(logq(exact)) / 100);
                worst = std::max(worst, error);
                if (value > 1e-10) worstVisible = std::max(worstVisible, error);
            }
        }
        MESSAGE("powUnit: " << worst << " ulp, " << worstVisible << " where above 1e-10");
        CHECK(worstVisible <= 0.8);
    }
}

TEST_CASE("arguments closest to a multiple of pi/2 keep their bound") {
    // Muller, Elementary Functions, 2016, section 11.3.2: the double nearest to such a multiple;
    // then the doubles nearest to multiples of pi and pi/2 of every size.
    const double hardest = std::ldexp(6381956970095103.0, 797);
    CHECK(errorInUlp(portable::cos(hardest), cosq(hardest)) <= 0.85);
    CHECK(errorInUlp(portable::tan(hardest), tanq(hardest)) <= 1.0);
    const Quad pi = 4 * atanq(1);
    for (std::int64_t n = 1; n < (std::int64_t{1} << 40); n += 1 + n / 37) {
        const auto x = static_cast<double>(static_cast<Quad>(n) * pi / 2);
        CAPTURE(x);
        CHECK(errorInUlp(portable::sin(x), sinq(x)) <= 0.85);
        CHECK(errorInUlp(portable::cos(x), cosq(x)) <= 0.85);
        CHECK(errorInUlp(portable::tan(x), tanq(x)) <= 1.0);
    }
}

TEST_CASE("functions keep their bound where two of their methods meet") {
    const double seams[] = {0x1p-27,
                            0.25,
                            0.5,
                            1.0,
                            0.6875,
                            1.375,
                            20.0,
                            0x1p20,
                            0x1p54,
                            0x1p500,
                            0.785398163397448,
                            1.0 / 128,
                            1.0 - 1.0 / 256,
                            1.0 + 1.0 / 128};
    for (const UnaryFunction& f : unaryFunctions()) {
        CAPTURE(f.name);
        const UnaryBound& bound = boundOf(kUnary, f.name);
        for (const double seam : seams) {
            double x = seam;
            for (int i = 0; i < 20; ++i) x = std::nextafter(x, 0.0);
            for (int i = 0; i < 40; ++i, x = std::nextafter(x, HUGE_VAL)) {
                CAPTURE(x);
                CHECK(errorInUlp(f.function(x), bound.exact(x)) <= bound.bound);
                CHECK(errorInUlp(f.function(-x), bound.exact(-x)) <= bound.bound);
            }
        }
    }
}
