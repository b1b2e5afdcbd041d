#include "rt/sampling/warp.h"

#include <doctest/doctest.h>

#include "rt/sampling/random.h"

#include <cmath>
#include <vector>

using namespace rt;

namespace {

constexpr std::uint64_t kSeed = 20260202;
constexpr double kPi = 3.141592653589793;

Vec2 randomPoint(std::uint64_t i) {
    return {toUnit(subKey(kSeed, 2 * i)), toUnit(subKey(kSeed, 2 * i + 1))};
}

Vec3 randomDirection(std::uint64_t i) {
    const Vec2 u = randomPoint(i);
    const double z = 2.0 * u.x - 1.0;
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(2.0 * kPi * u.y), r * std::sin(2.0 * kPi * u.y), z};
}

/// Directions where a basis could go wrong, then random ones.
std::vector<Vec3> directions() {
    std::vector<Vec3> all = {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}};
    for (const double tilt : {1e-300, 1e-17, 1e-9, 1e-6, 1e-3}) {
        for (const double sign : {1.0, -1.0}) {
            all.push_back(glm::normalize(Vec3(tilt, -tilt, sign)));
            all.push_back(glm::normalize(Vec3(1.0, tilt, sign * tilt)));
        }
    }
    for (std::uint64_t i = 0; i < 1000; ++i) all.push_back(randomDirection(i));
    return all;
}

double chiSquare(const std::vector<int>& count, double expected) {
    double sum = 0.0;
    for (const int c : count) sum += (c - expected) * (c - expected) / expected;
    return sum;
}

}  // namespace

TEST_CASE("the disc's map takes the square's centre, sides and corners where Shirley and Chiu do") {
    const double h = std::sqrt(0.5);
    CHECK(concentricDisc({0.5, 0.5}) == Vec2(0.0, 0.0));
    CHECK(concentricDisc({1.0, 0.5}) == Vec2(1.0, 0.0));
    CHECK(concentricDisc({0.0, 0.5}) == Vec2(-1.0, 0.0));
    CHECK(concentricDisc({0.5, 1.0}) == Vec2(0.0, 1.0));
    CHECK(concentricDisc({0.5, 0.0}) == Vec2(0.0, -1.0));
    for (const double x : {0.0, 1.0}) {
        for (const double y : {0.0, 1.0}) {
            const Vec2 corner = concentricDisc({x, y});
            CHECK(corner.x == doctest::Approx((2 * x - 1) * h).epsilon(1e-15));
            CHECK(corner.y == doctest::Approx((2 * y - 1) * h).epsilon(1e-15));
        }
    }
}

TEST_CASE(
    "the disc's map carries squares about the centre to circles, and equal areas to equal areas") {
    // Rings and sectors of equal area hold equally many of the points of a fine grid.
    constexpr int kGrid = 1024;
    constexpr int kRings = 8;
    constexpr int kSectors = 8;
    std::vector<int> count(kRings * kSectors, 0);
    for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
            const Vec2 u{(i + 0.5) / kGrid, (j + 0.5) / kGrid};
            const Vec2 p = concentricDisc(u);
            const double side = std::fmax(std::fabs(2 * u.x - 1), std::fabs(2 * u.y - 1));
            REQUIRE(std::hypot(p.x, p.y) == doctest::Approx(side).epsilon(1e-14));
            const double radius = p.x * p.x + p.y * p.y;
            const double angle = std::atan2(p.y, p.x) / (2 * kPi) + 0.5;
            const int ring = std::min(static_cast<int>(radius * kRings), kRings - 1);
            const int sector = std::min(static_cast<int>(angle * kSectors), kSectors - 1);
            ++count[static_cast<std::size_t>(ring * kSectors + sector)];
        }
    }
    const double expected = static_cast<double>(kGrid) * kGrid / (kRings * kSectors);
    for (const int c : count) CHECK(std::fabs(c - expected) < 0.03 * expected);
}

TEST_CASE("the basis is orthonormal and right-handed for every direction") {
    for (const Vec3& n : directions()) {
        const Basis b = orthonormalBasis(n);
        CAPTURE(n.x);
        CAPTURE(n.y);
        CAPTURE(n.z);
        CHECK(std::fabs(glm::dot(b.tangent, n)) < 1e-15);
        CHECK(std::fabs(glm::dot(b.bitangent, n)) < 1e-15);
        CHECK(std::fabs(glm::dot(b.tangent, b.bitangent)) < 1e-15);
        CHECK(glm::length(b.tangent) == doctest::Approx(1.0).epsilon(1e-15));
        CHECK(glm::length(b.bitangent) == doctest::Approx(1.0).epsilon(1e-15));
        CHECK(glm::length(glm::cross(b.tangent, b.bitangent) - n) < 1e-15);
    }
}

TEST_CASE("cone directions are unit vectors inside the cone, from the tiniest cone to the sphere") {
    const std::vector<Vec3> axes = directions();
    for (const double drop : {0.0, 1e-300, 1e-30, 1e-18, 1e-9, 1e-3, 0.5, 1.0, 1.7, 2.0}) {
        CAPTURE(drop);
        const double sine = std::sqrt(drop * (2.0 - drop));
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const Vec3 w = coneDirection(axes[i], drop, randomPoint(i));
            REQUIRE(std::fabs(glm::length(w) - 1.0) < 1e-15);
            const double across = glm::length(glm::cross(axes[i], w));
            if (drop < 0.5) REQUIRE(across <= sine + 1e-15);
            REQUIRE(1.0 - glm::dot(axes[i], w) <= drop + 1e-15);
        }
    }
    CHECK(coneDirection({0, 0, 1}, 0.0, {0.3, 0.9}) == Vec3(0, 0, 1));
    // The middle of the square is the axis, its sides are the rim.
    CHECK(coneDirection({0, 1, 0}, 0.3, {0.5, 0.5}) == Vec3(0, 1, 0));
    CHECK(coneDirection({0, 1, 0}, 0.3, {1.0, 0.5}).y == doctest::Approx(0.7).epsilon(1e-15));
}

TEST_CASE("a cone too small for its cosine still has its radius") {
    // 1 - cos A = 1e-24: cos A rounds to 1, yet the rim is 1.4e-12 from the axis.
    const Vec3 rim = coneDirection({0, 0, 1}, 1e-24, {1.0, 0.5});
    CHECK(std::hypot(rim.x, rim.y) == doctest::Approx(std::sqrt(2e-24)).epsilon(1e-12));
}

TEST_CASE("cone directions are uniform in solid angle") {
    constexpr int kHeights = 8;
    constexpr int kSectors = 8;
    constexpr int kPoints = 64000;
    const Vec3 axis = glm::normalize(Vec3(0.3, -0.5, 0.8));
    const Basis basis = orthonormalBasis(axis);
    for (const double drop : {1e-12, 0.2, 1.0, 2.0}) {
        std::vector<int> count(kHeights * kSectors, 0);
        for (std::uint64_t i = 0; i < kPoints; ++i) {
            const Vec3 w = coneDirection(axis, drop, randomPoint(i));
            const double x = glm::dot(w, basis.tangent);
            const double y = glm::dot(w, basis.bitangent);
            // 1 - cos from the sine in the small cone, from the cosine in the large.
            const double fall = drop < 0.5
                                    ? (x * x + y * y) / (1.0 + std::sqrt(1.0 - x * x - y * y))
                                    : 1.0 - glm::dot(w, axis);
            const int height = std::min(static_cast<int>(fall / drop * kHeights), kHeights - 1);
            const double angle = std::atan2(y, x) / (2 * kPi) + 0.5;
            const int sector = std::min(static_cast<int>(angle * kSectors), kSectors - 1);
            ++count[static_cast<std::size_t>(height * kSectors + sector)];
        }
        // 63 degrees of freedom: mean 63, standard deviation 11.2.
        CAPTURE(drop);
        CHECK(chiSquare(count, kPoints / 64.0) < 63 + 4.5 * 11.2);
    }
}
