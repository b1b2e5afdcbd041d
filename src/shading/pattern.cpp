#include "rt/shading/pattern.h"

#include "rt/core/ray.h"
#include "rt/math/portable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

constexpr double kTurn = 6.28318530717958647692;

/// Perlin's order of 0 .. 255.
constexpr std::array<std::uint8_t, 256> kOrder = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

std::uint8_t order(std::int64_t i) {
    return kOrder[static_cast<std::size_t>(i & 255)];
}

double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double between(double t, double a, double b) {
    return a + t * (b - a);
}

/// The product with one of the 12 directions to the middles of a cube's edges.
double slope(std::uint8_t hash, double x, double y, double z) {
    const int h = hash & 15;
    const double u = h < 8 ? x : y;
    const double v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

double fraction(double x) {
    return x - std::floor(x);
}

/// The sum of 2^-i f(N(2^i p)).
template <class Function>
double sumOfOctaves(Vec3 p, int octaves, const Function& f) {
    double sum = 0.0;
    double share = 1.0;
    for (int i = 0; i < octaves; ++i) {
        sum += share * f(gradientNoise(p));
        share *= 0.5;
        p *= 2.0;
    }
    return sum;
}

double noiseSum(const Vec3& p, int octaves) {
    return sumOfOctaves(p, octaves, [](double n) { return n; });
}

double isOdd(double cells) {
    return fraction(0.5 * cells) != 0.0 ? 1.0 : 0.0;
}

}  // namespace

double gradientNoise(const Vec3& p) {
    constexpr double kWhole = 0x1p52;
    if (!(std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z) < kWhole)) return 0.0;
    const Vec3 cell(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    const auto i = static_cast<std::int64_t>(cell.x);
    const auto j = static_cast<std::int64_t>(cell.y);
    const auto k = static_cast<std::int64_t>(cell.z);
    const Vec3 in = p - cell;
    const auto corner = [&](int a, int b, int c) {
        return slope(order(order(order(i + a) + j + b) + k + c), in.x - a, in.y - b, in.z - c);
    };
    const double u = fade(in.x);
    const double v = fade(in.y);
    const auto layer = [&](int c) {
        return between(v, between(u, corner(0, 0, c), corner(1, 0, c)),
                       between(u, corner(0, 1, c), corner(1, 1, c)));
    };
    return between(fade(in.z), layer(0), layer(1));
}

double Pattern::weight(const Vec3& p) const {
    const Vec3 q = p / size;
    const double along = glm::dot(q, direction);
    switch (kind) {
        case PatternKind::kChecker:
            return isOdd(std::floor(q.x) + std::floor(q.y) + std::floor(q.z));
        case PatternKind::kStripes:
            return isOdd(std::floor(along));
        case PatternKind::kGradient:
            return std::clamp(along, 0.0, 1.0);
        case PatternKind::kNoise: {
            const double most = 2.0 - std::ldexp(2.0, -octaves);
            return std::clamp(0.5 + 0.5 * noiseSum(q, octaves) / most, 0.0, 1.0);
        }
        case PatternKind::kMarble: {
            const double rough = sumOfOctaves(q, octaves, [](double n) { return std::fabs(n); });
            return 0.5 + 0.5 * portable::sincos(kTurn * fraction(along + turbulence * rough)).sin;
        }
        case PatternKind::kWood: {
            const double ring =
                glm::length(q - along * direction) + turbulence * noiseSum(q, octaves);
            return 0.5 - 0.5 * portable::sincos(kTurn * fraction(ring)).cos;
        }
    }
    return 0.0;
}

Color Pattern::at(const Vec3& p) const {
    double w = weight(p);
    // So far away, in sizes, that numbers do not hold it.
    if (!(w >= 0.0 && w <= 1.0)) w = 0.0;
    return (1.0 - w) * first + w * second;
}

int Pattern::tapsAlong(const Vec3& side) const {
    const double cells = 2.0 * std::ldexp(glm::length(side) / size, octaves - 1);
    if (!(cells > 1.0 && cells < kInfinity)) return 1;
    return static_cast<int>(std::min(std::ceil(cells), double{kMostTaps}));
}

Color Pattern::mean(const Vec3& p, const Vec3& across, const Vec3& down, const Vec2& phase) const {
    const int columns = tapsAlong(across);
    const int rows = tapsAlong(down);
    if (columns * rows == 1) return at(p);
    Color sum(0.0);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = (column + phase.x) / columns - phase.x;
            const double y = (row + phase.y) / rows - phase.y;
            // A single tap along a side that is not finite stays where it is.
            Vec3 tap = p;
            if (columns > 1) tap += x * across;
            if (rows > 1) tap += y * down;
            sum += at(tap);
        }
    }
    return sum / static_cast<double>(columns * rows);
}

}  // namespace rt
