// Water in a glass: a view through wall, water and wall, whether the water just touches the glass
// or reaches into it.
#include "optics_shot.h"

#include <utility>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

/// A long glass that lies on its side, open at x = 60: walls of 0.2 around a hollow of 3.6, its
/// bottom from x = 0 to 3.
std::string glassMesh(bool inwards) {
    std::string v;
    for (const double x : {0.0, 60.0, 3.0}) {
        const bool hollow = x == 3.0;
        const double z = hollow ? 1.8 : 2.0;
        const double y = hollow ? 17.0 : 20.0;
        for (const auto& [sy, sz] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            v += text(Vec3(x, sy * y, sz * z)) + ", ";
        }
    }
    // The hollow's mouth.
    for (const auto& [sy, sz] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        v += text(Vec3(60.0, sy * 17.0, sz * 1.8)) + ", ";
    }
    std::string f = inwards ? "{0,1,2,3}, {11,10,9,8}, " : "{3,2,1,0}, {8,9,10,11}, ";
    for (int k = 0; k < 4; ++k) {
        const int n = (k + 1) % 4;
        const auto quad = [&](int a, int b, int c, int d) {
            const int corners[] = {a, b, c, d};
            f += "{";
            for (int i = 0; i < 4; ++i) {
                f += std::to_string(corners[inwards ? 3 - i : i]) + (i < 3 ? "," : "}, ");
            }
        };
        quad(k, n, 4 + n, 4 + k);            // outside
        quad(12 + k, 12 + n, 8 + n, 8 + k);  // inside
        quad(4 + k, 4 + n, 12 + n, 12 + k);  // rim
    }
    return "gr.mesh('glass', {" + v + "}, {" + f + "})";
}

std::string glass(bool inwards) {
    return place(glassMesh(inwards), 0.0, "it:set_refraction(1.5, 0)");
}

/// Fills the hollow up to x = 30, and `into` the glass.
std::string water(double into) {
    return place("gr.nh_box('water', " + text(Vec3(3.0 - into, -17.0 - into, -1.8 - into)) + ", " +
                     text(Vec3(27.0 + into, 34.0 + 2.0 * into, 3.6 + 2.0 * into)) + ")",
                 0.0, "it:set_refraction(1.33, 0)");
}

/// Where a ray lands that starts at this angle in air: thickness and index of each layer.
double landing(double angle, const std::vector<std::pair<double, double>>& layers) {
    double x = 0.0;
    for (const auto& [thickness, index] : layers) {
        x += thickness * std::tan(std::asin(std::sin(angle) / index));
    }
    return x;
}

void checkLanding(const std::string& body, double from,
                  const std::vector<std::pair<double, double>>& layers, std::uint64_t crossings) {
    const Vec3 light(-40.0, 0.0, -8.0);
    for (const double degrees : {0.0, 3.0, 15.0, 30.0, 45.0}) {
        CAPTURE(degrees);
        const double angle = degrees * kPi / 180.0;
        Shot shot;
        shot.body = body + ruler(-10.0, light);
        shot.eye = {from, 0.0, 10.0};
        shot.view = {std::sin(angle), 0.0, -std::cos(angle)};
        RenderOptions options;
        options.cutoff = 0.0;
        const Picture picture = shoot(shot, 1, options);
        const double x = readRuler(picture.at(0, 0).x, -10.0, light) + light.x;
        CHECK(std::fabs(x - (from + landing(angle, layers))) < 1e-9);
        CHECK(picture.counts.rays.refraction == crossings);
    }
}

}  // namespace

TEST_CASE("through a glass of water a view runs as through its layers, however the two meet") {
    const std::vector<std::pair<double, double>> layers{
        {8.0, 1.0}, {0.2, 1.5}, {3.6, 1.33}, {0.2, 1.5}, {8.0, 1.0}};
    for (const bool inwards : {false, true}) {
        CAPTURE(inwards);
        // Water that just touches: each wall is crossed once, whatever was created first.
        checkLanding(water(0.0) + glass(inwards), 5.0, layers, 4);
        checkLanding(glass(inwards) + water(0.0), 5.0, layers, 4);
        // Water that reaches into the glass, which was created later: its index holds in the wall.
        checkLanding(water(0.1) + glass(inwards), 5.0, layers, 6);
        // Above the water there is air between the walls.
        checkLanding(water(0.1) + glass(inwards), 31.0,
                     {{8.0, 1.0}, {0.2, 1.5}, {3.6, 1.0}, {0.2, 1.5}, {8.0, 1.0}}, 4);
    }
}

TEST_CASE("a gap of air between water and glass is a layer of its own") {
    checkLanding(
        water(-0.05) + glass(false), 5.0,
        {{8.0, 1.0}, {0.2, 1.5}, {0.05, 1.0}, {3.5, 1.33}, {0.05, 1.0}, {0.2, 1.5}, {8.0, 1.0}}, 6);
}
