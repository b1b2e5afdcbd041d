// Patterns on objects: in the object's own space, wherever a texture may stand, and honest.
#include "kept_error.h"
#include "optics_shot.h"

using namespace rt;
using namespace rt::test;

namespace {

/// What ambient light of 1 shows of `body` straight below (x, y).
Color below(const std::string& body, double x, double y) {
    Shot shot;
    shot.body = body;
    shot.eye = {x, y, 10.0};
    shot.ambient = Color(1.0);
    return shoot(shot).at(0, 0);
}

const std::string kChecker =
    "checker = gr.checker{first = {0.1, 0.2, 0.3}, second = {0.9, 0.8, 0.7}, size = 1}\n";

}  // namespace

TEST_CASE("a face that lies where cells meet shows one layer of them, however it is moved") {
    for (const std::string place : {"", "it:rotate('x', 90)\nit:rotate('x', -90)",
                                    "it:translate(0, 0, 123.456)\n"
                                    "it:translate(0, 0, -123.456)"}) {
        const std::string body = kChecker + "it = gr.nh_box('it', {-4, -4, -3}, {8, 8, 3})\n" +
                                 place + "\nroot:add_child(it, nil, checker)\n";
        for (double x = -3.5; x < 4.0; x += 1.0) {
            for (double y = -3.5; y < 4.0; y += 1.0) {
                // Below z = 0: floor is -1.
                const bool even = std::lround(std::floor(x) + std::floor(y) - 1.0) % 2 == 0;
                CHECK(below(body, x, y) == (even ? Color(0.1, 0.2, 0.3) : Color(0.9, 0.8, 0.7)));
            }
        }
    }
}

TEST_CASE("patterns move with the object, and stand wherever a texture may") {
    const std::string ball = "it = gr.nh_sphere('it', {0, 0, 0}, 3)\n";
    const std::string marble =
        "m = gr.marble{first = {0, 0, 0}, second = {1, 1, 1}, size = 0.7, direction = {1, 1, 0}}\n";
    const Color still = below(marble + ball + "root:add_child(it, nil, m)\n", 0.4, 0.3);
    CHECK(below(marble + ball + "it:set_texture(m)\nroot:add_child(it)\n", 0.4, 0.3) == still);
    CHECK(glm::distance(below(marble + ball +
                                  "it:scale(2, 2, 2)\nit:translate(5, 1, 0)\n"
                                  "root:add_child(it, nil, m)\n",
                              5.8, 1.6),
                        still) < 1e-9);
    // It has the highlight that it was given.
    Shot lit;
    lit.body =
        "root:add_child(gr.nh_box('it', {-4, -4, -3}, {8, 8, 3}), nil, gr.stripes{first = "
        "{0, 0, 0}, second = {0, 0, 0}, specular = {0.5, 0.5, 0.5}, exponent = 7})\n"
        "lights[1] = gr.light({0, 0, 20}, {1, 1, 1}, {1, 0, 0})\n";
    CHECK(grey(lit) == doctest::Approx(0.5));
}

TEST_CASE("adaptive renders of patterns keep their error, to the horizon") {
    const std::string body =
        kChecker +
        "root:add_child(gr.nh_plane('ground', {0, 0, 0}, {0, 0, 1}), nil, checker)\n"
        "root:add_child(gr.nh_sphere('ball', {-1.2, 0, 1}, 1), nil, gr.marble{first = {0.2, 0.2, "
        "0.3}, second = {0.9, 0.9, 0.8}, size = 0.6})\n"
        "root:add_child(gr.nh_box('box', {0.3, -0.5, 0}, {1.4, 1, 1.2}), nil, gr.wood{first = "
        "{0.6, "
        "0.4, 0.2}, second = {0.3, 0.2, 0.1}, size = 0.2})\n"
        "lights[1] = gr.light({4, -3, 6}, {0.8, 0.8, 0.8}, {1, 0, 0}, 0.8)\n";
    Shot shot;
    shot.body = body;
    shot.eye = {0.0, -9.0, 3.0};
    shot.view = {0.0, 9.0, -2.2};
    shot.up = {0.0, 0.0, 1.0};
    shot.fov = 32.0;
    shot.width = shot.height = 48;
    shot.ambient = Color(0.2);
    checkErrorIsKept(shot, 2048, {0.01, 0.004});
}
