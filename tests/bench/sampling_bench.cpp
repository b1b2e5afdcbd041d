// Nanoseconds for the numbers of a sample, by sampler, and for filters and warps.
#include <benchmark/benchmark.h>

#include "rt/sampling/sampler.h"
#include "rt/sampling/warp.h"

namespace {

using namespace rt;

constexpr int kSamples = 64;

void lightPair(benchmark::State& state) {
    Sampler sampler({static_cast<SamplerKind>(state.range(0)), FilterKind::kBox, 1, kSamples});
    int index = 0;
    sampler.start(3, 4, 0);
    std::uint32_t light = 0;
    for (auto _ : state) {
        if (++light == 8) {
            light = 0;
            index = (index + 1) % kSamples;
            sampler.start(3, 4, index);
        }
        benchmark::DoNotOptimize(sampler.light(1, light));
    }
}

void pixelAndLens(benchmark::State& state) {
    Sampler sampler({static_cast<SamplerKind>(state.range(0)), FilterKind::kBox, 1, kSamples});
    int index = 0;
    for (auto _ : state) {
        index = (index + 1) % kSamples;
        sampler.start(3, 4, index);
        benchmark::DoNotOptimize(sampler.pixel());
        benchmark::DoNotOptimize(sampler.lens());
    }
}

void rawPair(benchmark::State& state) {
    std::uint32_t index = 0;
    for (auto _ : state) {
        index = (index + 1) % kSamples;
        benchmark::DoNotOptimize(sobolPair(index, SobolPair::kLight, 0x123456789abcdef0));
    }
}

void filterDraw(benchmark::State& state) {
    const PixelFilter& filter = PixelFilter::of(static_cast<FilterKind>(state.range(0)));
    std::uint32_t index = 0;
    for (auto _ : state) {
        index = (index + 1) % 1024;
        const UnitPoint u = sobolPair(index, SobolPair::kPixel, 0x123456789abcdef0);
        benchmark::DoNotOptimize(filter.sample({u.x, u.y}));
    }
}

void disc(benchmark::State& state) {
    std::uint32_t index = 0;
    for (auto _ : state) {
        index = (index + 1) % 1024;
        const UnitPoint u = sobolPair(index, SobolPair::kPixel, 0x123456789abcdef0);
        benchmark::DoNotOptimize(concentricDisc({u.x, u.y}));
    }
}

void cone(benchmark::State& state) {
    std::uint32_t index = 0;
    const Vec3 axis = glm::normalize(Vec3(1, 2, 3));
    for (auto _ : state) {
        index = (index + 1) % 1024;
        const UnitPoint u = sobolPair(index, SobolPair::kPixel, 0x123456789abcdef0);
        benchmark::DoNotOptimize(coneDirection(axis, 0.01, {u.x, u.y}));
    }
}

void fourSamplers(benchmark::internal::Benchmark* b) {
    for (const SamplerKind kind :
         {SamplerKind::kJoint, SamplerKind::kJitter, SamplerKind::kGrid, SamplerKind::kRandom}) {
        b->Arg(static_cast<int>(kind));
    }
}

BENCHMARK(rawPair);
BENCHMARK(lightPair)->Apply(fourSamplers);
BENCHMARK(pixelAndLens)->Apply(fourSamplers);
BENCHMARK(filterDraw)->DenseRange(0, 3);
BENCHMARK(disc);
BENCHMARK(cone);

}  // namespace

BENCHMARK_MAIN();
