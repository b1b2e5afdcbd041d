// What a light is and is not, beside its soft shadow.
#include "optics_shot.h"

#include "rt/shading/light_sample.h"

using namespace rt;
using namespace rt::test;

namespace {

std::string light(const Vec3& centre, double radius) {
    return "lights[#lights + 1] = gr.light(" + text(centre) + ", {1, 1, 1}, {1, 0, 0}, " +
           text(radius) + ")\n";
}

}  // namespace

TEST_CASE("lights cannot be seen, neither directly nor in mirrors or through glass") {
    for (const double radius : {0.0, 2.0, 30.0}) {
        CAPTURE(radius);
        Shot shot;
        shot.body = "gr.background({0.25, 0.5, 0.75})\n" + light({0, 0, 0}, radius) +
                    place("gr.nh_sphere('mirror', {-3, 0, 0}, 1)", 0.0, "it:set_reflection(0)") +
                    place("gr.nh_sphere('glass', {3, 0, 0}, 1)", 0.0, "it:set_refraction(1.5, 0)");
        shot.fov = 60.0;
        shot.width = shot.height = 16;
        for (const Color& pixel : shoot(shot, 2).pixels) CHECK(pixel == Color(0.25, 0.5, 0.75));
    }
}

TEST_CASE("a point light gives nothing at its very place, a sphere its hemisphere") {
    Light here;
    here.intensity = Color(1.0);
    here.position = {1.0, 2.0, 3.0};
    here.c2 = 1.0;
    CHECK(!viewOf(here, here.position));
    here.radius = 0.5;
    const auto view = viewOf(here, here.position);
    REQUIRE(view);
    CHECK(view->oneMinusCos == 1.0);
    CHECK(view->weight == 2.0);
    // The falloff's distance is at least the radius.
    CHECK(view->irradiance.x == doctest::Approx(1.0 / 1.25).epsilon(1e-15));
}

TEST_CASE("a light's cone has the sine R / d, and its weight is 2 / (1 + cos A)") {
    for (const double sine : {1e-9, 1e-3, 0.3, 0.9, 0.999999}) {
        CAPTURE(sine);
        Light far;
        far.intensity = Color(1.0);
        far.radius = 8.0 * sine;
        const auto view = viewOf(far, {0.0, 0.0, 8.0});
        REQUIRE(view);
        const double a = std::asin(sine);
        const double half = std::sin(0.5 * a);
        CHECK(view->oneMinusCos == doctest::Approx(2.0 * half * half).epsilon(1e-12));
        CHECK(view->weight == doctest::Approx(2.0 / (1.0 + std::cos(a))).epsilon(1e-12));
        // Its sphere begins at d - R straight ahead, and at the tangent's length along the rim.
        CHECK(view->reach(view->axis) == doctest::Approx(8.0 - far.radius).epsilon(1e-12));
    }
}

TEST_CASE("lights add up, and the order in which they are given does not matter") {
    const std::string floor = place("gr.nh_box('floor', {-9, -9, -1}, {18, 18, 1})", 0.5);
    const auto with = [&](const std::string& lights) {
        Shot shot;
        shot.body = floor + lights;
        return grey(shot);
    };
    const std::string one = light({3, 0, 4}, 0.0);
    const std::string two = light({0, 0, 20}, 0.0);
    CHECK(with(one + two) == doctest::Approx(with(one) + with(two)).epsilon(1e-15));
    CHECK(with(two + one) == doctest::Approx(with(one + two)).epsilon(1e-15));
    CHECK(with("") == 0.0);
}
