// The share that glass mirrors, against Fresnel's laws in angles.
#include "closed_forms.h"
#include "optics_shot.h"

#include "rt/shading/fresnel.h"

using namespace rt;
using namespace rt::test;

namespace {

/// A vast glass over the black: what is not mirrored at its top is lost.
std::string pool(double index) {
    return "gr.background({1, 1, 1})\n" +
           place("gr.nh_box('pool', {-9000, -9000, -10}, {18000, 18000, 10})", 0.0,
                 "it:set_refraction(" + text(index) + ", 0)\nit:set_fresnel(true)") +
           place("gr.nh_box('floor', {-8999, -8999, -9}, {17998, 17998, 8})", 0.0);
}

Shot at(double angle, double height, double up, const std::string& body) {
    Shot shot;
    shot.body = body;
    shot.eye = {0.0, 0.0, height};
    shot.view = {std::sin(angle), 0.0, up * std::cos(angle)};
    return shot;
}

}  // namespace

TEST_CASE("reflectance follows Fresnel's laws at every angle, both ways") {
    for (const double index : {1.0001, 1.33, 1.5, 2.4, 10.0}) {
        for (int i = 0; i < 900; ++i) {
            const double angle = 0.1 * i * kPi / 180.0;
            CAPTURE(index);
            CAPTURE(angle);
            const double in = reflectanceByAngles(angle, 1.0, index);
            const double out = reflectanceByAngles(angle, index, 1.0);
            // Near the critical angle F rises with an infinite slope.
            const bool steep = std::fabs(index * std::sin(angle) - 1.0) < 1e-6;
            CHECK(std::fabs(fresnelReflectance(std::cos(angle), 1.0, index) - in) < 1e-12);
            if (!steep) {
                CHECK(std::fabs(fresnelReflectance(std::cos(angle), index, 1.0) - out) < 1e-9);
            }
            CHECK(std::fabs(fresnelFromThinSide(std::cos(angle), index, 1.0) - in) < 1e-12);
        }
    }
}

TEST_CASE("water seen from above mirrors the sky by Fresnel's laws") {
    for (const double index : {1.33, 1.5, 2.4, 0.7}) {
        const std::string body = pool(index);
        for (int degrees = 0; degrees < 90; ++degrees) {
            const double angle = degrees * kPi / 180.0;
            CAPTURE(index);
            CAPTURE(degrees);
            const double expected = reflectanceByAngles(angle, 1.0, index);
            CHECK(std::fabs(grey(at(angle, 10.0, -1.0, body)) - expected) < 1e-10);
        }
    }
}

TEST_CASE("the sky seen from under water is dimmed by Fresnel's laws, to the critical angle") {
    for (const double index : {1.33, 1.5, 2.4}) {
        const std::string body = pool(index);
        for (int degrees = 0; degrees < 90; ++degrees) {
            const double angle = degrees * kPi / 180.0;
            CAPTURE(index);
            CAPTURE(degrees);
            const double expected = 1.0 - reflectanceByAngles(angle, index, 1.0);
            CHECK(std::fabs(grey(at(angle, -0.5, 1.0, body)) - expected) < 1e-10);
        }
    }
}

TEST_CASE("a pane's reflections between its faces sum up to 2 F / (1 + F)") {
    // All orders of reflection leave upwards into a white sky, or downwards into black.
    for (const double index : {1.33, 1.5, 2.4}) {
        for (int degrees = 0; degrees < 88; degrees += 8) {
            const double angle = degrees * kPi / 180.0;
            CAPTURE(index);
            CAPTURE(degrees);
            Shot shot =
                at(angle, 10.0, -1.0,
                   "gr.background({1, 1, 1})\n" +
                       place("gr.nh_box('pane', {-4000, -4000, -0.1}, {8000, 8000, 0.1})", 0.0,
                             "it:set_refraction(" + text(index) + ", 0)\nit:set_fresnel(true)") +
                       place("gr.nh_box('floor', {-4000, -4000, -3}, {8000, 8000, 1})", 0.0));
            RenderOptions options;
            options.reference = true;
            options.maxDepth = 60;
            const double f = reflectanceByAngles(angle, 1.0, index);
            const double value = shoot(shot, 1, options).at(0, 0).x;
            CHECK(std::fabs(value - 2.0 * f / (1.0 + f)) < 1e-10);
        }
    }
}

TEST_CASE("a sheet mirrors F of its index and lets the rest straight through") {
    for (int degrees = 0; degrees < 90; degrees += 5) {
        const double angle = degrees * kPi / 180.0;
        CAPTURE(degrees);
        const Shot shot = at(
            angle, 10.0, -1.0,
            "gr.background({1, 1, 1})\n" +
                place("gr.mesh('sheet', {{-999,-999,0}, {999,-999,0}, {999,999,0}, {-999,999,0}}, "
                      "{{0,1,2,3}})",
                      0.0, "it:set_refraction(1.5, 0)\nit:set_fresnel(true)") +
                place("gr.nh_box('floor', {-8000, -8000, -3}, {16000, 16000, 1})", 0.0));
        CHECK(std::fabs(grey(shot) - reflectanceByAngles(angle, 1.0, 1.5)) < 1e-10);
    }
}

TEST_CASE("own colour, mirrored and refracted light add up to one at each entry") {
    // Everything is white: whatever the split, so is the picture.
    for (const double own : {0.0, 0.3, 1.0}) {
        Shot shot;
        shot.body = "gr.background({1, 1, 1})\n" +
                    place("gr.sphere('ball')", 1.0,
                          "it:set_refraction(1.5, " + text(own) +
                              ")\nit:set_reflection(0.7)\nit:set_fresnel(true)");
        shot.ambient = Color(1.0);
        shot.fov = 14.0;
        shot.width = shot.height = 16;
        const Picture picture = shoot(shot, 4);
        for (const Color& pixel : picture.pixels) CHECK(std::fabs(pixel.x - 1.0) < 1e-13);
    }
}
