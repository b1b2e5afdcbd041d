// Light that shines straight through glass, against products of Fresnel's laws in angles.
#include "closed_forms.h"
#include "optics_shot.h"

using namespace rt;
using namespace rt::test;

namespace {

constexpr double kLightHeight = 8.0;

/// Transmittance of a face whose thinner side the light crosses at this angle.
double through(double angle, double thin, double thick) {
    return 1.0 - reflectanceByAngles(angle, thin, thick);
}

std::string glassCall(double index, double own) {
    return "it:set_refraction(" + text(index) + ", " + text(own) + ")";
}

/// A pane of thickness 0.2 about the origin, turned about the x axis and lifted.
std::string pane(double degrees, double index, double own, double size = 4.0, double height = 4.0) {
    return place("gr.nh_box('pane', {" + text(-0.5 * size) + ", " + text(-0.5 * size) +
                     ", -0.1}, {" + text(size) + ", " + text(size) + ", 0.2})",
                 0.0,
                 glassCall(index, own) + "\nit:rotate('x', " + text(degrees) +
                     ")\nit:translate(0, 0, " + text(height) + ")");
}

/// The value of the floor's origin under a light of intensity 1 straight above, seen from the side,
/// below whatever stands higher than 0.5.
double floorUnder(const std::string& body, double lightHeight = kLightHeight) {
    Shot shot;
    shot.body = body + place("gr.nh_box('floor', {-50, -50, -1}, {100, 100, 1})", 1.0) +
                "lights[1] = gr.light({0, 0, " + text(lightHeight) + "}, {1, 1, 1}, {1, 0, 0})\n";
    shot.eye = {10.0, 0.0, 0.5};
    shot.view = {-10.0, 0.0, -0.5};
    return grey(shot);
}

}  // namespace

TEST_CASE("a tilted pane's shadow is (1 - f) (1 - F)^2 at every half degree") {
    for (const double index : {1.0, 1.33, 1.5, 2.4}) {
        for (const double own : {0.0, 0.25}) {
            for (int i = 0; i < 176; ++i) {
                const double degrees = 0.5 * i;
                CAPTURE(index);
                CAPTURE(own);
                CAPTURE(degrees);
                const double face = through(degrees * kPi / 180.0, 1.0, index);
                const double value = floorUnder(pane(degrees, index, own, 7.0));
                CHECK(std::fabs(value - (1.0 - own) * face * face) < 1e-12);
                CHECK(value > 0.0);
            }
        }
    }
}

TEST_CASE("a pane of an index below 1 counts its own angle's like in the thinner medium") {
    // The straight line's angle is taken as the angle within the pane.
    const double face = through(0.5, 0.8, 1.0);
    CHECK(std::fabs(floorUnder(pane(0.5 * 180.0 / kPi, 0.8, 0.0)) - face * face) < 1e-12);
}

TEST_CASE("a pane's shadow is nowhere black, its rim included") {
    for (double degrees = 0.0; degrees < 180.0; degrees += 3.7) {
        CAPTURE(degrees);
        // A pane as thick as wide: its faces and rims are all passed as the box turns.
        const std::string block = place("gr.nh_box('block', {-1, -1, -1}, 2)", 0.0,
                                        glassCall(1.5, 0.0) + "\nit:rotate('x', " + text(degrees) +
                                            ")\nit:translate(0, 0.7, 4)");
        CHECK(floorUnder(block) > 0.0);
    }
    // In by a face and out by the rim beside it: both angles count.
    const double angle = 30.0 * kPi / 180.0;
    const std::string block =
        place("gr.nh_box('block', {-1, -1, -1}, 2)", 0.0,
              glassCall(1.5, 0.0) + "\nit:rotate('x', 30)\nit:translate(0, 1.1, 4)");
    const double expected = through(angle, 1.0, 1.5) * through(0.5 * kPi - angle, 1.0, 1.5);
    CHECK(std::fabs(floorUnder(block) - expected) < 1e-12);
}

TEST_CASE("a ball's shadow darkens towards its rim as Fresnel's laws do") {
    for (int i = 0; i < 40; ++i) {
        const double aside = i / 40.0;
        CAPTURE(aside);
        const double face = through(std::asin(aside), 1.0, 1.5);
        const std::string ball = place("gr.nh_sphere('ball', {" + text(aside) + ", 0, 4}, 1)", 0.0,
                                       glassCall(1.5, 0.125));
        CHECK(std::fabs(floorUnder(ball) - 0.875 * face * face) < 1e-10);
    }
}

TEST_CASE("nested glass weighs each boundary between its own two media") {
    const double angle = 0.6;
    const std::string turn =
        "\nit:rotate('x', " + text(angle * 180.0 / kPi) + ")\nit:translate(0, 0, 4)";
    const auto layer = [&](double half, double index, double own) {
        return place(
            "gr.nh_box('layer', {-8, -8, " + text(-half) + "}, {16, 16, " + text(2.0 * half) + "})",
            0.0, glassCall(index, own) + turn);
    };
    const double outer = through(angle, 1.0, 1.33);
    const double inner = through(angle, 1.33, 1.6);
    CHECK(std::fabs(floorUnder(layer(0.5, 1.33, 0.25) + layer(0.2, 1.6, 0.5)) -
                    0.75 * 0.5 * outer * outer * inner * inner) < 1e-12);
    // Created first, the inner layer has its own weight but no boundary of its own.
    CHECK(std::fabs(floorUnder(layer(0.2, 1.6, 0.5) + layer(0.5, 1.33, 0.25)) -
                    0.75 * 0.5 * outer * outer) < 1e-12);
    // Two panes that touch have one boundary in common.
    const auto half = [&](double from, double index, double own) {
        return place("gr.nh_box('half', {-8, -8, " + text(from) + "}, {16, 16, 0.3})", 0.0,
                     glassCall(index, own) + turn);
    };
    CHECK(std::fabs(floorUnder(half(-0.3, 1.33, 0.25) + half(0.0, 1.6, 0.5)) -
                    0.75 * 0.5 * outer * inner * through(angle, 1.0, 1.6)) < 1e-12);
}

TEST_CASE("a sheet weighs once at each crossing, an open box at both") {
    const std::string quad =
        "gr.mesh('quad', {{-9,-9,0}, {9,-9,0}, {9,9,0}, {-9,9,0}}, {{0,1,2,3}})";
    const double angle = 0.7;
    const std::string call = glassCall(1.5, 0.25) + "\nit:rotate('x', " +
                             text(angle * 180.0 / kPi) + ")\nit:translate(0, 0, 4)";
    const double once = 0.75 * through(angle, 1.0, 1.5);
    CHECK(std::fabs(floorUnder(place(quad, 0.0, call)) - once) < 1e-12);
    CHECK(std::fabs(floorUnder(place(quad, 0.0, call) +
                               place(quad, 0.0, call + "\nit:translate(0, 0, 1)")) -
                    once * once) < 1e-12);
}

TEST_CASE("the weight counts where light enters: not where a lamp inside sends it out") {
    const std::string ball = place("gr.nh_sphere('ball', {0, 0, 8}, 2)", 0.0, glassCall(1.5, 0.25));
    const double face = through(0.0, 1.0, 1.5);
    CHECK(std::fabs(floorUnder(ball, 8.0) - face) < 1e-12);
    CHECK(std::fabs(floorUnder(ball, 12.0) - 0.75 * face * face) < 1e-12);
}

TEST_CASE("what lies within glass is lit through the face that the light enters by") {
    // The eye is inside the glass too; what it sees of the floor within is not weighed.
    Shot shot;
    shot.body =
        place("gr.nh_box('glass', {-50, -50, -3}, {100, 100, 7})", 0.0, glassCall(1.5, 0.25)) +
        place("gr.nh_box('floor', {-40, -40, -1}, {80, 80, 1})", 1.0) +
        "lights[1] = gr.light({0, 0, 8}, {1, 1, 1}, {1, 0, 0})\n";
    shot.eye = {0.0, 0.0, 3.0};
    CHECK(std::fabs(grey(shot) - 0.75 * through(0.0, 1.0, 1.5)) < 1e-12);
}

TEST_CASE("an opaque thing behind or within glass still casts its black shadow") {
    const std::string glass = pane(0.0, 1.5, 0.0);
    CHECK(floorUnder(glass + place("gr.nh_sphere('ball', {0, 0, 6}, 0.5)", 1.0)) == 0.0);
    CHECK(floorUnder(glass + place("gr.nh_sphere('ball', {0, 0, 4}, 0.05)", 1.0)) == 0.0);
    CHECK(floorUnder(glass + place("gr.nh_sphere('ball', {0, 0, 2}, 0.5)", 1.0)) == 0.0);
}

TEST_CASE("light through more panes than a sample may follow is cut, and what was cut is booked") {
    const std::string scene = R"(
        root = gr.node('root')
        root:add_child(gr.nh_box('floor', {-9, -1, -9}, {18, 1, 18}),
                       gr.material({1, 1, 1}, {0, 0, 0}, 0))
        local clear = gr.material({0, 0, 0}, {0, 0, 0}, 0)
        for i = 1, PANES do
            local pane = gr.nh_box('pane' .. i, {2 + 0.001 * i, 0, -1}, {0.0005, 9, 2})
            pane:set_refraction(1, 0)
            root:add_child(pane, clear)
        end
        gr.render(root, 'x.png', 1, 1, {0, 9, 0}, {0, -1, 0}, {0, 0, 1}, 0.001, {0, 0, 0},
                  {gr.light({12, 3, 0}, {1, 1, 1}, {1, 0, 0})}))";
    const auto with = [&](const std::string& panes) {
        std::string script = scene;
        script.replace(script.find("PANES"), 5, panes);
        PictureSettings settings;
        settings.options.spp = 1;
        return renderScript(script, settings);
    };
    const Picture few = with("1000");
    CHECK(few.at(0, 0).x > 0.2);
    CHECK(few.counts.cutPaths == 0);
    const Picture many = with("3000");
    CHECK(many.at(0, 0).x == 0.0);
    CHECK(many.counts.cutPaths == 1);
    CHECK(many.counts.cutBound >= few.at(0, 0).x);
}
