// Loading OBJ files, and building their trees: a wavy grid of shared vertices, as scanned and
// modelled meshes are.
#include "rt/accel/mesh_tree.h"
#include "rt/compile/mesh_file.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

/// Two triangles a cell; `withNormals` writes vn and v//n corners.
std::string writeGrid(int cells, bool withNormals) {
    const std::string path =
        (std::filesystem::temp_directory_path() / ("obj_bench_" + std::to_string(cells) + ".obj"))
            .string();
    std::FILE* file = std::fopen(path.c_str(), "w");
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            const double height = 3.0 * std::sin(0.05 * x) * std::cos(0.07 * y);
            std::fprintf(file, "v %.6f %.6f %.6f\n", 0.1 * x, height, 0.1 * y);
            if (withNormals) std::fprintf(file, "vn %.6f %.6f %.6f\n", 0.01 * height, 1.0, 0.02);
        }
    }
    const char* form = withNormals ? "f %d//%d %d//%d %d//%d\n" : "f %d %d %d\n";
    const auto face = [&](int a, int b, int c) {
        if (withNormals) {
            std::fprintf(file, form, a, a, b, b, c, c);
        } else {
            std::fprintf(file, form, a, b, c);
        }
    };
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const int corner = y * (cells + 1) + x + 1;
            face(corner, corner + cells + 1, corner + 1);
            face(corner + 1, corner + cells + 1, corner + cells + 2);
        }
    }
    std::fclose(file);
    return path;
}

void loadGrid(benchmark::State& state) {
    const std::string path = writeGrid(static_cast<int>(state.range(0)), state.range(1) != 0);
    rt::MeshOptions options;
    options.smoothAngleDegrees = static_cast<double>(state.range(2));
    options.threads = static_cast<int>(state.range(3));
    std::size_t triangles = 0;
    for (auto _ : state) {
        rt::Diagnostics diagnostics;
        triangles = rt::loadObj(path, options, diagnostics).triangles.size();
    }
    state.counters["triangles"] = static_cast<double>(triangles);
    std::filesystem::remove(path);
}

void buildTree(benchmark::State& state) {
    const std::string path = writeGrid(static_cast<int>(state.range(0)), false);
    rt::Diagnostics diagnostics;
    const rt::TriangleMesh mesh = rt::loadObj(path, {}, diagnostics);
    for (auto _ : state) {
        benchmark::DoNotOptimize(rt::MeshTree::build(mesh, static_cast<int>(state.range(1))));
    }
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    std::filesystem::remove(path);
}

}  // namespace

BENCHMARK(loadGrid)
    ->ArgNames({"cells", "vn", "smooth", "threads"})
    ->Args({500, 0, 0, 1})
    ->Args({500, 0, 40, 1})
    ->Args({500, 1, 40, 1})
    ->Args({1414, 0, 40, 1})
    ->Args({1414, 0, 40, 2})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(buildTree)
    ->ArgNames({"cells", "threads"})
    ->Args({1414, 1})
    ->Args({1414, 2})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
