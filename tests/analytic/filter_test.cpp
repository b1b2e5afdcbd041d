// Pixel filters in pictures: an edge's profile is the filter's integral.
#include "optics_shot.h"
#include "unbiased.h"

#include <functional>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

struct Filter {
    std::string name;
    double radius;
    std::function<double(double)> value;  ///< up to a factor
};

const std::vector<Filter>& filters() {
    static const std::vector<Filter> known = {
        {"box", 0.5, [](double) { return 1.0; }},
        {"gaussian", 1.5, [](double x) { return std::exp(-2.0 * x * x) - std::exp(-4.5); }},
        {"mitchell", 2.0,
         [](double x) {
             x = std::fabs(x);
             // Mitchell and Netravali, 1988, B = C = 1/3, their equation 8.
             const double b = 1.0 / 3.0;
             const double c = 1.0 / 3.0;
             if (x < 1.0) {
                 return (12.0 - 9.0 * b - 6.0 * c) * x * x * x +
                        (-18.0 + 12.0 * b + 6.0 * c) * x * x + 6.0 - 2.0 * b;
             }
             return (-b - 6.0 * c) * x * x * x + (6.0 * b + 30.0 * c) * x * x +
                    (-12.0 * b - 48.0 * c) * x + 8.0 * b + 24.0 * c;
         }},
        {"blackman-harris", 1.5,
         [](double x) {
             const double t = 2.0 * kPi * (x + 1.5) / 3.0;
             return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2.0 * t) -
                    0.01168 * std::cos(3.0 * t);
         }},
    };
    return known;
}

double integral(const Filter& filter, double from, double to) {
    const int steps = 4000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += filter.value(from + (i + 0.5) * (to - from) / steps) * (to - from) / steps;
    }
    return sum;
}

/// The filter's weight beyond `from`, of all.
double shareBeyond(const Filter& filter, double from) {
    if (from <= -filter.radius) return 1.0;
    if (from >= filter.radius) return 0.0;
    return integral(filter, from, filter.radius) / integral(filter, -filter.radius, filter.radius);
}

/// 8 pixels across at unit distance, so that one pixel is 1 / 8 wide there.
Shot eightPixels(const std::string& body) {
    Shot shot;
    shot.body = body;
    shot.eye = {0.0, 0.0, 1.0};
    shot.ambient = Color(1.0);
    shot.fov = 2.0 * std::atan(0.5) * 180.0 / kPi;
    shot.width = shot.height = 8;
    return shot;
}

RenderOptions filtered(const Filter& filter) {
    RenderOptions options;
    options.filter = filter.name;
    return options;
}

}  // namespace

TEST_CASE("an edge shows each filter's integral, across and down") {
    for (const Filter& filter : filters()) {
        for (const double at : {0.0, 0.3, 0.5}) {
            CAPTURE(filter.name);
            CAPTURE(at);
            const std::string corner = text(at / 8.0);
            const Picture across =
                shoot(eightPixels(place(
                          "gr.nh_box('edge', {" + corner + ", -9, -1e-8}, {9, 18, 1e-8})", 1.0)),
                      1024, filtered(filter));
            const Picture down =
                shoot(eightPixels(place(
                          "gr.nh_box('edge', {-9, " + corner + ", -1e-8}, {18, 9, 1e-8})", 1.0)),
                      1024, filtered(filter));
            for (int i = 0; i < 8; ++i) {
                CAPTURE(i);
                double meanAcross = 0.0;
                double meanDown = 0.0;
                for (int k = 0; k < 8; ++k) {
                    meanAcross += across.at(i, k).x / 8.0;
                    meanDown += down.at(k, i).x / 8.0;
                }
                const double fromLeft = 4.0 + at - (i + 0.5);
                const double fromTop = (i + 0.5) - (4.0 - at);
                CHECK(std::fabs(meanAcross - shareBeyond(filter, fromLeft)) < 2e-3);
                CHECK(std::fabs(meanDown - shareBeyond(filter, fromTop)) < 2e-3);
            }
        }
    }
}

TEST_CASE("a picture of one colour keeps it under every filter") {
    for (const Filter& filter : filters()) {
        CAPTURE(filter.name);
        const bool signs = filter.name == "mitchell";
        for (const int spp : {16, 64}) {
            const Picture picture =
                shoot(eightPixels("gr.background({0.375, 0.375, 0.375})"), spp, filtered(filter));
            // Of sums of 0.375 no rounding remains; the weights of two signs are rounded.
            for (const Color& pixel : picture.pixels) {
                CHECK(std::fabs(pixel.x - 0.375) <= (signs ? 1e-14 : 0.0));
            }
        }
    }
}

TEST_CASE("unbiased: one pixel across an edge under every filter") {
    for (const Filter& filter : filters()) {
        for (const double at : {-0.35, 0.2, 1.2}) {
            // The pixel is 1 wide at unit distance, its centre at x = 0.
            const std::string corner = text(at);
            Shot shot = eightPixels(
                place("gr.nh_box('edge', {" + corner + ", -9, -1e-8}, {18, 18, 1e-8})", 1.0));
            shot.width = shot.height = 1;
            Estimate e{filter.name + " at " + corner, shot, shareBeyond(filter, at)};
            e.options = filtered(filter);
            checkUnbiased(e);
        }
    }
}
