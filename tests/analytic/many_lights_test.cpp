// More lights than are looked at from each point: their sum all the same.
#include "floor_shot.h"
#include "kept_error.h"
#include "unbiased.h"

using namespace rt;
using namespace rt::test;

namespace {

const std::string kFloor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);

/// n by n lights over the floor at height 2, `more` after their falloff.
std::string lamps(int n, const std::string& more = "") {
    return "local n = " + text(n) +
           "\nfor i = 1, n do for j = 1, n do\n"
           "lights[#lights + 1] = gr.light({8 * (i - 0.5) / n - 4, 8 * (j - 0.5) / n - 4, 2}, "
           "{4 / n ^ 2, 4 / n ^ 2, 4 / n ^ 2}, {0, 0, 1}" +
           more + ")\nend end\n";
}

/// What they give at (x, 0, 0); those from `least` on along x.
double sumOf(int n, double x, double least = -4.0) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 to(8.0 * (i + 0.5) / n - 4.0 - x, 8.0 * (j + 0.5) / n - 4.0, 2.0);
            const double d = glm::length(to);
            if (to.x + x >= least) sum += 4.0 / (n * n) * (to.z / d) / (d * d);
        }
    }
    return sum;
}

Shot at(double x, const std::string& body) {
    Shot shot;
    shot.body = body + kFloor;
    shot.eye = {x, -10.0, 0.5};
    shot.view = {0.0, 10.0, -0.5};
    return repeated(shot);
}

}  // namespace

TEST_CASE("unbiased: many lights give what their sum does") {
    constexpr int kSamples = 128;
    checkUnbiased({"in the middle", at(0.0, lamps(20)), sumOf(20, 0.0)}, kSamples);
    checkMean({"aside", at(6.0, lamps(20)), sumOf(20, 6.0)}, kSamples);
    // Balls high above the horizon give what points give.
    checkMean({"balls", at(1.0, lamps(20, ", 0.05")), sumOf(20, 1.0)}, kSamples);
    // A wall at x = 1 from the floor up to above the lights hides those beyond it.
    const std::string wall = place("gr.nh_box('wall', {-1.001, -90, 0}, {0.001, 180, 9})", 1.0);
    checkMean({"half hidden", at(0.0, lamps(20) + wall), sumOf(20, 0.0, -1.0)}, kSamples);
    // A mirror shows another point's lights.
    Shot mirror;
    mirror.body =
        lamps(20) + kFloor +
        place("gr.nh_box('mirror', {-9, 10, -1}, {18, 1, 18})", 0.0, "it:set_reflection(0)");
    mirror.eye = {0.0, 5.0, 5.0};
    mirror.view = {0.0, 5.0, -1.0};  // meets the mirror at y = 10, z = 4, and the floor at y = -10
    double far = 0.0;
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            const Vec3 to(8.0 * (i + 0.5) / 20 - 4.0, 8.0 * (j + 0.5) / 20 - 4.0 + 10.0, 2.0);
            const double d = glm::length(to);
            far += 0.01 * (to.z / d) / (d * d);
        }
    }
    checkMean({"mirrored", repeated(mirror), far}, kSamples);
}

TEST_CASE("unbiased: many spots, rectangles and a sun") {
    const std::string others =
        "for i = 1, 60 do\n"
        "lights[#lights + 1] = gr.spot_light{position = {i / 10 - 3, 0, 2}, direction = {0, 0, "
        "-1}, colour = {0.01, 0.01, 0.01}, inner = 90, outer = 90, falloff = {1, 0, 0}}\nend\n"
        "lights[#lights + 1] = gr.sun_light{direction = {0, 0, -1}, colour = {0.5, 0.5, 0.5}}\n";
    double expected = 0.5;
    for (int i = 1; i <= 60; ++i) {
        const double x = i / 10.0 - 3.0;
        expected += 0.02 / std::sqrt(x * x + 4.0);
    }
    checkUnbiased({"spots and a sun", at(0.0, others), expected});
}

TEST_CASE("--reference looks at every light") {
    RenderOptions options;
    options.reference = true;
    const Picture one = shoot(at(0.5, lamps(20)), 1, options);
    for (const Color& pixel : one.pixels) {
        CHECK(pixel.x == doctest::Approx(sumOf(20, 0.5)).epsilon(1e-9));
    }
}

TEST_CASE("adaptive renders of many lights keep their error") {
    const Shot shot = floorShot(kFloor + place("gr.nh_sphere('ball', {-1, 0, 0.7}, 0.7)", 0.7) +
                                    place("gr.nh_box('post', {0.8, 0, 0}, {0.3, 0.3, 1.5})", 0.9,
                                          "it:set_reflection(0.6)") +
                                    lamps(7, ", 0.1"),
                                32);
    checkErrorIsKept(shot, 256, {0.01, 0.004});
}
