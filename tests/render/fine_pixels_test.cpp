// What the corners of a pixel miss and fills more than a sliver of it lies in a pixel that is
// marked.
#include "rt/render/fine_pixels.h"

#include "support/textured_scene.h"
#include "trace/scene_intersect.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;
constexpr int kTurns = 30;
/// Round outlines of two pixels' radius or more leave less than this between two corners.
constexpr double kSliver = 0.06;

RenderScene compiledSolid(const std::string& solid, const Vec3& turn, double scale) {
    char place[200];
    std::snprintf(place, sizeof place,
                  "s:rotate('x', %.3f) s:rotate('y', %.3f) s:rotate('z', %.3f) s:scale(%g, %g, %g)",
                  turn.x, turn.y, turn.z, scale, scale, scale);
    const std::string script =
        "root = gr.node('root') s = " + solid + " " + place +
        " root:add_child(s, gr.material({1, 1, 1}, {0, 0, 0}, 1))"
        " gr.render(root, 'o.png', 40, 30, {0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 30, {1, 1, 1}, {})";
    return compiled(TemporaryFolder(), script);
}

bool shows(const RenderScene& scene, double x, double y) {
    return anyHit(scene, scene.camera.ray(x, y, {0.0, 0.0}), {0.0, kInfinity});
}

double coverage(const RenderScene& scene, int x, int y) {
    constexpr int kFine = 8;
    int covered = 0;
    for (int i = 0; i < kFine * kFine; ++i) {
        covered += shows(scene, x + (i % kFine + 0.5) / kFine, y + (i / kFine + 0.5) / kFine);
    }
    return covered / double(kFine * kFine);
}

/// Whether a corner of the pixel, or of one up to `reach` pixels off, sees anything.
bool anyCorner(const RenderScene& scene, int x, int y, int reach) {
    for (int v = y - reach; v <= y + 1 + reach; ++v) {
        for (int u = x - reach; u <= x + 1 + reach; ++u) {
            if (shows(scene, u, v)) return true;
        }
    }
    return false;
}

struct Missed {
    int hidden = 0;    ///< pixels none of whose corners sees what fills more than a sliver
    int unmarked = 0;  ///< those of them that are not marked
    int marked = 0;
};

Missed missedIn(const RenderScene& scene) {
    Missed missed;
    const std::vector<bool> fine = finePixels(scene, {0, 0, kWidth, kHeight});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool mark = fine[static_cast<std::size_t>(y * kWidth + x)];
            missed.marked += mark;
            if (anyCorner(scene, x, y, 0) || !anyCorner(scene, x, y, 2)) continue;
            if (coverage(scene, x, y) <= kSliver) continue;
            ++missed.hidden;
            missed.unmarked += !mark;
        }
    }
    return missed;
}

}  // namespace

TEST_CASE("a corner of an outline between the corners of a pixel marks it") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(0.0, 360.0);
    for (const std::string solid : {
             "gr.nh_box('s', {-1, -1, -1}, {2, 2, 2})",
             "gr.nh_box('s', {-1, -0.2, -1}, {2, 0.4, 2})",
             "gr.nh_cone('s', {0, -1, 0}, 2, 1)",
             "gr.nh_cone('s', {0, -1.5, 0}, 3, 0.4)",
             "gr.nh_cylinder('s', {0, -0.2, 0}, 0.4, 1.5)",
             "gr.nh_frustum('s', {0, -0.2, 0}, 0.4, 1.5, 1.2)",
             "gr.nh_frustum('s', {0, -1.5, 0}, 3, 0.001, 0.5)",
             "gr.nh_hemisphere('s', {0, 0, 0}, 1.5) s:scale(1, 0.2, 1)",
             "gr.nh_quad('s', {-1, -1, 0}, {2, 0, 0}, {0, 2, 0})",
             "gr.nh_disc('s', {0, 0, 0}, {0, 0, 1}, 1.3)",
             "gr.mesh('s', {{-1, -1, 0}, {1, -1, 0}, {0, 1.2, 0}, {0, 0, 1}},"
             " {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {0, 1, 3}})",
         }) {
        CAPTURE(solid);
        Missed all;
        for (int i = 0; i < kTurns; ++i) {
            const Vec3 turn(angle(random), angle(random), angle(random));
            const Missed missed = missedIn(compiledSolid(solid, turn, 1.0));
            all.hidden += missed.hidden;
            all.unmarked += missed.unmarked;
            all.marked += missed.marked;
        }
        CHECK(all.hidden > 0);
        CHECK(all.unmarked == 0);
        // A mark costs samples: a few pixels about each corner of the outline.
        CHECK(all.marked < kTurns * 8 * 12);
    }
}

TEST_CASE("a round outline marks nothing, a narrow thing all of its pixels") {
    CHECK(missedIn(compiledSolid("gr.sphere('s')", Vec3(0.0), 1.5)).marked == 0);
    const Missed rod =
        missedIn(compiledSolid("gr.nh_cylinder('s', {0, -2, 0}, 4, 0.02)", {0, 0, 33}, 1.0));
    CHECK(rod.hidden > 0);
    CHECK(rod.unmarked == 0);
}

TEST_CASE("a combined solid marks what its parts alone would hide, seen or not") {
    const std::string ball = "gr.nh_sphere('a', {0, 0, 0}, 1.5)";
    const auto marked = [](const std::string& solid) {
        return missedIn(compiledSolid(solid, {0, 0, 30}, 1.0)).marked;
    };
    CHECK(marked("gr.difference('s', " + ball + ", gr.nh_sphere('b', {0.5, 0.5, 1}, 1))") == 0);
    const std::string rod = "gr.nh_cylinder('r', {0, -2, 0}, 4, 0.02)";
    const std::string box = "gr.nh_box('b', {-0.5, -0.5, -3}, {1, 1, 9})";
    CHECK(marked(rod) > 0);
    CHECK(marked("gr.difference('s', " + ball + ", " + rod + ")") == marked(rod));
    CHECK(marked("gr.union('s', " + ball + ", " + box + ")") == marked(box));
    // What two thick parts share, if its box is narrow.
    CHECK(marked("gr.intersection('s', gr.nh_sphere('a', {0, -3, 0}, 3.02), gr.nh_sphere('b', "
                 "{0, 3, 0}, 3.02))") > 20);
}
