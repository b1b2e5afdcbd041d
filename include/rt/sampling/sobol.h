// Owen-scrambled Sobol points in six dimensions: pixel (0, 1), lens (2, 3) and light (4, 5).
//
// The sequence is Sobol's with the direction numbers of Joe and Kuo, Constructing Sobol sequences
// with better two-dimensional projections, SIAM J. Sci. Comput. 30, 2008 (file
// new-joe-kuo-6.21201): primitive polynomials and initial m of its first six rows. Scrambling is
// Owen's nested uniform scrambling (Monte Carlo variance of scrambled net quadrature, SIAM J.
// Numer. Anal. 34, 1997) by hashing (Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020;
// Laine and Karras, Stratified sampling for stochastic transparency, EGSR 2011). The hash is that
// of Vegdahl, Building a Better LK Hash, 2021: with Laine and Karras' constants, nodes of the
// scrambling tree that lie close together flip alike.
//
// Under independent keys for the dimensions each point is uniform in the unit cube, so means of
// samples are unbiased; the first 2^m points are a (t, m, s)-net of the same t as Sobol's.
#pragma once

#include <array>
#include <cstdint>

namespace rt {

inline constexpr int kSobolDimensions = 6;

/// Pairs of dimensions that belong together.
enum class SobolPair : int { kPixel = 0, kLens = 2, kLight = 4 };

/// The bits of `x` in reverse order.
constexpr std::uint32_t reversedBits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = (x & 0x0f0f0f0f) << 4 | (x >> 4 & 0x0f0f0f0f);
    x = (x & 0x33333333) << 2 | (x >> 2 & 0x33333333);
    return (x & 0x55555555) << 1 | (x >> 1 & 0x55555555);
}

constexpr std::uint64_t reversedBits(std::uint64_t x) {
    constexpr std::uint64_t kNibbles = 0x0f0f0f0f0f0f0f0f;
    constexpr std::uint64_t kPairs = 0x3333333333333333;
    constexpr std::uint64_t kOdd = 0x5555555555555555;
    x = __builtin_bswap64(x);
    x = (x & kNibbles) << 4 | (x >> 4 & kNibbles);
    x = (x & kPairs) << 2 | (x >> 2 & kPairs);
    return (x & kOdd) << 1 | (x >> 1 & kOdd);
}

/// Owen's scrambling seen from the other end: every bit is flipped or not by a hash of the bits
/// below it.
constexpr std::uint32_t scrambledReversed(std::uint32_t x, std::uint32_t key) {
    x ^= x * 0x3d20adea;
    x += key;
    x *= key >> 16 | 1;
    x ^= x * 0x05526c56;
    x ^= x * 0x53a22864;
    return x;
}

/// Owen's scrambling of a binary fraction; two different keys should be hashes themselves.
constexpr std::uint32_t owenScrambled(std::uint32_t fraction, std::uint32_t key) {
    return reversedBits(scrambledReversed(reversedBits(fraction), key));
}

namespace sobol {

/// Row d - 1 of Joe and Kuo's table for dimension d; dimension 0 is van der Corput's sequence.
struct DirectionRow {
    int degree;
    std::uint32_t polynomial;  ///< the inner coefficients of the primitive polynomial
    std::array<std::uint32_t, 4> m;
};

inline constexpr std::array<DirectionRow, kSobolDimensions - 1> kJoeKuo = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
}};

/// Direction numbers of a dimension: column i of its generator matrix, the first bit of the
/// fraction uppermost.
constexpr std::array<std::uint32_t, 32> directions(int dimension) {
    std::array<std::uint32_t, 32> v{};
    if (dimension == 0) {
        for (unsigned i = 0; i < 32; ++i) v[i] = 1u << (31 - i);
        return v;
    }
    const DirectionRow& row = kJoeKuo[static_cast<std::size_t>(dimension - 1)];
    const auto degree = static_cast<unsigned>(row.degree);
    for (unsigned i = 0; i < 32; ++i) {
        if (i < degree) {
            v[i] = row.m[i] << (31 - i);
            continue;
        }
        v[i] = v[i - degree] ^ v[i - degree] >> degree;
        for (unsigned k = 1; k < degree; ++k) {
            if ((row.polynomial >> (degree - 1 - k) & 1) != 0) v[i] ^= v[i - k];
        }
    }
    return v;
}

using Point = std::array<std::uint32_t, kSobolDimensions>;

/// Bit-reversed coordinates of the points whose index has all its bits in one byte.
using ByteTable = std::array<Point, 256>;

constexpr std::array<ByteTable, 4> byteTables() {
    std::array<ByteTable, 4> tables{};
    for (int d = 0; d < kSobolDimensions; ++d) {
        const std::array<std::uint32_t, 32> v = directions(d);
        for (std::size_t byte = 0; byte < 4; ++byte) {
            for (std::size_t i = 1; i < 256; ++i) {
                const auto lowest =
                    static_cast<std::size_t>(__builtin_ctz(static_cast<unsigned>(i)));
                tables[byte][i][static_cast<std::size_t>(d)] =
                    tables[byte][i & (i - 1)][static_cast<std::size_t>(d)] ^
                    reversedBits(v[8 * byte + lowest]);
            }
        }
    }
    return tables;
}

inline constexpr std::array<ByteTable, 4> kTables = byteTables();

/// Coordinate of point `index` with its first bit lowermost.
constexpr std::uint32_t reversedCoordinate(std::uint32_t index, std::size_t dimension) {
    std::uint32_t x = kTables[0][index & 255][dimension];
    for (std::size_t byte = 1; (index >>= 8) != 0; ++byte) {
        x ^= kTables[byte][index & 255][dimension];
    }
    return x;
}

}  // namespace sobol

struct UnitPoint {
    double x;
    double y;
};

/// The middle of the cell of width 2^-32 that a 32-bit fraction names.
constexpr double cellMiddle(std::uint32_t fraction) {
    return (static_cast<double>(fraction) + 0.5) * 0x1p-32;
}

/// Two dimensions of point `index`, scrambled under `key`, in (0, 1)^2. The keys of the pairs
/// have to be independent; the joint properties of the six dimensions hold for any keys.
constexpr UnitPoint sobolPair(std::uint32_t index, SobolPair pair, std::uint64_t key) {
    const auto first = static_cast<std::size_t>(pair);
    const auto low = static_cast<std::uint32_t>(key);
    const auto high = static_cast<std::uint32_t>(key >> 32);
    const std::uint32_t x = scrambledReversed(sobol::reversedCoordinate(index, first), low);
    const std::uint32_t y = scrambledReversed(sobol::reversedCoordinate(index, first + 1), high);
    // Reversed as one word, the halves change places.
    const std::uint64_t both = reversedBits(std::uint64_t{y} << 32 | x);
    return {cellMiddle(static_cast<std::uint32_t>(both >> 32)),
            cellMiddle(static_cast<std::uint32_t>(both))};
}

}  // namespace rt
