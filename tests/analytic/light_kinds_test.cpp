// Spots, suns and rectangles against their equations, and against the lights that they become.
#include "closed_forms.h"
#include "floor_shot.h"
#include "kept_error.h"
#include "unbiased.h"

#include "rt/shading/light_sample.h"

#include <algorithm>
#include <functional>
#include <tuple>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kFloor = place("gr.nh_box('floor', {-500, -500, -1}, {1000, 1000, 1})", 1.0);

std::string add(const std::string& light) {
    return "lights[#lights + 1] = " + light + "\n";
}

std::string spot(const Vec3& at, const Vec3& direction, double inner, double outer,
                 const std::string& more = "") {
    return add("gr.spot_light{position = " + text(at) + ", direction = " + text(direction) +
               ", colour = {1, 1, 1}, inner = " + text(inner) + ", outer = " + text(outer) + more +
               "}");
}

std::string sun(const Vec3& direction, double angle, const std::string& more = "") {
    return add("gr.sun_light{direction = " + text(direction) +
               ", colour = {1, 1, 1}, angle = " + text(angle) + more + "}");
}

/// A point of the floor, seen from the side.
Shot at(double x, const std::string& body) {
    Shot shot;
    shot.body = body + kFloor;
    shot.eye = {x, -10.0, 0.5};
    shot.view = {0.0, 10.0, -0.5};
    return shot;
}

double value(const std::string& body, double x = 0.0) {
    return grey(at(x, body));
}

/// Hides what lies more than `off` beyond the vertical, on the side of +x.
std::string edge(double off) {
    return place("gr.nh_box('edge', {" + text(2.0 * std::tan(off)) + ", -90, 2}, {90, 180, 1e-8})",
                 1.0);
}

/// The mean of f over the unit square, by Gauss' rule of two points in each of n by n cells.
double meanOverSquare(int n, const std::function<double(double, double)>& f) {
    const double off = 0.5 / std::sqrt(3.0);
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int corner = 0; corner < 4; ++corner) {
                sum += f((i + 0.5 + (corner & 1 ? off : -off)) / n,
                         (j + 0.5 + (corner & 2 ? off : -off)) / n);
            }
        }
    }
    return sum / (4.0 * n * n);
}

/// Adaptive pictures of a ball and a post on a floor are as near to the truth as they say.
void checkHonest(const std::string& lights) {
    const Shot shot =
        floorShot(lights + kFloor + place("gr.nh_sphere('ball', {-1, 0, 0.7}, 0.7)", 0.7) +
                      place("gr.nh_box('post', {0.8, 0, 0}, {0.1, 0.1, 1.5})", 0.9),
                  64);
    checkErrorIsKept(shot, 1024, {0.01, 0.003});
}

}  // namespace

TEST_CASE("a spot's light is that of its point times the smooth step of its cosine") {
    const double inner = 20.0;
    const double outer = 35.0;
    const Vec3 direction(-1.0, 0.0, -4.0);
    const std::string light = spot({0, 0, 4}, 0.01 * direction, inner, outer);
    const auto cosine = [](double degrees) { return std::cos(degrees * kPi / 180.0); };
    int lit = 0, dark = 0;
    for (double x = -5.0; x <= 5.0; x += 0.173) {
        CAPTURE(x);
        const Vec3 way(x, 0.0, -4.0);
        const double c = glm::dot(glm::normalize(way), glm::normalize(direction));
        const double s =
            std::clamp((c - cosine(outer)) / (cosine(inner) - cosine(outer)), 0.0, 1.0);
        const double expected = s * s * (3.0 - 2.0 * s) * 4.0 / glm::length(way);
        CHECK(std::fabs(value(light, x) - expected) < 1e-12);
        lit += s == 1.0;
        dark += s == 0.0;
    }
    CHECK(lit > 5);
    CHECK(dark > 5);
}

TEST_CASE("a spot without a fade has a sharp edge; one of all directions is a light") {
    const std::string sharp = spot({0, 0, 4}, {0, 0, -1}, 30.0, 30.0);
    const double rim = 4.0 * std::tan(kPi / 6.0);
    CHECK(value(sharp, rim - 1e-9) == doctest::Approx(std::cos(kPi / 6.0)));
    CHECK(value(sharp, rim + 1e-9) == 0.0);
    for (const std::string radius : {"0", "1.5"}) {
        Shot all = at(0.7, spot({1, 2, 4}, {0, 1, 0}, 180.0, 180.0,
                                ", radius = " + radius + ", falloff = {0, 0.5, 0.1}"));
        Shot ball = at(0.7, add("gr.light({1, 2, 4}, {1, 1, 1}, {0, 0.5, 0.1}, " + radius + ")"));
        CHECK(sameBytes(shoot(all, 16), shoot(ball, 16)));
    }
}

TEST_CASE("a ball's place in a spot: in the full light or none only if all of it is") {
    Light ball;
    ball.position = {0.0, 0.0, 4.0};
    const Light narrow = spotLight(ball, {0.0, 0.0, -1.0}, 29.0, 30.0);
    const Light wide = spotLight(ball, {0.0, 0.0, -1.0}, 5.0, 60.0);
    int seen[4] = {};
    for (double x = 0.0; x < 9.0; x += 0.01) {
        const Vec3 p(x, 0.0, 0.0);
        const double angle = std::atan2(x, 4.0) * 180.0 / kPi;
        const double blur = std::asin(0.05 / std::hypot(x, 4.0)) * 180.0 / kPi;
        for (const auto& [spot, inner, outer] :
             {std::tuple(&narrow, 29.0, 30.0), std::tuple(&wide, 5.0, 60.0)}) {
            const SpotPlace place = placeInSpot(*spot, p, 0.05);
            ++seen[static_cast<int>(place)];
            if (angle + blur > inner) CHECK(place != SpotPlace::kLit);
            if (angle - blur < outer) CHECK(place != SpotPlace::kDark);
            const double doubt = 1e-4;
            if (angle + blur + doubt < inner) CHECK(place == SpotPlace::kLit);
            if (angle - blur - doubt > outer) CHECK(place == SpotPlace::kDark);
            if (place == SpotPlace::kFading) CHECK(spot == &wide);
            if (place == SpotPlace::kEdge) CHECK(spot == &narrow);
        }
    }
    for (const int count : seen) CHECK(count > 5);
    CHECK(placeInSpot(narrow, ball.position, 0.1) == SpotPlace::kEdge);
}

TEST_CASE("a sun gives its colour times the cosine, near and far, and its shadow is parallel") {
    for (double degrees = 0.0; degrees < 89.0; degrees += 8.1) {
        const double angle = degrees * kPi / 180.0;
        const std::string light = sun({-std::sin(angle), 0.0, -std::cos(angle)}, 0.0);
        CHECK(value(light, 0.0) == doctest::Approx(std::cos(angle)).epsilon(1e-12));
        CHECK(value(light, 400.0) == doctest::Approx(std::cos(angle)).epsilon(1e-12));
        const double shift = 7.0 * std::tan(angle);
        const std::string plate =
            place("gr.nh_box('plate', {" + text(-1.0 + shift) + ", -20, 7}, {2, 40, 1e-9})", 1.0);
        CHECK(value(light + plate, -0.999) == 0.0);
        CHECK(value(light + plate, 0.999) == 0.0);
        CHECK(value(light + plate, -1.001) > 0.0);
        CHECK(value(light + plate, 1.001) > 0.0);
    }
    CHECK(value(sun({0, 0, 1}, 0.0)) == 0.0);
    CHECK(value(sun({0, 0, -1}, 0.0) + edge(-0.2)) == 0.0);
}

TEST_CASE("a sun shines through coloured glass") {
    const double angle = 0.6;
    const double face = 1.0 - reflectanceByAngles(angle, 1.0, 1.5);
    const std::string pane = place("gr.nh_box('pane', {-90, -90, 3}, {180, 180, 0.5})", 0.0,
                                   "it:set_refraction(1.5, 0)\nit:set_absorption{0.7, 0.7, 0.7}");
    const std::string light = sun({std::sin(angle), 0.0, -std::cos(angle)}, 0.0);
    CHECK(value(light + pane) ==
          doctest::Approx(std::cos(angle) * face * face * std::exp(-0.7 * 0.5 / std::cos(angle)))
              .epsilon(1e-10));
}

TEST_CASE("unbiased: a sun's disc, open, behind an edge, and cut by the horizon") {
    const double half = 0.3;
    const double degrees = half * 180.0 / kPi;
    checkUnbiased({"open", repeated(at(0.0, sun({-0.6, 0, -0.8}, degrees))), 0.8});
    for (const double off : {-0.1, 0.0, 0.2}) {
        checkUnbiased(
            {"edge at " + text(off),
             repeated(at(0.0, edge(off) + sun({0, 0, -1}, degrees, ", brightness = 1"))),
             lightWeight(half) * commonCap(half, 0.5 * kPi, 0.5 * kPi - off) / capOf(half)});
    }
    const double b = 1.5;
    checkUnbiased({"horizon", repeated(at(0.0, sun({-std::sin(b), 0.0, -std::cos(b)}, degrees))),
                   lightWeight(half) * meanCosineOfCutCone(half, b)});
}

TEST_CASE("unbiased: a rectangle's light is the mean of its points'") {
    const Vec3 corner(-1.0, -0.5, 2.0);
    const Vec3 u(2.0, 0.0, 0.5);
    const Vec3 v(0.3, 1.0, 0.0);
    const std::string light =
        add("gr.rectangle_light{corner = " + text(corner) + ", u = " + text(u) +
            ", v = " + text(v) + ", colour = {1, 1, 1}, falloff = {0.1, 0.2, 0.3}}");
    const auto mean = [&](double x, double hiddenFrom) {
        return meanOverSquare(400, [&](double a, double b) {
            const Vec3 way = corner + a * u + b * v - Vec3(x, 0.0, 0.0);
            const double d = glm::length(way);
            // Where the way is 2 high.
            const bool hidden = x + way.x * 2.0 / way.z > hiddenFrom;
            return hidden ? 0.0 : way.z / d / (0.1 + d * (0.2 + 0.3 * d));
        });
    };
    checkUnbiased({"below", repeated(at(0.0, light)), mean(0.0, 99.0)});
    checkUnbiased({"aside", repeated(at(3.0, light)), mean(3.0, 99.0)});
    const std::string low = place("gr.nh_box('edge', {0.4, -90, 1.99999}, {90, 180, 1e-5})", 1.0);
    checkUnbiased({"edge", repeated(at(0.0, light + low)), mean(0.0, 0.4)}, 1024, 2e-3);
    // One that is next to nothing is a point.
    const std::string tiny =
        add("gr.rectangle_light{corner = {1, 2, 4}, u = {1e-9, 0, 0}, v = {0, 1e-9, 0}, "
            "colour = {1, 1, 1}, falloff = {0, 0.5, 0.1}}");
    CHECK(
        value(tiny) ==
        doctest::Approx(value(add("gr.light({1, 2, 4}, {1, 1, 1}, {0, 0.5, 0.1})"))).epsilon(1e-8));
}

TEST_CASE("adaptive renders under each kind of light keep their error") {
    checkHonest(spot({-3, -3, 4}, {3, 3, -4}, 8.0, 22.0) +
                spot({3, -3, 4}, {-2, 3, -4}, 18.0, 18.0, ", radius = 0.3"));
    checkHonest(spot({2, -1, 5}, {-2, 1, -5}, 12.0, 12.2));
    checkHonest(sun({1, 1, -1}, 4.0) + sun({-1, 0, -1}, 0.0));
    checkHonest(
        add("gr.rectangle_light{corner = {-2, -2, 3}, u = {2, 0, 0}, v = {0, 1, 1}, "
            "colour = {6, 6, 6}, falloff = {0, 0, 1}}"));
}
