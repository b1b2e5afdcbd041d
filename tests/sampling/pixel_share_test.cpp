#include "rt/sampling/pixel_share.h"

#include "rt/sampling/sampler.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>

using namespace rt;

TEST_CASE("the shares of a net's points tile the pixel, those of each doubling by themselves too") {
    Sampler sampler({SamplerKind::kJoint, FilterKind::kBox, 5, 1});
    for (int pixel = 0; pixel < 20; ++pixel) {
        for (std::uint32_t count = 1; count <= 256; count *= 2) {
            CAPTURE(count);
            // All of the first points, told their number, and the second half, not told.
            for (const bool told : {true, false}) {
                std::set<std::pair<double, double>> corners;
                const std::uint32_t begin = told ? 0 : count;
                for (std::uint32_t i = begin; i < begin + count; ++i) {
                    sampler.start(pixel, 3, static_cast<int>(i));
                    const Vec2 u = sampler.pixelPoint();
                    const PixelShare share = pixelShare(i, told ? count : 1, u);
                    CHECK(share.size.x * share.size.y * count == 1.0);
                    CHECK(share.phase.x >= 0.0);
                    CHECK(share.phase.x < 1.0);
                    const Vec2 corner = u - share.phase * share.size;
                    corners.insert({corner.x, corner.y});
                }
                CHECK(corners.size() == count);
            }
        }
    }
}

TEST_CASE("shares of a number of samples that is no power of two are those of the power below") {
    CHECK(pixelShare(0, 100, {0.3, 0.9}).size == Vec2(1.0 / 8, 1.0 / 8));
    CHECK(pixelShare(0, 0, {0.3, 0.9}).size == Vec2(1.0));
    CHECK(pixelShare(0, 0, {0.3, 0.9}).phase == Vec2(0.3, 0.9));
    CHECK(pixelShare(3, 1, {0.75, 0.25}).phase == Vec2(0.75, 0.5));
}
