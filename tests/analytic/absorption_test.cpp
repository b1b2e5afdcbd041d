// Coloured glass: every way through a solid leaves exp(-a d), on rays and in shadows.
#include "closed_forms.h"
#include "optics_shot.h"
#include "unbiased.h"

#include "rt/compile/compile.h"
#include "rt/shading/absorption.h"

using namespace rt;
using namespace rt::test;

namespace {

const Color kAbsorption{0.0, 0.3, 1.7};

std::string glass(double index, const Color& absorption, double own = 0.0) {
    return "it:set_refraction(" + text(index) + ", " + text(own) + ")\nit:set_absorption(" +
           text(absorption) + ")";
}

/// What a way of this length leaves, on paper.
Color left(const Color& absorption, double way) {
    return {std::exp(-absorption.x * way), std::exp(-absorption.y * way),
            std::exp(-absorption.z * way)};
}

Color seen(const Shot& shot, int spp = 1) {
    RenderOptions options;
    options.cutoff = 0.0;
    return shoot(shot, spp, options).at(0, 0);
}

void checkNear(const Color& found, const Color& expected, double tolerance) {
    CAPTURE(found.x);
    CAPTURE(found.y);
    CAPTURE(found.z);
    CAPTURE(expected.x);
    CAPTURE(expected.y);
    CAPTURE(expected.z);
    for (int i = 0; i < 3; ++i) CHECK(std::fabs(found[i] - expected[i]) < tolerance);
}

std::string slab(double low, double high, const std::string& calls) {
    return place(
        "gr.nh_box('slab', {-20, -20, " + text(low) + "}, {40, 40, " + text(high - low) + "})", 0.0,
        calls);
}

/// A wall at z = -20 that shows 1.
const std::string kWall = place("gr.nh_box('wall', {-900, -900, -21}, {1800, 1800, 1})", 1.0);

Shot bright(const std::string& body) {
    Shot shot;
    shot.body = body + kWall;
    shot.ambient = Color(1.0);
    return shot;
}

}  // namespace

TEST_CASE("transmittance is exp(-a d), and 1 where nothing is absorbed, at any length") {
    for (const double d : {0.0, 1e-300, 0.5, 3.0, 700.0}) {
        const Color t = transmittance({0.0, 1.0, 0.25}, d);
        CHECK(t.x == 1.0);
        CHECK(std::fabs(t.y - std::exp(-d)) <= 1e-15 * t.y);
        CHECK(std::fabs(t.z - std::exp(-0.25 * d)) <= 1e-15 * t.z);
    }
    CHECK(transmittance({0.0, 2.0, 0.0}, kInfinity) == Color(1.0, 0.0, 1.0));
}

TEST_CASE("a slab leaves exp(-a d / cos) of what shines through, at every tilt") {
    for (const double index : {1.0, 1.5, 2.4}) {
        for (double degrees = 0.0; degrees < 80.0; degrees += 7.3) {
            CAPTURE(index);
            CAPTURE(degrees);
            const double angle = degrees * kPi / 180.0;
            Shot shot = bright(slab(0.0, 0.8, glass(index, kAbsorption)));
            shot.eye = {-10.0 * std::tan(angle), 0.0, 10.0};
            shot.view = {std::sin(angle), 0.0, -std::cos(angle)};
            const double inside = std::asin(std::sin(angle) / index);
            checkNear(seen(shot), left(kAbsorption, 0.8 / std::cos(inside)), 1e-9);
        }
    }
}

TEST_CASE("the length is that in the world, however the solid was scaled and turned") {
    Shot shot = bright(place("gr.cube('cube')", 0.0,
                             "it:translate(-0.5, -0.5, -0.5)\nit:scale(8, 0.35, 8)\n"
                             "it:rotate('x', 90)\n" +
                                 glass(1.5, kAbsorption)));
    checkNear(seen(shot), left(kAbsorption, 0.35), 1e-10);
}

TEST_CASE("a ball leaves exp(-a 2 r cos) on the chord that Snell's law says") {
    for (double aside = 0.0; aside < 0.97; aside += 0.0833) {
        CAPTURE(aside);
        Shot shot =
            bright(place("gr.nh_sphere('ball', {0, 0, 0}, 1)", 0.0, glass(1.5, kAbsorption)));
        shot.eye = {aside, 0.0, 10.0};
        const double inside = std::asin(aside / 1.5);
        checkNear(seen(shot), left(kAbsorption, 2.0 * std::cos(inside)), 1e-9);
    }
}

TEST_CASE("of nested and overlapping solids the one created last absorbs") {
    const Color other{0.9, 0.0, 0.2};
    const std::string outer = slab(-1.0, 1.0, glass(1.33, kAbsorption));
    const std::string inner = slab(-0.25, 0.5, glass(1.5, other));
    checkNear(seen(bright(outer + inner)), left(kAbsorption, 1.25) * left(other, 0.75), 1e-10);
    checkNear(seen(bright(inner + outer)), left(kAbsorption, 2.0), 1e-10);
    // Clear glass in coloured glass is a hole in it; so are two that touch two ways.
    const std::string clear = slab(-0.25, 0.5, "it:set_refraction(1.5, 0)");
    checkNear(seen(bright(outer + clear)), left(kAbsorption, 1.25), 1e-10);
    const std::string above = slab(1.0, 1.5, glass(1.5, other));
    checkNear(seen(bright(outer + above)), left(kAbsorption, 2.0) * left(other, 0.5), 1e-10);
}

TEST_CASE("a camera inside absorbs from the eye on; an object inside is seen over its way") {
    Shot inside = bright(slab(-3.0, 5.0, glass(1.5, kAbsorption)));
    inside.eye = {0.0, 0.0, -1.0};
    checkNear(seen(inside), left(kAbsorption, 2.0), 1e-10);
    Shot frozen = bright(slab(-3.0, 5.0, glass(1.5, kAbsorption)) +
                         place("gr.nh_box('it', {-0.5, -0.5, 0}, 1)", 0.5));
    checkNear(seen(frozen), 0.5 * left(kAbsorption, 4.0), 1e-10);
}

TEST_CASE(
    "what is reflected within glass is absorbed on its whole way, what is reflected off it not") {
    // Up to a mirror within the slab, and back.
    Shot back = bright(
        slab(0.0, 1.0, glass(1.5, kAbsorption)) +
        place("gr.nh_box('mirror', {-9, -9, 0.5}, {18, 18, 0.1})", 0.0, "it:set_reflection(0)"));
    back.body += place("gr.nh_box('ceiling', {-900, -900, 20}, {1800, 1800, 1})", 1.0);
    checkNear(seen(back), left(kAbsorption, 2.0 * 0.4), 1e-10);

    // Fresnel's share off the face is white, however dark the glass.
    Shot off = bright(slab(0.0, 1.0, glass(1.5, Color(200.0)) + "\nit:set_fresnel(true)"));
    off.body += place("gr.nh_box('ceiling', {-900, -900, 20}, {1800, 1800, 1})", 1.0);
    checkNear(seen(off), Color(reflectanceByAngles(0.0, 1.0, 1.5)), 1e-10);
}

TEST_CASE("the own colour counts where a path enters, before anything is absorbed") {
    Shot shot = bright("");
    shot.body = "it = gr.nh_box('slab', {-20, -20, 0}, {40, 40, 1})\n" +
                glass(1.5, kAbsorption, 0.25) +
                "\nroot:add_child(it, gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 0))\n" + kWall;
    checkNear(seen(shot), Color(0.25 * 0.8) + 0.75 * left(kAbsorption, 1.0), 1e-10);
}

TEST_CASE("a slab's shadow is (1 - F)^2 exp(-a d / cos) of the straight way") {
    for (double degrees = 0.0; degrees < 75.0; degrees += 6.1) {
        CAPTURE(degrees);
        const double angle = degrees * kPi / 180.0;
        Shot shot;
        shot.body = place("gr.nh_box('pane', {-8, -8, -0.1}, {16, 16, 0.2})", 0.0,
                          glass(1.5, kAbsorption) + "\nit:rotate('x', " + text(degrees) +
                              ")\nit:translate(0, 0, 4)") +
                    place("gr.nh_box('floor', {-50, -50, -1}, {100, 100, 1})", 1.0) +
                    "lights[1] = gr.light({0, 0, 100}, {1, 1, 1}, {1, 0, 0})\n";
        shot.eye = {10.0, 0.0, 0.5};
        shot.view = {-10.0, 0.0, -0.5};
        const double face = 1.0 - reflectanceByAngles(angle, 1.0, 1.5);
        checkNear(seen(shot), face * face * left(kAbsorption, 0.2 / std::cos(angle)), 1e-10);
    }
}

TEST_CASE("light within glass is absorbed up to the point light, whether anything lies between") {
    const std::string inside = slab(-9.0, 9.0, glass(1.5, kAbsorption)) +
                               place("gr.nh_box('floor', {-8, -8, -1}, {16, 16, 1})", 1.0) +
                               "lights[1] = gr.light({0, 0, 2}, {1, 1, 1}, {1, 0, 0})\n";
    Shot shot;
    shot.body = inside;
    shot.eye = {0.0, 0.0, 3.0};
    checkNear(seen(shot), left(kAbsorption, 2.0 + 3.0), 1e-10);
    shot.body +=
        place("gr.nh_box('air', {-4, -4, 1}, {8, 8, 0.5})", 0.0, "it:set_refraction(1.5, 0)");
    checkNear(seen(shot), left(kAbsorption, 1.5 + 2.5), 1e-10);
}

TEST_CASE("unbiased: a sphere light through coloured glass, and about a point within it") {
    const double half = std::asin(0.6);
    const auto red = [](double way) { return std::exp(-0.7 * way); };
    const std::string lamp = "lights[1] = gr.light({0, 0, 5}, {1, 1, 1}, {1, 0, 0}, 3, 1)\n";
    const auto floor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);
    Shot shot;
    shot.body =
        place("gr.nh_box('pane', {-9, -9, 1}, {18, 18, 0.2})", 0.0, glass(1.0, {0.7, 0.0, 0.0})) +
        floor + lamp;
    shot.eye = {0.0, -10.0, 0.5};
    shot.view = {0.0, 10.0, -0.5};
    checkUnbiased(
        {"pane", repeated(shot), lightWeight(half) * meanOverCone(half, [&](double t, double) {
                                     return red(0.2 / std::cos(t));
                                 })});
    // All of it in the glass: up to the lamp's sphere.
    shot.body = place("gr.nh_box('sea', {-900, -900, -5}, {1800, 1800, 905})", 0.0,
                      glass(1.0, {0.7, 0.0, 0.0})) +
                floor + lamp;
    const double toEye = red(glm::length(Vec3(0.0, 10.0, 0.5)));
    checkUnbiased({"sea", repeated(shot),
                   toEye * lightWeight(half) * meanOverCone(half, [&](double t, double) {
                       const double aside = 5.0 * std::sin(t);
                       return red(5.0 * std::cos(t) - std::sqrt(9.0 - aside * aside));
                   })});
}

TEST_CASE("adaptive renders of coloured glass keep their error") {
    // Lights within the glass, which the closed form of clear air would make too bright.
    Shot shot;
    shot.body =
        place("gr.nh_box('sea', {-30, -30, -5}, {60, 60, 9})", 0.0, glass(1.2, {0.05, 0.15, 0.4})) +
        place("gr.nh_box('floor', {-28, -28, -4}, {56, 56, 1})", 0.8) +
        place("gr.nh_sphere('ball', {0, 0, -2}, 1)", 0.9) +
        "lights[1] = gr.light({3, -2, 2}, {0.8, 0.8, 0.8}, {1, 0, 0}, 0.7)\n"
        "lights[2] = gr.light({-6, 2, 12}, {0.4, 0.4, 0.4}, {1, 0, 0})\n";
    shot.eye = {0.0, -9.0, 6.0};
    shot.view = {0.0, 9.0, -7.0};
    shot.up = {0.0, 0.0, 1.0};
    shot.fov = 45.0;
    shot.width = shot.height = 48;
    shot.ambient = Color(0.1);
    PictureSettings truth;
    truth.options.spp = 1024;
    truth.options.cutoff = 0.0;
    PictureSettings adaptive;
    adaptive.options.error = 0.003;
    const Picture right = renderScript(shot.script(), truth);
    const Picture found = renderScript(shot.script(), adaptive);
    CHECK(found.converged);
    double squares = 0.0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const Color off =
            glm::clamp(found.pixels[i], 0.0, 1.0) - glm::clamp(right.pixels[i], 0.0, 1.0);
        squares += glm::dot(off, off) / 3.0;
    }
    CHECK(std::sqrt(squares / static_cast<double>(found.pixels.size())) < 0.0036);
}

TEST_CASE(
    "no absorption is the picture without, to the byte; where it counts for nothing it says so") {
    const auto withCall = [](const std::string& call) {
        Shot shot = bright(place("gr.nh_sphere('ball', {0, 0, 0}, 1)", 0.2,
                                 "it:set_refraction(1.5, 0.1)\n" + call));
        shot.fov = 20.0;
        shot.width = shot.height = 16;
        return shot;
    };
    CHECK(sameBytes(shoot(withCall("")), shoot(withCall("it:set_absorption{0, 0, 0}"))));
    CHECK_FALSE(sameBytes(shoot(withCall("")), shoot(withCall("it:set_absorption{0, 0.1, 0}"))));

    const auto warning = [](const std::string& body) -> std::string {
        const TemporaryFolder folder;
        Diagnostics diagnostics;
        const SceneDesc scene =
            runScript(folder.write("scene.lua", bright(body).script()), {}, diagnostics).scene;
        AssetCache assets(1);
        compileScene(scene, 0, {}, assets, diagnostics);
        return diagnostics.countByKind().count("unused-absorption") == 0
                   ? ""
                   : diagnostics.shown().back().message;
    };
    CHECK(warning(place("gr.sphere('s')", 1.0, glass(1.5, kAbsorption))).empty());
    CHECK(warning(place("gr.sphere('s')", 1.0, "it:set_absorption{1, 0, 0}"))
              .find("no light shines through it") != std::string::npos);
    CHECK(warning(place("gr.mesh('m', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0,1,2}})", 1.0,
                        "it:set_refraction(1.5, 0)\nit:set_absorption{1, 0, 0}"))
              .find("open mesh") != std::string::npos);
}
