// What holds for every solid, and random rays to hold it against. A Model describes one solid
// twice: as the class under test, and in quadruple precision by the formulas of the textbooks:
//
//     Solid solid() const;                       the class under test
//     Vec3 anchor() const;                       what hit.local is relative to
//     Vec3 centre() const; double size() const;  a ball that contains the solid
//     Crossings crossings(const QuadRay&) const; all crossings of the whole line
//     Quad distance(const QuadVec& p) const;     to the surface; p relative to the anchor
//     Model scaled(double by) const;
#pragma once

#include "rt/core/numeric.h"
#include "rt/geometry/hit.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rt::test {

using Quad = __float128;

struct QuadVec {
    Quad x, y, z;

    explicit QuadVec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
    QuadVec(Quad px, Quad py, Quad pz) : x(px), y(py), z(pz) {}
};

inline QuadVec operator+(const QuadVec& a, const QuadVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline QuadVec operator*(Quad s, const QuadVec& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Quad dot(const QuadVec& a, const QuadVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Quad magnitude(Quad a) {
    return a < 0 ? -a : a;
}
inline Quad squareRoot(Quad a) {
    if (!(a > 0)) return 0;
    Quad root = std::sqrt(static_cast<double>(a));
    for (int i = 0; i < 3; ++i) root = (root + a / root) / 2;
    return root;
}
inline Quad length(const QuadVec& a) {
    return squareRoot(dot(a, a));
}

/// Relative to the model's anchor.
struct QuadRay {
    QuadVec origin;
    QuadVec direction;

    QuadVec at(Quad t) const { return origin + t * direction; }
};

struct QuadCrossing {
    Quad t;
    Quad cosine;  ///< of the angle between direction and normal
    Index part;
    QuadVec normal;
};

/// All crossings of a line, and the shortest shift of it that could change them.
struct Crossings {
    std::vector<QuadCrossing> found;
    Quad margin = 1e300;

    void doubtful(Quad by) { margin = std::min(margin, magnitude(by)); }
    void add(const QuadRay& ray, Quad t, Index part, const QuadVec& normal) {
        const QuadVec n = (1 / length(normal)) * normal;
        const Quad cosine = magnitude(dot(n, ray.direction)) / length(ray.direction);
        found.push_back({t, cosine, part, n});
    }
};

inline QuadRay quadRay(const Ray& ray, const Vec3& anchor) {
    return {QuadVec(ray.origin) - QuadVec(anchor), QuadVec(ray.direction)};
}

/// Roots of a t^2 + 2 b t + c, in order.
inline std::vector<Quad> quadraticRoots(Quad a, Quad b, Quad c) {
    if (a == 0) return b == 0 ? std::vector<Quad>{} : std::vector<Quad>{-c / (2 * b)};
    const Quad discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Quad root = squareRoot(discriminant);
    const Quad t1 = (-b - root) / a;
    const Quad t2 = (-b + root) / a;
    return {std::min(t1, t2), std::max(t1, t2)};
}

class Draws {
  public:
    explicit Draws(unsigned seed) : random_(seed) {}

    double uniform(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random_);
    }
    double powerOfTen(double a, double b) { return std::pow(10.0, uniform(a, b)); }
    bool chance(double p) { return uniform(0, 1) < p; }
    Vec3 unit() {
        std::normal_distribution<double> gauss;
        return glm::normalize(Vec3(gauss(random_), gauss(random_), gauss(random_)));
    }
    Vec3 inBall(const Vec3& centre, double radius) {
        return centre + radius * std::cbrt(uniform(0, 1)) * unit();
    }
    /// Of any length, some along axes and planes with zeros of both signs.
    Vec3 direction() {
        Vec3 d = unit();
        if (chance(0.3)) {
            for (int axis = 0; axis < 3; ++axis) {
                if (chance(0.5)) d[axis] = chance(0.5) ? 0.0 : -0.0;
            }
            if (d == Vec3(0.0)) d.y = chance(0.5) ? 1.0 : -1.0;
        }
        return chance(0.3) ? powerOfTen(-6, 6) * d : d;
    }

  private:
    std::mt19937 random_;
};

/// Towards the solid from outside, from far outside, or from within.
template <class Model>
Ray randomRay(const Model& model, Draws& draws) {
    const Vec3 d = draws.direction();
    const double away = draws.chance(0.25)   ? draws.uniform(-1, 1)
                        : draws.chance(0.25) ? draws.powerOfTen(2, 9)
                                             : draws.uniform(1.2, 20);
    const Vec3 aim = draws.inBall(model.centre(), 1.2 * model.size());
    return {aim - away * model.size() / glm::length(d) * d, d};
}

inline double largestOf(const Vec3& v) {
    return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

constexpr int kRays = 4000;

/// E <= 4 (the project's bar; 8 for cones), and the local point to some roundings of the size.
template <class Model>
void checkAgainstOracle(const Model& model, const Ray& ray, double worst) {
    const QuadRay exact = quadRay(ray, model.anchor());
    Crossings all = model.crossings(exact);
    const Quad magnitudes =
        std::max(largestOf(ray.origin), largestOf(model.centre()) + model.size());
    const Quad speed = length(exact.direction);
    const QuadCrossing* expected = nullptr;
    for (const QuadCrossing& crossing : all.found) {
        all.doubtful(crossing.t * speed * crossing.cosine);
        if (crossing.t > 0 && (!expected || crossing.t < expected->t)) expected = &crossing;
    }
    if (all.margin < 64 * kUnitRoundoff * magnitudes) return;

    PrimitiveHit hit;
    const bool found = model.solid().intersect(ray, {0.0, kInfinity}, hit);
    REQUIRE(found == (expected != nullptr));
    if (!expected) return;
    const Quad noise = kUnitRoundoff * (magnitudes + expected->t * speed);
    CHECK(static_cast<double>(magnitude(hit.t - expected->t) * speed * expected->cosine / noise) <=
          worst);
    CHECK(hit.part == expected->part);
    const Quad off = length(QuadVec(hit.local) - exact.at(expected->t));
    CHECK(static_cast<double>(off * expected->cosine / (kUnitRoundoff * model.size())) <=
          2.0 * worst);
    const Vec3 normal = model.solid().surface(hit).normal;
    CHECK(static_cast<double>(length(QuadVec(normal) - expected->normal) * expected->cosine) <=
          64.0 * kUnitRoundoff *
              static_cast<double>(model.size() / model.sharpest(*expected, exact)));
}

/// Point, error, normals and texture frame fit together.
template <class Model>
void checkSurface(const Model& model, const Ray& ray) {
    PrimitiveHit hit;
    if (!model.solid().intersect(ray, {}, hit)) return;
    const SurfacePoint at = model.solid().surface(hit);
    const Quad off = model.distance(QuadVec(at.point) - QuadVec(model.anchor()));
    CHECK(static_cast<double>(off) <= at.error);
    CHECK(at.error <= 24.0 * kUnitRoundoff * (model.size() + largestOf(model.centre())));
    CHECK(std::fabs(glm::length(at.normal) - 1.0) <= 4.0 * kUnitRoundoff);
    CHECK(at.shadingNormal == at.normal);
    CHECK(at.shadowOrigin == at.point);
    CHECK((at.uv.x >= 0.0 && at.uv.x <= 1.0 && at.uv.y >= 0.0 && at.uv.y <= 1.0));
    CHECK(isFinite(at.dpdu));
    CHECK(isFinite(at.dpdv));
    const double lengths = glm::length(at.dpdu) * glm::length(at.dpdv);
    if (lengths > 0.0) {
        const Vec3 outward = glm::cross(at.dpdu, at.dpdv) / lengths;
        CHECK(glm::dot(outward, at.normal) >= 0.99 * glm::length(outward));
    }
    const Bounds box = model.solid().bounds();
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(at.point[axis] >= box.min[axis] - at.error);
        CHECK(at.point[axis] <= box.max[axis] + at.error);
    }
}

/// Ranges are open: a crossing at an end does not count, and beyond it the next one is found.
template <class Model>
void checkRange(const Model& model, const Ray& ray) {
    PrimitiveHit first;
    if (!model.solid().intersect(ray, {}, first)) return;
    PrimitiveHit hit;
    CHECK(!model.solid().intersect(ray, {0.0, first.t}, hit));
    CHECK(model.solid().intersect(ray, {0.0, std::nextafter(first.t, kInfinity)}, hit));
    CHECK(hit.t == first.t);
    if (model.solid().intersect(ray, {first.t, kInfinity}, hit)) CHECK(hit.t > first.t);
    CHECK(model.solid().intersect(ray, {std::nextafter(first.t, 0.0), kInfinity}, hit));
    CHECK(hit.t == first.t);
    CHECK(!model.solid().intersect(ray, {first.t, first.t}, hit));
    const double nan = std::nan("");
    CHECK(!model.solid().intersect(ray, {nan, kInfinity}, hit));
}

/// Powers of two change no digit, neither of the scene's scale nor of the direction's length, also
/// where squares would leave the range of double.
template <class Model>
void checkScales(const Model& model, const Ray& ray) {
    PrimitiveHit expected;
    const bool found = model.solid().intersect(ray, {}, expected);
    for (const int exponent : {-400, -150, -20, 20, 150, 400}) {
        const double by = std::ldexp(1.0, exponent);
        PrimitiveHit hit;
        const Model scaled = model.scaled(by);
        REQUIRE(scaled.solid().intersect({by * ray.origin, by * ray.direction}, {}, hit) == found);
        if (!found) continue;
        CHECK(hit.t == expected.t);
        CHECK(hit.local == by * expected.local);
        REQUIRE(model.solid().intersect({ray.origin, by * ray.direction}, {}, hit));
        CHECK(by * hit.t == expected.t);
        CHECK(hit.local == expected.local);
        CHECK(hit.part == expected.part);
        const SurfacePoint at =
            scaled.solid().surface({expected.t, by * expected.local, expected.part});
        CHECK(glm::distance(at.normal, model.solid().surface(expected).normal) <=
              8.0 * kUnitRoundoff);
    }
}

/// Every law on random models of all sizes; `draw(draws, size, centre)` makes one.
template <class Draw>
void checkLaws(const Draw& draw, double worst = 4.0) {
    for (unsigned seed = 1; seed <= kRays; ++seed) {
        CAPTURE(seed);
        Draws draws(seed);
        const double size = draws.chance(0.3) ? draws.powerOfTen(-6, 6) : draws.uniform(0.3, 3.0);
        const double offset = draws.chance(0.2) ? 1e4 * size : draws.uniform(0, 5) * size;
        const Vec3 centre = draws.chance(0.2) ? Vec3(0.0) : offset * draws.unit();
        const auto model = draw(draws, size, centre);
        const Ray ray = randomRay(model, draws);
        checkAgainstOracle(model, ray, worst);
        checkSurface(model, ray);
        checkRange(model, ray);
        checkScales(model, ray);
    }
}

/// Rays that no answer is expected of, but neither a NaN.
template <class Solid>
void checkNothingIsNan(const Solid& solid) {
    const double values[] = {0.0,   -0.0,  1.0,    -1.0,      1e-310,       5e-324,
                             1e308, 1e-20, -1e160, kInfinity, std::nan(""), 0.5};
    Draws draws(1);
    constexpr int kValues = static_cast<int>(std::size(values));
    const auto any = [&] {
        return values[std::min(kValues - 1, static_cast<int>(draws.uniform(0, kValues)))];
    };
    for (int i = 0; i < 20000; ++i) {
        const Ray ray{Vec3(any(), any(), any()), Vec3(any(), any(), any())};
        CAPTURE(i);
        PrimitiveHit hit;
        if (!solid.intersect(ray, {}, hit)) continue;
        CHECK(std::isfinite(hit.t));
        CHECK(isFinite(hit.local));
        const SurfacePoint at = solid.surface(hit);
        CHECK(isFinite(at.point));
        CHECK(std::isfinite(at.error));
        CHECK(std::fabs(glm::length(at.normal) - 1.0) <= 4.0 * kUnitRoundoff);
        CHECK((at.uv.x >= 0.0 && at.uv.x <= 1.0 && at.uv.y >= 0.0 && at.uv.y <= 1.0));
        CHECK(isFinite(at.dpdu));
        CHECK(isFinite(at.dpdv));
    }
}

}  // namespace rt::test
