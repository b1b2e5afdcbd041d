// The thin lens against its formula: blur circles in pixels at every distance.
#include "optics_shot.h"

#include "rt/output/image_writer.h"

#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 8;
constexpr double kFov = 10.0;
constexpr double kLens = 3.0;
constexpr double kFocus = 10.0;

/// The radius of the blur circle in pixels of a point at distance d (infinity: its limit).
double blurRadius(double d) {
    const double apart = std::isinf(d) ? 1.0 : std::fabs(kFocus - d) / d;
    const double tangent = std::tan(0.5 * kFov * kPi / 180.0);
    return 0.5 * kHeight * kLens * apart / (kFocus * tangent);
}

/// A camera at the origin with the lens above.
Shot throughLens(const std::string& body) {
    Shot shot;
    shot.body = body;
    shot.eye = {0.0, 0.0, 0.0};
    shot.ambient = Color(1.0);
    shot.fov = kFov;
    shot.width = kWidth;
    shot.height = kHeight;
    shot.focal = text(kFocus) + ", 0.5, " + text(kLens);
    return shot;
}

/// A white half-plane at distance d that begins at x = 0, too thin for its side to be seen.
std::string edgeAt(double d) {
    const double size = 40.0 * d;
    return place("gr.nh_box('edge', {0, " + text(-0.5 * size) + ", " + text(-(1.0 + 1e-8) * d) +
                     "}, {" + text(size) + ", " + text(size) + ", " + text(1e-8 * d) + "})",
                 1.0);
}

std::vector<double> columnMeans(const Picture& picture) {
    std::vector<double> means(static_cast<std::size_t>(picture.width), 0.0);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            means[static_cast<std::size_t>(x)] += picture.at(x, y).x / picture.height;
        }
    }
    return means;
}

/// The share of a unit disc that lies beyond a line at distance -s from its centre.
double discBeyond(double s) {
    if (s <= -1.0) return 0.0;
    if (s >= 1.0) return 1.0;
    return 0.5 + (s * std::sqrt(1.0 - s * s) + std::asin(s)) / kPi;
}

/// The edge's picture in column x: the disc's share, averaged over the pixel.
double edgeProfile(int x, double radius) {
    const int steps = 200;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double place = x + (i + 0.5) / steps - 0.5 * kWidth;
        sum += radius > 0.0 ? discBeyond(place / radius) : (place > 0.0 ? 1.0 : 0.0);
    }
    return sum / steps;
}

/// The radius whose profile has this picture's deviation from a sharp edge: for a disc the mean of
/// |x| is 4 r / (3 pi).
double measuredRadius(const std::vector<double>& columns) {
    double deviation = 0.0;
    for (std::size_t x = 0; x < columns.size(); ++x) {
        deviation += std::fabs(columns[x] - (x < columns.size() / 2 ? 0.0 : 1.0));
    }
    return 0.75 * kPi * deviation;
}

}  // namespace

TEST_CASE("an edge's blur has the formula's radius and a disc's profile at every distance") {
    for (const double d : {3.5, 5.0, 7.0, 9.0, 10.0, 12.0, 20.0, 100.0, 1e6, 1e12}) {
        CAPTURE(d);
        const double radius = blurRadius(d);
        REQUIRE(radius < 0.5 * kWidth);
        const std::vector<double> columns = columnMeans(shoot(throughLens(edgeAt(d)), 1024));
        CHECK(std::fabs(measuredRadius(columns) - radius) <= 0.005 * radius);
        for (int x = 0; x < kWidth; ++x) {
            CAPTURE(x);
            const double value = columns[static_cast<std::size_t>(x)];
            // Outside the circle the picture is not touched.
            if (x + 1 <= 0.5 * kWidth - radius) CHECK(value == 0.0);
            if (x >= 0.5 * kWidth + radius) CHECK(value == 1.0);
            CHECK(std::fabs(value - edgeProfile(x, radius)) < 0.005);
        }
    }
}

TEST_CASE("a small bright ball becomes a disc of the formula's radius") {
    for (const double d : {5.0, 20.0, 200.0}) {
        CAPTURE(d);
        const double radius = blurRadius(d);
        const double perPixel = 2.0 * std::tan(0.5 * kFov * kPi / 180.0) / kHeight;
        const double size = 2.0 * d * perPixel;  // two pixels
        Shot shot = throughLens(
            place("gr.nh_sphere('ball', {0, 0, " + text(-d) + "}, " + text(size) + ")", 1.0));
        shot.height = kWidth;
        shot.fov = 2.0 * std::atan(0.5 * kWidth * perPixel) * 180.0 / kPi;
        const Picture picture = shoot(shot, 512);
        double sum = 0.0;
        double second = 0.0;
        double farthest = 0.0;
        for (int y = 0; y < kWidth; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const double value = picture.at(x, y).x;
                const double r = std::hypot(x + 0.5 - 0.5 * kWidth, y + 0.5 - 0.5 * kWidth);
                sum += value;
                second += value * r * r;
                if (value > 0.0) farthest = std::max(farthest, r);
            }
        }
        // A disc's mean square is r^2 / 2; the ball's own disc adds 2, the pixel's square 1/6.
        const double measured = std::sqrt(2.0 * (second / sum - 2.0 - 1.0 / 6));
        CHECK(std::fabs(measured - radius) < 0.02 * radius);
        CHECK(farthest <= radius + 2.1 + std::sqrt(0.5));
        CHECK(farthest >= radius + 1.0);
    }
}

TEST_CASE("the sky is blurred as the limit of far things is") {
    const TemporaryFolder folder;
    // Black left of the middle, which is at -z, and white right of it; the step is a texel wide.
    const int columns = 8192;
    PixelImage sky{columns, 2, {}};
    for (int i = 0; i < 2 * columns; ++i)
        sky.pixels.emplace_back(i % columns < columns / 2 ? 0 : 1);
    writeImage(folder.file("sky.png"), sky, {}, {});
    PictureSettings settings;
    settings.folder = folder.path().string();
    settings.options.spp = 1024;
    const Shot shot = throughLens("gr.background('sky.png')");
    const std::vector<double> measured = columnMeans(renderScript(shot.script(), settings));
    const double radius = blurRadius(kInfinity);
    // The texel's ramp covers 2 pi / 8192 of direction, a twentieth of a pixel.
    CHECK(std::fabs(measuredRadius(measured) - radius) < 0.01 * radius);
    for (int x = 0; x < kWidth; ++x) {
        CHECK(std::fabs(measured[static_cast<std::size_t>(x)] - edgeProfile(x, radius)) < 0.005);
    }
}

TEST_CASE("the focus may be a point: its distance along the view counts") {
    const std::string scene = edgeAt(20.0) + "gr.background({0, 0.1, 0.2}, {1, 0.9, 0.8})\n";
    Shot shot = throughLens(scene);
    shot.view = {0.0, 0.0, -3.0};
    const Picture byDistance = shoot(shot, 16);
    shot.focal = "{7, -4, -10}, 0.5, " + text(kLens);
    CHECK(sameBytes(shoot(shot, 16), byDistance));
    shot.focal = "{7, -4, -11}, 0.5, " + text(kLens);
    CHECK(!sameBytes(shoot(shot, 16), byDistance));
}

TEST_CASE("the focal length is not in the picture") {
    Shot shot = throughLens(edgeAt(20.0));
    const Picture one = shoot(shot, 16);
    shot.focal = text(kFocus) + ", 9.5, " + text(kLens);
    CHECK(sameBytes(shoot(shot, 16), one));
}

TEST_CASE("without an aperture the picture is the pinhole's, ray for ray") {
    Shot shot = throughLens(
        edgeAt(20.0) +
        place("gr.nh_sphere('ball', {-0.5, 0, -12}, 0.3)", 0.5, "it:set_refraction(1.5, 0.2)") +
        "lights[1] = gr.light({3, 4, 0}, {1, 1, 1}, {1, 0, 0}, 0.5)\n");
    shot.focal = "10, 0.5, 0";
    const Picture closed = shoot(shot, 16);
    shot.focal = "";
    const Picture pinhole = shoot(shot, 16);
    CHECK(sameBytes(closed, pinhole));
    CHECK(closed.counts.rays.camera == pinhole.counts.rays.camera);
    CHECK(closed.counts.rays.shadow == pinhole.counts.rays.shadow);
    CHECK(closed.counts.rays.refraction == pinhole.counts.rays.refraction);
    CHECK(pinhole.counts.rays.camera == 16u * kWidth * kHeight);
}

TEST_CASE("what lies in the plane in focus is sharp off the axis too") {
    Shot shot = throughLens(place("gr.nh_box('edge', {1, -50, -10.001}, {50, 100, 0.001})", 1.0));
    shot.fov = 60.0;
    const Picture sharp = shoot(shot, 64);
    // x = 1 at distance 10, in pixels from the middle.
    const double at = 0.5 * kWidth + 0.1 * 0.5 * kHeight / std::tan(30.0 * kPi / 180.0);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (x + 1 <= at) CHECK(sharp.at(x, y).x == 0.0);
            if (x >= at) CHECK(sharp.at(x, y).x == 1.0);
        }
    }
}
