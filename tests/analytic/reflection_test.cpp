// Mirrors against the series and directions that follow from their equation on paper.
#include "optics_shot.h"

using namespace rt;
using namespace rt::test;

namespace {

const std::string kBox = "gr.nh_box('wall', {-50, -50, -1}, {100, 100, 1})";

std::string mirrorCall(double own) {
    return "it:set_reflection(" + text(own) + ")";
}

/// Two walls that face each other 10 apart, and what a camera between them sees of the one at z =
/// 0.
Shot facingMirrors(double own) {
    Shot shot;
    shot.body = place(kBox, 0.25, mirrorCall(own)) +
                place("gr.nh_box('other', {-50, -50, 10}, {100, 100, 1})", 0.75, mirrorCall(own));
    shot.eye = {0.0, 0.0, 3.0};
    shot.ambient = Color(1.0);
    return shot;
}

RenderOptions uncut(int maxDepth) {
    RenderOptions options;
    options.reference = true;
    options.maxDepth = maxDepth;
    return options;
}

}  // namespace

TEST_CASE("a mirror's own colour weighs f, and what it mirrors 1 - f") {
    for (const double own : {0.0, 0.125, 0.5, 0.9375, 1.0}) {
        CAPTURE(own);
        Shot shot;
        shot.body = "gr.background({0.3, 0.3, 0.3})\n" + place(kBox, 0.8, mirrorCall(own));
        shot.ambient = Color(1.0);
        CHECK(grey(shot) == doctest::Approx(own * 0.8 + (1.0 - own) * 0.3).epsilon(1e-14));
    }
}

TEST_CASE("a mirror sends the view to d - 2 (d.n) n") {
    for (int i = 0; i < 24; ++i) {
        const double tilt = -85.0 + 7.0 * i;
        CAPTURE(tilt);
        Shot shot;
        shot.body = "gr.background({0, 0, 0}, {1, 1, 1})\n" +
                    place("gr.nh_box('wall', {-50, -50, -1}, {100, 100, 1})", 0.0,
                          mirrorCall(0.0) + "\nit:rotate('x', " + text(tilt) + ")");
        shot.view = glm::normalize(Vec3(0.02, 0.01, -1.0));
        shot.eye = -10.0 * shot.view;
        const double angle = tilt * kPi / 180.0;
        const Vec3 n(0.0, -std::sin(angle), std::cos(angle));
        const Vec3 mirrored = shot.view - 2.0 * glm::dot(shot.view, n) * n;
        CHECK(std::fabs(grey(shot) - (0.5 + 0.5 * mirrored.y)) < 1e-10);
    }
}

TEST_CASE("a mirror ball shows the sky in the direction of its normal's mirror image") {
    for (int i = 1; i < 40; ++i) {
        const double aside = i / 40.0;  // of the ball's radius
        CAPTURE(aside);
        Shot shot;
        shot.body = "gr.background({0, 0, 0}, {1, 1, 1})\n" +
                    place("gr.sphere('ball')", 0.0, mirrorCall(0.0));
        const double turn = 2.4 * i;
        shot.eye = {aside * std::cos(turn), aside * std::sin(turn), 10.0};
        const Vec3 n(shot.eye.x, shot.eye.y, std::sqrt(1.0 - aside * aside));
        CHECK(std::fabs(grey(shot) - (0.5 + 0.5 * (2.0 * n.z * n.y))) < 1e-9);
    }
}

TEST_CASE("facing mirrors show a geometric series that ends in the last one's own colour") {
    for (const double own : {0.0, 0.25, 0.5}) {
        for (const int depth : {0, 1, 2, 5, 16, 64}) {
            CAPTURE(own);
            CAPTURE(depth);
            double expected = 0.0;
            for (int k = 0; k <= depth; ++k) {
                const double color = k % 2 == 0 ? 0.25 : 0.75;
                expected += (k < depth ? own : 1.0) * std::pow(1.0 - own, k) * color;
            }
            const Picture picture = shoot(facingMirrors(own), 1, uncut(depth));
            CHECK(std::fabs(picture.at(0, 0).x - expected) < 1e-14);
            CHECK(picture.counts.rays.reflection == static_cast<std::uint64_t>(depth));
        }
    }
}

TEST_CASE("a corridor of mirrors is left after as many bounces as its length says") {
    // Between z = 0 and z = 1 the ray, of slope 1 along x, moves one unit a bounce; from (0.3, 0.5)
    // it meets a wall at 0.8, 1.8, 2.8 ... up to the corridor's end.
    for (const int length : {1, 2, 7, 64}) {
        CAPTURE(length);
        const std::string size = ", {" + text(length) + ", 2, 1})";
        Shot shot;
        shot.body = "gr.background({0.6, 0.6, 0.6})\n" +
                    place("gr.nh_box('low', {0, -1, -1}" + size, 0.2, mirrorCall(0.03125)) +
                    place("gr.nh_box('high', {0, -1, 1}" + size, 0.9, mirrorCall(0.03125));
        shot.eye = {0.3, 0.0, 0.5};
        shot.view = {1.0, 0.0, -1.0};
        shot.ambient = Color(1.0);
        double expected = 0.6 * std::pow(0.96875, length);
        for (int k = 0; k < length; ++k) {
            expected += 0.03125 * std::pow(0.96875, k) * (k % 2 == 0 ? 0.2 : 0.9);
        }
        const Picture picture = shoot(shot, 1, uncut(100));
        CHECK(std::fabs(picture.at(0, 0).x - expected) < 1e-13);
        CHECK(picture.counts.rays.reflection == static_cast<std::uint64_t>(length));
    }
}
