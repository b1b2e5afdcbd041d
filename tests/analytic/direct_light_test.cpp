// Pixels that follow from the local colour equation on paper.
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

// The pixel of these pictures is 1.7e-6 wide where the camera looks: it is off its middle by less.
constexpr double kOnePoint = 1e-6;

void checkColor(const Color& actual, const Color& expected, double tolerance = kOnePoint) {
    for (int channel = 0; channel < 3; ++channel) {
        CAPTURE(channel);
        CAPTURE(actual[channel]);
        CAPTURE(expected[channel]);
        CHECK(std::fabs(actual[channel] - expected[channel]) <= tolerance);
    }
}

/// A script around `body`, which adds to `root` and makes the list `lights`; the camera at z = 10
/// looks down at the plane z = 0 through a tiny angle, so that a pixel is nearly one point.
std::string looking(const std::string& body, const std::string& ambient = "{0, 0, 0}",
                    const std::string& eye = "{0, 0, 10}", const std::string& view = "{0, 0, -1}") {
    return "root = gr.node('root')\nlights = {}\n" + body + "\ngr.render(root, 'out.png', 1, 1, " +
           eye + ", " + view + ", {0, 1, 0}, 0.00001, " + ambient + ", lights)\n";
}

/// A matt wall whose front is the plane z = 0.
const std::string kWall =
    "wall = gr.nh_box('wall', {-50, -50, -1}, {100, 100, 1})\n"
    "root:add_child(wall, gr.material({0.5, 0.25, 1}, {0, 0, 0}, 0))\n";

Color onePixel(const std::string& script) {
    return renderScript(script).at(0, 0);
}

}  // namespace

TEST_CASE("a wall lit by a point light straight above shows kd times intensity") {
    checkColor(
        onePixel(looking(kWall + "lights[1] = gr.light({0, 0, 5}, {1, 0.5, 0.25}, {1, 0, 0})")),
        {0.5, 0.125, 0.25});
}

TEST_CASE("light from the side weighs in by the cosine") {
    // From (3, 0, 4) the cosine at the origin is 4/5.
    checkColor(onePixel(looking(kWall + "lights[1] = gr.light({3, 0, 4}, {1, 1, 1}, {1, 0, 0})")),
               {0.4, 0.2, 0.8});
}

TEST_CASE("falloff divides by c0 + c1 d + c2 d^2") {
    // d = 5: 2 + 0.4 * 5 + 0.08 * 25 = 6.
    checkColor(
        onePixel(looking(kWall + "lights[1] = gr.light({0, 0, 5}, {6, 6, 6}, {2, 0.4, 0.08})")),
        {0.5, 0.25, 1.0});
}

TEST_CASE("two lights add up, and ambient light is added once") {
    checkColor(onePixel(looking(kWall + "lights[1] = gr.light({0, 0, 5}, {0.5, 0, 0}, {1, 0, 0})\n"
                                        "lights[2] = gr.light({0, 0, 7}, {0, 0.5, 0}, {1, 0, 0})",
                                "{0.1, 0.2, 0.3}")),
               {0.5 * (0.5 + 0.1), 0.25 * (0.5 + 0.2), 0.3});
}

TEST_CASE("brightness is the floor of the cosine") {
    checkColor(
        onePixel(looking(kWall + "lights[1] = gr.light({3, 0, 4}, {1, 1, 1}, {1, 0, 0}, 0, 0.9)")),
        {0.45, 0.225, 0.9});
    // Not on the side that the light does not reach.
    checkColor(
        onePixel(looking(kWall + "lights[1] = gr.light({0, 0, -5}, {1, 1, 1}, {1, 0, 0}, 0, 0.9)")),
        {0.0, 0.0, 0.0});
}

TEST_CASE("the highlight is ks times the mirrored light's cosine to the power p") {
    const std::string wall =
        "root:add_child(gr.nh_box('wall', {-50, -50, -1}, {100, 100, 1}),\n"
        "               gr.material({0, 0, 0}, {0.5, 1, 0.25}, 3))\n";
    // Light from (3, 0, 4) is mirrored to (-3, 0, 4)/5: its cosine to the viewer on +z is 4/5.
    const double lobe = 0.8 * 0.8 * 0.8;
    checkColor(onePixel(looking(wall + "lights[1] = gr.light({3, 0, 4}, {1, 1, 1}, {1, 0, 0})")),
               {0.5 * lobe, lobe, 0.25 * lobe});
}

TEST_CASE("an exponent of 0 is a lobe of 1 wherever the light is above the surface") {
    const std::string wall =
        "root:add_child(gr.nh_box('wall', {-50, -50, -1}, {100, 100, 1}),\n"
        "               gr.material({0, 0, 0}, {1, 1, 1}, 0))\n";
    checkColor(onePixel(looking(wall + "lights[1] = gr.light({30, 0, 4}, {1, 1, 1}, {1, 0, 0})")),
               {1.0, 1.0, 1.0});
}

TEST_CASE("something between surface and light leaves only ambient light") {
    checkColor(onePixel(looking(kWall + "root:add_child(gr.nh_sphere('s', {3, 0, 4}, 1), "
                                        "gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
                                        "lights[1] = gr.light({6, 0, 8}, {1, 1, 1}, {1, 0, 0})",
                                "{0.1, 0.1, 0.1}")),
               {0.05, 0.025, 0.1});
}

TEST_CASE("what stands behind the light casts no shadow") {
    checkColor(onePixel(looking(kWall + "root:add_child(gr.nh_sphere('s', {6, 0, 8}, 1), "
                                        "gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
                                        "lights[1] = gr.light({3, 0, 4}, {1, 1, 1}, {1, 0, 0})")),
               {0.4, 0.2, 0.8});
}

TEST_CASE("the middle of a sphere faces the viewer") {
    checkColor(
        onePixel(looking("root:add_child(gr.sphere('s'), gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
                         "lights[1] = gr.light({0, 3, 5}, {1, 1, 1}, {1, 0, 0})")),
        Color(4.0 / 5.0));
}

TEST_CASE("a sphere seen from inside is lit from inside") {
    checkColor(onePixel(looking("root:add_child(gr.nh_sphere('s', {0, 0, 0}, 20), "
                                "gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
                                "lights[1] = gr.light({0, 0, 0}, {1, 1, 1}, {1, 0, 0})")),
               Color(1.0));
}

TEST_CASE("normals of nested, non-uniformly scaled objects are those of the world") {
    // y = 0.5 at x = 0 of a 45 degree slope, made by squeezing and turning a cube in two nodes.
    const std::string slope =
        "inner = gr.nh_box('slope', {-1, -1, -1}, {2, 1, 2})\n"
        "inner:scale(7, 0.25, 3)\n"
        "outer = gr.node('outer')\nouter:add_child(inner, gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
        "outer:rotate('z', 45)\nouter:rotate('x', 90)\nroot:add_child(outer)\n";
    // The top, normal (0, 1, 0), turns to (-1, 1, 0)/sqrt 2 and then to (-1, 0, 1)/sqrt 2.
    checkColor(onePixel(looking(slope + "lights[1] = gr.light({0, 0, 9}, {1, 1, 1}, {1, 0, 0})")),
               Color(std::sqrt(0.5)));
    checkColor(onePixel(looking(slope + "lights[1] = gr.light({-5, 0, 5}, {1, 1, 1}, {1, 0, 0})")),
               Color(1.0));
}

TEST_CASE("transforms apply in the order of the calls") {
    const std::string light = "lights[1] = gr.light({0, 0, 9}, {1, 1, 1}, {1, 0, 0})";
    const std::string ball =
        "s = gr.sphere('s')\ns:set_material(gr.material({1,1,1}, {0,0,0}, 0))\n";
    // Moved to x = 4, then shrunk to x = 0.4: the ball, of radius 0.1, misses the middle.
    CHECK(onePixel(looking(ball +
                           "s:translate(4, 0, 0)\ns:scale(0.1, 0.1, 0.1)\nroot:add_child(s)\n" +
                           light)) == Color(0.0));
    // Shrunk, then moved by its radius less a bit: still there.
    CHECK(onePixel(looking(ball +
                           "s:scale(0.1, 0.1, 0.1)\ns:translate(0.05, 0, 0)\nroot:add_child(s)\n" +
                           light)) != Color(0.0));
}

TEST_CASE("the edge's material hides the child's own, per parent") {
    const std::string script =
        "s = gr.nh_box('s', {-1, -1, -1}, 2)\ns:set_material(gr.material({0, 0, 1}, {0, 0, 0}, "
        "0))\n"
        "lights[1] = gr.light({0, 0, 9}, {1, 1, 1}, {1, 0, 0})\n";
    checkColor(
        onePixel(looking(script + "root:add_child(s, gr.material({1, 0, 0}, {0, 0, 0}, 0))")),
        {1.0, 0.0, 0.0});
    checkColor(onePixel(looking(script + "root:add_child(s)")), {0.0, 0.0, 1.0});
}

TEST_CASE("the background is seen where nothing is hit") {
    checkColor(onePixel(looking("gr.background({0.1, 0.2, 0.3})")), {0.1, 0.2, 0.3});
    // A gradient by the direction's y: straight ahead is the middle.
    checkColor(onePixel(looking("gr.background({0, 0, 0}, {1, 0.5, 0.25})")), {0.5, 0.25, 0.125},
               1e-6);
    checkColor(onePixel(looking("gr.background({0, 0, 0}, {1, 1, 1})", "{0,0,0}", "{0, 0, 0}",
                                "{0, 0.6, -0.8}")),
               Color(0.8), 1e-6);
}

TEST_CASE("a pixel is the mean over its square") {
    // Half of the pixel's width shows the wall, by a box that ends at x = 0.
    const std::string script =
        "root = gr.node('root')\n"
        "root:add_child(gr.nh_box('half', {-50, -50, -1}, {50, 100, 1}), "
        "gr.material({1, 1, 1}, {0, 0, 0}, 0))\n"
        "gr.render(root, 'out.png', 1, 1, {0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 10, {1, 1, 1}, {})\n";
    CHECK(renderScript(script).at(0, 0).x == doctest::Approx(0.5).epsilon(0.001));
}
