// Motion blur: what a point shows is the mean over the shutter's time.
#include "floor_shot.h"
#include "kept_error.h"
#include "unbiased.h"

using namespace rt;
using namespace rt::test;

namespace {

const std::string kFloor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);

/// What the point (x, 0) shows from above, ambient light being 1.
Shot above(const std::string& body, double x) {
    Shot shot;
    shot.body = body;
    shot.eye = {x, 0.0, 10.0};
    shot.ambient = Color(1.0);
    return repeated(shot);
}

/// A slab over -1 <= x <= 0 of grey 0.8, moved by `calls`.
std::string slab(const std::string& calls) {
    return place("gr.nh_box('slab', {-1, -9, 0}, {1, 18, 1})", 0.8, calls);
}

Picture rendered(const std::string& body, int spp) {
    Shot shot = above(body, 0.0);
    shot.fov = 20.0;
    shot.width = shot.height = 24;
    return shoot(shot, spp);
}

}  // namespace

TEST_CASE("unbiased: a slab that passes covers a point for its share of the time") {
    // From x - 1 .. x at time 0 to 3 further: over 0.6 while 0.6 / 3 <= s <= 1.6 / 3.
    checkUnbiased({"passes", above(slab("it:move(3, 0, 0)"), 0.6), 0.8 / 3.0});
    checkUnbiased({"ends there", above(slab("it:move(2, 0, 0)"), 1.5), 0.8 * 0.25});
    checkUnbiased({"starts there", above(slab("it:move(-2, 0, 0)"), -0.5), 0.8 * 0.25});
    checkUnbiased({"along itself", above(slab("it:move(0, 3, 0)"), -0.5), 0.8});
}

TEST_CASE("unbiased: motions add up, and go through the transforms that follow and the parents'") {
    const double third = 0.8 / 3.0;
    checkUnbiased({"two moves", above(slab("it:move(1, 0, 0)\nit:move(2, 0, 0)"), 0.6), third});
    checkUnbiased({"then scaled", above(slab("it:move(1.5, 0, 0)\nit:scale(2, 1, 1)"), 0.6),
                   0.8 * 2.0 / 3.0});
    checkUnbiased(
        {"then turned",
         above(slab("it:rotate('z', 90)\nit:move(0, -3, 0)\nit:rotate('z', -90)"), -0.4 - 0.6),
         0.8 * 1.0 / 3.0});
    const std::string parent =
        "it = gr.nh_box('slab', {-1, -9, 0}, {1, 18, 1})\nit:move(0.5, 0, 0)\n"
        "group = gr.node('group')\ngroup:add_child(it, gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, "
        "0))\n"
        "group:move(1, 0, 0)\ntop = gr.node('top')\ntop:add_child(group)\ntop:scale(2, 1, 1)\n"
        "root:add_child(top)\n";
    // -2 .. 0 moves by 3.
    checkUnbiased({"parents", above(parent, 0.6), 0.8 * 2.0 / 3.0});
}

TEST_CASE("unbiased: what turns covers a point for its share of the time") {
    // A quarter of the plane, x and y > 0, about the origin; the point at 1 on the x axis.
    const auto quarter = [](const std::string& calls) {
        return place("gr.nh_box('quarter', {0, 0, 0}, {9, 9, 1})", 0.8, calls);
    };
    checkUnbiased({"a whole turn", above(quarter("it:spin('z', 360)"), 1.0), 0.8 * 0.25});
    // At time s it covers the angles from 180 s - 90 - 45 to 180 s - 45.
    checkUnbiased(
        {"half a turn", above(quarter("it:rotate('z', -135)\nit:spin('z', 180)"), 1.0), 0.8 * 0.5});
    checkUnbiased(
        {"backwards", above(quarter("it:rotate('z', 45)\nit:spin('z', -180)"), 1.0), 0.8 * 0.5});
    // About its own corner, which then stands at (3, 0): the angle there is 180 degrees.
    checkUnbiased({"then moved", above(quarter("it:spin('z', 360)\nit:translate(3, 0, 0)"), 1.0),
                   0.8 * 0.25});
    // The disc of radius 1 about (-3, 0) passes the point (3, 0) after half a turn about the
    // origin.
    const std::string disc = "gr.nh_sphere('disc', {0, 0, 0}, 1)";
    const double width = 2.0 * 2.0 * std::asin(1.0 / 6.0) / (2.0 * std::acos(-1.0));
    checkUnbiased({"first moved",
                   above(place(disc, 0.8, "it:translate(-3, 0, 0)\nit:spin('z', 360)"), 3.0),
                   0.8 * width});
}

TEST_CASE("unbiased: turns of a node, of its parents, and ways go one after another") {
    // Two half turns about one axis are a whole one.
    const std::string nested =
        "it = gr.nh_box('quarter', {0, 0, 0}, {9, 9, 1})\nit:spin('z', 180)\n"
        "group = gr.node('group')\ngroup:spin('z', 180)\n"
        "group:add_child(it, gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 0))\n"
        "root:add_child(group)\n";
    checkUnbiased({"turns add up", above(nested, 1.0), 0.8 * 0.25});
    // Turned there and back again, what is left is the way.
    checkUnbiased({"there and back",
                   above(slab("it:move(3, 0, 0)\nit:spin('z', 70)\nit:spin('z', -70)"), 0.6),
                   0.8 / 3.0});
    // A ball that rolls is a ball that slides.
    const std::string ball = "gr.nh_sphere('ball', {0, 0, 0}, 1)";
    checkUnbiased({"rolls", above(place(ball, 0.8, "it:spin('z', 77)\nit:move(3, 0, 0)"), 1.5),
                   0.8 * 2.0 / 3.0});
    // The other way round its centre goes along a spiral.
    const double turn = -100.0 * std::acos(-1.0) / 180.0;
    constexpr int kMoments = 100'000;
    int covered = 0;
    for (int i = 0; i < kMoments; ++i) {
        const double s = (i + 0.5) / kMoments;
        const double x = 3.0 * s * std::cos(turn * s);
        const double y = 3.0 * s * std::sin(turn * s);
        if ((x - 1.2) * (x - 1.2) + y * y < 1.0) ++covered;
    }
    checkUnbiased({"spirals", above(place(ball, 0.8, "it:move(3, 0, 0)\nit:spin('z', -100)"), 1.2),
                   0.8 * covered / kMoments});
}

TEST_CASE("unbiased: a shadow and a mirror image of what moves") {
    Shot shadow;
    shadow.body = kFloor +
                  place("gr.nh_box('slab', {-1, -9, 5}, {1, 18, 1})", 0.8, "it:move(3, 0, 0)") +
                  "lights[1] = gr.sun_light{direction = {0, 0, -1}, colour = {1, 1, 1}}\n";
    shadow.eye = {0.6, -10.0, 0.5};
    shadow.view = {0.0, 10.0, -0.5};
    checkUnbiased({"shadow", repeated(shadow), 2.0 / 3.0});
    Shot mirror;
    mirror.body =
        place("gr.nh_box('mirror', {-9, -9, -1}, {18, 18, 1})", 0.0, "it:set_reflection(0)") +
        place("gr.nh_box('slab', {-1, -9, 12}, {1, 18, 1})", 0.8, "it:move(3, 0, 0)");
    mirror.eye = {0.6, 0.0, 10.0};
    mirror.ambient = Color(1.0);
    checkUnbiased({"mirror", repeated(mirror), 0.8 / 3.0});
}

TEST_CASE("what does not move is the picture without, to the byte; a tree and few boxes agree") {
    CHECK(
        sameBytes(rendered(kFloor + slab(""), 4), rendered(kFloor + slab("it:move(0, 0, 0)"), 4)));
    std::string many;
    for (int i = 0; i < 40; ++i) {
        many += place("gr.nh_sphere('far', {" + text(i) + ", 300, 300}, 0.4)", 1.0);
    }
    const std::string moving = kFloor + slab("it:move(1, 0.5, 0)");
    CHECK(sameBytes(rendered(moving, 16), rendered(moving + many, 16)));
    CHECK_FALSE(sameBytes(rendered(moving, 16), rendered(kFloor + slab(""), 16)));
}

TEST_CASE("adaptive renders of what moves keep their error") {
    const Shot shot = floorShot(
        kFloor + place("gr.nh_sphere('ball', {-1, 0, 0.7}, 0.7)", 0.7, "it:move(0.6, 0, 0.3)") +
        place("gr.nh_box('post', {0.8, 0, 0}, {0.1, 0.1, 1.5})", 0.9) +
        "lights[1] = gr.light({4, -3, 6}, {0.8, 0.8, 0.8}, {1, 0, 0}, 0.5)\n");
    checkErrorIsKept(shot, 1024, {0.01, 0.004});
}
