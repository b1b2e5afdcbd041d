#include "rt/shading/bump.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using namespace rt;

Texture uniform(std::uint8_t r, std::uint8_t g, std::uint8_t b, bool flipV = false) {
    return Texture(Image{1, 1, 3, std::vector<std::uint8_t>{r, g, b}}, {flipV});
}

SurfacePoint facing(const Vec3& normal, const Vec3& dpdu, const Vec3& dpdv) {
    SurfacePoint surface;
    surface.normal = surface.shadingNormal = normal;
    surface.dpdu = dpdu;
    surface.dpdv = dpdv;
    surface.uv = {0.37, 0.61};
    return surface;
}

Vec3 randomUnit(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

const Vec3 kX(1, 0, 0);
const Vec3 kY(0, 1, 0);
const Vec3 kZ(0, 0, 1);

TEST_CASE("codes are decoded as max(-1, (c - 128) / 127)") {
    CHECK(decodedNormal({128, 128, 255}) == Vec3(0, 0, 1));
    CHECK(decodedNormal({255, 1, 0}) == Vec3(1, -1, -1));
    CHECK(decodedNormal({129, 127, 191.5}) == Vec3(1 / 127.0, -1 / 127.0, 0.5));
}

TEST_CASE("a straight map gives the surface's normal, to the bit") {
    const Texture straight8(Image{
        2, 2, 3,
        std::vector<std::uint8_t>{128, 128, 255, 128, 128, 255, 128, 128, 255, 128, 128, 255}});
    const std::uint16_t half = 128 * 257;
    const Texture straight16(Image{1, 1, 3, std::vector<std::uint16_t>{half, half, 65535}});
    const Texture level(Image{3, 2, 1, std::vector<std::uint8_t>(6, 201)});
    const unsigned seed = 3;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 500; ++i) {
        SurfacePoint surface =
            facing(randomUnit(random), 3.0 * randomUnit(random), randomUnit(random));
        surface.uv = {17.0 * randomUnit(random).x, randomUnit(random).y};
        for (const Texture* map : {&straight8, &straight16, &level}) {
            CHECK(bumpedNormal(*map, surface) == surface.shadingNormal);
        }
    }
}

TEST_CASE("red leans along dpdu and green along dpdv") {
    const SurfacePoint surface = facing(kZ, 2.0 * kX, 5.0 * kY);
    const double h = std::sqrt(0.5);
    const auto near = [](const Vec3& a, const Vec3& b) { return glm::length(a - b) < 1e-14; };
    CHECK(near(bumpedNormal(uniform(255, 128, 255), surface), {h, 0, h}));
    CHECK(near(bumpedNormal(uniform(1, 128, 255), surface), {-h, 0, h}));
    CHECK(near(bumpedNormal(uniform(128, 255, 255), surface), {0, h, h}));
    CHECK(near(bumpedNormal(uniform(255, 128, 128), surface), kX));

    // Mirrored in u, in v, and seen from inside.
    CHECK(near(bumpedNormal(uniform(255, 128, 255), facing(kZ, -kX, kY)), {-h, 0, h}));
    CHECK(near(bumpedNormal(uniform(128, 255, 255), facing(kZ, -kX, kY)), {0, h, h}));
    CHECK(near(bumpedNormal(uniform(128, 255, 255), facing(kZ, kX, -kY)), {0, -h, h}));
    CHECK(near(bumpedNormal(uniform(128, 255, 255), facing(-kZ, kX, kY)), {0, h, -h}));
    // With v downwards the image's top is towards falling v.
    CHECK(near(bumpedNormal(uniform(128, 255, 255, true), surface), {0, -h, h}));
}

TEST_CASE("dpdu is made square with the normal, and dpdv only says which side is up") {
    const SurfacePoint surface = facing(kZ, kX + 7.0 * kZ, kY + 0.9 * kX - kZ);
    const Vec3 n = bumpedNormal(uniform(255, 255, 255), surface);
    CHECK(glm::length(n - Vec3(1, 1, 1) / std::sqrt(3.0)) < 1e-14);
}

// Heights that rise by `code` codes a column, or a row upwards; white stands kHeightOfWhite above.
Texture slope(int size, int code, bool alongV, bool flipV = false) {
    std::vector<std::uint8_t> codes;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int steps = alongV ? (flipV ? y : size - 1 - y) : x;
            codes.push_back(static_cast<std::uint8_t>(code * steps));
        }
    }
    return Texture(Image{size, size, 1, std::move(codes)}, {flipV});
}

TEST_CASE("heights that rise along u or v lean the normal back") {
    const int size = 16;
    const double rise = 10.0 * size / 255.0 * kHeightOfWhite;
    const double length = std::sqrt(1.0 + rise * rise);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const bool flip : {false, true}) {
            SurfacePoint surface = facing(kZ, scale * kX, scale * kY);
            surface.uv = {0.5, 0.5};
            const Vec3 u = bumpedNormal(slope(size, 10, false, flip), surface);
            CHECK(glm::length(u - Vec3(-rise, 0, 1) / length) < 1e-13);
            const Vec3 v = bumpedNormal(slope(size, 10, true, flip), surface);
            CHECK(glm::length(v - Vec3(0, -rise, 1) / length) < 1e-13);
            surface.dpdu = -surface.dpdu;
            const Vec3 mirrored = bumpedNormal(slope(size, 10, false, flip), surface);
            CHECK(glm::length(mirrored - Vec3(rise, 0, 1) / length) < 1e-13);
        }
    }
}

TEST_CASE("a height map agrees with the normal of the raised surface, skewed coordinates too") {
    const unsigned seed = 8;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Texture map = slope(16, 9, false);
    for (int i = 0; i < 200; ++i) {
        const Vec3 dpdu = 2.0 * randomUnit(random);
        const Vec3 dpdv = 3.0 * randomUnit(random);
        const Vec3 across = glm::cross(dpdu, dpdv);
        const Vec3 n = (random() % 2 ? 1.0 : -1.0) * glm::normalize(across);
        SurfacePoint surface = facing(n, dpdu, dpdv);
        surface.uv = {0.5, 0.5};
        // The raised surface p + H n has the tangents dpdu + H_u n and dpdv + H_v n.
        const double unit = kHeightOfWhite * std::sqrt(glm::length(across));
        const Vec2 rise = unit * map.gradient(surface.uv);
        Vec3 expected = glm::normalize(glm::cross(dpdu + rise.x * n, dpdv + rise.y * n));
        if (glm::dot(expected, n) < 0.0) expected = -expected;
        CHECK(glm::length(bumpedNormal(map, surface) - expected) < 1e-12);
    }
}

TEST_CASE("where the surface has no parametrisation the normal stays") {
    const Texture normals = uniform(200, 10, 255);
    const Texture heights = slope(16, 9, false);
    for (const auto& [dpdu, dpdv] :
         {std::pair(Vec3(0.0), Vec3(0.0)), std::pair(kX, Vec3(0.0)), std::pair(Vec3(0.0), kY),
          std::pair(kX, 2.0 * kX), std::pair(kZ, kY)}) {
        SurfacePoint surface = facing(kZ, dpdu, dpdv);
        surface.uv = {0.5, 0.5};
        CHECK(bumpedNormal(normals, surface) == kZ);
        CHECK(bumpedNormal(heights, surface) == kZ);
    }
}

}  // namespace
