// What rays cost in scenes of solids: each kind by itself, hit and missed, and whole renders of 1
// to 100,000 spheres or tori, in nanoseconds of one core a ray.
//
//     premake4 --bench gmake && make scene_bench config=release
//     build/release/scene_bench [--isa NAME] [largest number of solids]
#include "rt/compile/compile.h"
#include "rt/core/cpu_time.h"
#include "rt/render/kernel_choice.h"
#include "rt/script/scene_script.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr int kRounds = 7;

template <class Work>
double medianSeconds(const Work& work) {
    std::vector<double> seconds;
    for (int round = 0; round < kRounds; ++round) {
        const double before = processCpuSeconds();
        work();
        seconds.push_back(processCpuSeconds() - before);
    }
    std::nth_element(seconds.begin(), seconds.begin() + kRounds / 2, seconds.end());
    return seconds[kRounds / 2];
}

/// Rays from a sphere of radius 10 to points of the cube [-1, 1]^3, that hit or miss the shape.
std::vector<Ray> raysThat(bool hit, const TraceKernel& kernel, const Shape& shape,
                          const Transform& place) {
    std::mt19937_64 random(1);
    std::normal_distribution<> normal;
    std::uniform_real_distribution<> within(-1.0, 1.0);
    std::vector<Ray> rays;
    while (rays.size() < 4096) {
        const Vec3 from =
            10.0 * glm::normalize(Vec3(normal(random), normal(random), normal(random)));
        const Vec3 to(within(random), within(random), within(random));
        const Ray ray{from, glm::normalize(to - from)};
        PrimitiveHit found;
        Vec3 n;
        if (kernel.intersectShape(shape, place, ray, {}, found, n) == hit) rays.push_back(ray);
    }
    return rays;
}

void benchKinds(const TraceKernel& kernel) {
    const std::pair<const char*, Shape> kinds[] = {
        {"sphere", Sphere(Vec3(0.0), 1.0)},
        {"box", Box(Vec3(-0.7), Vec3(1.4))},
        {"cylinder", Cylinder(Vec3(0, -0.8, 0), 1.6, 0.7)},
        {"cone", Cone(Vec3(0, -0.8, 0), 1.6, 0.9)},
        {"torus", Torus(Vec3(0.0), 0.7, 0.3)},
    };
    Transform turned;
    if (!Transform::make(compose(Affine::rotate(0, 30), Affine::rotate(1, 50)), turned)) return;
    std::printf("%-10s %8s %8s %8s %8s   ns a ray; a hit with its normal\n", "solid", "hit", "miss",
                "hit", "miss");
    for (const auto& [name, shape] : kinds) {
        std::printf("%-10s", name);
        for (const Transform& place : {Transform(), turned}) {
            for (const bool hit : {true, false}) {
                const std::vector<Ray> rays = raysThat(hit, kernel, shape, place);
                constexpr int kPasses = 64;
                const double seconds = medianSeconds([&] {
                    for (int pass = 0; pass < kPasses; ++pass) {
                        for (const Ray& ray : rays) {
                            PrimitiveHit found;
                            Vec3 n;
                            if (kernel.intersectShape(shape, place, ray, {}, found, n) != hit) {
                                std::abort();
                            }
                        }
                    }
                });
                std::printf(" %8.1f", 1e9 * seconds / (kPasses * static_cast<double>(rays.size())));
            }
        }
        std::printf("   %s\n", "in place, turned");
    }
}

/// `count` solids of radius 0.5 to 1.5 thrown into a cube that grows with them, above a floor.
std::string script(const char* solid, int count) {
    const bool torus = std::strcmp(solid, "torus") == 0;
    const std::string make =
        torus ? "gr.nh_torus('t', {0,0,0}, r, 0.4 * r)" : "gr.nh_sphere('s', {0,0,0}, r)";
    return "math.randomseed(1)\nlocal u = math.random\nroot = gr.node('root')\n"
           "m = gr.material({0.6, 0.5, 0.4}, {0.5, 0.5, 0.5}, 60)\n"
           "local n = " +
           std::to_string(count) +
           "\nlocal side = 2.5 * n ^ (1 / 3)\n"
           "for i = 1, n do\n local r = 0.5 + u()\n local s = " +
           make +
           "\n s:rotate('x', 360 * u()); s:rotate('y', 360 * u())\n"
           " s:translate(side * (u() - 0.5), side * (u() - 0.5), side * (u() - 0.5))\n"
           " root:add_child(s, m)\nend\n"
           "root:add_child(gr.nh_box('f', {-100 * side, -side, -100 * side}, "
           "{200 * side, 0.3 * side, 200 * side}), m)\n"
           "gr.render(root, 'x.png', 320, 180, {0, 0.5 * side, 2 * side}, {0, -0.5, -2}, {0, 1, "
           "0}, "
           "40, {0.1, 0.1, 0.1}, {gr.light({3 * side, 9 * side, 6 * side}, {1, 1, 1}, {1, 0, 0})})";
}

void benchScene(const TraceKernel& kernel, const char* solid, int count) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                       ("scene_bench_" + std::to_string(std::random_device()()));
    std::ofstream(path) << script(solid, count);
    Diagnostics diagnostics;
    ScriptSettings limits;
    const SceneDesc described = runScript(path.string(), limits, diagnostics).scene;
    std::filesystem::remove(path);
    AssetCache assets(1);
    const RenderScene scene = compileScene(described, 0, {}, assets, diagnostics);

    TraceSettings settings;
    settings.spp = 4;
    const Tile tile{0, 0, scene.width, scene.height};
    const auto pixelCount = static_cast<std::size_t>(scene.width * scene.height);
    const std::vector<std::uint32_t> ends(pixelCount, 4);
    TraceCounts counts;
    const double seconds = medianSeconds([&] {
        std::vector<PixelState> pixels(pixelCount);
        counts = {};
        kernel.renderTile(scene, settings, tile, ends.data(), pixels.data(), counts);
    });
    const auto rays = static_cast<double>(counts.rays.camera + counts.rays.shadow);
    std::printf("%-10s %8d %8.1f ns a ray, %.0f rays, shading included\n", solid, count,
                1e9 * seconds / rays, rays);
}

}  // namespace

int main(int argc, char** argv) {
    std::string isa;
    int most = 100'000;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--isa") == 0 && i + 1 < argc) {
            isa = argv[++i];
        } else {
            most = std::atoi(argv[i]);
        }
    }
    const TraceKernel& kernel = chooseKernel(isa);
    std::printf("instruction set: %s; medians of %d rounds\n", kernel.name, kRounds);
    benchKinds(kernel);
    for (const char* solid : {"sphere", "torus"}) {
        for (int count = 1; count <= most; count *= 10) benchScene(kernel, solid, count);
    }
}
