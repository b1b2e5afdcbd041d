// What --error promises, held against the slow truth.
#include "rt/render/kernel_choice.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

/// Edges, a penumbra, a highlight, a mirror and glass.
const char* const kScene = R"(
    gr.background({0.1, 0.2, 0.4}, {0.5, 0.6, 0.7})
    local root = gr.node('root')
    local grey = gr.material({0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}, 40)
    root:add_child(gr.nh_box('floor', {-9, -2, -9}, {18, 1, 18}), grey)
    local mirror = gr.nh_sphere('mirror', {-1.2, 0, 0}, 1)
    mirror:set_reflection(0.3)
    root:add_child(mirror, grey)
    local glass = gr.nh_sphere('glass', {1.2, 0, 0.5}, 1)
    glass:set_refraction(1.5, 0.1)
    root:add_child(glass, grey)
    gr.render(root, 'x.png', 60, 40, {0, 1, 7}, {0, -0.15, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.2},
              {gr.light({4, 7, 4}, {0.8, 0.8, 0.8}, {1, 0, 0}, 1.5)}))";

double rmse(const Picture& a, const Picture& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Color difference =
            glm::clamp(a.pixels[i], 0.0, 1.0) - glm::clamp(b.pixels[i], 0.0, 1.0);
        sum += glm::dot(difference, difference) / 3.0;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace

TEST_CASE("the error that was reached is the error that was promised") {
    PictureSettings truth;
    truth.options.reference = true;
    truth.options.spp = 4096;
    truth.options.seed = 77;
    const Picture reference = renderScript(kScene, truth);
    for (const double target : {0.02, 0.01, 0.005}) {
        for (const double seed : {1.0, 2.0, 3.0}) {
            PictureSettings settings;
            settings.options.error = target;
            settings.options.seed = seed;
            const Picture picture = renderScript(kScene, settings);
            const double actual = rmse(picture, reference);
            CAPTURE(target);
            CAPTURE(seed);
            CAPTURE(actual);
            CHECK(picture.errorEstimate.value() <= target);
            CHECK(actual <= 1.15 * target);
            CHECK(actual >= 0.3 * picture.errorEstimate.value());
        }
    }
}

TEST_CASE("thin bars that only a mirror shows count towards the error") {
    const char* const bars = R"(
        local root = gr.node('root')
        local grey = gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1)
        local mirror = gr.nh_box('mirror', {-4, -3, -1}, {8, 6, 1})
        mirror:set_reflection(0.1)
        root:add_child(mirror, grey)
        for i = -30, 30 do
            root:add_child(gr.nh_box('bar', {i, -30, 24}, {0.05, 60, 0.05}), grey)
        end
        gr.render(root, 'x.png', 90, 60, {0, 0, 12}, {0.03, 0.02, -1}, {0.1, 1, 0}, 40, {1, 1, 1}, {}))";
    PictureSettings truth;
    truth.options.reference = true;
    truth.options.spp = 4096;
    const Picture reference = renderScript(bars, truth);
    for (const double target : {0.01, 0.004}) {
        PictureSettings settings;
        settings.options.error = target;
        CHECK(rmse(renderScript(bars, settings), reference) <= 1.15 * target);
    }
}

TEST_CASE("tips of leaves beside leaves count towards the error") {
    const char* const leaves = R"(
        local points, faces = {}, {}
        local function leaf(x, y, angle)
            local n = #points
            for i, r in ipairs{0.5, 0.08, 0.08} do
                local a = angle + (i == 1 and 0 or i == 2 and 2 or -2)
                points[n + i] = {x + r * math.cos(a), y + r * math.sin(a), 0}
            end
            faces[#faces + 1] = {n, n + 1, n + 2}
        end
        for i = 1, 500 do
            local a = i * 2.4
            local r = 0.13 * math.sqrt(i)
            leaf(r * math.cos(a), r * math.sin(a), i * 1.7)
        end
        local root = gr.node('root')
        root:add_child(gr.mesh('leaves', points, faces, {smooth = false}),
                       gr.material({1, 1, 1}, {0, 0, 0}, 1))
        gr.render(root, 'x.png', 90, 60, {0, 0, 12}, {0, 0, -1}, {0.1, 1, 0}, 40, {1, 1, 1}, {}))";
    PictureSettings truth;
    truth.options.reference = true;
    truth.options.spp = 1024;
    const Picture reference = renderScript(leaves, truth);
    PictureSettings settings;
    settings.options.error = 0.004;
    CHECK(rmse(renderScript(leaves, settings), reference) <= 1.15 * 0.004);
}

TEST_CASE("towards an error target the picture is the same for any threads and kernel") {
    PictureSettings settings;
    settings.options.error = 0.01;
    const Picture one = renderScript(kScene, settings);
    settings.threads = 7;
    CHECK(renderScript(kScene, settings).pixels == one.pixels);
    settings.threads = 2;
    for (const TraceKernel* kernel : availableKernels()) {
        settings.kernel = kernel->name;
        CHECK(renderScript(kScene, settings).pixels == one.pixels);
    }
}

TEST_CASE("an error out of reach is reported as not converged") {
    PictureSettings settings;
    settings.options.error = 1e-4;
    settings.options.maxSpp = 8;
    const Picture picture = renderScript(kScene, settings);
    CHECK(!picture.converged);
    CHECK(picture.errorEstimate.value() > 1e-4);
}
