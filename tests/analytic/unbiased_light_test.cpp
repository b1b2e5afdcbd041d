// Soft shadows and the light of spheres agree with their integrals in the mean.
#include "closed_forms.h"
#include "unbiased.h"

using namespace rt;
using namespace rt::test;

namespace {

const std::string kFloor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);

std::string light(const Vec3& centre, double radius, double brightness = 0.0) {
    return "lights[#lights + 1] = gr.light(" + text(centre) + ", {1, 1, 1}, {1, 0, 0}, " +
           text(radius) + ", " + text(brightness) + ")\n";
}

/// The floor's origin, seen from the side.
Shot origin(const std::string& body) {
    Shot shot;
    shot.body = body + kFloor;
    shot.eye = {0.0, -10.0, 0.5};
    shot.view = {0.0, 10.0, -0.5};
    return repeated(shot);
}

/// Hides what lies more than `off` beyond the vertical, on the side of +x.
std::string edge(double off) {
    return place("gr.nh_box('edge', {" + text(2.0 * std::tan(off)) + ", -90, 2}, {90, 180, 1e-8})",
                 1.0);
}

/// The value under a light of half-angle a straight above, with the edge in front of it.
double besideEdge(double a, double off) {
    return lightWeight(a) * commonCap(a, 0.5 * kPi, 0.5 * kPi - off) / capOf(a);
}

const double kHalf = std::asin(0.6);  // of a light of radius 3 at distance 5

std::string highLight(double brightness = 1.0) {
    return light({0, 0, 5}, 3.0, brightness);
}

}  // namespace

TEST_CASE("unbiased: a light with nothing in its way") {
    for (const double radius : {0.5, 2.0, 3.9}) {
        checkUnbiased({"radius " + text(radius), origin(light({6, 0, 8}, radius)), 0.8});
    }
}

TEST_CASE("unbiased: an edge in front of a light, with every sampler that claims it") {
    for (const double off : {-0.3, 0.0, 0.2}) {
        Estimate e{"edge at " + text(off), origin(edge(off) + highLight()), besideEdge(kHalf, off)};
        checkUnbiased(e);
        e.options.sampler = "jitter";
        checkUnbiased(e);
        e.options.sampler = "random";
        checkMean(e, 1024, 5e-3);
    }
}

TEST_CASE("unbiased: what a single pixel of 4096 samples is off at a shadow's edge is scatter") {
    for (const double off : {-0.3, 0.0, 0.2}) {
        Shot shot = origin(edge(off) + highLight());
        shot.width = shot.height = 1;
        checkMean({"edge at " + text(off), shot, besideEdge(kHalf, off)}, 4096, 1.5e-3);
    }
}

TEST_CASE("unbiased: a ball in front of a light") {
    const double ballHalf = std::asin(0.2 / 1.9);
    const double apart = 0.6;
    const std::string ball =
        place("gr.nh_sphere('ball', " + text(1.9 * Vec3(0.0, std::sin(apart), std::cos(apart))) +
                  ", 0.2)",
              1.0);
    checkUnbiased({"cap by cap", origin(ball + highLight()),
                   lightWeight(kHalf) * (1.0 - commonCap(kHalf, ballHalf, apart) / capOf(kHalf))});
}

TEST_CASE("unbiased: a light that the horizon cuts, and one around the point") {
    for (const double b : {1.2, 1.5, 1.9}) {
        const Vec3 centre = 10.0 * Vec3(std::sin(b), 0.0, std::cos(b));
        checkUnbiased({"horizon, " + text(b), origin(light(centre, 10.0 * std::sin(0.5))),
                       lightWeight(0.5) * meanCosineOfCutCone(0.5, b)});
        checkUnbiased(
            {"inside, " + text(b), origin(light(0.15 * centre, 4.0)), 0.5 * (1.0 + std::cos(b))});
    }
}

TEST_CASE("unbiased: a sphere light's highlight") {
    // Seen from above, under a light straight above: the mean of cos^p over the cone.
    const double c = std::cos(kHalf);
    for (const double p : {0.0, 1.0, 12.0, 300.0}) {
        Shot shot;
        shot.body =
            "root:add_child(gr.nh_box('floor', {-9, -9, -1}, {18, 18, 1}),\n"
            "               gr.material({0, 0, 0}, {1, 1, 1}, " +
            text(p) + "))\n" + highLight(0.0);
        checkUnbiased(
            {"p = " + text(p), repeated(shot),
             lightWeight(kHalf) * (1.0 - std::pow(c, p + 1.0)) / ((p + 1.0) * (1.0 - c))});
    }
}

TEST_CASE("unbiased: the floor under the cosine") {
    const double expected =
        meanOverCone(kHalf, [](double t, double) { return std::max(std::cos(t), 0.93); });
    checkUnbiased({"brightness", origin(highLight(0.93)), lightWeight(kHalf) * expected});
}

TEST_CASE("unbiased: several lights, in a mirror, and through glass") {
    const std::string two = edge(0.2) + highLight() + light({6, 0, 8}, 2.0);
    // The second light is beyond the edge, which hides all of it.
    checkUnbiased({"two lights", origin(two), besideEdge(kHalf, 0.2)});
    const std::string bare = highLight() + light({6, 0, 8}, 2.0);
    checkUnbiased({"two open lights", origin(bare), lightWeight(kHalf) + 0.8});

    // A mirror behind the camera shows the origin over a way of 30.
    Shot mirrored = origin(
        edge(0.2) + highLight() +
        place("gr.nh_box('mirror', {-9, -21, -9}, {18, 1, 18})", 0.0, "it:set_reflection(0.25)"));
    mirrored.view = {0.0, -30.0, -0.5};
    checkUnbiased({"in a mirror", mirrored, 0.75 * besideEdge(kHalf, 0.2)});

    const std::string pane =
        place("gr.nh_box('pane', {-1, -6, -0.5}, {2, 1, 1.2})", 0.0, "it:set_refraction(1, 0.25)");
    checkUnbiased(
        {"through glass", origin(edge(0.2) + highLight() + pane), 0.75 * besideEdge(kHalf, 0.2)});
}

TEST_CASE("unbiased: light through a pane, and through a ball of glass") {
    const auto through = [](double angle) {
        const double t = 1.0 - reflectanceByAngles(angle, 1.0, 1.5);
        return t * t;
    };
    const std::string pane =
        place("gr.nh_box('pane', {-9, -9, 1}, {18, 18, 0.2})", 0.0, "it:set_refraction(1.5, 0.25)");
    checkUnbiased({"pane", origin(pane + highLight()),
                   lightWeight(kHalf) * 0.75 *
                       meanOverCone(kHalf, [&](double t, double) { return through(t); })});

    // A ball that takes 0.4 of the sine, below the light.
    const std::string ball =
        place("gr.nh_sphere('ball', {0, 0, 1}, 0.4)", 0.0, "it:set_refraction(1.5, 0)");
    const double expected = meanOverCone(kHalf, [&](double t, double) {
        const double aside = std::sin(t) / 0.4;
        return aside < 1.0 ? through(std::asin(aside)) : 1.0;
    });
    checkUnbiased({"ball", origin(ball + highLight()), lightWeight(kHalf) * expected});
}
