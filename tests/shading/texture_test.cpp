#include "rt/shading/texture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace rt;

Image grey8(int width, int height, std::vector<std::uint8_t> codes) {
    return {width, height, 1, std::move(codes)};
}

/// Red by column, green by row, both as codes.
Image ramps(int width, int height) {
    std::vector<std::uint8_t> codes;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int code : {10 * x, 20 * y, 7}) {
                codes.push_back(static_cast<std::uint8_t>(code));
            }
        }
    }
    return {width, height, 3, std::move(codes)};
}

TEST_CASE("at a texel's centre the value is code / 255, with v = 0 at the bottom row") {
    const Texture texture(ramps(4, 3));
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const Color c = texture.bilinear({(x + 0.5) / 4, 1.0 - (y + 0.5) / 3});
            CHECK(c.x == doctest::Approx(10 * x / 255.0).epsilon(1e-14));
            CHECK(c.y == doctest::Approx(20 * y / 255.0).epsilon(1e-14));
            CHECK(c.z == 7 / 255.0);
        }
    }
    const Texture flipped(ramps(4, 3), {true});
    CHECK(flipped.bilinear({0.125, 0.5 / 3}).y == doctest::Approx(0.0));
    CHECK(flipped.bilinear({0.125, 2.5 / 3}).y == doctest::Approx(40 / 255.0));
}

TEST_CASE("between centres the value is bilinear, across the border too") {
    const Texture texture(grey8(2, 2, {0, 100, 40, 200}));
    CHECK(texture.bilinear({0.5, 0.75}).x == doctest::Approx(50 / 255.0));
    CHECK(texture.bilinear({0.25, 0.5}).x == doctest::Approx(20 / 255.0));
    CHECK(texture.bilinear({0.5, 0.5}).x == doctest::Approx(85 / 255.0));
    CHECK(texture.bilinear({0.0, 0.75}).x == doctest::Approx(50 / 255.0));
    CHECK(texture.bilinear({0.375, 0.75}).x == doctest::Approx(25 / 255.0));
    CHECK(texture.bilinear({0.25, 0.0}).x == doctest::Approx(20 / 255.0));
    CHECK(texture.bilinear({0.25, 0.5}).z == texture.bilinear({0.25, 0.5}).x);
}

TEST_CASE("a tile with held edges blends with none of its repeats") {
    TextureSettings settings;
    settings.heldEdges = true;
    const Texture texture(grey8(2, 2, {0, 100, 40, 200}), settings);
    CHECK(texture.bilinear({0.0, 0.75}).x == 0.0);
    CHECK(texture.bilinear({0.999, 0.75}).x == 100 / 255.0);
    CHECK(texture.bilinear({1.0, 0.75}).x == 0.0);
    CHECK(texture.bilinear({0.25, 0.001}).x == 40 / 255.0);
    CHECK(texture.bilinear({0.5, 0.5}).x == doctest::Approx(85 / 255.0));
    CHECK(texture.bilinear({-0.75, 1.75}).x == texture.bilinear({0.25, 0.75}).x);
    const Texture grey(grey8(1, 1, {77}), settings);
    CHECK(grey.bilinear({0.3, 0.9}).x == 77 / 255.0);
}

TEST_CASE("a texture repeats outside the unit square") {
    const Texture texture(ramps(5, 4));
    const unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 uv(unit(random), unit(random));
        const Vec2 shift(static_cast<double>(random() % 9) - 4,
                         static_cast<double>(random() % 9) - 4);
        const Color difference = texture.bilinear(uv) - texture.bilinear(uv + shift);
        CHECK(glm::length(difference) < 1e-12);
    }
}

TEST_CASE("every uv has a finite value within the image's range") {
    const double inf = std::numeric_limits<double>::infinity();
    const double values[] = {0.0,   -0.0,         1.0,         -1.0,   1e30,
                             -1e30, 1e308,        -1e-320,     -1e-17, inf,
                             -inf,  std::nan(""), 1.0 - 1e-16, 0.5,    3.999999999999};
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 7), std::pair(5, 2)}) {
        const Texture texture(ramps(width, height));
        for (const double u : values) {
            for (const double v : values) {
                const Color c = texture.bilinear({u, v});
                CHECK(c.x >= 0.0);
                CHECK(c.x <= 10 * (width - 1) / 255.0 + 1e-15);
                CHECK(c.z == doctest::Approx(7 / 255.0).epsilon(1e-15));
            }
        }
    }
    CHECK(Texture(ramps(3, 3)).bilinear({std::nan(""), 0.3}) ==
          Texture(ramps(3, 3)).bilinear({0.0, 0.3}));
}

TEST_CASE("16 bits and floats keep their precision") {
    const Texture wide(Image{2, 1, 1, std::vector<std::uint16_t>{0, 12345}});
    CHECK(wide.bilinear({0.75, 0.5}).x == 12345 / 65535.0);
    CHECK(wide.bilinearCodes({0.75, 0.5}).x == 12345 / 257.0);
    const Texture floats(Image{2, 1, 3, std::vector<float>{0, 0, 0, 1e6f, 0.5f, 3}});
    CHECK(floats.bilinear({0.75, 0.5}) == Color(1e6, 0.5, 3));
    CHECK(floats.bilinearCodes({0.75, 0.5}).y == 127.5);
}

TEST_CASE("sRGB is made linear before the blend, floats are not touched") {
    const Texture texture(grey8(2, 1, {0, 188}), {false, true});
    const double full = std::pow((188 / 255.0 + 0.055) / 1.055, 2.4);
    CHECK(texture.bilinear({0.75, 0.5}).x == doctest::Approx(full).epsilon(1e-14));
    CHECK(texture.bilinear({0.5, 0.5}).x == doctest::Approx(full / 2).epsilon(1e-14));
    CHECK(Texture(grey8(1, 1, {5}), {false, true}).bilinear({0, 0}).x ==
          doctest::Approx(5 / 255.0 / 12.92).epsilon(1e-14));
    CHECK(Texture(grey8(1, 1, {255}), {false, true}).bilinear({0, 0}).x == 1.0);
    const Texture wide(Image{1, 1, 1, std::vector<std::uint16_t>{188 * 257}}, {false, true});
    CHECK(wide.bilinear({0, 0}).x == doctest::Approx(full).epsilon(1e-14));
    const Texture floats(Image{1, 1, 1, std::vector<float>{0.5f}}, {false, true});
    CHECK(floats.bilinear({0, 0}).x == 0.5);
}

TEST_CASE("the gradient is the slope of the heights") {
    // Height = 3 codes a column and 5 codes a row downwards, away from the border.
    std::vector<std::uint8_t> codes;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) codes.push_back(static_cast<std::uint8_t>(3 * x + 5 * y));
    }
    for (const bool flip : {false, true}) {
        const Texture texture(grey8(16, 8, codes), {flip});
        for (const Vec2 uv : {Vec2(0.5, 0.5), Vec2(0.31, 0.44), Vec2(0.6, 0.7)}) {
            const Vec2 slope = texture.gradient(uv);
            CHECK(slope.x == doctest::Approx(3 * 16 / 255.0));
            CHECK(slope.y == doctest::Approx((flip ? 5 : -5) * 8 / 255.0));
        }
    }
    CHECK(Texture(grey8(3, 3, std::vector<std::uint8_t>(9, 77))).gradient({0.123, 0.456}) ==
          Vec2(0.0));
}

// A checker of 1 and 0 with squares of `square` texels, as wide as the image.
Image checker(int size, int square) {
    std::vector<std::uint8_t> codes;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) codes.push_back((x / square + y / square) % 2 ? 255 : 0);
    }
    return grey8(size, size, std::move(codes));
}

/// The mean of the full-resolution value over the footprint, by brute force.
double meanOver(const Texture& texture, const Vec2& uv, const Vec2& dx, const Vec2& dy) {
    constexpr int kSteps = 300;
    double sum = 0.0;
    for (int j = 0; j < kSteps; ++j) {
        for (int i = 0; i < kSteps; ++i) {
            const Vec2 p = uv + ((i + 0.5) / kSteps - 0.5) * dx + ((j + 0.5) / kSteps - 0.5) * dy;
            sum += texture.bilinear(p).x;
        }
    }
    return sum / (kSteps * kSteps);
}

struct FilteredErrors {
    double single = 0.0;   ///< RMS of the filtered values
    double average = 0.0;  ///< RMS of their means over all phases
};

/// Against exact means, for footprints of any shape from a few texels to some squares wide.
FilteredErrors filteredErrors(const Texture& texture) {
    const unsigned seed = 5;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> signedUnit(-1.0, 1.0);
    constexpr int kCases = 100;
    constexpr int kPhases = 16;
    FilteredErrors errors;
    for (int i = 0; i < kCases; ++i) {
        const Vec2 middle(signedUnit(random), signedUnit(random));
        const double scale = std::pow(2.0, 2.5 * signedUnit(random)) * 16.0 / texture.width();
        const Vec2 dx = scale * Vec2(signedUnit(random), signedUnit(random));
        const Vec2 dy = scale * Vec2(signedUnit(random), signedUnit(random));
        const double truth = meanOver(texture, middle, dx, dy);
        double sum = 0.0;
        for (int j = 0; j < kPhases; ++j) {
            for (int k = 0; k < kPhases; ++k) {
                const Vec2 phase((j + 0.5) / kPhases, (k + 0.5) / kPhases);
                const Vec2 uv = middle + (phase.x - 0.5) * dx + (phase.y - 0.5) * dy;
                const double error = texture.filtered(uv, {dx, dy, phase}).x - truth;
                sum += error;
                errors.single += error * error;
            }
        }
        errors.average += sum * sum / std::pow(kPhases, 4);
    }
    errors.single = std::sqrt(errors.single / kCases) / kPhases;
    errors.average = std::sqrt(errors.average / kCases);
    return errors;
}

TEST_CASE("filtered values have the exact mean of a checker over the footprint as their mean") {
    for (const int square : {2, 8, 32}) {
        CAPTURE(square);
        const Image image = checker(512, square);
        const FilteredErrors plain = filteredErrors(Texture(image));
        const FilteredErrors pyramid = filteredErrors(Texture(image, {false, false, true}));
        MESSAGE("full resolution: " << plain.single << ", mean " << plain.average
                                    << "; with a pyramid: " << pyramid.single << ", mean "
                                    << pyramid.average);
        CHECK(plain.average < 0.003);
        CHECK(pyramid.average < 0.006);
        CHECK(plain.single < 0.1);
        CHECK(pyramid.single < 0.1);
    }
}

TEST_CASE("without a footprint the filtered value is the bilinear one") {
    const Texture texture(ramps(7, 5), {false, false, true});
    CHECK(texture.filtered({0.3, 0.4}, {}) == texture.bilinear({0.3, 0.4}));
    const Texture plain(ramps(7, 5));
    CHECK(plain.filtered({0.3, 0.4}, {Vec2(1e-9, 0.0), Vec2(0.0)}) == plain.bilinear({0.3, 0.4}));
}

TEST_CASE("a footprint over whole repeats gives the image's mean, at any size of image") {
    for (const auto& size :
         {std::pair(1, 1), std::pair(7, 5), std::pair(13, 1), std::pair(20, 12)}) {
        const int width = size.first;
        const int height = size.second;
        CAPTURE(width);
        const Texture texture(ramps(width, height), {false, false, true});
        for (const double repeats : {64.0, 1024.0}) {
            const Color mean = texture.filtered({0.1, 0.2}, {{repeats, 0.0}, {0.0, repeats}});
            CHECK(mean.x == doctest::Approx(10 * (width - 1) / 2.0 / 255.0).epsilon(1e-7));
            CHECK(mean.y == doctest::Approx(20 * (height - 1) / 2.0 / 255.0).epsilon(1e-7));
            CHECK(mean.z == doctest::Approx(7 / 255.0).epsilon(1e-7));
        }
    }
}

TEST_CASE("footprints that are not finite have a finite value") {
    const double inf = std::numeric_limits<double>::infinity();
    const Texture texture(ramps(7, 5), {false, false, true});
    for (const double bad : {inf, -inf, std::nan(""), 1e300}) {
        const Color c = texture.filtered({0.5, 0.5}, {{bad, 0.0}, {0.0, bad}});
        CHECK(c.x >= 0.0);
        CHECK(c.x <= 1.0);
    }
}

}  // namespace
