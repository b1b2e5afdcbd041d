#include "rt/render/first_hits.h"

#include "rt/compile/compile.h"
#include "rt/render/kernel_choice.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 16;
constexpr double kFov = 40.0;

/// A sphere of radius 1.5 about (0.25, 0, 0) before a wall at z = -3 that ends on the right; seen
/// from (0, 0, 6).
const std::string kScene = R"(
local root = gr.node('root')
root:add_child(gr.nh_sphere('ball', {0.25, 0, 0}, 1.5), gr.material({0.1, 0.2, 0.3}, {0.9, 0.9, 0.9}, 5))
root:add_child(gr.nh_box('wall', {-20, -20, -4}, {22, 40, 1}), gr.material({0.5, 0.6, 0.7}, {0, 0, 0}, 0))
gr.render(root, 'x.png', 24, 16, {0, 0, 6}, {0, 0, -2}, {0, 1, 0}, 40, {1, 1, 1},
          {gr.light({0, 9, 9}, {1, 1, 1}, {1, 0, 0})} LENS)
)";

std::vector<FirstHit> hitsOf(std::string script, const std::string& lens, int threads,
                             const std::string& kernel) {
    script.replace(script.find("LENS"), 4, lens);
    Diagnostics diagnostics;
    AssetCache assets(1);
    const RenderScene scene =
        compileScene(rt::test::describe(script).scene, 0, {}, assets, diagnostics);
    return firstHits(scene, {}, {0, 0, scene.width, scene.height}, threads, chooseKernel(kernel));
}

/// The direction through the centre of a pixel, of length 1 along the view.
Vec3 through(int x, int y) {
    const double scale = 2.0 * std::tan(kFov * std::numbers::pi / 360.0) / kHeight;
    return {(x + 0.5 - 0.5 * kWidth) * scale, (0.5 * kHeight - y - 0.5) * scale, -1.0};
}

}  // namespace

TEST_CASE(
    "Centres of pixels show the sphere and the wall of the closed forms, and nothing beside") {
    const std::vector<FirstHit> hits = hitsOf(kScene, "", 2, "");
    const Vec3 eye(0.0, 0.0, 6.0);
    const Vec3 centre(0.25, 0.0, 0.0);
    int onSphere = 0;
    int onWall = 0;
    int onNothing = 0;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const FirstHit& hit = hits[static_cast<std::size_t>(i)];
        const Vec3 d = through(i % kWidth, i / kWidth);
        const double a = glm::dot(d, d);
        const double b = glm::dot(d, eye - centre);
        const double c = glm::dot(eye - centre, eye - centre) - 1.5 * 1.5;
        const Vec3 onPlane = eye + 9.0 * d;
        CAPTURE(i);
        if (b * b > a * c) {
            ++onSphere;
            const double z = (-b - std::sqrt(b * b - a * c)) / a;
            const Vec3 n = (eye + z * d - centre) / 1.5;
            CHECK(hit.depth == doctest::Approx(z).epsilon(1e-12));
            CHECK(glm::length(hit.position - (eye + z * d)) < 1e-12);
            CHECK(glm::length(hit.normal - n) < 1e-12);
            CHECK(hit.albedo == Color(0.1, 0.2, 0.3));
            CHECK(hit.uv.x == doctest::Approx(0.5 + std::atan2(n.x, n.z) / (2 * std::numbers::pi)));
            CHECK(hit.uv.y == doctest::Approx(0.5 + std::asin(n.y) / std::numbers::pi));
            CHECK(hit.object == 1);
        } else if (onPlane.x < 2.0) {
            ++onWall;
            CHECK(hit.depth == doctest::Approx(9.0).epsilon(1e-12));
            CHECK(glm::length(hit.normal - Vec3(0.0, 0.0, 1.0)) < 1e-12);
            CHECK(hit.albedo == Color(0.5, 0.6, 0.7));
            CHECK(hit.uv.x == doctest::Approx((onPlane.x + 20.0) / 22.0));
            CHECK(hit.uv.y == doctest::Approx((onPlane.y + 20.0) / 40.0));
            CHECK(hit.object == 2);
        } else {
            ++onNothing;
            CHECK(hit.depth == kInfinity);
            CHECK(hit.position == Vec3(0.0));
            CHECK(hit.normal == Vec3(0.0));
            CHECK(hit.object == 0);
        }
    }
    CHECK(onSphere > 40);
    CHECK(onWall > 40);
    CHECK(onNothing > 40);
}

TEST_CASE("First hits depend on neither a lens, nor threads, nor the instruction set") {
    const std::vector<FirstHit> expected = hitsOf(kScene, "", 1, "baseline");
    const auto same = [&](const std::vector<FirstHit>& hits) {
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].position != expected[i].position || hits[i].uv != expected[i].uv) {
                return false;
            }
        }
        return hits.size() == expected.size();
    };
    CHECK(same(hitsOf(kScene, ", gr.focal(4, 0.5, 0.4)", 3, "")));
    for (const TraceKernel* kernel : availableKernels()) {
        CAPTURE(kernel->name);
        CHECK(same(hitsOf(kScene, "", 2, kernel->name)));
    }
}
