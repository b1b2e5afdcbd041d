// Sphere lights against closed forms: the parts of spherical caps that something covers.
#include "closed_forms.h"
#include "optics_shot.h"

#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kFloor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);

/// Samples that bring a shadow's edge to a few 1e-4.
constexpr int kMany = 32768;

/// A light of intensity 1 without falloff. Brightness 1 lifts every cosine to 1.
std::string light(const Vec3& centre, double radius, double brightness = 0.0) {
    return "lights[#lights + 1] = gr.light(" + text(centre) + ", {1, 1, 1}, {1, 0, 0}, " +
           text(radius) + ", " + text(brightness) + ")\n";
}

/// Sees the floor's origin from the direction -y, from low enough to pass below any obstacle.
Shot origin(const std::string& body) {
    Shot shot;
    shot.body = body + kFloor;
    shot.eye = {0.0, -10.0, 0.5};
    shot.view = {0.0, 10.0, -0.5};
    return shot;
}

/// Above the origin, a wall whose edge runs along y in the plane of directions `off` from the
/// vertical; it hides what lies on the side of +x, and is too thin to hide more.
std::string edge(double off) {
    const double height = 2.0;
    return place(
        "gr.nh_box('edge', {" + text(height * std::tan(off)) + ", -90, 2}, {90, 180, 1e-8})", 1.0);
}

}  // namespace

TEST_CASE("a light with nothing in its way gives kd n.l, whatever its radius") {
    for (const double radius : {1e-6, 0.01, 0.5, 2.0, 3.9}) {
        CAPTURE(radius);
        // The centre is 6 off along x and 8 up; all of the light is above the horizon.
        CHECK(std::fabs(grey(origin(light({6.0, 0.0, 8.0}, radius)), 4096) - 0.8) < 1e-3);
    }
}

TEST_CASE("an edge through the middle of the light, or off it, hides its share of the cap") {
    for (const double radius : {0.2, 1.0, 2.0, 2.9}) {
        const double cap = std::asin(radius / 5.0);
        for (const double part : {-0.9, -0.5, 0.0, 0.3, 0.8}) {
            CAPTURE(radius);
            CAPTURE(part);
            const double off = part * cap;
            const double seen = commonCap(cap, 0.5 * kPi, 0.5 * kPi - off) / capOf(cap);
            const double value = grey(origin(edge(off) + light({0, 0, 5}, radius, 1.0)), kMany);
            CHECK(std::fabs(value - lightWeight(cap) * seen) < 1e-3);
        }
    }
}

TEST_CASE("a ball in front of the light hides what the caps have in common") {
    struct Case {
        double lightRadius, ballRadius, apart;
    };
    for (const Case& c : std::vector<Case>{{1.0, 0.3, 0.15},
                                           {1.0, 0.5, 0.3},
                                           {3.0, 0.2, 0.6},
                                           {4.0, 1.5, 0.5},
                                           {2.0, 0.8, 0.7}}) {
        CAPTURE(c.lightRadius);
        CAPTURE(c.ballRadius);
        const double lightCap = std::asin(c.lightRadius / 5.0);
        const double ballCap = std::asin(c.ballRadius / 1.9);
        const std::string ball = place(
            "gr.nh_sphere('ball', " + text(1.9 * Vec3(0.0, std::sin(c.apart), std::cos(c.apart))) +
                ", " + text(c.ballRadius) + ")",
            1.0);
        double hidden = 0.0;
        if (c.apart + lightCap <= ballCap) {
            hidden = capOf(lightCap);
        } else if (c.apart + ballCap <= lightCap) {
            hidden = capOf(ballCap);
        } else if (c.apart < lightCap + ballCap) {
            hidden = commonCap(lightCap, ballCap, c.apart);
        }
        // Of a cone that reaches below the horizon nothing is asked here.
        REQUIRE(lightCap < 0.5 * kPi);
        const double expected = lightWeight(lightCap) * (1.0 - hidden / capOf(lightCap));
        const double value = grey(origin(ball + light({0, 0, 5}, c.lightRadius, 1.0)), kMany);
        CHECK(std::fabs(value - expected) < 1e-3);
    }
}

TEST_CASE("a light that the horizon cuts gives the mean of its part above, in closed form") {
    const double a = 0.5;
    for (const double b : {1.1, 1.3, 0.5 * kPi, 1.8, 2.0}) {
        CAPTURE(b);
        const Vec3 centre = 10.0 * Vec3(std::sin(b), 0.0, std::cos(b));
        // The floor hides nothing of it: light from below the horizon does not count anyway.
        const double value = grey(origin(light(centre, 10.0 * std::sin(a))), 4096);
        CHECK(std::fabs(value - lightWeight(a) * meanCosineOfCutCone(a, b)) < 1e-3);
    }
    // At the ends of its range the form meets those of a light above and of one below.
    const double rising = 0.5 * kPi - a;
    CHECK(std::fabs(meanCosineOfCutCone(a, rising + 1e-9) -
                    std::cos(rising) * (1.0 + std::cos(a)) / 2.0) < 1e-7);
    CHECK(std::fabs(meanCosineOfCutCone(a, 0.5 * kPi + a - 1e-9)) < 1e-7);
}

TEST_CASE("a point inside the light sees a hemisphere of it, at the falloff of its radius") {
    // Radius 4, the centre at a distance below that, b off the normal; E of a hemisphere whose axis
    // is b off the normal is (1 + cos b) / 2.
    for (const double degrees : {0.0, 40.0, 90.0, 130.0}) {
        CAPTURE(degrees);
        const double b = degrees * kPi / 180.0;
        const Vec3 centre = 1.5 * Vec3(std::sin(b), 0.0, std::cos(b));
        const std::string body =
            "lights[1] = gr.light(" + text(centre) + ", {1, 1, 1}, {1, 0.25, 0}, 4)\n";
        CHECK(std::fabs(grey(origin(body), 4096) - 0.5 * (1.0 + std::cos(b)) / 2.0) < 1e-3);
    }
}

TEST_CASE("things within a light hide it from a point that is within too, and from no other") {
    const std::string ball = place("gr.nh_sphere('ball', {0, 0, 2}, 0.5)", 1.0);
    // Seen from within, the ball takes its cap off the hemisphere: cos(asin(0.5 / 2)) is left.
    CHECK(std::fabs(grey(origin(ball + light({0, 0, 1.5}, 4.0, 1.0)), kMany) -
                    2.0 * std::sqrt(1.0 - 0.0625)) < 1e-3);
    CHECK(std::fabs(grey(origin(ball + light({0, 0, 2}, 1.2, 1.0)), 16) -
                    lightWeight(std::asin(0.6))) < 1e-12);
}

TEST_CASE("each light costs one shadow ray a hit, a point as well as a sphere") {
    for (const double radius : {0.0, 1.0}) {
        for (const int lights : {1, 3}) {
            Shot shot;
            shot.body = kFloor;
            for (int i = 0; i < lights; ++i) shot.body += light({i - 1.0, 0.0, 8.0}, radius);
            shot.fov = 40.0;
            shot.width = 7;
            shot.height = 5;
            const Picture picture = shoot(shot, 3);
            CHECK(picture.counts.rays.camera == 7 * 5 * 3);
            CHECK(picture.counts.rays.shadow ==
                  static_cast<std::uint64_t>(lights) * picture.counts.rays.camera);
        }
    }
}

TEST_CASE("a light of radius 0 is the limit of small ones") {
    const std::string ball = place("gr.nh_sphere('ball', {0.5, 0, 3}, 0.4)", 1.0);
    const double point = grey(origin(ball + light({1, 2, 7}, 0.0)));
    CHECK(point == doctest::Approx(7.0 / std::sqrt(54.0)).epsilon(1e-12));
    CHECK(std::fabs(grey(origin(ball + light({1, 2, 7}, 1e-7)), 16) - point) < 1e-6);
}
