// Nanoseconds a call of the portable functions beside those of libm, over the same arguments.
#include <benchmark/benchmark.h>

#include <dlfcn.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "rt/math/portable.h"

namespace {

constexpr std::size_t kArguments = 1024;

std::vector<double> uniformArguments(double low, double high, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> distribution(low, high);
    std::vector<double> arguments(kArguments);
    for (double& x : arguments) x = distribution(engine);
    return arguments;
}

void countCalls(benchmark::State& state) {
    state.counters["per_call"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * static_cast<double>(kArguments),
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void unary(benchmark::State& state, double (*function)(double), double low, double high) {
    const std::vector<double> x = uniformArguments(low, high, 1);
    for (auto _ : state) {
        double sum = 0.0;
        for (std::size_t i = 0; i < kArguments; ++i) sum += function(x[i]);
        benchmark::DoNotOptimize(sum);
    }
    countCalls(state);
}

void binary(benchmark::State& state, double (*function)(double, double), double range, double low,
            double high) {
    const std::vector<double> x = uniformArguments(range, 1, 1);
    const std::vector<double> y = uniformArguments(low, high, 2);
    for (auto _ : state) {
        double sum = 0.0;
        for (std::size_t i = 0; i < kArguments; ++i) sum += function(x[i], y[i]);
        benchmark::DoNotOptimize(sum);
    }
    countCalls(state);
}

/// libm's own function: the program's references to it are redirected when it is linked.
template <class Function>
Function fromLibm(const std::string& name) {
    static void* const library = dlopen("libm.so.6", RTLD_NOW);
    void* const symbol = library ? dlsym(library, name.c_str()) : nullptr;
    if (!symbol) throw std::runtime_error("libm has no " + name);
    return reinterpret_cast<Function>(symbol);
}

using UnaryFunction = double (*)(double);
using BinaryFunction = double (*)(double, double);

struct Unary {
    const char* name;
    const char* libm;
    UnaryFunction portable;
    double low;
    double high;
};

struct Binary {
    const char* name;
    const char* libm;
    BinaryFunction portable;
    double xLow;
    double yLow;
    double yHigh;
};

namespace own = rt::portable;

double sincosSum(double x) {
    const own::SinCos both = own::sincos(x);
    return both.sin + both.cos;
}

constexpr Unary kUnary[] = {
    {"sin", "sin", own::sin, -7, 7},
    {"cos", "cos", own::cos, -7, 7},
    {"sincos", "sin", sincosSum, -7, 7},
    {"sin_huge", "sin", own::sin, 1e20, 1e30},
    {"sinDegrees", "sin", own::sinDegrees, -350, 350},
    {"tan", "tan", own::tan, -7, 7},
    {"asin", "asin", own::asin, -1, 1},
    {"acos", "acos", own::acos, -1, 1},
    {"atan", "atan", own::atan, -3, 3},
    {"exp", "exp", own::exp, -20, 20},
    {"exp2", "exp2", own::exp2, -20, 20},
    {"log", "log", own::log, 0, 10},
    {"log2", "log2", own::log2, 0, 10},
    {"log10", "log10", own::log10, 0, 10},
    {"cbrt", "cbrt", own::cbrt, 0, 10},
    {"sinh", "sinh", own::sinh, -3, 3},
    {"cosh", "cosh", own::cosh, -3, 3},
    {"tanh", "tanh", own::tanh, -3, 3},
};

constexpr Binary kBinary[] = {
    {"atan2", "atan2", own::atan2, -1, -1, 1},
    {"pow", "pow", own::pow, 0, 0, 100},
    {"powUnit", "pow", own::powUnit, 0, 0, 100},
    {"hypot", "hypot", own::hypot, -1, -1, 1},
};

[[maybe_unused]] const bool kRegistered = [] {
    for (const Unary& f : kUnary) {
        const std::string name = f.name;
        benchmark::RegisterBenchmark(("libm/" + name).c_str(), unary,
                                     fromLibm<UnaryFunction>(f.libm), f.low, f.high);
        benchmark::RegisterBenchmark(("portable/" + name).c_str(), unary, f.portable, f.low,
                                     f.high);
    }
    for (const Binary& f : kBinary) {
        const std::string name = f.name;
        benchmark::RegisterBenchmark(("libm/" + name).c_str(), binary,
                                     fromLibm<BinaryFunction>(f.libm), f.xLow, f.yLow, f.yHigh);
        benchmark::RegisterBenchmark(("portable/" + name).c_str(), binary, f.portable, f.xLow,
                                     f.yLow, f.yHigh);
    }
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
