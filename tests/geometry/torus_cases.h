// Tori and rays to try them with, shared by the tests of the torus.
#pragma once

#include "rt/core/numeric.h"
#include "rt/geometry/torus.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rt::test {

inline constexpr Interval kWholeLine{-kInfinity, kInfinity};

struct Case {
    Vec3 centre{0.0};
    double major = 1.0;
    double minor = 0.25;
    Ray ray;

    Torus torus() const { return {centre, major, minor}; }
    double size() const { return major + minor; }
    /// The largest coordinate that the answer is computed from.
    double magnitude() const {
        const Vec3 far = glm::max(glm::abs(ray.origin), glm::abs(centre) + size());
        return std::max({far.x, far.y, far.z});
    }
};

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double uniform(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(engine_);
    }
    double power(double from, double to) { return std::pow(10.0, uniform(from, to)); }
    Vec3 direction() {
        std::normal_distribution<double> gauss;
        return glm::normalize(Vec3{gauss(engine_), gauss(engine_), gauss(engine_)});
    }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }

    /// Any size, place and proportion; a ray of any length and start, aimed at the torus.
    Case any() {
        Case c;
        const double scale = power(-6.0, 6.0);
        const double far[] = {0.0, 1.0, 1e4};
        const double ratios[] = {uniform(0.05, 0.95), power(-5.0, -2.0), uniform(1.01, 4.0),
                                 1.0 + uniform(-1.0, 1.0) * power(-15.0, -2.0)};
        c.centre = scale * far[below(3)] * direction();
        c.major = scale;
        c.minor = scale * ratios[below(4)];
        const double steps[] = {0.5, uniform(1.0, 10.0), 1e3, 1e6};
        const double step = c.size() * steps[below(4)];
        const Vec3 towards = direction();
        c.ray.origin = c.centre + c.size() * uniform(0.0, 1.1) * direction() - step * towards;
        c.ray.direction = power(-6.0, 6.0) * towards;
        return c;
    }

  private:
    std::mt19937_64 engine_;
};

/// All crossings of the line, by asking for the nearest one beyond the last.
inline std::vector<PrimitiveHit> crossings(const Torus& torus, const Ray& ray) {
    std::vector<PrimitiveHit> all;
    Interval range = kWholeLine;
    PrimitiveHit hit;
    while (all.size() < 9 && torus.intersect(ray, range, hit)) {
        all.push_back(hit);
        range.min = hit.t;
    }
    return all;
}

inline std::vector<double> parameters(const std::vector<PrimitiveHit>& hits) {
    std::vector<double> t;
    for (const PrimitiveHit& hit : hits) t.push_back(hit.t);
    return t;
}

}  // namespace rt::test
