#include "rt/sampling/sobol.h"

#include <doctest/doctest.h>

#include "rt/sampling/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

using namespace rt;

namespace {

constexpr std::uint64_t kSeed = 20260201;

std::uint32_t coordinate(std::uint32_t index, std::size_t dimension) {
    return reversedBits(sobol::reversedCoordinate(index, dimension));
}

/// Coordinate of a scrambled point; key 0 leaves it as it is.
std::uint32_t coordinate(std::uint32_t index, std::size_t dimension, std::uint64_t key) {
    const std::uint32_t x = coordinate(index, dimension);
    if (key == 0) return x;
    return owenScrambled(x, static_cast<std::uint32_t>(subKey(key, dimension)));
}

/// Whether every elementary interval of the shape 2^-d[0] x 2^-d[1] x ... holds equally many of the
/// points first .. first + 2^m.
bool isBalanced(const std::vector<std::size_t>& dimensions, const std::vector<unsigned>& depth,
                std::uint32_t first, unsigned m, std::uint64_t key) {
    unsigned cells = 0;
    for (const unsigned d : depth) cells += d;
    std::vector<unsigned> count(std::size_t{1} << cells, 0);
    for (std::uint32_t i = first; i < first + (1u << m); ++i) {
        std::size_t cell = 0;
        for (std::size_t k = 0; k < dimensions.size(); ++k) {
            const std::uint64_t x = coordinate(i, dimensions[k], key);
            cell = cell << depth[k] | static_cast<std::size_t>(x >> (32 - depth[k]));
        }
        ++count[cell];
    }
    for (const unsigned c : count) {
        if (c != 1u << (m - cells)) return false;
    }
    return true;
}

/// Whether all shapes of `volume` halvings are balanced, from dimension `next` on.
bool allBalanced(const std::vector<std::size_t>& dimensions, std::vector<unsigned>& depth,
                 std::size_t next, unsigned volume, std::uint32_t first, unsigned m,
                 std::uint64_t key) {
    if (next + 1 == dimensions.size()) {
        depth[next] = volume;
        return isBalanced(dimensions, depth, first, m, key);
    }
    for (unsigned d = 0; d <= volume; ++d) {
        depth[next] = d;
        if (!allBalanced(dimensions, depth, next + 1, volume - d, first, m, key)) return false;
    }
    return true;
}

/// The smallest t for which 2^m points from `first` on are a (t, m, s)-net in base 2.
unsigned netQuality(const std::vector<std::size_t>& dimensions, std::uint32_t first, unsigned m,
                    std::uint64_t key) {
    std::vector<unsigned> depth(dimensions.size(), 0);
    for (unsigned t = 0; t < m; ++t) {
        if (allBalanced(dimensions, depth, 0, m - t, first, m, key)) return t;
    }
    return m;
}

/// What the given function does to the bit below a prefix of `depth` bits: the node's flip.
template <class Scramble>
bool flipAt(Scramble scramble, unsigned depth, std::uint32_t prefix, std::uint32_t key) {
    const std::uint32_t x = depth == 0 ? 0 : prefix << (32 - depth);
    return (scramble(x, key) >> (31 - depth) & 1) != 0;
}

struct TreeStatistics {
    double worstMean;         ///< of a node's flip, from 1/2, in standard deviations
    double worstCorrelation;  ///< of two nodes' flips, in standard deviations
};

/// Flips at all nodes of the first `levels` levels of the tree, over many keys.
template <class Scramble>
TreeStatistics treeStatistics(Scramble scramble, unsigned levels, int keys) {
    const std::size_t nodes = (std::size_t{1} << levels) - 1;
    std::vector<int> ones(nodes, 0);
    std::vector<int> equal(nodes * nodes, 0);
    std::vector<char> flips(nodes);
    for (int k = 0; k < keys; ++k) {
        const auto key = static_cast<std::uint32_t>(subKey(kSeed, static_cast<std::uint64_t>(k)));
        std::size_t node = 0;
        for (unsigned depth = 0; depth < levels; ++depth) {
            for (std::uint32_t prefix = 0; prefix < 1u << depth; ++prefix, ++node) {
                flips[node] = flipAt(scramble, depth, prefix, key) ? 1 : 0;
            }
        }
        for (std::size_t a = 0; a < nodes; ++a) {
            ones[a] += flips[a];
            for (std::size_t b = 0; b < a; ++b) equal[a * nodes + b] += flips[a] == flips[b];
        }
    }
    const double deviation = 0.5 * std::sqrt(static_cast<double>(keys));
    TreeStatistics worst{0.0, 0.0};
    for (std::size_t a = 0; a < nodes; ++a) {
        worst.worstMean = std::fmax(worst.worstMean, std::fabs(ones[a] - 0.5 * keys) / deviation);
        for (std::size_t b = 0; b < a; ++b) {
            worst.worstCorrelation = std::fmax(
                worst.worstCorrelation, std::fabs(equal[a * nodes + b] - 0.5 * keys) / deviation);
        }
    }
    return worst;
}

/// Laine and Karras' constants of 2011, for comparison.
std::uint32_t scrambledWith2011Constants(std::uint32_t fraction, std::uint32_t key) {
    std::uint32_t x = reversedBits(fraction) + key;
    x ^= x * 0x6c50b47c;
    x ^= x * 0xb82f1e52;
    x ^= x * 0xc7afe638;
    x ^= x * 0x8d22f6e6;
    return reversedBits(x);
}

}  // namespace

TEST_CASE("the first Sobol points are those that Joe and Kuo's program prints") {
    // Their listing for three dimensions, in Gray code order; it starts with the origin.
    constexpr double kListing[][3] = {{0, 0, 0},
                                      {0.5, 0.5, 0.5},
                                      {0.75, 0.25, 0.25},
                                      {0.25, 0.75, 0.75},
                                      {0.375, 0.375, 0.625},
                                      {0.875, 0.875, 0.125},
                                      {0.625, 0.125, 0.875},
                                      {0.125, 0.625, 0.375},
                                      {0.1875, 0.3125, 0.9375},
                                      {0.6875, 0.8125, 0.4375}};
    for (std::uint32_t i = 0; i < 10; ++i) {
        for (std::size_t d = 0; d < 3; ++d) {
            CAPTURE(i);
            CAPTURE(d);
            CHECK(coordinate(i ^ i >> 1, d) * 0x1p-32 == kListing[i][d]);
        }
    }
}

TEST_CASE("direction numbers follow from the published rows by the published recurrence") {
    // m_1 .. m_10 of dimensions 2 to 6, worked out apart from this program from Joe and Kuo's
    // m_k = 2 a_1 m_(k-1) ^ ... ^ 2^s m_(k-s) ^ m_(k-s); the direction number is m_k / 2^k.
    constexpr std::uint32_t kM[][10] = {{1, 3, 5, 15, 17, 51, 85, 255, 257, 771},
                                        {1, 3, 3, 9, 29, 23, 71, 197, 209, 627},
                                        {1, 3, 1, 5, 31, 29, 81, 147, 433, 149},
                                        {1, 1, 1, 11, 31, 55, 61, 157, 181, 191},
                                        {1, 1, 3, 3, 25, 9, 43, 251, 449, 449}};
    for (int d = 1; d < kSobolDimensions; ++d) {
        for (unsigned k = 0; k < 10; ++k) {
            CAPTURE(d);
            CAPTURE(k);
            CHECK(sobol::directions(d)[k] == kM[d - 1][k] << (31 - k));
        }
    }
}

TEST_CASE("a pair is its two coordinates, each scrambled with its half of the key") {
    const std::uint64_t key = subKey(kSeed, 9);
    for (const SobolPair pair : {SobolPair::kPixel, SobolPair::kLens, SobolPair::kLight}) {
        const auto first = static_cast<std::size_t>(pair);
        for (const std::uint32_t index : {0u, 1u, 100u, 255u, 256u, 70000u, 0xffffffffu}) {
            const UnitPoint p = sobolPair(index, pair, key);
            const auto low = static_cast<std::uint32_t>(key);
            const auto high = static_cast<std::uint32_t>(key >> 32);
            CHECK(p.x * 0x1p32 == owenScrambled(coordinate(index, first), low) + 0.5);
            CHECK(p.y * 0x1p32 == owenScrambled(coordinate(index, first + 1), high) + 0.5);
        }
    }
}

TEST_CASE("the byte tables give what the direction numbers give, for indices of every size") {
    for (int d = 0; d < kSobolDimensions; ++d) {
        const auto v = sobol::directions(d);
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const auto index = static_cast<std::uint32_t>(subKey(kSeed, i) >> (i % 64));
            std::uint32_t expected = 0;
            for (unsigned bit = 0; bit < 32; ++bit) {
                if ((index >> bit & 1) != 0) expected ^= v[bit];
            }
            REQUIRE(coordinate(index, static_cast<std::size_t>(d)) == expected);
        }
    }
}

TEST_CASE("bits are reversed") {
    CHECK(reversedBits(0x80000000u) == 1u);
    CHECK(reversedBits(0x00000002u) == 0x40000000u);
    CHECK(reversedBits(0x12345678u) == 0x1e6a2c48u);
}

TEST_CASE("every dimension alone is a (0,1)-sequence, scrambled or not") {
    for (std::size_t d = 0; d < kSobolDimensions; ++d) {
        for (unsigned m = 1; m <= 10; ++m) {
            for (const std::uint64_t key : {std::uint64_t{0}, kSeed, kSeed + 1}) {
                CHECK(netQuality({d}, 0, m, key) == 0);
                CHECK(netQuality({d}, 5u << m, m, key) == 0);
            }
        }
    }
}

TEST_CASE("the pixel's pair is a (0,2)-sequence, scrambled or not, in every block of 2^m") {
    for (unsigned m = 1; m <= 10; ++m) {
        for (const std::uint64_t key : {std::uint64_t{0}, kSeed, kSeed + 1}) {
            for (const std::uint32_t block : {0u, 1u, 6u, 1000u}) {
                CAPTURE(m);
                CHECK(netQuality({0, 1}, block << m, m, key) == 0);
            }
        }
    }
}

TEST_CASE("the other projections have the quality t that the documentation states") {
    struct Projection {
        std::vector<std::size_t> dimensions;
        unsigned worst;  ///< t over m = 1 .. 10, for six dimensions to 8
    };
    const Projection projections[] = {
        {{2, 3}, 2}, {{4, 5}, 3},       {{0, 4}, 2},
        {{1, 5}, 3}, {{0, 1, 2, 3}, 3}, {{0, 1, 2, 3, 4, 5}, 4},
    };
    for (const Projection& p : projections) {
        CAPTURE(p.dimensions.front());
        CAPTURE(p.dimensions.back());
        unsigned plain = 0;
        unsigned scrambled = 0;
        for (unsigned m = 1; m <= (p.dimensions.size() > 4 ? 8 : 10); ++m) {
            plain = std::max(plain, netQuality(p.dimensions, 0, m, 0));
            scrambled = std::max(scrambled, netQuality(p.dimensions, 0, m, kSeed));
        }
        CHECK(plain == p.worst);
        CHECK(scrambled == plain);
    }
}

TEST_CASE("scrambling maps elementary intervals onto elementary intervals") {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto key = static_cast<std::uint32_t>(subKey(kSeed, 3 * i));
        const auto a = static_cast<std::uint32_t>(subKey(kSeed, 3 * i + 1));
        const auto shared = static_cast<unsigned>(i % 32);
        const auto other = static_cast<std::uint32_t>(subKey(kSeed, 3 * i + 2));
        const std::uint32_t b =
            shared == 0 ? other : (a >> (32 - shared)) << (32 - shared) | other >> shared;
        const std::uint32_t before = a ^ b;
        const std::uint32_t after = owenScrambled(a, key) ^ owenScrambled(b, key);
        // The highest bit in which two numbers differ stays the highest, so it is a bijection too.
        CAPTURE(a);
        CAPTURE(b);
        REQUIRE(std::countl_zero(before) == std::countl_zero(after));
    }
}

TEST_CASE("nodes of the scrambling tree flip fairly and independently") {
    constexpr int kKeys = 100000;
    constexpr unsigned kLevels = 6;
    const TreeStatistics own = treeStatistics(owenScrambled, kLevels, kKeys);
    MESSAGE("flips: mean off by " << own.worstMean << " sigma, correlation by "
                                  << own.worstCorrelation);
    const TreeStatistics old = treeStatistics(scrambledWith2011Constants, kLevels, kKeys);
    MESSAGE("with the constants of 2011: " << old.worstMean << ", " << old.worstCorrelation);
    CHECK(own.worstMean < 5.0);
    CHECK(own.worstCorrelation < 5.0);
    CHECK(old.worstCorrelation > 20.0);
}

TEST_CASE("a flip depends on every single bit above it, deep in the tree as well") {
    constexpr int kKeys = 40000;
    double worst = 0.0;
    for (unsigned depth = 1; depth < 32; ++depth) {
        for (unsigned bit = 0; bit < depth; ++bit) {
            const auto prefix =
                static_cast<std::uint32_t>(subKey(kSeed, 32 * depth + bit) >> (64 - depth));
            int equal = 0;
            for (int k = 0; k < kKeys; ++k) {
                const auto key =
                    static_cast<std::uint32_t>(subKey(kSeed + 1, static_cast<std::uint64_t>(k)));
                equal += flipAt(owenScrambled, depth, prefix, key) ==
                         flipAt(owenScrambled, depth, prefix ^ 1u << bit, key);
            }
            worst = std::fmax(worst, std::fabs(equal - 0.5 * kKeys) / (0.5 * std::sqrt(kKeys)));
        }
    }
    MESSAGE("equal flips off by " << worst << " sigma at most");
    CHECK(worst < 5.0);
}

TEST_CASE("every scrambled point is uniform over the keys") {
    constexpr int kCells = 16;
    constexpr int kKeys = 65536;
    for (const SobolPair pair : {SobolPair::kPixel, SobolPair::kLens, SobolPair::kLight}) {
        for (const std::uint32_t index : {0u, 1u, 77u, 4000u, 70000u}) {
            std::vector<int> count(kCells * kCells, 0);
            for (int k = 0; k < kKeys; ++k) {
                const UnitPoint p =
                    sobolPair(index, pair, subKey(kSeed, static_cast<std::uint64_t>(k)));
                REQUIRE(p.x > 0.0);
                REQUIRE(p.x < 1.0);
                ++count[static_cast<std::size_t>(p.x * kCells) * kCells +
                        static_cast<std::size_t>(p.y * kCells)];
            }
            const double expected = static_cast<double>(kKeys) / (kCells * kCells);
            double chiSquare = 0.0;
            for (const int c : count) chiSquare += (c - expected) * (c - expected) / expected;
            // 255 degrees of freedom: mean 255, standard deviation 22.6.
            CAPTURE(index);
            CHECK(chiSquare < 255 + 4.5 * 22.6);
            CHECK(chiSquare > 255 - 4.5 * 22.6);
        }
    }
}
