// Numbers that are functions of what they are for: no state, so that no order of work can change
// them.
#pragma once

#include <cstdint>

namespace rt {

/// A bijection of 64 bits in which every input bit flips every output bit with probability 1/2:
/// variant 13 of Stafford, Better Bit Mixing, 2011, as used by Steele, Lea and Flood, Fast
/// Splittable Pseudorandom Number Generators, OOPSLA 2014.
constexpr std::uint64_t mixBits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

/// The key of everything that one more value distinguishes below a key.
constexpr std::uint64_t subKey(std::uint64_t key, std::uint64_t value) {
    return mixBits(key + 0x9e3779b97f4a7c15 * (value + 1));
}

/// The key of pixel (x, y) under a seed.
constexpr std::uint64_t pixelKey(std::uint64_t seed, int x, int y) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::uint32_t>(x));
    const auto row = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y));
    return subKey(mixBits(seed), column << 32 | row);
}

/// The upper 53 bits as a multiple of 2^-53 in [0, 1).
constexpr double toUnit(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// Uniform in [0, 1), independent for different arguments.
constexpr double randomUnit(std::uint64_t seed, int x, int y, std::uint64_t sample,
                            std::uint64_t dimension) {
    return toUnit(subKey(subKey(pixelKey(seed, x, y), sample), dimension));
}

/// Number `index` of a random permutation of [0, count), count >= 1: a bijection of the next power
/// of two, repeated until the result is in range (Kensler, Correlated Multi-Jittered Sampling,
/// Pixar Technical Memo 13-01, 2013, section "Permutations").
constexpr std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    std::uint32_t mask = count - 1;
    mask |= mask >> 1;
    mask |= mask >> 2;
    mask |= mask >> 4;
    mask |= mask >> 8;
    mask |= mask >> 16;
    const auto low = static_cast<std::uint32_t>(key);
    const auto high = static_cast<std::uint32_t>(key >> 32);
    // Every step is a bijection of the masked bits: an odd factor, an added key, a shift to the
    // right xored on.
    const auto round = [mask](std::uint32_t i, std::uint32_t factor, std::uint32_t add) {
        i = ((i + add) & mask) * (factor | 1) & mask;
        i ^= i >> 1;
        i ^= i >> 4;
        i ^= i >> 9;
        return i;
    };
    do {
        index = round(index, 0xe170893d ^ high, low);
        index = round(index, 0x0929eb3f ^ low >> 7, high);
        index = round(index, 0x6935fa69 ^ high >> 9, low >> 16 ^ high << 16);
        index = round(index, 0x9e501cc3 ^ low, high >> 5);
    } while (index >= count);
    return index;
}

}  // namespace rt
