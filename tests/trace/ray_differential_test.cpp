// Footprints against differences of paths that lie close together.
#include "trace/ray_differential.h"

#include "rt/shading/fresnel.h"
#include "support/textured_scene.h"
#include "trace/scene_intersect.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

using namespace rt;
using namespace rt::test;

namespace {

struct Seen {
    Vec2 uv;
    TextureFootprint footprint;
    std::vector<Index> way;  ///< the instances that were met
    std::vector<Index> parts;
};

/// Follows mirrors, and glass in air, to what shows a texture.
std::optional<Seen> look(const RenderScene& scene, double x, double y, const Vec2& lens) {
    Ray ray = scene.camera.ray(x, y, lens);
    RayDifferential differential = cameraDifferential(scene.camera, ray.direction);
    Seen seen;
    bool inside = false;
    for (int depth = 0; depth < 8; ++depth) {
        SceneHit hit;
        if (!closestHit(scene, ray, {}, hit)) return std::nullopt;
        const Look& what = scene.looks[scene.instances[hit.instance].look];
        const ShadePoint point = shadePoint(scene, hit, ray.direction, true);
        seen.way.push_back(hit.instance);
        seen.parts.push_back(hit.at.part);
        if (!what.reflects && !what.refracts) {
            const SurfacePoint surface = surfaceAt(scene, hit, SurfaceDetail::kParametrised);
            seen.uv = surface.uv;
            const Beam beam{ray, differential, {}};
            seen.footprint = beam.on(surface, scene.instances[hit.instance].transform, hit.at.t);
            return seen;
        }
        if (glm::dot(ray.direction, point.normal) > -0.05) return std::nullopt;
        Vec3 direction = mirrored(ray.direction, point.normal);
        double ratio = 0.0;
        if (what.refracts) {
            const double from = inside ? what.index : 1.0;
            const double to = inside ? 1.0 : what.index;
            if (const auto bent = refracted(ray.direction, point.normal, from, to)) {
                direction = *bent;
                ratio = from / to;
                inside = !inside;
            }
        }
        differential = differentialBeyond(differential, scene, ray, hit, point, direction, ratio);
        ray = {point.leave(point.position, direction), direction};
    }
    return std::nullopt;
}

/// The relative differences of footprints from central differences, over many image points, in
/// rising order. Where neighbours go different ways there is nothing to compare.
std::vector<double> differences(const RenderScene& scene, std::size_t bounces) {
    const unsigned seed = 17;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double h = 1e-4;
    std::vector<double> found;
    for (int i = 0; i < 3000; ++i) {
        const double x = scene.width * unit(random);
        const double y = scene.height * unit(random);
        const Vec2 lens = 0.7 * Vec2(unit(random), unit(random));
        const auto middle = look(scene, x, y, lens);
        if (!middle || middle->way.size() <= bounces) continue;
        for (const bool down : {false, true}) {
            const Vec2 step = down ? Vec2(0.0, h) : Vec2(h, 0.0);
            const auto one = look(scene, x - step.x, y - step.y, lens);
            const auto two = look(scene, x + step.x, y + step.y, lens);
            if (!one || !two || one->way != two->way || one->parts != two->parts) continue;
            const Vec2 difference = (two->uv - one->uv) / (2.0 * h);
            if (glm::length(two->uv - one->uv) > 0.01) continue;  // a seam, or a pole
            const Vec2 side = down ? middle->footprint.down : middle->footprint.across;
            const double size = std::max(glm::length(middle->footprint.down),
                                         glm::length(middle->footprint.across));
            found.push_back(glm::length(side - difference) / size);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

const char* const kSolids[] = {
    "gr.sphere('s')",
    "gr.nh_box('s', {-0.9, -0.8, -0.7}, {1.8, 1.6, 1.4})",
    "gr.cylinder('s')",
    "gr.nh_cone('s', {0, -1, 0}, 2, 1)",
    "gr.torus('s', 0.8, 0.35)",
    "gr.torus('s', 0.4, 0.6)",
    "gr.mesh('s', 'ball.obj')",
    "gr.nh_frustum('s', {0, -1, 0}, 1.8, 1, 0.5)",
    "gr.nh_hemisphere('s', {0, -0.4, 0}, 1)",
};

const char* const kSheets[] = {
    "gr.nh_disc('s', {0, 0, 0}, {0.1, 0, 1}, 1)",
    "gr.nh_quad('s', {-0.8, -0.7, 0}, {1.6, 0, 0.3}, {0.2, 1.5, -0.4})",
    "gr.nh_plane('s', {0, -1, 0}, {0.1, 1, 0.2})",
};

const char* const kPlacements[] = {
    "",
    "s:rotate('x', 35) s:rotate('y', 20)",
    "s:rotate('z', 30) s:scale(1.2, 0.7, -0.9) s:rotate('x', 50)",
};

/// An octahedron with the normals of the sphere around it, and a uv that is a map of the sphere.
const char* const kBall = R"(v 1 0 0
v -1 0 0
v 0 1 0
v 0 -1 0
v 0 0 1
v 0 0 -1
vn 1 0 0
vn -1 0 0
vn 0 1 0
vn 0 -1 0
vn 0 0 1
vn 0 0 -1
vt 0.1 0.2
vt 0.9 0.3
vt 0.4 0.8
f 1/1/1 3/2/3 5/3/5
f 3/1/3 2/2/2 5/3/5
f 2/1/2 4/2/4 5/3/5
f 4/1/4 1/2/1 5/3/5
f 3/1/3 1/2/1 6/3/6
f 2/1/2 3/2/3 6/3/6
f 4/1/4 2/2/2 6/3/6
f 1/1/1 4/2/4 6/3/6
)";

/// `solid` in front of the camera, placed and then given `calls` and an appearance.
std::string scene(const std::string& solid, const std::string& calls, const std::string& appearance,
                  const std::string& focal = "") {
    return "root = gr.node('root') s = " + solid + " " + calls +
           " picture = gr.texture('picture.png', {0, 0, 0}, 1)\n"
           "matt = gr.material({1, 1, 1}, {0, 0, 0}, 1)\n" +
           appearance +
           "\ngr.render(root, 'o.png', 40, 30, {0.1, 0.4, 4}, {0, -0.1, -1}, {0.1, 1, 0}, 42, "
           "{1, 1, 1}, {}" +
           focal + ")";
}

const std::string kAround =
    "around = gr.nh_sphere('around', {3, 2, 1}, 40) root:add_child(around, nil, picture)\n";

TemporaryFolder& files() {
    static TemporaryFolder folder;
    writePng(folder, "picture.png", 1, 1, 1, {128});
    writePng(folder, "bump.png", 1, 1, 3, {200, 128, 220});
    folder.write("ball.obj", kBall);
    return folder;
}

/// 95 of 100 differences, at least `least` of them, are below `bound`; the rest lie where a step of
/// the central difference is too long, at grazing angles.
void hold(const std::string& script, double bound, std::size_t least, std::size_t bounces) {
    CAPTURE(script);
    const std::vector<double> found = differences(compiled(files(), script), bounces);
    REQUIRE(found.size() > least);
    MESSAGE(found[found.size() * 95 / 100] << ", worst " << found.back());
    CHECK(found[found.size() * 95 / 100] < bound);
    CHECK(found.back() < 0.1);
}

}  // namespace

TEST_CASE("a pixel's footprint on every solid, however it is placed, is the derivative of its uv") {
    const auto onEach = [](const auto& solids) {
        for (const char* solid : solids) {
            for (const char* placement : kPlacements) {
                hold(scene(solid, placement, "root:add_child(s, nil, picture)"), 1e-4, 300, 0);
                hold(scene(solid, placement, "root:add_child(s, nil, picture)",
                           ", gr.focal(3, 0.1, 0.2)"),
                     1e-4, 300, 0);
            }
        }
    };
    onEach(kSolids);
    onEach(kSheets);
}

TEST_CASE("a pixel's footprint is followed through mirrors of every shape") {
    const auto inEach = [](const auto& solids) {
        for (const char* solid : solids) {
            for (const char* placement : kPlacements) {
                hold(scene(solid, placement,
                           "s:set_reflection(0) root:add_child(s, matt)\n" + kAround),
                     1e-3, 200, 1);
            }
        }
    };
    inEach(kSolids);
    inEach(kSheets);
}

TEST_CASE("a pixel's footprint is followed through glass of every shape") {
    for (const char* solid : kSolids) {
        for (const char* placement : kPlacements) {
            hold(scene(solid, placement,
                       "s:set_refraction(1.4, 0) root:add_child(s, matt)\n" + kAround),
                 1e-2, 200, 2);
        }
    }
}

TEST_CASE("behind a mirror with a bump map no footprint is known") {
    const RenderScene bumped = compiled(
        files(),
        scene("gr.sphere('s')", "",
              "s:set_reflection(0) root:add_child(s, matt, nil, gr.bumpmap('bump.png'))\n" +
                  kAround));
    const auto seen = look(bumped, 20.0, 15.0, Vec2(0.0));
    REQUIRE(seen);
    REQUIRE(seen->way.size() == 2);
    CHECK(std::isnan(seen->footprint.across.x));
    CHECK(std::isnan(seen->footprint.down.y));
}
