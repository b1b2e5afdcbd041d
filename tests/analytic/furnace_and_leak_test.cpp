// No light where none can be, and all of it where nothing takes any: rooms, contacts, seams.
#include "optics_shot.h"

#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

/// Three lights around the origin, farther than 5, with a floor under their cosines.
const std::string kLightsOutside =
    "lights[1] = gr.light({0, 7, 0.3}, {9, 9, 9}, {1, 0, 0}, 0, 0.5)\n"
    "lights[2] = gr.light({-6, 1, -6}, {9, 9, 9}, {1, 0, 0}, 1, 1)\n"
    "lights[3] = gr.light({8, -8, 8}, {9, 9, 9}, {1, 0, 0}, 0, 1)\n";

/// Six slabs around [-1, 1]^3 whose edges just touch, turned as a whole.
const std::string kSlabRoom =
    "room = gr.node('room')\n"
    "grey = gr.material({0.8, 0.8, 0.8}, {0.5, 0.5, 0.5}, 2)\n"
    "room:add_child(gr.nh_box('left', {-1.5, -1, -1}, {0.5, 2, 2}), grey)\n"
    "room:add_child(gr.nh_box('right', {1, -1, -1}, {0.5, 2, 2}), grey)\n"
    "room:add_child(gr.nh_box('down', {-1.5, -1.5, -1}, {3, 0.5, 2}), grey)\n"
    "room:add_child(gr.nh_box('up', {-1.5, 1, -1}, {3, 0.5, 2}), grey)\n"
    "room:add_child(gr.nh_box('back', {-1.5, -1.5, -1.5}, {3, 3, 0.5}), grey)\n"
    "room:add_child(gr.nh_box('front', {-1.5, -1.5, 1}, {3, 3, 0.5}), grey)\n";

/// A ball of triangles without any thickness, its poles fans.
const std::string kMeshRoom =
    "v, f = {{0, 1, 0}}, {}\n"
    "for i = 1, 7 do for k = 0, 11 do\n"
    "  local a, b = i * math.pi / 8, k * math.pi / 6\n"
    "  v[#v + 1] = {math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b)}\n"
    "end end\n"
    "v[#v + 1] = {0, -1, 0}\n"
    "for k = 0, 11 do\n"
    "  local n = (k + 1) % 12\n"
    "  f[#f + 1] = {0, 1 + n, 1 + k}\n"
    "  f[#f + 1] = {85, 73 + k, 73 + n}\n"
    "  for i = 0, 5 do\n"
    "    local r = 1 + 12 * i\n"
    "    f[#f + 1] = {r + k, r + n, r + 12 + n, r + 12 + k}\n"
    "  end\n"
    "end\n";

std::string turned(const std::string& node, int turn) {
    return node + ":rotate('x', " + text(29.0 * turn) + ")\n" + node + ":rotate('y', " +
           text(17.0 * turn) + ")\n";
}

int pixelsOtherThan(const Picture& picture, const Color& expected, double tolerance = 0.0) {
    int count = 0;
    for (const Color& pixel : picture.pixels) {
        if (!(glm::length(pixel - expected) <= tolerance)) ++count;
    }
    return count;
}

Shot wide(const std::string& body, const Vec3& eye, const Vec3& view) {
    Shot shot;
    shot.body = body;
    shot.eye = eye;
    shot.view = view;
    shot.up = {0.1, 1.0, 0.2};
    shot.fov = 140.0;
    shot.width = shot.height = 24;
    return shot;
}

}  // namespace

TEST_CASE("a closed room lit from outside is black inside, of slabs and of triangles") {
    for (int turn = 0; turn < 4; ++turn) {
        CAPTURE(turn);
        const std::string slabs =
            kSlabRoom + turned("room", turn) + "root:add_child(room)\n" + kLightsOutside;
        const std::string ball =
            kMeshRoom +
            place("gr.mesh('ball', v, f)", 0.8, "it:scale(1, 2, 3)\n" + turned("it", turn)) +
            kLightsOutside;
        for (const Vec3& view : {Vec3(0, 0, -1), Vec3(1, 0.2, 1), Vec3(0.1, -1, 0.1)}) {
            const Vec3 eye(0.1, -0.2, 0.05);
            CHECK(pixelsOtherThan(shoot(wide(slabs, eye, view), 4), Color(0.0)) == 0);
            CHECK(pixelsOtherThan(shoot(wide(ball, eye, view), 4), Color(0.0)) == 0);
        }
    }
}

TEST_CASE("a furnace in which everything is white is white in every pixel") {
    const std::string things =
        place("gr.nh_sphere('mirror', {-2, 0, -3}, 1)", 1.0, "it:set_reflection(0.3)") +
        place("gr.nh_sphere('glass', {1, 0.5, -3}, 1.2)", 1.0,
              "it:set_refraction(1.5, 0.1)\nit:set_fresnel(true)") +
        place("gr.nh_sphere('within', {1, 0.5, -3}, 0.7)", 1.0,
              "it:set_refraction(1.2, 0.2)\nit:set_reflection(0.9)") +
        place("gr.torus('ring')", 1.0, "it:translate(0, -1, -2)\nit:set_refraction(1.3, 0)") +
        place("gr.cone('cone')", 1.0, "it:translate(2, 1, -4)") + kMeshRoom +
        place("gr.mesh('ball', v, f)", 1.0, "it:translate(0, 2, -4)\nit:set_reflection(0)");
    for (const bool closed : {false, true}) {
        Shot shot = wide("gr.background({1, 1, 1})\n" + things, {0, 0, 1}, {0, 0, -1});
        if (closed) shot.body += place("gr.nh_box('room', {-9, -9, -9}, 18)", 1.0);
        shot.ambient = Color(1.0);
        CHECK(pixelsOtherThan(shoot(shot, 4), Color(1.0), 1e-13) == 0);
    }
}

TEST_CASE("convex things between opposite lights are lit once everywhere, at any scale and place") {
    // Far lights in opposite directions, their cosines lifted to 1: each point sees exactly one of
    // them. A point that shadows itself shows 0; one that light leaks through to shows 2.
    struct Solid {
        std::string node;
        bool isRing;
    };
    const std::vector<Solid> solids = {
        {"gr.sphere('s')", false},
        {"gr.nh_box('s', {-0.7, -0.7, -0.7}, 1.4)", false},
        {"gr.cylinder('s')", false},
        {"gr.cone('s')", false},
        {"gr.torus('s', 0.8, 0.2)", true},
        {"gr.mesh('s', v, f, {smooth = 0})", false},
        {"gr.mesh('s', v, f, {smooth = 180})", false},
    };
    for (const Solid& solid : solids) {
        for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
            for (const double offset : {0.0, 1e3, 1e6}) {
                CAPTURE(solid.node);
                CAPTURE(size);
                CAPTURE(offset);
                // Grazing the flat faces; a ring is convex only to light along its axis.
                const Vec3 toLight = solid.isRing ? Vec3(0, 0, 1e9) : Vec3(1e9, 3e5, 1e4);
                const Vec3 centre = size * offset * Vec3(0.7, -1.1, 0.9);
                const auto light = [&](double side) {
                    return "lights[#lights + 1] = gr.light(" +
                           text(centre + side * size * toLight) + ", {1, 1, 1}, {1, 0, 0}, 0, 1)\n";
                };
                Shot shot;
                shot.body = "gr.background({1, 1, 1})\n" + kMeshRoom +
                            place(solid.node, 1.0,
                                  "it:scale(" + text(size) + ", " + text(size) + ", " + text(size) +
                                      ")\nit:translate(" + text(centre.x) + ", " + text(centre.y) +
                                      ", " + text(centre.z) + ")") +
                            light(1.0) + light(-1.0);
                const Vec3 from(1.5, 2.0, 3.1);
                shot.eye = centre + size * from;
                shot.view = -from;
                shot.fov = 30.0;
                shot.width = shot.height = 20;
                const Picture picture = shoot(shot, 1);
                CHECK(picture.counts.rays.shadow > 100u);
                CHECK(pixelsOtherThan(picture, Color(1.0)) == 0);
            }
        }
    }
}

TEST_CASE("two glass balls that touch are entered once each, at their contact too") {
    // A quarter of black own colour at each entry: three quarters of the sky through each ball.
    const std::string balls =
        "gr.background({1, 1, 1})\n" +
        place("gr.nh_sphere('left', {-1, 0, 0}, 1)", 0.0, "it:set_refraction(1.5, 0.25)") +
        place("gr.nh_sphere('right', {1, 0, 0}, 1)", 0.0, "it:set_refraction(1.33, 0.25)");
    for (const double distance : {5.0, 5e3}) {
        for (const double width : {1e-1, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-12}) {
            CAPTURE(distance);
            CAPTURE(width);
            Shot shot = wide(balls, {distance, 0, 0}, {-1, 0, 0});
            shot.fov = width / distance * 180.0 / kPi;
            const Picture along = shoot(shot, 2);
            CHECK(pixelsOtherThan(along, Color(0.75 * 0.75)) == 0);
            CHECK(along.counts.rays.refraction >= 3 * along.counts.rays.camera);
            // From the side only one of them lies in the way, or none.
            shot.eye = {0, 0, distance};
            shot.view = {0, 0, -1};
            int odd = 0;
            for (const Color& pixel : shoot(shot, 1).pixels) {
                odd += pixel.x == 1.0 || (pixel.x >= 0.5 * 0.75 && pixel.x <= 0.75) ? 0 : 1;
            }
            CHECK(odd == 0);
        }
    }
}

TEST_CASE("surfaces too close to tell apart from afar are left behind together") {
    // From 5000 away, gaps below 4e-9 count as none. The inner ball touches the outer one from
    // within: near there both are entered at once, and only the outer one's own colour weighs in.
    Shot shot = wide(
        "gr.background({1, 1, 1})\n" +
            place("gr.nh_sphere('inner', {-1, 0, 0}, 1)", 0.0, "it:set_refraction(1.5, 0.25)") +
            place("gr.nh_sphere('outer', {-2, 0, 0}, 2)", 0.0, "it:set_refraction(1.33, 0.25)"),
        {5000, 0, 0}, {-1, 0, 0});
    for (const double width : {1e-5, 1e-6, 1e-7}) {
        CAPTURE(width);
        shot.fov = width / 5000 * 180.0 / kPi;
        CHECK(pixelsOtherThan(shoot(shot, 1), Color(0.75)) == 0);
    }
    // Of two plates 1e-10 apart the lower one is first in the graph, and lit as if on top.
    shot.body = place("gr.nh_box('lower', {-9, -9, -9}, {18, 18, 9})", 1.0) +
                place("gr.nh_box('upper', {-9, -9, -9}, {18, 18, 9.0000000001})", 0.5) +
                "lights[1] = gr.light({0, 0, 1e6}, {1, 1, 1}, {1, 0, 0}, 0, 1)\n";
    shot.eye = {0, 0, 5000};
    shot.view = {0, 0, -1};
    shot.fov = 0.001;
    CHECK(pixelsOtherThan(shoot(shot, 1), Color(1.0)) == 0);
}

TEST_CASE("a ball that rests on a box leaves no gap for light under it") {
    for (const double size : {1e-3, 1.0, 1e3}) {
        const auto scaled = [&](const Vec3& v) { return text(size * v); };
        const std::string scene =
            place("gr.nh_box('table', " + scaled({-9, -9, -2}) + ", " + scaled({18, 18, 2}) + ")",
                  1.0) +
            place("gr.nh_sphere('ball', " + scaled({0, 0, 1}) + ", " + text(size) + ")", 1.0) +
            "lights[1] = gr.light(" + scaled({10, 0, 10}) + ", {1, 1, 1}, {1, 0, 0}, 0, 1)\n";
        for (const double apart : {0.3, 1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10}) {
            for (int turn = 0; turn < 8; ++turn) {
                CAPTURE(size);
                CAPTURE(apart);
                CAPTURE(turn);
                // The table's point next to the contact, seen from its own side, or the ball's.
                const double a = turn * kPi / 4.0 + 0.1;
                const Vec3 out(std::cos(a), std::sin(a), 0.0);
                Shot shot;
                shot.body = scene;
                shot.eye = size * (6.0 * out + Vec3(0.0, 0.0, 0.5 * std::min(apart, 0.1)));
                shot.view = size * (apart * out) - shot.eye;
                shot.up = {0.0, 0.0, 1.0};
                CHECK(grey(shot) == 0.0);
            }
        }
    }
}

TEST_CASE("of faces that coincide the first in the graph is seen, in every pixel") {
    const std::string scene =
        "red = gr.material({1, 0, 0}, {0, 0, 0}, 0)\n"
        "blue = gr.material({0, 0, 1}, {0, 0, 0}, 0)\n"
        "one = gr.nh_box('one', {-3, -3, -1}, {6, 6, 1})\n"
        "two = gr.nh_box('two', {-8, -6, -4}, {16, 12, 4})\n"
        "two:scale(0.3, 0.7, 0.1)\ntwo:rotate('z', 40)\n"
        "group = gr.node('group')\ngroup:rotate('x', -35)\ngroup:translate(0.1, 0.2, 0.3)\n"
        "root:add_child(group)\n";
    const Color colors[] = {{1, 0, 0}, {0, 0, 1}};
    // Lit along the view: a face that hid the other one's light would show.
    const std::string light = "lights[1] = gr.light({0, 0, 1e6}, {1, 1, 1}, {1, 0, 0}, 0, 1)\n";
    for (const bool redFirst : {true, false}) {
        const std::string red = "group:add_child(one, red)\n";
        const std::string blue = "group:add_child(two, blue)\n";
        for (const double distance : {3.0, 30.0, 3e4}) {
            CAPTURE(redFirst);
            CAPTURE(distance);
            Shot shot;
            shot.body = scene + (redFirst ? red + blue : blue + red) + light;
            shot.eye = {0.1, 0.2, distance};
            shot.fov = 2.0 * std::atan(0.8 / distance) * 180.0 / kPi;
            shot.width = shot.height = 32;
            PictureSettings settings;
            settings.options.spp = 4;
            const Picture picture = renderScript(shot.script(), settings);
            CHECK(pixelsOtherThan(picture, colors[redFirst ? 0 : 1]) == 0);
            settings.threads = 3;
            CHECK(sameBytes(renderScript(shot.script(), settings), picture));
        }
    }
}
