// Which solids a ray is inside: nested, overlapping, touching, open and turned inside out.
#include "optics_shot.h"

#include <utility>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kSky = "gr.background({1, 1, 1})\n";
const Vec3 kLight(-40.0, 0.0, -9.5);
constexpr double kFloor = -10.0;

std::string glassCall(double index, double own = 0.0) {
    return "it:set_refraction(" + text(index) + ", " + text(own) + ")";
}

/// `calls` come after the refraction's.
std::string slab(double bottom, double top, double index, const std::string& calls = "") {
    return place("gr.nh_box('slab', {-500, -500, " + text(bottom) + "}, {1000, 1000, " +
                     text(top - bottom) + "})",
                 0.0, glassCall(index) + "\n" + calls);
}

/// A layer's thickness and index.
using Layers = std::vector<std::pair<double, double>>;

/// Where a ray lands that starts in the first layer at this angle.
double landing(double angle, const Layers& layers) {
    double x = 0.0;
    for (const auto& [thickness, index] : layers) {
        x += thickness * std::tan(std::asin(layers.front().second * std::sin(angle) / index));
    }
    return x;
}

/// Looks down on `slabs` from z = 10 at some angles; the layers start there and reach the floor.
void checkLayers(const std::string& slabs, const Layers& layers, std::uint64_t crossings,
                 double eye = 10.0) {
    for (const double degrees : {0.0, 5.0, 20.0, 40.0, 50.0}) {
        CAPTURE(degrees);
        const double angle = degrees * kPi / 180.0;
        Shot shot;
        shot.body = slabs + ruler(kFloor, kLight);
        shot.eye.z = eye;
        shot.view = {std::sin(angle), 0.0, -std::cos(angle)};
        RenderOptions options;
        options.cutoff = 0.0;
        const Picture picture = shoot(shot, 1, options);
        const double x = readRuler(picture.at(0, 0).x, kFloor, kLight) + kLight.x;
        CHECK(std::fabs(x - landing(angle, layers)) < 1e-9);
        CHECK(picture.counts.rays.refraction == crossings);
    }
}

/// A cube [-1, 1]^3 as a mesh, of either winding, complete or without its front.
std::string cubeMesh(bool inwards, bool open = false) {
    std::string faces;
    for (const std::vector<int>& face : {std::vector<int>{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}}) {
        if (open && face[0] == 4) continue;
        std::string corners;
        for (std::size_t i = 0; i < 4; ++i) {
            corners += (i ? ", " : "") + std::to_string(face[inwards ? 3 - i : i]);
        }
        faces += "{" + corners + "}, ";
    }
    return "gr.mesh('cube', {{-1,-1,-1}, {1,-1,-1}, {-1,1,-1}, {1,1,-1}, {-1,-1,1}, {1,-1,1}, "
           "{-1,1,1}, {1,1,1}}, {" +
           faces + "})";
}

const std::string kQuad =
    "gr.mesh('quad', {{-90,-90,0}, {90,-90,0}, {90,90,0}, {-90,90,0}}, {{0,1,2,3}})";

}  // namespace

TEST_CASE("of overlapping solids the one created later decides the index") {
    const std::string glass = slab(-6.0, 0.0, 1.5);
    checkLayers(glass + slab(-4.0, -2.0, 1.33),
                {{10.0, 1.0}, {2.0, 1.5}, {2.0, 1.33}, {2.0, 1.5}, {4.0, 1.0}}, 4);
    checkLayers(slab(-4.0, -2.0, 1.33) + glass, {{10.0, 1.0}, {6.0, 1.5}, {4.0, 1.0}}, 4);
    checkLayers(glass + slab(-8.0, -4.0, 1.33), {{10.0, 1.0}, {4.0, 1.5}, {4.0, 1.33}, {2.0, 1.0}},
                4);
    checkLayers(slab(-8.0, -4.0, 1.33) + glass, {{10.0, 1.0}, {6.0, 1.5}, {2.0, 1.33}, {2.0, 1.0}},
                4);
}

TEST_CASE("a face that two boxes share is crossed once") {
    const Layers layers{{10.0, 1.0}, {0.7, 1.5}, {0.7, 1.33}, {8.6, 1.0}};
    checkLayers(slab(-0.7, 0.0, 1.5) + slab(-1.4, -0.7, 1.33), layers, 3);
    checkLayers(slab(-1.4, -0.7, 1.33) + slab(-0.7, 0.0, 1.5), layers, 3);
    // The same faces by ways of different rounding.
    checkLayers(slab(-0.7, 0.0, 1.5, "it:rotate('z', 33)") +
                    slab(-0.7, 0.0, 1.33, "it:translate(0.1, 0, -0.7)"),
                layers, 3);
    checkLayers(slab(0.0, 1.0, 1.5, "it:scale(1, 1, 0.7)\nit:translate(0, 0, -0.7)") +
                    slab(-7.0, 0.0, 1.33,
                         "it:scale(0.3, 0.3, 0.1)\nit:rotate('x', 30)\nit:translate(0, 0, -0.7)\n"
                         "it:translate(0, 0, 0.7)\nit:rotate('x', -30)\nit:translate(0, 0, -0.7)"),
                layers, 3);
}

TEST_CASE("boxes of one index that touch are one box") {
    checkLayers(slab(-2.0, 0.0, 1.5) + slab(-4.0, -2.0, 1.5), {{10.0, 1.0}, {4.0, 1.5}, {6.0, 1.0}},
                3);
}

TEST_CASE("between touching glasses there is no air that would reflect totally") {
    // 50 degrees in glass is beyond asin(1 / 1.5), and short of asin(1.33 / 1.5).
    checkLayers(slab(-5.0, 5.0, 1.5) + slab(kFloor, -5.0, 1.33), {{6.0, 1.5}, {5.0, 1.33}}, 1, 1.0);
}

TEST_CASE("more solids than a path keeps at hand nest as well") {
    // Each of ten balls gives a tenth of its own colour where the ray enters it.
    Shot shot;
    shot.body = kSky;
    double expected = 0.0;
    double weight = 1.0;
    for (int i = 0; i < 10; ++i) {
        const double color = 0.05 * i;
        shot.body += place("gr.nh_sphere('shell', {0, 0, 0}, " + text(5.0 - 0.4 * i) + ")", color,
                           glassCall(1.1 + 0.05 * i, 0.1));
        expected += weight * 0.1 * color;
        weight *= 0.9;
    }
    expected += weight;
    shot.ambient = Color(1.0);
    RenderOptions options;
    options.maxDepth = 40;
    options.cutoff = 0.0;
    CHECK(std::fabs(shoot(shot, 1, options).at(0, 0).x - expected) < 1e-14);
    // From within all of them no weight applies.
    shot.eye = {0.01, 0.0, 0.0};
    CHECK(std::fabs(shoot(shot, 1, options).at(0, 0).x - 1.0) < 1e-14);
}

TEST_CASE("each point of a lens that straddles a glass wall starts in its own medium") {
    // Rays from the lens' right half run within the glass, the others beside it.
    Shot shot;
    shot.body =
        kSky + place("gr.nh_box('wall', {0, -50, -9}, {50, 100, 50})", 0.0, glassCall(1.5, 0.25));
    // The eye itself is outside.
    shot.eye = {-0.1, 0.0, 0.0};
    shot.focal = "100, 1, 0.5";
    CHECK(grey(shot, 64) == 1.0);
    shot.eye.x = 0.0;
    // With the wall wholly ahead of the lens, the right half's rays enter it.
    shot.body =
        kSky + place("gr.nh_box('wall', {0, -50, -9}, {50, 100, 8})", 0.0, glassCall(1.5, 0.25));
    CHECK(grey(shot, 4096) == doctest::Approx(0.5 + 0.5 * 0.75).epsilon(1e-3));
}

TEST_CASE("a mesh's winding changes nothing about its glass") {
    Shot shot;
    const std::string turn = glassCall(1.5, 0.2) + "\nit:rotate('x', 20)\nit:rotate('y', 35)";
    const auto withCube = [&](const std::string& cube) {
        Shot made = shot;
        made.body = "gr.background({0, 0.2, 0.9}, {1, 0.7, 0.1})\n" + place(cube, 0.5, turn) +
                    "lights[1] = gr.light({3, 4, 8}, {0.5, 0.5, 0.5}, {1, 0, 0})\n";
        made.fov = 25.0;
        made.width = made.height = 24;
        RenderOptions options;
        options.sampler = "grid";
        return shoot(made, 1, options);
    };
    const Picture outwards = withCube(cubeMesh(false));
    for (const std::string& other :
         {cubeMesh(true), std::string("gr.nh_box('cube', {-1, -1, -1}, 2)")}) {
        const Picture picture = withCube(other);
        int different = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            if (!(glm::length(picture.pixels[i] - outwards.pixels[i]) < 1e-12)) ++different;
        }
        CHECK(different == 0);
    }
}

TEST_CASE("a mesh that is not closed is a sheet at each crossing: straight through, weighed") {
    const std::string gradient = "gr.background({0, 0, 0}, {1, 1, 1})\n";
    Shot shot;
    shot.ambient = Color(1.0);
    for (const double tilt : {0.0, 30.0, 60.0, 85.0}) {
        CAPTURE(tilt);
        shot.view = glm::normalize(Vec3(0.1, 0.2, -1.0));
        const double sky = 0.5 + 0.5 * shot.view.y;
        shot.body = gradient + place(kQuad, 0.8,
                                     glassCall(1.5, 0.25) + "\nit:rotate('x', " + text(tilt) + ")");
        CHECK(std::fabs(grey(shot) - (0.25 * 0.8 + 0.75 * sky)) < 1e-13);
    }
    // An open box is two sheets in a row, from either side.
    for (const bool inwards : {false, true}) {
        shot.view = {0.0, 0.0, -1.0};
        shot.body = kSky + place(cubeMesh(inwards, true), 0.8,
                                 glassCall(1.5, 0.25) + "\nit:rotate('x', 90)");
        const double one = 0.25 * 0.8 + 0.75;
        CHECK(std::fabs(grey(shot) - (0.25 * 0.8 + 0.75 * one)) < 1e-14);
    }
}
