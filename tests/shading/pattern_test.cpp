// Patterns: known answers, laws of the noise, means against brute force.
#include "rt/shading/pattern.h"

#include "rt/core/ray.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace rt;

namespace {

constexpr double kTurn = 6.283185307179586;

Pattern pattern(PatternKind kind) {
    Pattern p;
    p.kind = kind;
    p.first = {0.25, 0.5, 0.0};
    p.second = {0.75, 0.25, 1.0};
    p.size = 0.5;
    p.direction = glm::normalize(Vec3(1.0, 2.0, -2.0));
    p.turbulence = 0.7;
    p.octaves = 3;
    return p;
}

constexpr PatternKind kAll[] = {PatternKind::kChecker,  PatternKind::kStripes,
                                PatternKind::kGradient, PatternKind::kNoise,
                                PatternKind::kMarble,   PatternKind::kWood};

/// How far along from the first to the second colour.
double weightAt(const Pattern& p, const Vec3& at) {
    return 2.0 * (p.at(at).x - 0.25);
}

class Places {
  public:
    Vec3 next(double reach) {
        std::uniform_real_distribution<double> d(-reach, reach);
        const double x = d(random_);
        const double y = d(random_);
        return {x, y, d(random_)};
    }
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  private:
    std::mt19937 random_{7};
};

}  // namespace

TEST_CASE("the noise is Perlin's, of which a value is published") {
    CHECK(gradientNoise({3.14, 42.0, 7.0}) == doctest::Approx(0.13691995878400012).epsilon(1e-14));
}

TEST_CASE("the noise is 0 on the lattice, within -1 .. 1, smooth, and the same after 256") {
    Places places;
    double least = 0.0;
    double most = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = places.next(90.0);
        const double n = gradientNoise(p);
        least = std::min(least, n);
        most = std::max(most, n);
        CHECK(gradientNoise(glm::floor(p)) == 0.0);
        CHECK(std::fabs(gradientNoise(p + Vec3(256.0, -512.0, 256.0)) - n) < 1e-11);
    }
    CHECK(least > -1.0);
    CHECK(most < 1.0);
    CHECK(least < -0.7);
    CHECK(most > 0.7);
    // Its slope is the same on both sides of a wall of the lattice.
    for (int i = 0; i < 200; ++i) {
        Vec3 p = places.next(20.0);
        p.x = std::floor(p.x);
        constexpr double h = 1e-6;
        const Vec3 step(h, 0.0, 0.0);
        const double before = (gradientNoise(p) - gradientNoise(p - step)) / h;
        const double after = (gradientNoise(p + step) - gradientNoise(p)) / h;
        CHECK(std::fabs(before - after) < 1e-4);
    }
    for (const double far : {0x1p60, 1e300, kInfinity, std::nan("")}) {
        CHECK(gradientNoise({far, 0.5, 0.5}) == 0.0);
    }
}

TEST_CASE("checker, stripes and gradient by their formulas") {
    const Pattern checker = pattern(PatternKind::kChecker);
    const Pattern stripes = pattern(PatternKind::kStripes);
    const Pattern gradient = pattern(PatternKind::kGradient);
    Places places;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = places.next(5.0);
        const long cells = std::lround(std::floor(p.x / 0.5)) + std::lround(std::floor(p.y / 0.5)) +
                           std::lround(std::floor(p.z / 0.5));
        CHECK(weightAt(checker, p) == (cells % 2 == 0 ? 0.0 : 1.0));
        const double along = (p.x + 2.0 * p.y - 2.0 * p.z) / 3.0 / 0.5;
        CHECK(weightAt(stripes, p) == (std::lround(std::floor(along)) % 2 == 0 ? 0.0 : 1.0));
        CHECK(std::fabs(weightAt(gradient, p) - std::min(std::max(along, 0.0), 1.0)) < 1e-14);
    }
}

TEST_CASE("noise, marble and wood are their formulas of the noise") {
    const auto sum = [](Vec3 p, bool absolute) {
        double all = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double n = gradientNoise(std::pow(2.0, i) * p);
            all += std::pow(0.5, i) * (absolute ? std::fabs(n) : n);
        }
        return all;
    };
    Places places;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = places.next(5.0);
        const Vec3 q = 2.0 * p;
        const Vec3 d = glm::normalize(Vec3(1.0, 2.0, -2.0));
        CHECK(std::fabs(weightAt(pattern(PatternKind::kNoise), p) -
                        (0.5 + 0.5 * sum(q, false) / 1.75)) < 1e-12);
        CHECK(std::fabs(weightAt(pattern(PatternKind::kMarble), p) -
                        (0.5 + 0.5 * std::sin(kTurn * (glm::dot(q, d) + 0.7 * sum(q, true))))) <
              1e-11);
        const double away = glm::length(glm::cross(q, d));
        CHECK(std::fabs(weightAt(pattern(PatternKind::kWood), p) -
                        (0.5 - 0.5 * std::cos(kTurn * (away + 0.7 * sum(q, false))))) < 1e-11);
    }
}

TEST_CASE("colours lie between the two") {
    Places places;
    for (const PatternKind kind : kAll) {
        const Pattern p = pattern(kind);
        for (int i = 0; i < 500; ++i) {
            const Color c = p.at(places.next(1e3));
            CHECK((c.x >= 0.25 && c.x <= 0.75 && c.y >= 0.25 && c.y <= 0.5));
            CHECK((c.z >= 0.0 && c.z <= 1.0));
        }
    }
}

TEST_CASE("patterns that are too fine or too far for numbers have a colour of theirs") {
    for (const PatternKind kind : kAll) {
        for (const double size : {5e-324, 1e-300, 1e-18, 1e300}) {
            Pattern p = pattern(kind);
            p.size = size;
            for (const Vec3& at : {Vec3(1.0, -2.0, 3.0), Vec3(1e300, 0.0, -1e300), Vec3(0.0)}) {
                const Color c = p.at(at);
                CHECK((c.x >= 0.25 && c.x <= 0.75));
                const Color mean = p.mean(at, Vec3(1e-3), Vec3(1.0, 0.0, 1e3), Vec2(0.3));
                CHECK((mean.x >= 0.25 && mean.x <= 0.75));
            }
        }
    }
}

TEST_CASE("the mean over uniform phases is the mean over the parallelogram") {
    const Vec3 corner(0.31, -0.24, 0.77);
    const Vec3 across(0.9, 0.2, 0.3);
    const Vec3 down(-0.2, 0.1, 0.6);
    Places places;
    for (const PatternKind kind : kAll) {
        const Pattern p = pattern(kind);
        Color right(0.0);
        constexpr int kFine = 400;
        for (int i = 0; i < kFine * kFine; ++i) {
            right += p.at(corner + (i % kFine + 0.5) / kFine * across +
                          (i / kFine + 0.5) / kFine * down);
        }
        right /= double(kFine * kFine);
        Color found(0.0);
        constexpr int kPhases = 4000;
        for (int i = 0; i < kPhases; ++i) {
            const Vec2 phase(places.unit(), places.unit());
            found += p.mean(corner + phase.x * across + phase.y * down, across, down, phase);
        }
        found /= double(kPhases);
        CHECK(glm::distance(found, right) < 3e-3);
    }
}

TEST_CASE("a small footprint is a point, and so is one that is not known") {
    const Pattern p = pattern(PatternKind::kMarble);
    const Vec3 at(0.3, 0.2, 0.9);
    const double nan = std::nan("");
    CHECK(p.mean(at, Vec3(1e-3, 0, 0), Vec3(0, 1e-3, 0), Vec2(0.1, 0.9)) == p.at(at));
    CHECK(p.mean(at, Vec3(nan), Vec3(nan), Vec2(0.1, 0.9)) == p.at(at));
    CHECK(p.mean(at, Vec3(kInfinity, 0, 0), Vec3(0, 1e-3, 0), Vec2(0.1, 0.9)) == p.at(at));
}
