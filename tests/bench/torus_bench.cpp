// What the torus costs beside the closed form of the textbooks: nearest hit and its surface point,
// through the same call. Compare within one run:
//
//     build/release/torus_bench --benchmark_enable_random_interleaving=true
//         --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
//
// The baseline is Ferrari's method as in Schwarze, Cubic and Quartic Roots, Graphics Gems, 1990:
// the quartic in the ray's own parameter, one root of the resolvent cubic, two quadratics.
#include "rt/geometry/torus.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

// The C library's own functions: the program's linker puts its portable ones in their place, and
// the baseline is to have the faster.
extern "C" {
double __real_cos(double);
double __real_acos(double);
double __real_cbrt(double);
}

namespace {

using namespace rt;

/// One root of x^3 + a x^2 + b x + c.
double cubicRoot(double a, double b, double c) {
    const double p = (b - a * a / 3.0) / 3.0;
    const double q = (2.0 / 27.0 * a * a * a - a * b / 3.0 + c) / 2.0;
    const double discriminant = q * q + p * p * p;
    if (discriminant < 0.0) {
        const double angle = __real_acos(-q / std::sqrt(-p * p * p)) / 3.0;
        return 2.0 * std::sqrt(-p) * __real_cos(angle) - a / 3.0;
    }
    const double root = std::sqrt(discriminant);
    return __real_cbrt(root - q) - __real_cbrt(root + q) - a / 3.0;
}

/// Takes over the smaller root of y^2 + b y + c whose t is in range.
void nearestOfQuadratic(double b, double c, double shift, const Interval& range, double& nearest) {
    const double discriminant = b * b / 4.0 - c;
    if (discriminant < 0.0) return;
    const double root = std::sqrt(discriminant);
    for (const double t : {-b / 2.0 - root - shift, -b / 2.0 + root - shift}) {
        if (range.contains(t) && t < nearest) nearest = t;
    }
}

/// The nearest root of t^4 + a t^3 + b t^2 + c t + d in range, infinity if there is none.
double nearestQuarticRoot(double a, double b, double c, double d, const Interval& range) {
    const double square = a * a;
    const double p = b - 3.0 / 8.0 * square;
    const double q = square * a / 8.0 - a * b / 2.0 + c;
    const double r = -3.0 / 256.0 * square * square + square * b / 16.0 - a * c / 4.0 + d;
    const double z = cubicRoot(-p / 2.0, -r, r * p / 2.0 - q * q / 8.0);
    double nearest = kInfinity;
    const double u = z * z - r;
    const double v = 2.0 * z - p;
    if (u < 0.0 || v < 0.0) return nearest;
    const double rootU = std::sqrt(u);
    const double rootV = q < 0.0 ? -std::sqrt(v) : std::sqrt(v);
    nearestOfQuadratic(rootV, z - rootU, a / 4.0, range, nearest);
    nearestOfQuadratic(-rootV, z + rootU, a / 4.0, range, nearest);
    return nearest;
}

struct Case {
    Vec3 centre;
    double major;
    double minor;
    Torus torus;
    Ray ray;
};

bool intersectFerrari(const Case& c, Interval range, PrimitiveHit& hit) {
    const Vec3 o = c.ray.origin - c.centre;
    const Vec3& d = c.ray.direction;
    const double dd = glm::dot(d, d);
    const double od = glm::dot(o, d);
    const double k = glm::dot(o, o) + c.major * c.major - c.minor * c.minor;
    const double four = 4.0 * c.major * c.major;
    const double perLeading = 1.0 / (dd * dd);
    const double t = nearestQuarticRoot(
        4.0 * dd * od * perLeading,
        (2.0 * dd * k + 4.0 * od * od - four * (d.x * d.x + d.y * d.y)) * perLeading,
        (4.0 * od * k - 2.0 * four * (o.x * d.x + o.y * d.y)) * perLeading,
        (k * k - four * (o.x * o.x + o.y * o.y)) * perLeading, range);
    if (!(t < kInfinity)) return false;
    hit.t = t;
    hit.local = o + t * d;
    hit.part = 0;
    return true;
}

bool intersectTorus(const Case& c, Interval range, PrimitiveHit& hit) {
    return c.torus.intersect(c.ray, range, hit);
}

Vec3 randomUnit(std::mt19937_64& random) {
    std::normal_distribution<double> gauss;
    return glm::normalize(Vec3(gauss(random), gauss(random), gauss(random)));
}

/// Ring tori of all proportions, rays from outside aimed at a ball a fifth larger than the torus.
std::vector<Case> typicalCases() {
    std::mt19937_64 random(1);
    const auto uniform = [&random](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    std::vector<Case> cases;
    for (int i = 0; i < 4096; ++i) {
        const double major = uniform(0.3, 3.0);
        const double minor = major * uniform(0.05, 0.8);
        const double size = major + minor;
        const Vec3 centre(uniform(-5, 5), uniform(-5, 5), uniform(-5, 5));
        const Vec3 origin = centre + size * uniform(1.2, 20.0) * randomUnit(random);
        const Vec3 aim = centre + 1.2 * size *
                                      std::max({uniform(0, 1), uniform(0, 1), uniform(0, 1)}) *
                                      randomUnit(random);
        cases.push_back(
            {centre, major, minor, Torus(centre, major, minor), {origin, aim - origin}});
    }
    return cases;
}

enum class Which { kAll, kHits, kMisses };

std::vector<Case> select(Which which) {
    std::vector<Case> chosen;
    for (const Case& c : typicalCases()) {
        PrimitiveHit hit;
        const bool hits = intersectTorus(c, {}, hit);
        if (which == Which::kAll || hits == (which == Which::kHits)) chosen.push_back(c);
    }
    return chosen;
}

template <bool (*kIntersect)(const Case&, Interval, PrimitiveHit&)>
void nearestHit(benchmark::State& state, Which which) {
    const std::vector<Case> cases = select(which);
    double sum = 0.0;
    for (auto _ : state) {
        for (const Case& c : cases) {
            PrimitiveHit hit;
            if (!kIntersect(c, {}, hit)) continue;
            const SurfacePoint at = c.torus.surface(hit);
            sum += hit.t + at.normal.x;
        }
    }
    benchmark::DoNotOptimize(sum);
    state.counters["ns_per_ray"] = benchmark::Counter(
        static_cast<double>(cases.size()) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void ferrari(benchmark::State& state, Which which) {
    nearestHit<intersectFerrari>(state, which);
}
void torus(benchmark::State& state, Which which) {
    nearestHit<intersectTorus>(state, which);
}

BENCHMARK_CAPTURE(ferrari, all, Which::kAll);
BENCHMARK_CAPTURE(torus, all, Which::kAll);
BENCHMARK_CAPTURE(ferrari, hits, Which::kHits);
BENCHMARK_CAPTURE(torus, hits, Which::kHits);
BENCHMARK_CAPTURE(ferrari, misses, Which::kMisses);
BENCHMARK_CAPTURE(torus, misses, Which::kMisses);

}  // namespace

BENCHMARK_MAIN();
