// Pixels, lenses and skies agree with their areas in the mean.
#include "closed_forms.h"
#include "unbiased.h"

#include "rt/output/image_writer.h"

using namespace rt;
using namespace rt::test;

namespace {

/// 4 x 4 pixels of ambient white on black.
Shot square(const std::string& body, double fov) {
    Shot shot;
    shot.body = body;
    shot.ambient = Color(1.0);
    shot.fov = fov;
    return repeated(shot);
}

double halfHeight(const Shot& shot) {
    return std::tan(0.5 * shot.fov * kPi / 180.0);
}

/// The mean over the square image of f(u, v), in units of its half height, v upwards; by the
/// midpoint rule.
template <class F>
double imageMean(F f) {
    constexpr int kSteps = 500;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int k = 0; k < kSteps; ++k) {
            sum += f(2.0 * (i + 0.5) / kSteps - 1.0, 2.0 * (k + 0.5) / kSteps - 1.0);
        }
    }
    return sum / (kSteps * kSteps);
}

/// A white half-plane at z = `z`, too thin for its side to be seen; the calls turn it.
std::string halfPlane(double x, double z, const std::string& calls = "") {
    return place(
        "gr.nh_box('half', {" + text(x) + ", -9000, " + text(z - 1e-8) + "}, {9000, 18000, 1e-8})",
        1.0, calls);
}

/// The share of a unit disc that lies beyond x = s.
double discBeyond(double s) {
    return 0.5 - (s * std::sqrt(1.0 - s * s) + std::asin(s)) / kPi;
}

}  // namespace

TEST_CASE("unbiased: a slanted edge, and a ball's outline") {
    // Ten before the camera the image reaches to x = +-1; its rows' mean is the middle row's share.
    const double fov = 2.0 * std::atan(0.1) * 180.0 / kPi;
    Estimate e{"edge", square(halfPlane(0.26, 0.0, "it:rotate('z', 20)"), fov),
               0.5 - 0.5 * 0.26 / std::cos(20.0 * kPi / 180.0)};
    checkUnbiased(e);
    e.options.sampler = "jitter";
    checkUnbiased(e);
    e.options.sampler = "random";
    checkMean(e, 1024, 2e-3);
    // A ball of radius 0.5 at distance 10 is seen under the sine 1 / 20.
    const double outline = std::tan(std::asin(0.05)) / 0.1;
    checkUnbiased({"ball", square(place("gr.nh_sphere('ball', {0, 0, 0}, 0.5)", 1.0), fov),
                   0.25 * kPi * outline * outline});
}

TEST_CASE("unbiased: an edge in a mirror, and one behind a slab of glass") {
    const double fov = 2.0 * std::atan(0.1) * 180.0 / kPi;
    // The mirror at z = 0 shows what is 20 behind the camera's image: at 30, 3 to either side.
    const std::string mirror = place("gr.nh_box('mirror', {-90, -90, -1}, {180, 180, 1})", 0.0,
                                     "it:set_reflection(0.125)");
    checkUnbiased(
        {"mirror", square(mirror + halfPlane(1.2, 20.0), fov), 0.875 * 0.5 * (1.0 - 1.2 / 3.0)});

    // A narrow view, 40 degrees off the normal, through 2 of glass onto an edge 3 below it.
    const double angle = 40.0 * kPi / 180.0;
    const auto landing = [](double a) {
        return 8.0 * std::tan(a) + 2.0 * std::tan(std::asin(std::sin(a) / 1.5));
    };
    Shot shot = square("", 0.01);
    shot.view = {std::sin(angle), 0.0, -std::cos(angle)};
    const double aside = 0.3;  // of the half width, by which the edge is off the middle
    const double at = landing(angle + std::atan(aside * halfHeight(shot)));
    shot.body =
        place("gr.nh_box('slab', {-99, -99, 3}, {198, 198, 2})", 0.0, "it:set_refraction(1.5, 0)") +
        halfPlane(at, 0.0);
    // Rows off the middle look past the plane of the angle, by the square of 1e-4.
    checkUnbiased({"slab", shot, 0.5 * (1.0 - aside)});
}

TEST_CASE("unbiased: Fresnel's reflection over a wide view of water") {
    Shot shot = square("gr.background({1, 1, 1})\n" +
                           place("gr.nh_box('pool', {-9000, -9000, -9}, {18000, 18000, 9})", 0.0,
                                 "it:set_refraction(1.33, 0)\nit:set_fresnel(true)") +
                           place("gr.nh_box('bottom', {-8999, -8999, -8}, {17998, 17998, 7})", 0.0),
                       30.0);
    const double angle = 65.0 * kPi / 180.0;
    shot.view = {0.0, std::sin(angle), -std::cos(angle)};
    shot.up = {0.0, 0.0, 1.0};
    const double t = halfHeight(shot);
    const double expected = imageMean([&](double u, double v) {
        const Vec3 d =
            shot.view + t * u * Vec3(1, 0, 0) + t * v * Vec3(0.0, std::cos(angle), std::sin(angle));
        return reflectanceByAngles(std::acos(-d.z / glm::length(d)), 1.0, 1.33);
    });
    checkUnbiased({"pool", shot, expected});
}

TEST_CASE("unbiased: an edge out of focus, and a soft shadow out of focus") {
    // The lens' disc of radius 0.4 shrinks towards the focus at 20, to a half where the edge is.
    for (const double x : {-0.1, 0.0, 0.15}) {
        Shot shot = square(halfPlane(x, 0.0), 1e-12);
        shot.focal = "20, 0.5, 0.4";
        checkUnbiased({"edge at " + text(x), shot, discBeyond(x / 0.2)});
    }

    // The camera, between the floor and an edge that half hides a light, sees a disc of 0.5.
    Shot shot = square(place("gr.nh_box('floor', {-99, -99, -1}, {198, 198, 1})", 1.0) +
                           place("gr.nh_box('edge', {0, -90, 2}, {90, 180, 1e-8})", 1.0) +
                           "lights[1] = gr.light({0, 0, 5}, {1, 1, 1}, {1, 0, 0}, 1, 1)\n",
                       1e-12);
    shot.ambient = Color(0.0);
    shot.eye = {0.0, 0.0, 1.0};
    shot.focal = "2, 0.5, 1";
    const auto at = [](double x, double y) {
        const Vec3 toLight(-x, -y, 5.0);
        const double distance = glm::length(toLight);
        const double half = std::asin(1.0 / distance);
        const double hidden = std::asin(glm::dot(glm::normalize(Vec3(2.0, 0.0, x)), toLight) /
                                        distance);  // beyond the edge
        if (hidden >= half) return 0.0;
        if (hidden <= -half) return lightWeight(half);
        return lightWeight(half) * commonCap(half, 0.5 * kPi, 0.5 * kPi + hidden) / capOf(half);
    };
    double expected = 0.0;
    constexpr int kRings = 300;
    for (int i = 0; i < kRings; ++i) {
        const double r = 0.5 * std::sqrt((i + 0.5) / kRings);
        for (int k = 0; k < kRings; ++k) {
            const double turn = 2.0 * kPi * (k + 0.5) / kRings;
            expected += at(r * std::cos(turn), r * std::sin(turn)) / (kRings * kRings);
        }
    }
    checkUnbiased({"shadow", shot, expected});
}

TEST_CASE("unbiased: a lens that straddles a glass wall") {
    // Rays from the lens' right half start within the wall, leave it at z = -9 and bend there;
    // those from the left half pass beside it. All would meet at z = -30; the edge lies at z = -20.
    for (const double edge : {-0.1, 0.05}) {
        Shot shot = square(place("gr.nh_box('wall', {0, -50, -9}, {50, 100, 50})", 0.0,
                                 "it:set_refraction(1.5, 0.3)") +
                               halfPlane(edge, -20.0),
                           1e-12);
        shot.eye = {0.0, 0.0, 0.0};
        shot.focal = "30, 0.5, 0.5";
        constexpr int kRings = 800;
        int beyond = 0;
        for (int i = 0; i < kRings; ++i) {
            const double r = 0.5 * std::sqrt((i + 0.5) / kRings);
            const double sine = 1.5 * std::sin(std::atan(r / 30.0));
            const double bent = 21.0 / 30.0 - 11.0 * std::tan(std::asin(sine)) / r;
            for (int k = 0; k < kRings; ++k) {
                const double x = r * std::cos(2.0 * kPi * (k + 0.5) / kRings);
                beyond += x * (x > 0.0 ? bent : 10.0 / 30.0) > edge ? 1 : 0;
            }
        }
        checkUnbiased({"edge at " + text(edge), shot, beyond / (1.0 * kRings * kRings)});
    }
}

TEST_CASE("unbiased: a gradient and a panorama over a wide view") {
    Shot shot = square("gr.background({0, 0, 0}, {1, 1, 1})", 100.0);
    const double tilt = 0.5;
    shot.view = {0.0, std::sin(tilt), -std::cos(tilt)};
    const double t = halfHeight(shot);
    checkUnbiased({"gradient", shot, imageMean([&](double u, double v) {
                       const Vec3 d = shot.view + t * u * Vec3(1, 0, 0) +
                                      t * v * Vec3(0.0, std::cos(tilt), std::sin(tilt));
                       return 0.5 + 0.5 * d.y / glm::length(d);
                   })});

    // Black left of -z, white right of it, over a texel; seen a fifth of the half width aside.
    const TemporaryFolder folder;
    const int columns = 8192;
    PixelImage sky{columns, 2, {}};
    for (int i = 0; i < 2 * columns; ++i) {
        sky.pixels.emplace_back(i % columns < columns / 2 ? 0 : 1);
    }
    writeImage(folder.file("sky.png"), sky, {}, {});
    Estimate e{"panorama", square("gr.background('sky.png')", 60.0), 0.6};
    const double aside = std::atan(0.2 * halfHeight(e.shot));
    e.shot.view = {std::sin(aside), 0.0, -std::cos(aside)};
    e.folder = folder.path().string();
    checkUnbiased(e);
}
