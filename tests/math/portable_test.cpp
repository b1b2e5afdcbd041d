#include "rt/math/portable.h"

#include <doctest/doctest.h>

#include <limits>

#include "portable_functions.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.141592653589793;
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr std::uint64_t kSeed = 20260102;
constexpr int kChecksumArguments = 1000000;

std::uint64_t bitsOf(double x) {
    return std::isnan(x) ? 0 : std::bit_cast<std::uint64_t>(x);
}

/// Equal to the bit, all NaN being one.
bool same(double a, double b) {
    return bitsOf(a) == bitsOf(b) && std::isnan(a) == std::isnan(b);
}

/// One step of a hash in which every bit of every value and their order count.
std::uint64_t mixed(std::uint64_t hash, double value) {
    hash = (hash ^ bitsOf(value)) * 0x9e3779b97f4a7c15;
    return hash ^ (hash >> 29);
}

std::uint64_t checksum(const UnaryFunction& f, int count) {
    SplitMix random(kSeed);
    std::uint64_t hash = 0;
    for (int i = 0; i < count; ++i) {
        const auto range = static_cast<std::size_t>(i) % f.ranges.size();
        hash = mixed(hash, f.function(f.ranges[range].draw(random)));
    }
    return hash;
}

std::uint64_t checksum(const BinaryFunction& f, int count) {
    SplitMix random(kSeed);
    std::uint64_t hash = 0;
    for (int i = 0; i < count; ++i) {
        const auto& [first, second] = f.ranges[static_cast<std::size_t>(i) % f.ranges.size()];
        const double x = first.draw(random);
        hash = mixed(hash, f.function(x, second.draw(random)));
    }
    return hash;
}

struct Checksum {
    std::string name;
    std::uint64_t value;
};

const Checksum kChecksums[] = {
    {"sin", 0x3e3363b3823b642b},        {"cos", 0x3e21664c5bb6e37e},
    {"sincos.sin", 0x3e3363b3823b642b}, {"sincos.cos", 0x3e21664c5bb6e37e},
    {"tan", 0x05ad58bfba92e69f},        {"sinDegrees", 0x9bfd9c2f6bf4c147},
    {"cosDegrees", 0x486810b0bf9671cd}, {"asin", 0xb2fc867de8ee7435},
    {"acos", 0x5c88bb08096f6443},       {"atan", 0x10d68809ab8478c3},
    {"exp", 0x4d443a83cc0ba69b},        {"exp2", 0x805c8d94a2bf1518},
    {"log", 0x7ca905d32ac8d077},        {"log2", 0xc9e5ff459574aad8},
    {"log10", 0x4250e9e957979fe9},      {"cbrt", 0x5fdd44037f78ffe0},
    {"sinh", 0x8def4870eaa14e6b},       {"cosh", 0xcdf5cfcf67ad356d},
    {"tanh", 0x6804aa09f8d073ba},       {"atan2", 0x0e6e119d3b76a741},
    {"pow", 0x9159b8344a4740e4},        {"powUnit", 0xd9c12135e76465ff},
    {"hypot", 0x6530f425af826612},
};

std::uint64_t expectedChecksum(const std::string& name) {
    for (const Checksum& row : kChecksums) {
        if (row.name == name) return row.value;
    }
    return 0;
}

struct Special {
    double x;
    double result;
};

void checkSpecials(double (*function)(double), std::initializer_list<Special> rows) {
    for (const Special& row : rows) {
        CAPTURE(row.x);
        CAPTURE(function(row.x));
        CHECK(same(function(row.x), row.result));
    }
}

struct Special2 {
    double x;
    double y;
    double result;
};

void checkSpecials(double (*function)(double, double), std::initializer_list<Special2> rows) {
    for (const Special2& row : rows) {
        CAPTURE(row.x);
        CAPTURE(row.y);
        CAPTURE(function(row.x, row.y));
        CHECK(same(function(row.x, row.y), row.result));
    }
}

/// Runs its body with and without fused instructions.
template <class Body>
void forBothInstructionSets(Body body) {
    const bool before = portable::selectFusedInstructions(true);
    body();
    portable::selectFusedInstructions(false);
    body();
    portable::selectFusedInstructions(before);
}

}  // namespace

TEST_CASE("a million results of every portable function have the bits of every other machine") {
    for (const UnaryFunction& f : unaryFunctions()) {
        CAPTURE(f.name);
        const std::uint64_t value = checksum(f, kChecksumArguments);
        CHECK(value == expectedChecksum(f.name));
    }
    for (const BinaryFunction& f : binaryFunctions()) {
        CAPTURE(f.name);
        const std::uint64_t value = checksum(f, kChecksumArguments);
        CHECK(value == expectedChecksum(f.name));
    }
}

TEST_CASE("fused instructions change no bit") {
    constexpr int kCount = 100000;
    const bool before = portable::selectFusedInstructions(true);
    std::vector<std::uint64_t> fused;
    for (const UnaryFunction& f : unaryFunctions()) fused.push_back(checksum(f, kCount));
    for (const BinaryFunction& f : binaryFunctions()) fused.push_back(checksum(f, kCount));
    portable::selectFusedInstructions(false);
    std::vector<std::uint64_t> plain;
    for (const UnaryFunction& f : unaryFunctions()) plain.push_back(checksum(f, kCount));
    for (const BinaryFunction& f : binaryFunctions()) plain.push_back(checksum(f, kCount));
    portable::selectFusedInstructions(before);
    CHECK(fused == plain);
}

TEST_CASE("trigonometric functions treat zeros, infinities and NaN as Annex F does") {
    forBothInstructionSets([] {
        for (auto* odd : {portable::sin, portable::tan, sinOfPair}) {
            checkSpecials(odd, {{0.0, 0.0},
                                {-0.0, -0.0},
                                {kSmallest, kSmallest},
                                {kInfinity, kNan},
                                {-kInfinity, kNan},
                                {kNan, kNan}});
        }
        for (auto* even : {portable::cos, cosOfPair}) {
            checkSpecials(even, {{0.0, 1.0},
                                 {-0.0, 1.0},
                                 {kSmallest, 1.0},
                                 {kInfinity, kNan},
                                 {-kInfinity, kNan},
                                 {kNan, kNan}});
        }
        checkSpecials(portable::asin, {{0.0, 0.0},
                                       {-0.0, -0.0},
                                       {1.0, kPi / 2},
                                       {-1.0, -kPi / 2},
                                       {1.0000000000000002, kNan},
                                       {-kInfinity, kNan},
                                       {kNan, kNan},
                                       {0.5, 0x1.0c152382d7366p-1}});
        checkSpecials(portable::acos, {{1.0, 0.0},
                                       {-1.0, kPi},
                                       {0.0, kPi / 2},
                                       {-0.0, kPi / 2},
                                       {1.0000000000000002, kNan},
                                       {kInfinity, kNan},
                                       {kNan, kNan},
                                       {-0.5, 0x1.0c152382d7366p+1}});
        checkSpecials(portable::atan, {{0.0, 0.0},
                                       {-0.0, -0.0},
                                       {kInfinity, kPi / 2},
                                       {-kInfinity, -kPi / 2},
                                       {1.0, kPi / 4},
                                       {-1.0, -kPi / 4},
                                       {kSmallest, kSmallest},
                                       {kNan, kNan}});
    });
}

TEST_CASE("atan2 treats every pair of zeros and infinities as Annex F does") {
    forBothInstructionSets([] {
        for (const double sign : {1.0, -1.0}) {
            checkSpecials(portable::atan2, {{sign * 0.0, -0.0, sign * kPi},
                                            {sign * 0.0, 0.0, sign * 0.0},
                                            {sign * 0.0, -1.0, sign * kPi},
                                            {sign * 0.0, 1.0, sign * 0.0},
                                            {sign * 1.0, 0.0, sign * kPi / 2},
                                            {sign * 1.0, -0.0, sign * kPi / 2},
                                            {sign * 1.0, -kInfinity, sign * kPi},
                                            {sign * 1.0, kInfinity, sign * 0.0},
                                            {sign * kInfinity, 1.0, sign * kPi / 2},
                                            {sign * kInfinity, -kInfinity, sign * 3 * kPi / 4},
                                            {sign * kInfinity, kInfinity, sign * kPi / 4},
                                            {sign * kSmallest, -kLargest, sign * kPi},
                                            {sign * kSmallest, kLargest, sign * 0.0},
                                            {sign * kLargest, kSmallest, sign * kPi / 2},
                                            {sign * kSmallest, kSmallest, sign * kPi / 4},
                                            {sign * kLargest, -kLargest, sign * 3 * kPi / 4},
                                            {sign * 1.0, kNan, kNan},
                                            {kNan, sign * 1.0, kNan}});
        }
    });
}

TEST_CASE("exponentials and logarithms treat their limits as Annex F does") {
    forBothInstructionSets([] {
        checkSpecials(portable::exp, {{0.0, 1.0},
                                      {-0.0, 1.0},
                                      {kInfinity, kInfinity},
                                      {-kInfinity, 0.0},
                                      {kNan, kNan},
                                      {710.0, kInfinity},
                                      {0x1.62e42fefa39efp+9, 0x1.fffffffffff2ap+1023},
                                      {0x1.62e42fefa39f0p+9, kInfinity},
                                      {-745.2, 0.0},
                                      {-745.0, kSmallest},
                                      {1.0, 0x1.5bf0a8b145769p+1}});
        checkSpecials(portable::exp2, {{0.0, 1.0},
                                       {10.0, 1024.0},
                                       {-1074.0, kSmallest},
                                       {-1076.0, 0.0},
                                       {1024.0, kInfinity},
                                       {kNan, kNan},
                                       {kInfinity, kInfinity},
                                       {-kInfinity, 0.0},
                                       {0.5, 0x1.6a09e667f3bcdp+0},
                                       {1023.0, 0x1p1023}});
        for (auto* log : {portable::log, portable::log2, portable::log10}) {
            checkSpecials(log, {{1.0, 0.0},
                                {0.0, -kInfinity},
                                {-0.0, -kInfinity},
                                {kInfinity, kInfinity},
                                {-1.0, kNan},
                                {-kSmallest, kNan},
                                {-kInfinity, kNan},
                                {kNan, kNan}});
        }
        for (int n = -1074; n < 1024; ++n) {
            CHECK(portable::log2(std::ldexp(1.0, n)) == n);
            CHECK(portable::exp2(n) == std::ldexp(1.0, n));
        }
        double power = 1.0;
        for (int n = 0; n <= 22; ++n, power *= 10.0) CHECK(portable::log10(power) == n);
    });
}

TEST_CASE("pow follows every rule of Annex F") {
    forBothInstructionSets([] {
        for (const double any : {0.0, -0.0, 3.5, -3.5, kInfinity, -kInfinity, kNan}) {
            CHECK(portable::pow(any, 0.0) == 1.0);
            CHECK(portable::pow(any, -0.0) == 1.0);
            CHECK(portable::pow(1.0, any) == 1.0);
        }
        checkSpecials(portable::pow, {{0.0, 3.0, 0.0},
                                      {-0.0, 3.0, -0.0},
                                      {0.0, 2.0, 0.0},
                                      {-0.0, 2.0, 0.0},
                                      {-0.0, 0.5, 0.0},
                                      {0.0, -3.0, kInfinity},
                                      {-0.0, -3.0, -kInfinity},
                                      {-0.0, -2.0, kInfinity},
                                      {-0.0, -kInfinity, kInfinity},
                                      {-1.0, kInfinity, 1.0},
                                      {-1.0, -kInfinity, 1.0},
                                      {-8.0, 1.0 / 3.0, kNan},
                                      {0.5, -kInfinity, kInfinity},
                                      {-0.5, kInfinity, 0.0},
                                      {2.0, kInfinity, kInfinity},
                                      {-2.0, -kInfinity, 0.0},
                                      {-kInfinity, 3.0, -kInfinity},
                                      {-kInfinity, 2.0, kInfinity},
                                      {-kInfinity, -3.0, -0.0},
                                      {-kInfinity, -2.0, 0.0},
                                      {kInfinity, 0.5, kInfinity},
                                      {kInfinity, -0.5, 0.0},
                                      {kNan, 1.0, kNan},
                                      {2.0, kNan, kNan},
                                      {-2.0, 3.0, -8.0},
                                      {-2.0, 2.0, 4.0},
                                      {-2.0, -3.0, -0.125},
                                      {2.0, 0.5, 0x1.6a09e667f3bcdp+0},
                                      {2.0, 1023.0, 0x1p1023},
                                      {2.0, 1024.0, kInfinity},
                                      {-2.0, 1025.0, -kInfinity},
                                      {2.0, -1074.0, kSmallest},
                                      {2.0, -1076.0, 0.0},
                                      {-2.0, 0x1p53, kInfinity},
                                      {-1.0, 0x1.fffffffffffffp52, -1.0},
                                      {10.0, 22.0, 1e22},
                                      {kLargest, kLargest, kInfinity},
                                      {kSmallest, 2.0, 0.0}});
    });
}

TEST_CASE("powers far beyond the range are infinite or 0, however large the exponent") {
    forBothInstructionSets([] {
        for (double y = 1100.0; y < 1e300; y *= 1.03) {
            CAPTURE(y);
            REQUIRE(portable::pow(2.0, y) == kInfinity);
            REQUIRE(portable::pow(0.5, y) == 0.0);
            REQUIRE(portable::powUnit(0.5, y) == 0.0);
            REQUIRE(portable::exp(y) == kInfinity);
            REQUIRE(portable::exp(-y) == 0.0);
            REQUIRE(portable::exp2(-y) == 0.0);
            REQUIRE(portable::cosh(y) == kInfinity);
        }
    });
}

TEST_CASE("powers that a double holds exactly are exact") {
    SplitMix random(kSeed);
    for (int i = 0; i < 10000; ++i) {
        const double x = random.scaled(-300, 300);
        CAPTURE(x);
        CHECK(portable::pow(x, 1.0) == x);
        CHECK(portable::pow(x, -1.0) == doctest::Approx(1.0 / x).epsilon(1e-15));
        const auto whole = static_cast<double>(random.bits() % 94906265);
        CHECK(portable::pow(whole, 2.0) == whole * whole);
        const auto small = static_cast<double>(random.bits() % 2000);
        CHECK(portable::pow(small, 4.0) == small * small * small * small);
        CHECK(portable::cbrt(small * small * small) == small);
    }
}

TEST_CASE("powUnit is exact at the ends of its range and refuses what lies outside") {
    forBothInstructionSets([] {
        checkSpecials(portable::powUnit, {{0.0, 0.0, 1.0},
                                          {-0.0, 0.0, 1.0},
                                          {0.0, 3.0, 0.0},
                                          {1.0, 1e300, 1.0},
                                          {0.5, 0.0, 1.0},
                                          {0.5, 10.0, 0x1p-10},
                                          {0.5, 1022.0, 0.0},
                                          {0.5, 1021.0, 0x1p-1021},
                                          {0.5, 1e300, 0.0},
                                          {1.5, 2.0, kNan},
                                          {-0.5, 2.0, kNan},
                                          {0.5, -1.0, kNan},
                                          {kNan, 0.0, kNan},
                                          {0.5, kNan, kNan},
                                          {0.0, kNan, kNan},
                                          {0.5, kInfinity, kNan}});
        SplitMix random(kSeed);
        for (int i = 0; i < 1000; ++i) {
            const double x = random.unit();
            CAPTURE(x);
            CHECK(portable::powUnit(x, 1.0) == x);
        }
    });
}

TEST_CASE("roots and hyperbolic functions treat their limits as Annex F does") {
    forBothInstructionSets([] {
        checkSpecials(portable::cbrt, {{0.0, 0.0},
                                       {-0.0, -0.0},
                                       {27.0, 3.0},
                                       {-0.001, -0.1},
                                       {0x1p-1074, 0x1p-358},
                                       {kInfinity, kInfinity},
                                       {-kInfinity, -kInfinity},
                                       {kNan, kNan}});
        checkSpecials(portable::hypot, {{3.0, -4.0, 5.0},
                                        {0.0, -0.0, 0.0},
                                        {-7.0, 0.0, 7.0},
                                        {kInfinity, kNan, kInfinity},
                                        {kNan, -kInfinity, kInfinity},
                                        {kNan, 1.0, kNan},
                                        {1.0, kNan, kNan},
                                        {0.0, kNan, kNan},
                                        {kLargest, kLargest, kInfinity},
                                        {kLargest, 1.0, kLargest},
                                        {3 * 0x1p1000, 4 * 0x1p1000, 5 * 0x1p1000},
                                        {3 * 0x1p-1070, 4 * 0x1p-1070, 5 * 0x1p-1070}});
        checkSpecials(portable::sinh, {{0.0, 0.0},
                                       {-0.0, -0.0},
                                       {kInfinity, kInfinity},
                                       {-kInfinity, -kInfinity},
                                       {kNan, kNan},
                                       {1000.0, kInfinity},
                                       {-1000.0, -kInfinity}});
        checkSpecials(portable::cosh, {{0.0, 1.0},
                                       {-0.0, 1.0},
                                       {kInfinity, kInfinity},
                                       {-kInfinity, kInfinity},
                                       {kNan, kNan},
                                       {-1000.0, kInfinity}});
        checkSpecials(portable::tanh, {{0.0, 0.0},
                                       {-0.0, -0.0},
                                       {kInfinity, 1.0},
                                       {-kInfinity, -1.0},
                                       {kNan, kNan},
                                       {-20.0, -1.0}});
        // Beyond the overflow of exp, sinh and cosh are still finite for a while.
        CHECK(portable::cosh(710.0) == doctest::Approx(1.1169973830808557e308).epsilon(1e-15));
        CHECK(portable::sinh(-710.0) == doctest::Approx(-1.1169973830808557e308).epsilon(1e-15));
    });
}

TEST_CASE("degrees are exact at multiples of 30 in every turn") {
    constexpr double kSines[] = {0, 0.5, 2, 1, 2, 0.5, 0, -0.5, 2, -1, 2, -0.5};
    forBothInstructionSets([&] {
        for (int n = -1200; n <= 1200; ++n) {
            const double sine = kSines[((n % 12) + 12) % 12];
            const double cosine = kSines[((n % 12) + 15) % 12];
            CAPTURE(n);
            if (sine != 2) CHECK(portable::sinDegrees(30.0 * n) == sine);
            if (cosine != 2) CHECK(portable::cosDegrees(30.0 * n) == cosine);
        }
        checkSpecials(portable::sinDegrees, {{0.0, 0.0},
                                             {-0.0, -0.0},
                                             {180.0, 0.0},
                                             {-180.0, -0.0},
                                             {-720.0, -0.0},
                                             {kInfinity, kNan},
                                             {0x1p1000 * 45.0, 0.0},
                                             {kNan, kNan}});
        checkSpecials(portable::cosDegrees, {{90.0, 0.0},
                                             {-90.0, 0.0},
                                             {270.0, 0.0},
                                             {0.0, 1.0},
                                             {-kInfinity, kNan},
                                             {kNan, kNan},
                                             {1e-300, 1.0}});
        CHECK(portable::sinDegrees(45.0) == portable::cosDegrees(45.0));
    });
}

TEST_CASE("functions are odd or even to the bit, and sincos agrees with sin and cos") {
    CAPTURE(kSeed);
    SplitMix random(kSeed);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.scaledSigned(-60, 60);
        CAPTURE(x);
        for (auto* odd : {portable::sin, portable::tan, portable::atan, portable::cbrt,
                          portable::sinh, portable::tanh, portable::sinDegrees}) {
            REQUIRE(same(odd(-x), -odd(x)));
        }
        for (auto* even : {portable::cos, portable::cosh, portable::cosDegrees}) {
            REQUIRE(same(even(-x), even(x)));
        }
        const portable::SinCos both = portable::sincos(x);
        REQUIRE(same(both.sin, portable::sin(x)));
        REQUIRE(same(both.cos, portable::cos(x)));
        const double y = random.scaledSigned(-60, 60);
        REQUIRE(same(portable::atan2(-y, x), -portable::atan2(y, x)));
        REQUIRE(same(portable::hypot(x, y), portable::hypot(-y, x)));
    }
}

TEST_CASE("functions rise where they should, from one double to the next") {
    CAPTURE(kSeed);
    SplitMix random(kSeed);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.scaledSigned(-40, 8);
        const double next = std::nextafter(x, kInfinity);
        CAPTURE(x);
        for (auto* rising : {portable::exp, portable::exp2, portable::atan, portable::cbrt,
                             portable::sinh, portable::tanh}) {
            REQUIRE(rising(next) >= rising(x));
        }
        if (x > 0.0) {
            for (auto* rising : {portable::log, portable::log2, portable::log10}) {
                REQUIRE(rising(next) >= rising(x));
            }
        }
    }
}
