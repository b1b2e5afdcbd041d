// Bent rays against Snell's law, followed by angles rather than by vectors.
#include "optics_shot.h"

#include "rt/shading/fresnel.h"

#include <optional>
#include <utility>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kGradient = "gr.background({0, 0, 0}, {1, 1, 1})\n";

double gradientAt(const Vec3& direction) {
    return 0.5 + 0.5 * direction.y;
}

std::string glassCall(double index, double own = 0.0) {
    return "it:set_refraction(" + text(index) + ", " + text(own) + ")";
}

std::string slab(double bottom, double top, double index, double own = 0.0, double color = 0.0) {
    return place("gr.nh_box('slab', {-500, -500, " + text(bottom) + "}, {1000, 1000, " +
                     text(top - bottom) + "})",
                 color, glassCall(index, own));
}

struct Ray2 {
    Vec3 origin;
    Vec3 direction;
};

/// Through a glass ball of radius 1 about the origin: in the plane of ray and centre, the ray keeps
/// its distance b from the centre and turns by 2 (asin b - asin(b / n)).
std::optional<Ray2> throughBall(const Ray2& in, double index) {
    const Vec3 nearest = in.origin - glm::dot(in.origin, in.direction) * in.direction;
    const double b = glm::length(nearest);
    if (b >= 1.0) return std::nullopt;
    if (b == 0.0) return in;
    const Vec3 aside = nearest / b;
    const double turn = 2.0 * (std::asin(b) - std::asin(b / index));
    const Vec3 out = std::cos(turn) * in.direction - std::sin(turn) * aside;
    const Vec3 outAside = std::cos(turn) * aside + std::sin(turn) * in.direction;
    return Ray2{std::sqrt(1.0 - b * b) * out + b * outAside, out};
}

}  // namespace

TEST_CASE("a thick slab shifts a ray by the formula of its parallel faces") {
    const Vec3 light(-40.0, 0.0, -4.0);
    for (const double index : {1.0, 1.1, 1.33, 1.5, 2.4, 0.8}) {
        for (const double degrees : {0.0, 1e-3, 10.0, 35.0, 50.0, 53.0, 70.0, 85.0}) {
            const double angle = degrees * kPi / 180.0;
            if (std::sin(angle) >= index) continue;
            CAPTURE(index);
            CAPTURE(degrees);
            Shot shot;
            shot.body = slab(-2.0, 0.5, index) + ruler(-5.0, light);
            shot.view = {std::sin(angle), 0.0, -std::cos(angle)};
            const double inside = std::asin(std::sin(angle) / index);
            const double expected = 12.5 * std::tan(angle) + 2.5 * std::tan(inside);
            const double landing = readRuler(grey(shot), -5.0, light) + light.x;
            CHECK(std::fabs(landing - expected) < 1e-9 * (1.0 + expected));
        }
    }
}

TEST_CASE("a glass ball shows the sky where two refractions send the view") {
    for (const double index : {1.01, 1.33, 1.5, 2.4}) {
        for (int i = 1; i < 50; ++i) {
            const double aside = i / 50.0;
            CAPTURE(index);
            CAPTURE(aside);
            Shot shot;
            shot.body = kGradient + place("gr.sphere('ball')", 0.0, glassCall(index));
            const double turn = 2.4 * i;
            shot.eye = {aside * std::cos(turn), aside * std::sin(turn), 3.0};
            const auto out = throughBall({shot.eye, shot.view}, index);
            REQUIRE(out);
            CHECK(std::fabs(grey(shot) - gradientAt(out->direction)) < 1e-10);
        }
    }
}

TEST_CASE("a glass ball's picture of a checkerboard is that of an independent ray trace") {
    const double index = 1.5;
    const int side = 48;
    Shot shot;
    shot.body =
        place("gr.sphere('ball')", 0.0, glassCall(index)) +
        "gr.background({0.5, 0.5, 0.5})\n"
        "white = gr.material({1, 1, 1}, {0, 0, 0}, 0)\nblack = gr.material({0, 0, 0}, {0, 0, 0}, "
        "0)\n"
        "for i = -12, 11 do for j = -12, 11 do\n"
        "  root:add_child(gr.nh_box('square', {i / 4, j / 4, -5}, {0.25, 0.25, 1}),\n"
        "                 (i + j) % 2 == 0 and white or black)\nend end\n";
    shot.eye = {0.31, 0.17, 6.0};
    shot.fov = 22.0;
    shot.width = shot.height = side;
    shot.ambient = Color(1.0);
    RenderOptions options;
    options.sampler = "grid";
    const Picture picture = shoot(shot, 1, options);

    const double perPixel = 2.0 * std::tan(11.0 * kPi / 180.0) / side;
    int throughGlass = 0;
    int squares = 0;
    int wrong = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Vec3 d = glm::normalize(
                Vec3((x + 0.5 - side / 2) * perPixel, -(y + 0.5 - side / 2) * perPixel, -1.0));
            const auto bent = throughBall({shot.eye, d}, index);
            throughGlass += bent ? 1 : 0;
            const Ray2 ray = bent.value_or(Ray2{shot.eye, d});
            const Vec3 at = ray.origin + ((-4.0 - ray.origin.z) / ray.direction.z) * ray.direction;
            double expected = 0.5;
            if (ray.direction.z < 0.0 && std::fabs(at.x) < 3.0 && std::fabs(at.y) < 3.0) {
                const double sum = std::floor(4.0 * at.x) + std::floor(4.0 * at.y);
                expected = std::fmod(std::fabs(sum), 2.0) == 0.0 ? 1.0 : 0.0;
                ++squares;
            } else if (ray.direction.z < 0.0 && at.z < 0.0 && std::fabs(ray.direction.z) < 0.95) {
                continue;  // may meet the board's rim
            }
            if (std::fabs(picture.at(x, y).x - expected) > 1e-12) ++wrong;
        }
    }
    CHECK(throughGlass > side * side / 3);
    CHECK(squares > side * side / 2);
    CHECK(wrong == 0);
}

TEST_CASE("a camera inside a glass ball looks out of it, and its own colour does not weigh in") {
    const double index = 1.5;
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        Shot shot;
        shot.body = kGradient + place("gr.sphere('ball')", 1.0, glassCall(index, 0.5));
        shot.ambient = Color(1.0);
        shot.eye = {0.3 * std::cos(i), 0.5 * std::sin(2.0 * i), 0.1};
        shot.view = glm::normalize(Vec3(std::sin(3.0 * i), 0.7 * std::cos(5.0 * i), -0.5));
        const Vec3& d = shot.view;
        const double along = glm::dot(shot.eye, d);
        const double b2 = glm::dot(shot.eye, shot.eye) - along * along;
        const double sineOut = index * std::sqrt(b2);
        if (sineOut >= 1.0) {
            // Reflected for ever, down to the depth limit.
            CHECK(grey(shot) == doctest::Approx(1.0).epsilon(1e-12));
            continue;
        }
        const Vec3 n = shot.eye + (std::sqrt(1.0 - b2) - along) * d;
        const Vec3 aside = (d - glm::dot(d, n) * n) / std::sqrt(b2);
        const Vec3 out = std::sqrt(1.0 - sineOut * sineOut) * n + sineOut * aside;
        CHECK(std::fabs(grey(shot) - gradientAt(out)) < 1e-10);
    }
}

TEST_CASE("total internal reflection sets in at asin(1 / n) to 1e-11") {
    for (const double index : {1.05, 1.33, 1.5, 2.4}) {
        CAPTURE(index);
        // Within a vast glass over a black floor, looking up: the sky, or the mirrored floor.
        const auto seesSky = [&](double angle) {
            Shot shot;
            shot.body = "gr.background({1, 1, 1})\n" + slab(-10.0, 0.0, index) +
                        place("gr.nh_box('floor', {-400, -400, -9}, {800, 800, 1})", 0.0);
            shot.eye = {-200.0, 0.0, -4.0};
            shot.view = {std::sin(angle), 0.0, std::cos(angle)};
            return grey(shot) > 0.5;
        };
        double sky = 0.2;
        double floor = 1.5;
        REQUIRE(seesSky(sky));
        REQUIRE(!seesSky(floor));
        while (floor - sky > 1e-12) {
            const double middle = 0.5 * (sky + floor);
            (seesSky(middle) ? sky : floor) = middle;
        }
        CHECK(std::fabs(sky - std::asin(1.0 / index)) < 1e-11);
    }
}

TEST_CASE("own colour weighs f where a ray enters, and not where it leaves") {
    for (const double own : {0.0, 0.25, 1.0}) {
        CAPTURE(own);
        Shot shot;
        shot.body = "gr.background({0.25, 0.25, 0.25})\n" + slab(-2.0, 0.0, 1.5, own, 0.75);
        shot.ambient = Color(1.0);
        CHECK(grey(shot) == doctest::Approx(own * 0.75 + (1.0 - own) * 0.25).epsilon(1e-14));
    }
}

TEST_CASE("glass that also mirrors mixes the mirror image in after what shines through") {
    // The ray that shines through meets 0.2 below, the mirrored one the sky.
    Shot shot;
    shot.body = "gr.background({0.9, 0.9, 0.9})\n" +
                place("gr.nh_box('floor', {-50, -50, -9}, {100, 100, 1})", 0.2) +
                place("gr.nh_box('slab', {-50, -50, -2}, {100, 100, 2})", 0.6,
                      glassCall(1.5, 0.25) + "\nit:set_reflection(0.375)");
    shot.ambient = Color(1.0);
    const double through = 0.25 * 0.6 + 0.75 * 0.2;
    CHECK(grey(shot) == doctest::Approx(0.375 * through + 0.625 * 0.9).epsilon(1e-14));
}

TEST_CASE("glass of index 1 and no colour of its own cannot be seen") {
    Shot shot;
    shot.body = kGradient + place("gr.nh_sphere('red', {0.4, 0.2, -3}, 1)", 0.7) +
                place("gr.nh_box('floor', {-9, -3, -9}, {18, 1, 18})", 0.3) +
                "lights[1] = gr.light({3, 4, 5}, {0.5, 0.5, 0.5}, {1, 0, 0})\n";
    shot.ambient = Color(0.5);
    shot.fov = 50.0;
    shot.width = shot.height = 24;
    const Picture without = shoot(shot, 4);
    shot.body += place("gr.nh_sphere('clear', {0, 0, 3}, 2)", 1.0, glassCall(1.0)) +
                 place("gr.nh_box('clear', {-1, -1, -1}, 2)", 1.0,
                       glassCall(1.0) + "\nit:set_fresnel(true)");
    const Picture with = shoot(shot, 4);
    double largest = 0.0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        largest = std::max(largest, std::fabs(with.pixels[i].x - without.pixels[i].x));
    }
    CHECK(largest < 1e-12);
}

TEST_CASE("over all angles there is one jump from the sky to total reflection") {
    for (const double index : {1.05, 1.33, 1.5, 2.4}) {
        CAPTURE(index);
        int jumps = 0;
        bool sky = true;
        for (double degrees = 0.0; degrees < 89.5; degrees += 0.05) {
            const double angle = degrees * kPi / 180.0;
            Shot shot;
            shot.body = "gr.background({1, 1, 1})\n" +
                        place("gr.nh_box('sea', {-9000, -9000, -10}, {18000, 18000, 10})", 0.0,
                              glassCall(index)) +
                        place("gr.nh_box('floor', {-8000, -8000, -9}, {16000, 16000, 1})", 0.0);
            shot.eye = {0.0, 0.0, -4.0};
            shot.view = {std::sin(angle), 0.0, std::cos(angle)};
            const bool seen = grey(shot) > 0.5;
            if (seen == sky) continue;
            ++jumps;
            sky = seen;
            CHECK(std::fabs(angle - std::asin(1.0 / index)) < 0.05 * kPi / 180.0);
        }
        CHECK(jumps == 1);
        CHECK(!sky);
    }
}
