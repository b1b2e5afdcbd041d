#include "app/commands/golden_verdict.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace rt;

namespace {

ComparedImage evenImage(int width, int height, double value) {
    ComparedImage compared;
    compared.image = {
        width, height,
        std::vector<Color>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                           Color(value))};
    compared.step = 1.0 / 255.0;
    return compared;
}

/// A smooth picture with Gaussian noise, and as much, times `together`, common to each 64 pixels.
ComparedImage noisyImage(std::uint64_t seed, double noise, double together = 0.0) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> error(0.0, noise);
    ComparedImage compared = evenImage(96, 64, 0.0);
    compared.step = 1.0 / 65535.0;
    std::vector<double> shared;
    for (int i = 0; i < 12 * 8; ++i) shared.push_back(together * error(random));
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 96; ++x) {
            const double common = shared[static_cast<std::size_t>(y / 8 * 12 + x / 8)];
            for (int c = 0; c < 3; ++c) {
                compared.image.at(x, y)[c] =
                    0.2 + 0.005 * x + (c == 1 ? 0.3 : 0.0) + error(random) + common;
            }
        }
    }
    return compared;
}

std::vector<ComparedImage> noisyImages(std::uint64_t seed, double noise, double together = 0.0) {
    std::vector<ComparedImage> images;
    for (std::uint64_t i = 0; i < 4; ++i) images.push_back(noisyImage(seed + i, noise, together));
    return images;
}

void addTo(ComparedImage& compared, int x0, int y0, int x1, int y1, double value) {
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) compared.image.at(x, y) += value;
    }
}

}  // namespace

TEST_CASE("Equal pictures are exact, and one step in a thousandth of the pixels is portable") {
    const ComparedImage a = evenImage(100, 50, 0.5);
    CHECK(verdictOf(a, a, GoldenTier::kExact).problem.empty());
    CHECK(verdictOf(a, a, GoldenTier::kPortable).tier == GoldenTier::kExact);
    ComparedImage b = a;
    for (int i = 0; i < 5; ++i) b.image.at(7 * i, 3).g += 1.0 / 255.0;
    const Verdict portable = verdictOf(a, b, GoldenTier::kPortable);
    CHECK(portable.problem.empty());
    CHECK(portable.tier == GoldenTier::kPortable);
    CHECK(verdictOf(a, b, GoldenTier::kExact).problem == "5 pixels differ, by up to 1.00/255");
    b.image.at(99, 49).r -= 1.0 / 255.0;
    CHECK_FALSE(verdictOf(a, b, GoldenTier::kPortable).problem.empty());
}

TEST_CASE("Two steps in one pixel are not portable") {
    for (int byte = 0; byte + 2 <= 255; ++byte) {
        CAPTURE(byte);
        ComparedImage a = evenImage(100, 100, 0.5);
        ComparedImage b = a;
        a.image.at(9, 9).b = byte / 255.0;
        b.image.at(9, 9).b = (byte + 1) / 255.0;
        CHECK(verdictOf(a, b, GoldenTier::kPortable).problem.empty());
        b.image.at(9, 9).b = (byte + 2) / 255.0;
        CHECK_FALSE(verdictOf(a, b, GoldenTier::kPortable).problem.empty());
    }
}

TEST_CASE("Floats may differ everywhere by less than half a step, relative above 1") {
    ComparedImage a = evenImage(10, 10, 300.0);
    a.floats = true;
    ComparedImage b = a;
    for (Color& pixel : b.image.pixels) pixel *= 1.0019;
    CHECK(verdictOf(a, b, GoldenTier::kPortable).tier == GoldenTier::kPortable);
    CHECK(verdictOf(a, b, GoldenTier::kPortable).problem.empty());
    CHECK_FALSE(verdictOf(a, b, GoldenTier::kExact).problem.empty());
    for (Color& pixel : b.image.pixels) pixel *= 1.0019;
    CHECK_FALSE(verdictOf(a, b, GoldenTier::kPortable).problem.empty());
}

TEST_CASE("What cannot be compared is named") {
    const ComparedImage a = evenImage(4, 3, 0.5);
    CHECK(incomparable(a, a).empty());
    CHECK(incomparable(a, evenImage(3, 4, 0.5)) ==
          "the sizes differ: the picture has 4x3 pixels, its reference 3x4");
    ComparedImage other = a;
    other.channels = 1;
    CHECK(incomparable(a, other).find("the picture has 3, its reference 1") != std::string::npos);
    other = a;
    other.floats = true;
    CHECK(incomparable(a, other).find("the reference has the floats") != std::string::npos);
    other = a;
    other.step = 1.0 / 65535.0;
    CHECK(incomparable(a, other).find("fewer bits") != std::string::npos);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        other = a;
        other.image.at(3, 2).g = bad;
        CHECK(incomparable(a, other).find("reference holds") != std::string::npos);
        CHECK(incomparable(other, a).find("picture holds") != std::string::npos);
        CHECK_FALSE(incomparable(other, other).empty());
    }
}

TEST_CASE("One more render passes by its statistics, of the same noise or of another") {
    for (std::uint64_t seed = 0; seed < 200; seed += 10) {
        CAPTURE(seed);
        for (const double together : {0.0, 0.5, 1.0}) {
            CAPTURE(together);
            const std::vector<ComparedImage> pictures = noisyImages(seed, 0.03, together);
            for (const double noise : {0.0, 0.003, 0.03, 0.3}) {
                CAPTURE(noise);
                const ComparedImage reference = noisyImage(seed + 5000, noise, together);
                CHECK(statisticalVerdict(pictures, reference).problem == "");
            }
        }
    }
}

TEST_CASE("A change far below the noise of a pixel fails by its statistics") {
    for (std::uint64_t seed = 0; seed < 200; seed += 10) {
        CAPTURE(seed);
        const std::vector<ComparedImage> pictures = noisyImages(seed, 0.03);
        ComparedImage everywhere = noisyImage(seed + 5000, 0.03);
        addTo(everywhere, 0, 0, 96, 64, 0.007);
        CHECK_FALSE(statisticalVerdict(pictures, everywhere).problem.empty());
        ComparedImage spot = noisyImage(seed + 5000, 0.03);
        addTo(spot, 40, 24, 48, 32, 0.07);
        CHECK(statisticalVerdict(pictures, spot).problem.find("from 40,24") != std::string::npos);
    }
}

TEST_CASE("Pictures without noise pass when equal, or one step of rounding apart") {
    const std::vector<ComparedImage> pictures(4, evenImage(20, 20, 0.5));
    CHECK(statisticalVerdict(pictures, pictures[0]).problem.empty());
    CHECK(statisticalVerdict(pictures, evenImage(20, 20, 0.5 + 1.0 / 255.0)).problem.empty());
    CHECK_FALSE(statisticalVerdict(pictures, evenImage(20, 20, 0.5 + 2.0 / 255.0)).problem.empty());
    const std::vector<ComparedImage> tiny(4, evenImage(1, 1, 0.5));
    CHECK(statisticalVerdict(tiny, tiny[0]).problem.empty());
    CHECK_FALSE(statisticalVerdict(tiny, evenImage(1, 1, 0.9)).problem.empty());
}
