// Caustics against what is known: light that nothing bends, mirrors that are windows, foci, flux,
// and a brute-force path tracer that shares no code with the renderer.
#include "kept_error.h"
#include "optics_shot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rt::test {
namespace {

const std::string kOn = "gr.options{caustics = true}\n";

/// A matt floor z = 0, seen from aside so that nothing above stands in the way.
std::string floorOf(double grey) {
    return place("gr.nh_box('floor', {-50, -50, -1}, {100, 100, 1})", grey);
}

std::string light(const Vec3& at, double intensity, const std::string& falloff, double radius) {
    return "lights[#lights + 1] = gr.light(" + text(at) + ", {" + text(intensity) + ", " +
           text(intensity) + ", " + text(intensity) + "}, " + falloff + ", " + text(radius) + ")\n";
}

/// Looks at a piece of the floor about (x, y) of about `width` across y, from far away on the side
/// of `side` x: what stands in the way at height z stands over the floor of x - `side` z.
Shot floorShot(const std::string& body, double x, double y, double width, int pixels,
               double side = -1.0) {
    Shot shot;
    shot.body = body;
    shot.eye = {x + 60.0 * side, y, 60.0};
    shot.view = {-side, 0.0, -1.0};
    shot.up = {0.0, 0.0, 1.0};
    shot.fov = 2.0 * std::atan(0.5 * width / std::sqrt(7200.0)) * 180.0 / kPi;
    shot.width = pixels;
    shot.height = pixels;
    return shot;
}

Picture adaptive(const Shot& shot, double error, int threads = 1) {
    PictureSettings settings;
    settings.options.error = error;
    settings.threads = threads;
    return renderScript(shot.script(), settings);
}

Picture plain(const Shot& shot, int spp) {
    PictureSettings settings;
    settings.options.spp = spp;
    return renderScript(shot.script(), settings);
}

/// The floor's point that a direction from the eye meets.
Vec3 onFloor(const Vec3& eye, const Vec3& direction) {
    return eye - (eye.z / direction.z) * direction;
}

/// The floor's points that the pixels' centres show.
Vec3 floorAt(const Shot& shot, double x, double y) {
    const Vec3 forward = glm::normalize(shot.view);
    const Vec3 right = glm::normalize(glm::cross(forward, shot.up));
    const Vec3 down = -glm::cross(right, forward);
    const double pixel = 2.0 * std::tan(0.5 * shot.fov * kPi / 180.0) / shot.height;
    return onFloor(shot.eye, forward + (x - 0.5 * shot.width) * pixel * right +
                                 (y - 0.5 * shot.height) * pixel * down);
}

// The oracle: Kajiya's equation at points of the floor, solved by sending rays towards the one
// object that bends light and following them to the light.

struct Straight {
    Vec3 from;
    Vec3 way;  // unit
};

/// The first crossing with a ball beyond `after`.
std::optional<double> crossing(const Straight& ray, const Vec3& centre, double radius,
                               double after) {
    const Vec3 off = ray.from - centre;
    const double b = glm::dot(off, ray.way);
    const double root = b * b - glm::dot(off, off) + radius * radius;
    if (root < 0.0) return std::nullopt;
    for (const double t : {-b - std::sqrt(root), -b + std::sqrt(root)}) {
        if (t > after) return t;
    }
    return std::nullopt;
}

struct OracleScene {
    Vec3 ball;
    double ballRadius;
    double index;  ///< 0: a mirror
    Vec3 lamp;
    double lampRadius;
    double intensity;
    std::array<double, 3> falloff;
};

std::uint64_t next(std::uint64_t& state) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

double uniform(std::uint64_t& state) {
    return static_cast<double>(next(state) >> 11) * 0x1p-53;
}

Vec3 bent(const Vec3& d, const Vec3& n, double ratio) {
    const double c = -glm::dot(d, n);
    const double squared = 1.0 - ratio * ratio * (1.0 - c * c);
    return ratio * d + (ratio * c - std::sqrt(std::max(squared, 0.0))) * n;
}

/// The light's radiance where the ray leaves the ball again towards it, or nothing. `way` is how
/// far it has come.
double radianceAlong(const OracleScene& scene, Straight ray) {
    constexpr double kAside = 1e-9;
    const std::optional<double> first = crossing(ray, scene.ball, scene.ballRadius, kAside);
    if (!first) return 0.0;
    double way = *first;
    Vec3 p = ray.from + *first * ray.way;
    Vec3 n = (p - scene.ball) / scene.ballRadius;
    if (scene.index == 0.0) {
        ray = {p, ray.way - 2.0 * glm::dot(ray.way, n) * n};
    } else {
        const Straight inside{p, bent(ray.way, n, 1.0 / scene.index)};
        const double across = *crossing(inside, scene.ball, scene.ballRadius, kAside);
        way += across;
        p = inside.from + across * inside.way;
        n = (p - scene.ball) / scene.ballRadius;
        ray = {p, bent(inside.way, -n, scene.index)};
    }
    const std::optional<double> last = crossing(ray, scene.lamp, scene.lampRadius, kAside);
    if (!last) return 0.0;
    way += *last;
    // The distance from the lamp's centre of the point at the end of the way, made straight.
    const Vec3 onLamp = ray.from + *last * ray.way;
    const double d = glm::length(onLamp - way * ray.way - scene.lamp);
    const double irradiance =
        scene.intensity / (scene.falloff[0] + scene.falloff[1] * d + scene.falloff[2] * d * d);
    return irradiance * d * d / (kPi * scene.lampRadius * scene.lampRadius);
}

/// The irradiance of a floor point by way of the ball: directions uniform in the ball's cone.
double irradianceAt(const OracleScene& scene, const Vec3& p, int samples, std::uint64_t& state) {
    const Vec3 axis = glm::normalize(scene.ball - p);
    const double sine = scene.ballRadius / glm::length(scene.ball - p);
    const double least = std::sqrt(1.0 - sine * sine);
    const Vec3 side = glm::normalize(glm::cross(axis, Vec3(0.3, 0.5, 0.81)));
    const Vec3 other = glm::cross(axis, side);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double c = 1.0 - uniform(state) * (1.0 - least);
        const double s = std::sqrt(1.0 - c * c);
        const double turn = 2.0 * kPi * uniform(state);
        const Vec3 w = c * axis + s * (std::cos(turn) * side + std::sin(turn) * other);
        if (w.z > 0.0) sum += w.z * radianceAlong(scene, {p, w});
    }
    return 2.0 * kPi * (1.0 - least) * sum / samples;
}

std::string scriptOf(const OracleScene& scene) {
    const std::string falloff = "{" + text(scene.falloff[0]) + ", " + text(scene.falloff[1]) +
                                ", " + text(scene.falloff[2]) + "}";
    return kOn + floorOf(0.5) +
           place("gr.nh_sphere('ball', " + text(scene.ball) + ", " + text(scene.ballRadius) + ")",
                 0.0,
                 scene.index == 0.0 ? "it:set_reflection(0)"
                                    : "it:set_refraction(" + text(scene.index) + ", 0)") +
           light(scene.lamp, scene.intensity, falloff, scene.lampRadius);
}

/// Of the lamp as the floor sees it past the ball: the mean of what is not behind the ball, by
/// directions in the lamp's cone.
double straightAt(const OracleScene& scene, const Vec3& p, int samples, std::uint64_t& state) {
    const double d = glm::length(scene.lamp - p);
    const Vec3 axis = (scene.lamp - p) / d;
    const double sine = scene.lampRadius / d;
    const double least = std::sqrt(1.0 - sine * sine);
    const Vec3 side = glm::normalize(glm::cross(axis, Vec3(0.3, 0.5, 0.81)));
    const Vec3 other = glm::cross(axis, side);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double c = 1.0 - uniform(state) * (1.0 - least);
        const double s = std::sqrt(1.0 - c * c);
        const double turn = 2.0 * kPi * uniform(state);
        const Vec3 w = c * axis + s * (std::cos(turn) * side + std::sin(turn) * other);
        if (!crossing({p, w}, scene.ball, scene.ballRadius, 0.0)) sum += w.z;
    }
    const double irradiance =
        scene.intensity / (scene.falloff[0] + scene.falloff[1] * d + scene.falloff[2] * d * d);
    return irradiance * 2.0 / (1.0 + least) * sum / samples;
}

void checkAgainstOracle(const OracleScene& scene, double x, double width, double side,
                        double error) {
    constexpr int kPixels = 24;
    const Shot shot = floorShot(scriptOf(scene), x, 0.0, width, kPixels, side);
    const Picture found = adaptive(shot, error);
    CHECK(found.converged);
    Picture right = found;
    Picture halves = found;
    std::uint64_t state = 88172645463325252;
    double caustic = 0.0;
    for (int v = 0; v < kPixels; ++v) {
        for (int u = 0; u < kPixels; ++u) {
            constexpr int kPlaces = 64;
            std::array<double, 2> sums{};
            for (int i = 0; i < kPlaces; ++i) {
                const Vec3 p = floorAt(shot, u + uniform(state), v + uniform(state));
                const double thrown = irradianceAt(scene, p, 256, state);
                caustic += thrown / (kPlaces * kPixels * kPixels);
                sums[i % 2] += 0.5 * (thrown + straightAt(scene, p, 16, state)) / (kPlaces / 2);
            }
            const auto pixel = static_cast<std::size_t>(v * kPixels + u);
            right.pixels[pixel] = Color(0.5 * (sums[0] + sums[1]));
            halves.pixels[pixel] = right.pixels[pixel] + Color(0.5 * (sums[0] - sums[1]));
        }
    }
    CAPTURE(caustic);
    CHECK(caustic > 0.05);
    const double off = clippedRmse(found, right);
    const double oracle = clippedRmse(halves, right);
    CAPTURE(off);
    CAPTURE(oracle);
    CHECK(oracle < error);
    CHECK(std::sqrt(std::max(off * off - oracle * oracle, 0.0)) < 1.2 * error);
    double mean = 0.0;
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        mean += std::min(found.pixels[i].x, 1.0) - std::min(right.pixels[i].x, 1.0);
    }
    CHECK(std::fabs(mean) / static_cast<double>(right.pixels.size()) < 0.5 * error);
}

}  // namespace

TEST_CASE("A pane that bends nothing throws the light that would come straight") {
    const std::string lamp = light({0, 0, 8}, 40.0, "{1, 0.5, 1}", 0.4);
    const std::string pane = place("gr.nh_box('pane', {-1.6, -1.6, 6}, {3.2, 3.2, 0.5})", 0.0,
                                   "it:set_refraction(1, 0.25)");
    const Shot through = floorShot(kOn + floorOf(0.8) + pane + lamp, 0.5, 0.0, 4.0, 16);
    const Shot open = floorShot(floorOf(0.6) + lamp, 0.5, 0.0, 4.0, 16);
    const Picture thrown = adaptive(through, 0.01);
    CHECK(thrown.converged);
    CHECK(clippedRmse(thrown, plain(open, 64)) < 0.01);
    // Photons bring all of it.
    const Shot dark = floorShot(floorOf(0.8) + pane + lamp, 0.5, 0.0, 4.0, 16);
    CHECK(adaptive(dark, 0.01).at(8, 8).x == doctest::Approx(thrown.at(8, 8).x).epsilon(0.1));
}

TEST_CASE("A plane mirror throws what a light behind it would") {
    for (const double radius : {0.0, 0.5}) {
        CAPTURE(radius);
        // The mirror is the wall x = 5, and reaches over all that the floor sees of it.
        const std::string mirror =
            place("gr.nh_box('wall', {5, -40, -1}, {1, 80, 60})", 0.0, "it:set_reflection(0.3)");
        const Shot both =
            floorShot(kOn + floorOf(0.5) + mirror + light({2, 0, 6}, 20.0, "{0, 0, 1}", radius),
                      1.0, 0.0, 5.0, 16);
        const Shot twice = floorShot(floorOf(0.5) + light({2, 0, 6}, 20.0, "{0, 0, 1}", radius) +
                                         light({8, 0, 6}, 14.0, "{0, 0, 1}", radius),
                                     1.0, 0.0, 5.0, 16);
        const Picture found = adaptive(both, 0.01);
        CHECK(found.converged);
        CHECK(clippedRmse(found, plain(twice, 64)) < 0.01);
    }
}

TEST_CASE("Other kinds of light throw what a light behind a mirror would") {
    const auto lamp = [](const char* kind, double x, double turn, double share) {
        const std::string colour =
            "{" + text(20.0 * share) + ", " + text(20.0 * share) + ", " + text(20.0 * share) + "}";
        const std::string sun = "{" + text(share) + ", " + text(share) + ", " + text(share) + "}";
        if (std::string(kind) == "spot") {
            return "lights[#lights + 1] = gr.spot_light{position = {" + text(x) +
                   ", 0, 6}, direction = {" + text(turn * 0.4) +
                   ", 0, -1}, inner = 5, outer = 50, falloff = {0, 0, 1}, colour = " + colour +
                   "}\n";
        }
        if (std::string(kind) == "sun") {
            return "lights[#lights + 1] = gr.sun_light{direction = {" + text(turn) +
                   ", 0.2, -1}, angle = 4, colour = " + sun + "}\n";
        }
        return "lights[#lights + 1] = gr.rectangle_light{corner = {" + text(x) + ", -1, 6}, u = {" +
               text(turn) + ", 0, 0.5}, v = {0, 2, 0}, falloff = {0, 0, 1}, " +
               "colour = " + colour + "}\n";
    };
    for (const char* kind : {"spot", "sun", "rectangle"}) {
        CAPTURE(kind);
        const std::string mirror =
            place("gr.nh_box('wall', {5, -12, -1}, {1, 24, 14})", 0.0, "it:set_reflection(0.3)");
        const Shot both =
            floorShot(kOn + floorOf(0.5) + mirror + lamp(kind, 2.0, 1.0, 1.0), 1.5, 0.0, 4.0, 16);
        const Shot twice =
            floorShot(floorOf(0.5) + lamp(kind, 2.0, 1.0, 1.0) + lamp(kind, 8.0, -1.0, 0.7), 1.5,
                      0.0, 4.0, 16);
        const Picture found = adaptive(both, 0.01);
        CHECK(found.converged);
        CHECK(clippedRmse(found, plain(twice, 256)) < 0.011);
    }
}

TEST_CASE("Caustics of a glass ball are those of brute force") {
    const OracleScene scene{{0, 0, 1.6}, 1.0, 1.5, {-2.5, 0, 6}, 0.4, 12.0, {0, 0, 1}};
    checkAgainstOracle(scene, 1.4, 2.2, 1.0, 0.01);
}

TEST_CASE("Caustics of a mirror ball are those of brute force") {
    const OracleScene scene{{0, 0, 1.2}, 1.0, 0.0, {-3, 0, 4}, 0.5, 4.0, {1, 0.2, 0}};
    checkAgainstOracle(scene, -2.2, 2.6, -1.0, 0.01);
}

TEST_CASE("A glass ball keeps the flux that it gathers") {
    // A sun at 45 degrees. What falls on the ball's disc comes down beyond it, less what the ball
    // keeps for its own colour.
    const Shot shot = floorShot(
        kOn + floorOf(0.01) +
            place("gr.nh_sphere('ball', {0, 0, 3}, 1)", 0.0, "it:set_refraction(1.02, 0.2)") +
            "lights[1] = gr.sun_light{direction = {1, 0, -1}, colour = {1, 1, 1}}\n",
        4.4, 0.0, 7.0, 32, 1.0);
    const Picture found = adaptive(shot, 0.004);
    double flux = 0.0;
    for (int v = 0; v < shot.height; ++v) {
        for (int u = 0; u < shot.width; ++u) {
            const Vec3 across = floorAt(shot, u + 1, v + 0.5) - floorAt(shot, u, v + 0.5);
            const Vec3 down = floorAt(shot, u + 0.5, v + 1) - floorAt(shot, u + 0.5, v);
            flux +=
                (found.at(u, v).x / 0.01 - std::sqrt(0.5)) * glm::length(glm::cross(across, down));
        }
    }
    CHECK(flux == doctest::Approx(-0.2 * kPi).epsilon(0.08));
}

TEST_CASE("A concave mirror's light comes to a point at half its radius") {
    // A half cylinder of facets with normals, the sun along +x: the nephroid's cusp.
    const Shot shot = floorShot(
        kOn + floorOf(0.02) +
            "local points, faces, normals = {}, {}, {}\n"
            "for i = 0, 128 do\n"
            "  local a = math.pi * (i / 128 - 0.5)\n"
            "  for _, z in ipairs{0, 1} do points[#points + 1] = {2 * math.cos(a), 2 * "
            "math.sin(a), z} end\n"
            "  if i > 0 then faces[#faces + 1] = {2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i} end\n"
            "end\n" +
            place("gr.mesh('ring', points, faces)", 0.0, "it:set_reflection(0)") +
            "lights[1] = gr.sun_light{direction = {1, 0, -0.2}, colour = {1, 1, 1}}\n",
        1.0, 0.0, 1.0, 48);
    const Picture found = adaptive(shot, 0.004);
    // Along the axis: dark before the cusp, brightest at it.
    double brightest = 0.0;
    double at = 0.0;
    for (int v = 0; v < 48; ++v) {
        const double value = found.at(24, v).x + found.at(23, v).x;
        if (value > brightest) {
            brightest = value;
            at = floorAt(shot, 24, v + 0.5).x;
        }
    }
    CHECK(at == doctest::Approx(1.0).epsilon(0.06));
    // Nearer to the axis of the cylinder than the cusp only the sun itself shines.
    CHECK(found.at(24, 46).x < 0.3 * brightest);
}

TEST_CASE("A ball of glass burns where paraxial rays meet") {
    // n R / (2 (n - 1)) from its centre: 1.5 R for n = 1.5.
    const auto widthAt = [](double height) {
        Shot shot = floorShot(
            kOn + floorOf(0.002) +
                place("gr.nh_sphere('ball', {0, 0, " + text(height) + "}, 1)", 0.0,
                      "it:set_refraction(1.5, 0)") +
                // Through a hole in the screen, for rays near the axis.
                "for i = 0, 3 do local s = gr.nh_box('screen', {0.2, -1.3, 6}, {1.1, 2.6, 0.1})\n"
                "s:rotate('z', 90 * i) root:add_child(s, gr.material({0, 0, 0}, {0, 0, 0}, 0)) "
                "end\n"
                "lights[1] = gr.sun_light{direction = {0, 0, -1}, colour = {1, 1, 1}}\n",
            0.0, 0.0, 0.6, 32);
        // From low down, to see the floor below the ball.
        shot.eye = {-300.0, 0.0, 60.0};
        shot.view = {5.0, 0.0, -1.0};
        shot.fov *= std::sqrt(7200.0) / glm::length(shot.eye);
        const Picture found = adaptive(shot, 0.003);
        double sum = 0.0;
        double second = 0.0;
        for (int u = 0; u < 32; ++u) {
            const double y = floorAt(shot, u + 0.5, 16).y;
            const double value = found.at(u, 15).x + found.at(u, 16).x;
            sum += value;
            second += value * y * y;
        }
        return std::sqrt(second / sum);
    };
    const double focus = widthAt(1.5);
    CHECK(focus < widthAt(1.3));
    CHECK(focus < widthAt(1.8));
}

TEST_CASE("Caustics are the same to the byte for any number of threads and every kernel") {
    const OracleScene scene{{0, 0, 1.6}, 1.0, 1.5, {-2.5, 0, 6}, 0.4, 12.0, {0, 0, 1}};
    const Shot shot = floorShot(scriptOf(scene), 1.4, 0.0, 2.2, 12, 1.0);
    constexpr double kError = 0.1;
    const Picture one = adaptive(shot, kError, 1);
    CHECK(sameBytes(one, adaptive(shot, kError, 2)));
    CHECK(sameBytes(one, adaptive(shot, kError, 7)));
    PictureSettings settings;
    settings.options.error = kError;
    settings.kernel = "baseline";
    CHECK(sameBytes(one, renderScript(shot.script(), settings)));
}

TEST_CASE("Pictures with caustics are as near to the truth as they say") {
    Shot shot;
    shot.eye = {0, -9, 5};
    shot.view = {0, 0.9, -0.5};
    shot.up = {0, 0, 1};
    shot.fov = 40;
    shot.width = 24;
    shot.height = 14;
    shot.ambient = Color(0.1);
    shot.body = kOn + floorOf(0.7) +
                place("gr.nh_sphere('ball', {-1, 0, 1.2}, 1)", 0.1,
                      "it:set_refraction(1.5, 0) it:set_fresnel(true)") +
                place("gr.nh_box('mirror', {1, -0.5, 0}, {0.2, 2, 2})", 0.3,
                      "it:set_reflection(0.1) it:rotate('z', 20)") +
                light({-4, -2, 6}, 0.7, "{1, 0, 0}", 0.3);
    checkErrorIsKept(shot, 32, {0.03, 0.015}, 1.0);
}

TEST_CASE("Without anything that mirrors or refracts, caustics change no byte") {
    const std::string body = floorOf(0.7) + place("gr.nh_sphere('ball', {-1, 0, 1.2}, 1)", 0.1) +
                             light({-4, -2, 6}, 0.7, "{1, 0, 0}", 0.3);
    const Shot without = floorShot(body, 0.0, 0.0, 6.0, 16);
    const Shot with = floorShot(kOn + body, 0.0, 0.0, 6.0, 16);
    CHECK(sameBytes(adaptive(without, 0.02), adaptive(with, 0.02)));
}

}  // namespace rt::test
