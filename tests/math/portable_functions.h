// The portable functions as rows: name, function, its exact twin in quadruple precision, and the
// arguments over which the tests run it.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "rt/math/portable.h"

namespace rt::test {

/// Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    /// Magnitude 2^low to 2^high, uniform in the exponent.
    double scaled(int low, int high) {
        const double mantissa = 1.0 + unit();
        const auto span = static_cast<std::uint64_t>(high - low);
        return std::ldexp(mantissa, low + static_cast<int>(bits() % span));
    }
    double scaledSigned(int low, int high) {
        const double x = scaled(low, high);
        return bits() >> 63 != 0 ? -x : x;
    }

  private:
    std::uint64_t state_;
};

/// Arguments: uniform in [low, high], or, if exponents is set, magnitudes 2^low .. 2^high.
struct Range {
    double low;
    double high;
    enum Kind { kUniform, kPositiveExponents, kSignedExponents } kind = kUniform;

    double draw(SplitMix& random) const {
        const int from = static_cast<int>(low);
        const int to = static_cast<int>(high);
        if (kind == kPositiveExponents) return random.scaled(from, to);
        if (kind == kSignedExponents) return random.scaledSigned(from, to);
        return random.uniform(low, high);
    }
};

struct UnaryFunction {
    std::string name;
    double (*function)(double);
    std::vector<Range> ranges;
};

struct BinaryFunction {
    std::string name;
    double (*function)(double, double);
    std::vector<std::pair<Range, Range>> ranges;
};

inline double sinOfPair(double x) {
    return portable::sincos(x).sin;
}
inline double cosOfPair(double x) {
    return portable::sincos(x).cos;
}

inline const std::vector<UnaryFunction>& unaryFunctions() {
    constexpr auto kSigned = Range::kSignedExponents;
    constexpr auto kPositive = Range::kPositiveExponents;
    static const std::vector<Range> angles = {
        {-0.8, 0.8}, {-7, 7}, {-1e6, 1e6}, {-60, 20, kSigned}, {20, 1024, kSigned}};
    static const std::vector<Range> degrees = {{-400, 400}, {-1e6, 1e6}, {-900, 40, kSigned}};
    static const std::vector<Range> sines = {{-1, 1}, {-60, 0, kSigned}, {0.999, 1}, {-1, -0.999}};
    static const std::vector<Range> powers = {
        {-1, 1}, {-708, 709}, {-746, -700}, {-60, 9, kSigned}};
    static const std::vector<Range> positives = {{0.5, 2}, {0.99, 1.01}, {-1074, 1024, kPositive}};
    static const std::vector<Range> hyperbolic = {{-0.3, 0.3}, {-3, 3}, {-60, 9, kSigned}};
    static const std::vector<UnaryFunction> all = {
        {"sin", portable::sin, angles},
        {"cos", portable::cos, angles},
        {"sincos.sin", sinOfPair, angles},
        {"sincos.cos", cosOfPair, angles},
        {"tan", portable::tan, angles},
        {"sinDegrees", portable::sinDegrees, degrees},
        {"cosDegrees", portable::cosDegrees, degrees},
        {"asin", portable::asin, sines},
        {"acos", portable::acos, sines},
        {"atan", portable::atan, {{-3, 3}, {-60, 60, kSigned}}},
        {"exp", portable::exp, powers},
        {"exp2", portable::exp2, {{-1, 1}, {-1022, 1024}, {-1076, -1020}, {-60, 10, kSigned}}},
        {"log", portable::log, positives},
        {"log2", portable::log2, positives},
        {"log10", portable::log10, positives},
        {"cbrt", portable::cbrt, {{-8, 8}, {-1074, 1024, kSigned}}},
        {"sinh", portable::sinh, hyperbolic},
        {"cosh", portable::cosh, hyperbolic},
        {"tanh", portable::tanh, hyperbolic},
    };
    return all;
}

inline const std::vector<BinaryFunction>& binaryFunctions() {
    constexpr auto kSigned = Range::kSignedExponents;
    constexpr auto kPositive = Range::kPositiveExponents;
    static const std::vector<BinaryFunction> all = {
        {"atan2",
         portable::atan2,
         {{{-1, 1}, {-1, 1}},
          {{-20, 20, kSigned}, {-20, 20, kSigned}},
          {{-1074, 1024, kSigned}, {-1074, 1024, kSigned}},
          {{-1074, -1000, kSigned}, {-30, 20, kSigned}}}},
        {"pow",
         portable::pow,
         {{{0, 1}, {0, 200}},
          {{-30, 30, kPositive}, {-10, 5, kSigned}},
          {{0.99, 1.01}, {5, 17, kSigned}},
          {{-1074, 1024, kPositive}, {-1, 1}}}},
        {"powUnit",
         portable::powUnit,
         {{{0, 1}, {0, 200}}, {{0.99, 1}, {0, 20000}}, {{-60, 0, kPositive}, {-10, 4, kPositive}}}},
        {"hypot",
         portable::hypot,
         {{{-1, 1}, {-1, 1}},
          {{-10, 10, kSigned}, {-10, 10, kSigned}},
          {{-1074, 1023, kSigned}, {-1074, 1023, kSigned}},
          {{-1074, -1020, kSigned}, {-1074, -1020, kSigned}}}},
    };
    return all;
}

}  // namespace rt::test
