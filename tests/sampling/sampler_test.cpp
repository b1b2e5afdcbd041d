#include "rt/sampling/sampler.h"

#include <doctest/doctest.h>

#include "rt/sampling/warp.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace rt;

namespace {

constexpr std::uint64_t kSeed = 20260203;
constexpr SamplerKind kKinds[] = {SamplerKind::kJoint, SamplerKind::kJitter, SamplerKind::kGrid,
                                  SamplerKind::kRandom};

Sampler samplerOf(SamplerKind kind, int samples, std::uint64_t seed = kSeed) {
    return Sampler({kind, FilterKind::kBox, seed, samples});
}

/// The six numbers of a sample, with one light at one node.
std::vector<double> numbersOf(Sampler& sampler, int x, int y, int index) {
    sampler.start(x, y, index);
    const Vec2 pixel = sampler.pixel().offset;
    const Vec2 lens = sampler.lens();
    const Vec2 light = sampler.light(1, 0);
    return {pixel.x + 0.5, pixel.y + 0.5, lens.x, lens.y, light.x, light.y};
}

/// The cell of a point among n of equal area, found by looking at all of them.
int cellOf(const Strata& strata, int n, const Vec2& p) {
    for (int cell = 0; cell < n; ++cell) {
        const auto i = static_cast<std::uint64_t>(cell);
        const Vec2 low = strata.inCell(i, Vec2(0.0));
        const Vec2 high = strata.inCell(i, Vec2(1.0));
        if (p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y) return cell;
    }
    return -1;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - 0.5) * (b[i] - 0.5);
        aa += (a[i] - 0.5) * (a[i] - 0.5);
        bb += (b[i] - 0.5) * (b[i] - 0.5);
    }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

TEST_CASE("mixed bits are those of the published generator") {
    // SplitMix64 from state 0, as in Steele, Lea and Flood's Java code: its first three outputs.
    CHECK(mixBits(0x9e3779b97f4a7c15) == 0xe220a8397b1dcdaf);
    CHECK(mixBits(2 * 0x9e3779b97f4a7c15) == 0x6e789e6aa1b965f4);
    CHECK(mixBits(3 * 0x9e3779b97f4a7c15) == 0x06c45d188009454f);
}

TEST_CASE("units are multiples of 2^-53 below 1") {
    CHECK(toUnit(0) == 0.0);
    CHECK(toUnit(~std::uint64_t{0}) == 1.0 - 0x1p-53);
    CHECK(toUnit(std::uint64_t{1} << 63) == 0.5);
}

TEST_CASE("random numbers differ and do not correlate when any one argument moves by one") {
    constexpr int kCount = 20000;
    std::vector<double> base;
    std::vector<std::vector<double>> moved(5);
    for (int i = 0; i < kCount; ++i) {
        const int x = i % 141 - 20;
        const int y = i / 141 - 30;
        base.push_back(randomUnit(kSeed, x, y, 5, 2));
        moved[0].push_back(randomUnit(kSeed + 1, x, y, 5, 2));
        moved[1].push_back(randomUnit(kSeed, x + 1, y, 5, 2));
        moved[2].push_back(randomUnit(kSeed, x, y + 1, 5, 2));
        moved[3].push_back(randomUnit(kSeed, x, y, 6, 2));
        moved[4].push_back(randomUnit(kSeed, x, y, 5, 3));
    }
    double mean = 0.0;
    for (const double u : base) mean += u / kCount;
    CHECK(std::fabs(mean - 0.5) < 4.5 * std::sqrt(1.0 / 12.0 / kCount));
    for (const auto& other : moved) {
        CHECK(std::fabs(correlation(base, other)) < 4.5 / std::sqrt(1.0 * kCount));
    }
    CHECK(std::set<double>(base.begin(), base.end()).size() == base.size());
    CHECK(randomUnit(kSeed, 1, 2, 3, 4) != randomUnit(kSeed, 2, 1, 3, 4));
    CHECK(randomUnit(kSeed, 1, 2, 3, 4) != randomUnit(kSeed, 1, 2, 4, 3));
}

TEST_CASE("permutations are permutations for every count, and all places are equally likely") {
    for (std::uint32_t count = 1; count <= 300; ++count) {
        std::set<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < count; ++i) {
            seen.insert(permuted(i, count, subKey(kSeed, count)));
        }
        REQUIRE(seen.size() == count);
        REQUIRE(*seen.rbegin() == count - 1);
    }
    // A count of more than 16 bits: every number of the range is taken once.
    constexpr std::uint32_t kMany = (1 << 20) + 1;
    std::vector<bool> taken(kMany, false);
    for (std::uint32_t i = 0; i < kMany; ++i) taken[permuted(i, kMany, kSeed)] = true;
    CHECK(std::find(taken.begin(), taken.end(), false) == taken.end());
    constexpr int kKeys = 40000;
    for (const std::uint32_t count : {5u, 8u, 16u, 23u}) {
        std::vector<int> place(count * count, 0);
        for (std::uint64_t k = 0; k < kKeys; ++k) {
            for (std::uint32_t i = 0; i < count; ++i) {
                ++place[i * count + permuted(i, count, subKey(kSeed, k))];
            }
        }
        const double expected = static_cast<double>(kKeys) / count;
        for (const int c : place) CHECK(std::fabs(c - expected) < 5.5 * std::sqrt(expected));
    }
}

TEST_CASE("strata have equal areas and cover the square, for every count") {
    for (int n = 1; n <= 200; ++n) {
        CAPTURE(n);
        const Strata strata(n);
        double area = 0.0;
        for (int cell = 0; cell < n; ++cell) {
            const auto i = static_cast<std::uint64_t>(cell);
            const Vec2 size = strata.inCell(i, Vec2(1.0)) - strata.inCell(i, Vec2(0.0));
            REQUIRE(size.x * size.y == doctest::Approx(1.0 / n).epsilon(1e-13));
            // Near-square: no cell is more than about twice as long as wide, but for 2 and 3.
            if (n > 3) REQUIRE(std::max(size.x / size.y, size.y / size.x) < 2.1);
            area += size.x * size.y;
            REQUIRE(cellOf(strata, n, strata.inCell(i, Vec2(0.5))) == cell);
        }
        CHECK(area == doctest::Approx(1.0).epsilon(1e-12));
    }
    // Squares of whole numbers give the plain grid, row by row.
    const Strata nine(9);
    CHECK(nine.middle(0) == Vec2(0.5 / 3, 0.5 / 3));
    CHECK(nine.middle(5).x == doctest::Approx(2.5 / 3));
    CHECK(nine.middle(5).y == doctest::Approx(0.5));
}

TEST_CASE("all numbers lie in the unit square and depend on nothing but their arguments") {
    for (const SamplerKind kind : kKinds) {
        Sampler sampler = samplerOf(kind, 16);
        Sampler other = samplerOf(kind, 16);
        for (int index = 0; index < 40; ++index) {
            const std::vector<double> u = numbersOf(sampler, 7, -3, index);
            for (const double v : u) {
                REQUIRE(v >= 0.0);
                REQUIRE(v < 1.0);
            }
            // The other sampler comes from elsewhere, and asks in another order.
            numbersOf(other, index, 1000, 39 - index);
            other.start(7, -3, index);
            other.light(9, 9);
            REQUIRE(other.light(1, 0) == Vec2(u[4], u[5]));
            REQUIRE(other.lens() == Vec2(u[2], u[3]));
        }
    }
}

TEST_CASE("joint and random points do not depend on how many there will be") {
    for (const SamplerKind kind : {SamplerKind::kJoint, SamplerKind::kRandom}) {
        Sampler few = samplerOf(kind, 1);
        Sampler many = samplerOf(kind, 4096);
        for (int index = 0; index < 5000; index += 7) {
            REQUIRE(numbersOf(few, 3, 4, index) == numbersOf(many, 3, 4, index));
        }
    }
}

TEST_CASE("joint points are those of the scrambled sequence, pair by pair") {
    Sampler sampler = samplerOf(SamplerKind::kJoint, 1);
    const std::uint64_t pixel = pixelKey(kSeed, 12, 34);
    for (std::uint32_t index = 0; index < 64; ++index) {
        const std::vector<double> u = numbersOf(sampler, 12, 34, static_cast<int>(index));
        const UnitPoint p = sobolPair(index, SobolPair::kPixel, subKey(pixel, 0));
        const UnitPoint q = sobolPair(index, SobolPair::kLens, subKey(pixel, 1));
        const UnitPoint r =
            sobolPair(index, SobolPair::kLight, subKey(pixel, 2 + (std::uint64_t{1} << 32)));
        CHECK(u == std::vector<double>{p.x - 0.5 + 0.5, p.y - 0.5 + 0.5, q.x, q.y, r.x, r.y});
    }
}

TEST_CASE("pixels, seeds, streams, nodes and lights are scrambled independently") {
    for (const SamplerKind kind :
         {SamplerKind::kJoint, SamplerKind::kJitter, SamplerKind::kRandom}) {
        constexpr int kPixels = 20000;
        std::vector<std::vector<double>> columns(9);
        Sampler sampler = samplerOf(kind, 16);
        Sampler reseeded = samplerOf(kind, 16, kSeed + 1);
        for (int i = 0; i < kPixels; ++i) {
            const std::vector<double> u = numbersOf(sampler, i % 200, i / 200, 3);
            for (std::size_t d = 0; d < 6; ++d) columns[d].push_back(u[d]);
            columns[6].push_back(sampler.light(1, 1).x);
            columns[7].push_back(sampler.light(2, 0).x);
            columns[8].push_back(numbersOf(reseeded, i % 200, i / 200, 3)[0]);
        }
        for (std::size_t a = 0; a < columns.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                CAPTURE(a);
                CAPTURE(b);
                CHECK(std::fabs(correlation(columns[a], columns[b])) <
                      4.5 / std::sqrt(1.0 * kPixels));
            }
        }
    }
}

TEST_CASE("random samples of a pixel are independent of each other") {
    constexpr int kPixels = 20000;
    std::vector<std::vector<double>> columns(4);
    Sampler sampler = samplerOf(SamplerKind::kRandom, 16);
    for (int i = 0; i < kPixels; ++i) {
        for (int index = 0; index < 4; ++index) {
            columns[static_cast<std::size_t>(index)].push_back(
                numbersOf(sampler, i % 200, i / 200, index)[2]);
        }
    }
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            CHECK(std::fabs(correlation(columns[a], columns[b])) < 4.5 / std::sqrt(1.0 * kPixels));
        }
    }
}

TEST_CASE("jitter puts one point into each cell, for every count, stream and pass") {
    for (const int n : {1, 2, 3, 5, 9, 16, 23, 64}) {
        const Strata strata(n);
        Sampler sampler = samplerOf(SamplerKind::kJitter, n);
        for (int pass = 0; pass < 3; ++pass) {
            std::vector<std::set<int>> cells(3);
            for (int i = 0; i < n; ++i) {
                const std::vector<double> u = numbersOf(sampler, 5, 6, pass * n + i);
                for (std::size_t s = 0; s < 3; ++s) {
                    cells[s].insert(cellOf(strata, n, {u[2 * s], u[2 * s + 1]}));
                }
            }
            for (const auto& seen : cells) {
                CAPTURE(n);
                CHECK(seen.size() == static_cast<std::size_t>(n));
                CHECK(*seen.begin() == 0);
            }
        }
    }
}

TEST_CASE("jittered points are uniform and the passes differ") {
    constexpr int kPixels = 40000;
    constexpr int kCells = 8;
    std::vector<int> count(kCells * kCells, 0);
    Sampler sampler = samplerOf(SamplerKind::kJitter, 5);
    int equal = 0;
    for (int i = 0; i < kPixels; ++i) {
        const std::vector<double> u = numbersOf(sampler, i % 200, i / 200, 2);
        ++count[static_cast<std::size_t>(u[4] * kCells) * kCells +
                static_cast<std::size_t>(u[5] * kCells)];
        equal += numbersOf(sampler, i % 200, i / 200, 7) == u ? 1 : 0;
    }
    const double expected = static_cast<double>(kPixels) / (kCells * kCells);
    for (const int c : count) CHECK(std::fabs(c - expected) < 5 * std::sqrt(expected));
    CHECK(equal == 0);
}

TEST_CASE("the grid is one grid for pixel, lens and lights, and for every pixel") {
    Sampler sampler = samplerOf(SamplerKind::kGrid, 9);
    for (int index = 0; index < 18; ++index) {
        const std::vector<double> u = numbersOf(sampler, 1, 2, index);
        CHECK(u == numbersOf(sampler, 8, 9, index));
        CHECK(u[2] == doctest::Approx((index % 3 + 0.5) / 3));
        CHECK(u[3] == doctest::Approx((index / 3 % 3 + 0.5) / 3));
        for (const std::size_t d : {0u, 4u}) {
            CHECK(u[d] == doctest::Approx(u[2]));
            CHECK(u[d + 1] == doctest::Approx(u[3]));
        }
    }
}

TEST_CASE("the sampler's pixel goes through the filter") {
    Sampler sampler({SamplerKind::kJoint, FilterKind::kMitchell, kSeed, 16});
    bool negative = false;
    bool outside = false;
    for (int index = 0; index < 256; ++index) {
        sampler.start(0, 0, index);
        const FilterSample s = sampler.pixel();
        negative = negative || s.weight < 0.0;
        outside = outside || std::fabs(s.offset.x) > 0.5;
    }
    CHECK(negative);
    CHECK(outside);
}

TEST_CASE("numbers, filters and warps have the bits of every other machine") {
    std::uint64_t hash = 0;
    const auto add = [&hash](double v) { hash = mixBits(hash ^ std::bit_cast<std::uint64_t>(v)); };
    const Vec3 axis(0.36, -0.48, 0.8);
    for (const SamplerKind kind : kKinds) {
        for (const FilterKind filter : {FilterKind::kBox, FilterKind::kGaussian,
                                        FilterKind::kMitchell, FilterKind::kBlackmanHarris}) {
            Sampler sampler({kind, filter, kSeed, 23});
            for (int index = 0; index < 5000; ++index) {
                sampler.start(index % 7, index % 5, index);
                const FilterSample s = sampler.pixel();
                const Vec2 lens = concentricDisc(sampler.lens());
                const Vec3 light = coneDirection(axis, 0.3, sampler.light(3, 1));
                for (const double v : {s.offset.x, s.offset.y, s.weight, lens.x, lens.y, light.x,
                                       light.y, light.z}) {
                    add(v);
                }
            }
        }
    }
    CHECK(hash == 0xf1741b1e5ddf9a5d);
}
