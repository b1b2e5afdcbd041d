// The rays behind a sample: those of the render, and in a scene of closed forms what they must be.
#include "rt/trace/traced_sample.h"

#include "rt/compile/compile.h"
#include "rt/render/kernel_choice.h"
#include "support/render_script.h"
#include "trace/tracer_variants.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

using namespace rt;

namespace {

RenderScene compiled(const std::string& script) {
    Diagnostics diagnostics;
    AssetCache assets(1);
    return compileScene(rt::test::describe(script).scene, 0, {}, assets, diagnostics);
}

/// A floor, a mirror, glass inside glass and a post before a light; `more` goes to the balls.
std::string sceneWith(const std::string& more, const std::string& radius) {
    return R"(
local root = gr.node('root')
local grey = gr.material({0.6, 0.5, 0.4}, {0.3, 0.3, 0.3}, 20)
root:add_child(gr.nh_box('floor', {-6, -2, -6}, {12, 1, 12}), grey)
local glass, inner, mirror = gr.nh_sphere('glass', {-1, 0, 1}, 1), gr.nh_sphere('inner', {-1, 0, 1}, 0.5),
                             gr.nh_cylinder('mirror', {1.3, -1, -1}, 2.5, 0.9)
)" + more + R"(
for _, ball in ipairs{glass, inner, mirror} do root:add_child(ball, grey) end
root:add_child(gr.nh_cone('post', {2, -1, 2}, 1.5, 0.4), grey)
gr.background({0.1, 0.1, 0.2}, {0.4, 0.5, 0.7})
gr.render(root, 'x.png', 16, 12, {0, 1.5, 7}, {0, -0.3, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.6, 0.6, 0.6}, {1, 0, 0.01}, )" +
           radius +
           R"(), gr.light({-6, 5, 3}, {0.3, 0.3, 0.3}, {1, 0, 0})}, gr.focal({0, 0, 1}, 0.05, 0.02))
)";
}

const std::string kMirror = "mirror:set_reflection(0.2) ";
const std::string kGlass =
    "for _, b in ipairs{glass, inner} do b:set_refraction(b == glass and 1.5 or 1.2, 0.1) "
    "b:set_fresnel(true) end ";
const std::string kColour = "glass:set_absorption({0.1, 0.5, 0.9}) ";

Color sumOf(const TracedSample& sample) {
    Color sum(0.0);
    for (const TracedRay& ray : sample.rays) sum += ray.weight * ray.parts.own * ray.color;
    return sum;
}

void checkTree(const RenderScene& scene, const TracedSample& sample) {
    REQUIRE(!sample.rays.empty());
    CHECK(sample.rays[0].kind == RayKind::kCamera);
    std::vector<const TracedRay*> above;  // by depth
    for (const TracedRay& ray : sample.rays) {
        REQUIRE(ray.depth <= static_cast<int>(above.size()));
        above.resize(static_cast<std::size_t>(ray.depth));
        if (!above.empty()) {
            const TracedRay& parent = *above.back();
            const bool through = ray.kind == RayKind::kRefracted;
            const double part = through ? parent.parts.refracted : parent.parts.reflected;
            CHECK(part > 0.0);
            CHECK(ray.weight.x <= parent.weight.x * part);
            CHECK(glm::length(ray.ray.origin - parent.point) < 1e-9);
            const double side = glm::dot(ray.ray.direction, parent.geometricNormal);
            CHECK((through ? side < 0.0 : side > 0.0));
        } else {
            CHECK(ray.kind == RayKind::kCamera);
        }
        above.push_back(&ray);
        if (ray.instance == kNone) continue;
        CHECK(ray.parts.own + ray.parts.reflected + ray.parts.refracted ==
              doctest::Approx(1.0).epsilon(1e-12));
        CHECK(glm::length(ray.ray.at(ray.t) - ray.point) < 1e-9);
        CHECK(glm::dot(ray.ray.direction, ray.geometricNormal) <= 0.0);
        if (!(ray.parts.own > 0.0)) continue;
        Color own = ray.material.diffuse * scene.ambient;
        for (const TracedLight& light : ray.lights) own += light.visible * light.unhidden;
        CHECK(own == ray.color);
    }
}

}  // namespace

TEST_CASE("The rays that are told are those of the render, to the bit, for every variant") {
    std::set<unsigned> variants;
    for (const std::string& more : {std::string(), kMirror, kGlass, kMirror + kGlass + kColour}) {
        for (const char* radius : {"0", "0.8"}) {
            const RenderScene scene = compiled(sceneWith(more, radius));
            variants.insert(variantOf(scene.features));
            TraceSettings settings;
            settings.spp = 3;
            settings.seed = 7;
            settings.filter = FilterKind::kMitchell;
            for (const char* kernel : {"baseline", ""}) {
                for (int y = 0; y < scene.height; ++y) {
                    for (int x = 0; x < scene.width; ++x) {
                        const std::uint32_t end = 3;
                        PixelState pixel;
                        TraceCounts counts;
                        chooseKernel(kernel).renderTile(scene, settings, {x, y, x + 1, y + 1}, &end,
                                                        &pixel, counts);
                        Color sum(0.0);
                        std::size_t rays = 0;
                        for (int i = 0; i < 3; ++i) {
                            const TracedSample told = tracedSample(scene, settings, {x, y}, i);
                            CHECK(told.value == told.filterWeight * sumOf(told));
                            checkTree(scene, told);
                            sum += told.value;
                            rays += told.rays.size();
                        }
                        CHECK(sum == pixel.sum);
                        CHECK(rays ==
                              counts.rays.camera + counts.rays.reflection + counts.rays.refraction);
                    }
                }
            }
        }
    }
#ifdef RT_TWO_VARIANTS
    CHECK(variants.size() == 2);
#else
    CHECK(variants.size() == 8);
#endif
}

TEST_CASE("A mirror, a window and a hidden light are told as the closed forms have them") {
    // Down onto a mirror at 45 degrees, along the x axis through a pane that bends nothing (index 1
    // in a medium of 1), onto a wall at x = 5 whose light a board hides.
    const RenderScene scene = compiled(R"(
local root = gr.node('root')
local black, white = gr.material({0, 0, 0}, {0, 0, 0}, 0), gr.material({0.5, 0.25, 1}, {0, 0, 0}, 0)
local mirror = gr.mesh('mirror', {{1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, 1}}, {{0, 3, 2, 1}})
mirror:set_reflection(0.25)
root:add_child(mirror, white)
local pane = gr.nh_box('pane', {2, -4, -4}, {1, 8, 8})
pane:set_refraction(1, 0.5)
root:add_child(pane, black)
root:add_child(gr.nh_box('wall', {5, -4, -4}, {1, 8, 8}), white)
root:add_child(gr.nh_box('board', {4.1, 2, -1}, {0.5, 0.1, 2}), black)
gr.render(root, 'x.png', 1, 1, {0, 10, 0}, {0, -1, 0}, {1, 0, 0}, 1e-9, {0.5, 0.5, 0.5},
          {gr.light({4, 3, 0}, {1, 1, 1}, {1, 0, 0})})
)");
    TraceSettings settings;
    settings.cutoff = 0.0;
    const TracedSample sample = tracedSample(scene, settings, {0, 0}, 0);
    REQUIRE(sample.rays.size() == 4);
    const auto& [camera, mirrored, inside, beyond] =
        std::tie(sample.rays[0], sample.rays[1], sample.rays[2], sample.rays[3]);
    CHECK(glm::length(camera.point) < 1e-9);
    CHECK(camera.parts.own == 0.25);
    CHECK(camera.parts.reflected == 0.75);
    CHECK(mirrored.kind == RayKind::kReflected);
    CHECK(glm::length(mirrored.ray.direction - Vec3(1, 0, 0)) < 1e-9);
    CHECK(mirrored.weight == Color(0.75));
    CHECK(glm::length(mirrored.point - Vec3(2, 0, 0)) < 1e-9);
    CHECK(mirrored.parts.own == 0.5);
    CHECK(inside.kind == RayKind::kRefracted);
    CHECK(inside.weight == Color(0.375));
    CHECK(inside.fromInside);
    CHECK(inside.parts.own == 0.0);
    CHECK(beyond.depth == 3);
    CHECK(beyond.weight == Color(0.375));
    CHECK(glm::length(beyond.point - Vec3(5, 0, 0)) < 1e-9);
    CHECK(beyond.color == Color(0.25, 0.125, 0.5));  // the ambient light alone
    REQUIRE(beyond.lights.size() == 1);
    CHECK(beyond.lights[0].visible == Color(0.0));
    REQUIRE(beyond.lights[0].first != kNone);
    CHECK(scene.instances[beyond.lights[0].first].shape ==
          scene.instances[scene.instances.size() - 1].shape);
    CHECK(beyond.lights[0].reach == doctest::Approx(std::sqrt(10.0)));
    CHECK(beyond.lights[0].unhidden.z == doctest::Approx(1.0 / std::sqrt(10.0)));
}
