// Scenes on a plane without bounds are those on a floor that is wide enough.
#include "kept_error.h"
#include "optics_shot.h"

using namespace rt;
using namespace rt::test;

namespace {

const std::string kBall = place("gr.nh_sphere('ball', {0.5, 0, 1}, 1)", 0.7);

/// A ball over z = 0, turned and moved with the ground.
Shot over(const std::string& ground, const std::string& rest) {
    Shot shot;
    shot.body = ground + rest;
    shot.eye = {0.0, -9.0, 3.0};
    shot.view = {0.0, 9.0, -3.2};
    shot.up = {0.0, 0.0, 1.0};
    shot.fov = 30.0;
    shot.width = shot.height = 40;
    shot.ambient = Color(0.1);
    return shot;
}

std::string plane(const std::string& calls = "") {
    return place("gr.nh_plane('ground', {3, -2, 0}, {0, 0, 2})", 0.6, calls);
}

std::string quad(const std::string& calls = "") {
    return place("gr.nh_quad('ground', {-400, -300, 0}, {800, 0, 0}, {0, 700, 0})", 0.6, calls);
}

std::string disc(const std::string& calls = "") {
    return place("gr.nh_disc('ground', {1, -2, 0}, {0, 0, 5}, 500)", 0.6, calls);
}

const std::string kLights =
    "lights[1] = gr.light({4, -3, 6}, {0.5, 0.5, 0.5}, {1, 0, 0}, 0.8)\n"
    "lights[2] = gr.sun_light{direction = {1, 2, -2}, colour = {0.3, 0.3, 0.3}, angle = 2}\n";

}  // namespace

TEST_CASE("a plane, a wide quad, a wide disc and a wide box give the same picture") {
    for (const std::string calls : {"", "it:set_reflection(0.6)"}) {
        const std::string box =
            place("gr.nh_box('ground', {-400, -300, -1}, {800, 700, 1})", 0.6, calls);
        RenderOptions exact;
        exact.cutoff = 0.0;
        const Picture right = shoot(over(box, kBall + kLights), 16, exact);
        for (const std::string& ground : {plane(calls), quad(calls), disc(calls)}) {
            CHECK(clippedRmse(shoot(over(ground, kBall + kLights), 16, exact), right) < 1e-9);
        }
    }
}

TEST_CASE("a plane needs nothing else in the scene, and nothing else in it needs a plane") {
    Shot alone =
        over(plane(), "lights[1] = gr.sun_light{direction = {0, 0, -1}, colour = {1, 1, 1}}\n");
    for (const Color& pixel : shoot(alone, 1).pixels) {
        const bool ground = std::fabs(pixel.x - 0.6 * 1.1) < 1e-12;
        CHECK((ground || pixel == Color(0.0)));
    }
    PictureSettings adaptive;
    adaptive.options.error = 0.003;
    CHECK(renderScript(alone.script(), adaptive).converged);
    // Two planes that face each other, the eye between them, the light beyond one.
    Shot between = over(plane() + place("gr.nh_plane('ceiling', {0, 0, 50}, {0, 0, 1})", 0.5),
                        "lights[1] = gr.light({0, 0, 60}, {1, 1, 1}, {1, 0, 0}, 3)\n");
    between.ambient = Color(0.0);
    for (const Color& pixel : shoot(between, 1).pixels) CHECK(pixel == Color(0.0));
    for (const Color& pixel : renderScript(between.script(), adaptive).pixels) {
        CHECK(pixel == Color(0.0));
    }
}

TEST_CASE("adaptive renders on what is flat keep their error") {
    const std::string more = place("gr.nh_disc('shade', {-1, 0, 1.5}, {0.2, -0.3, 1}, 0.7)", 0.8) +
                             place("gr.nh_quad('wall', {-3, 2, 0}, {6, 0, 0}, {0, 1, 2})", 0.5) +
                             place("gr.nh_frustum('post', {0, 0, 0}, 1.2, 0.3, 0.1)", 0.5,
                                   "it:rotate('x', 90)\nit:translate(-1.5, -1, 0)") +
                             place("gr.nh_hemisphere('dome', {0, 0, 0}, 0.5)", 0.6,
                                   "it:rotate('x', 90)\nit:translate(1.8, -1.5, 0)");
    for (const std::string& calls : {std::string(), std::string("it:set_reflection(0.7)")}) {
        checkErrorIsKept(over(plane(calls), kBall + more + kLights), 1024, {0.01, 0.003});
    }
}

TEST_CASE("a plane far below the horizon is finite and reaches it") {
    Shot shot = over(plane(), "");
    shot.eye = {0.0, 0.0, 1e-3};
    shot.view = {0.0, 1.0, 0.0};
    shot.ambient = Color(1.0);
    const Picture seen = shoot(shot, 4);
    for (int x = 0; x < shot.width; ++x) {
        CHECK(seen.at(x, 19) == Color(0.0));
        CHECK(seen.at(x, 20).x == doctest::Approx(0.6));
    }
}
