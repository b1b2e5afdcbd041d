// Laws that hold for every torus and every ray.
#include "rt/core/numeric.h"
#include "rt/geometry/torus.h"
#include "torus_cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace rt;
using namespace rt::test;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Distance of a point, relative to the centre, from the surface.
double distanceToSurface(const Case& c, const Vec3& local) {
    const long double x = local.x;
    const long double y = local.y;
    const long double z = local.z;
    const long double rho = std::sqrt(x * x + y * y);
    const auto toCircle = [&](long double radius) {
        return std::fabs(std::sqrt((rho - radius) * (rho - radius) + z * z) -
                         static_cast<long double>(c.minor));
    };
    return static_cast<double>(std::min(toCircle(c.major), toCircle(-c.major)));
}

template <typename Check>
void forRandomHits(unsigned seed, int count, const Check& check) {
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        const Case c = random.any();
        INFO("seed " << seed << ", case " << i << ", R " << c.major << ", r " << c.minor);
        const Torus torus = c.torus();
        for (const PrimitiveHit& hit : crossings(torus, c.ray)) {
            ++hits;
            check(c, torus, hit);
        }
    }
    CHECK(hits > count);
}

TEST_CASE("every crossing lies on the surface to a few roundings, and the error bound holds") {
    forRandomHits(1, 4000, [](const Case& c, const Torus& torus, const PrimitiveHit& hit) {
        const double off = distanceToSurface(c, hit.local);
        CHECK(off <= 8.0 * kUnitRoundoff * c.size());
        const SurfacePoint at = torus.surface(hit);
        const double rounded = glm::length(at.point - c.centre - hit.local);
        CHECK(off + rounded <= at.error);
        const double size = c.size() + glm::length(c.centre);
        CHECK(at.error <= 32.0 * kUnitRoundoff * size);
    });
}

TEST_CASE("the crossing is where its parameter says") {
    forRandomHits(2, 2000, [](const Case& c, const Torus&, const PrimitiveHit& hit) {
        const double length = glm::length(c.ray.direction);
        const Vec3 walked = c.ray.at(hit.t) - c.centre;
        const double noise = kUnitRoundoff * (c.magnitude() + std::fabs(hit.t) * length);
        CHECK(glm::length(walked - hit.local) <= 16.0 * noise);
    });
}

TEST_CASE("normals are unit vectors along the gradient of the quartic") {
    forRandomHits(3, 2000, [](const Case& c, const Torus& torus, const PrimitiveHit& hit) {
        const SurfacePoint at = torus.surface(hit);
        CHECK(std::fabs(glm::dot(at.normal, at.normal) - 1.0) <= 16.0 * kUnitRoundoff);
        CHECK(at.shadingNormal == at.normal);
        const Vec3 p = hit.local / c.size();
        const double major = c.major / c.size();
        const double minor = c.minor / c.size();
        const double g = glm::dot(p, p) + major * major - minor * minor;
        const double turn = 2.0 * major * major;
        const Vec3 gradient(p.x * (g - turn), p.y * (g - turn), p.z * g);
        // Near the singular points of horn and spindle the gradient is lost in rounding.
        if (glm::length(gradient) < 1e-6) return;
        CHECK(glm::dot(at.normal, glm::normalize(gradient)) > 1.0 - 1e-6);
    });
}

TEST_CASE("the parametrisation leads back to the point, and its derivatives are true") {
    forRandomHits(4, 2000, [](const Case& c, const Torus& torus, const PrimitiveHit& hit) {
        const SurfacePoint at = torus.surface(hit);
        REQUIRE((at.uv.x >= 0.0 && at.uv.x < 1.0));
        REQUIRE((at.uv.y >= 0.0 && at.uv.y < 1.0));
        const double side = hit.part == 0 ? 1.0 : -1.0;
        const auto point = [&](double u, double v) {
            const double rho = side * (c.major + c.minor * std::cos(kTurn * v));
            return Vec3(rho * std::cos(kTurn * u), rho * std::sin(kTurn * u),
                        c.minor * std::sin(kTurn * v));
        };
        const double u = at.uv.x;
        const double v = at.uv.y;
        const double tolerance = 1e-14 * c.size();
        if (std::hypot(hit.local.x, hit.local.y) < 1e-6 * c.size()) return;
        CHECK(glm::length(point(u, v) - hit.local) <= tolerance);
        const double h = 1e-4;
        const Vec3 byU = (point(u + h, v) - point(u - h, v)) / (2.0 * h);
        const Vec3 byV = (point(u, v + h) - point(u, v - h)) / (2.0 * h);
        CHECK(glm::length(byU - at.dpdu) <= 1e-6 * glm::length(at.dpdu) + tolerance / h);
        CHECK(glm::length(byV - at.dpdv) <= 1e-6 * glm::length(at.dpdv) + tolerance / h);
        const Vec3 across = glm::cross(at.dpdu / c.size(), at.dpdv / c.minor);
        CHECK(glm::dot(glm::normalize(across), at.normal) > 1.0 - 1e-12);
    });
}

TEST_CASE("the bounds contain every surface point") {
    forRandomHits(5, 2000, [](const Case&, const Torus& torus, const PrimitiveHit& hit) {
        const SurfacePoint at = torus.surface(hit);
        const Bounds box = torus.bounds();
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(at.point[axis] >= box.min[axis] - at.error);
            CHECK(at.point[axis] <= box.max[axis] + at.error);
        }
    });
}

TEST_CASE("scaling the scene or the direction by a power of two scales the answer exactly") {
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        INFO("case " << i);
        const Case c = random.any();
        const double sizes[] = {0x1p-40, 0x1p-1, 0x1p300};
        const double speeds[] = {0x1p-500, 0x1p-20, 0x1p3, 0x1p400};
        const double size = sizes[random.below(3)];
        const double speed = speeds[random.below(4)];
        const Torus scaled(c.centre * size, c.major * size, c.minor * size);
        const Ray longer{c.ray.origin, c.ray.direction * speed};
        const Ray larger{c.ray.origin * size, c.ray.direction * size};
        PrimitiveHit hit;
        PrimitiveHit other;
        const bool found = c.torus().intersect(c.ray, {}, hit);
        REQUIRE(c.torus().intersect(longer, {}, other) == found);
        if (found) {
            CHECK(other.t == hit.t / speed);
            CHECK(other.local == hit.local);
        }
        REQUIRE(scaled.intersect(larger, {}, other) == found);
        if (found) {
            CHECK(other.t == hit.t);
            CHECK(other.local == hit.local * size);
        }
    }
}

TEST_CASE("the range is open at both ends") {
    forRandomHits(7, 1000, [](const Case& c, const Torus& torus, const PrimitiveHit& hit) {
        const double length = glm::length(c.ray.direction);
        const double slant =
            std::fabs(glm::dot(torus.surface(hit).normal, c.ray.direction)) / length;
        const double noise = kUnitRoundoff * (c.magnitude() + std::fabs(hit.t) * length);
        const double before = hit.t - 64.0 * noise / (slant * length);
        PrimitiveHit other;
        if (torus.intersect(c.ray, {hit.t, kInfinity}, other)) CHECK(other.t > hit.t);
        if (torus.intersect(c.ray, {before, hit.t}, other)) CHECK(other.t < hit.t);
        REQUIRE(torus.intersect(c.ray, {before, kInfinity}, other));
        CHECK(other.t <= hit.t + (hit.t - before));
        const double found = other.t;
        CHECK_FALSE(torus.intersect(c.ray, {before, found}, other));
        REQUIRE(torus.intersect(c.ray, {before, std::nextafter(found, kInfinity)}, other));
        CHECK(other.t == found);
    });
}

TEST_CASE("a line crosses the surface an even number of times, in ascending order") {
    Random random(8);
    for (int i = 0; i < 40000; ++i) {
        INFO("case " << i);
        const Case c = random.any();
        const std::vector<double> t = parameters(crossings(c.torus(), c.ray));
        CHECK(t.size() % 2 == 0);
        CHECK(t.size() <= 4);
        CHECK(std::is_sorted(t.begin(), t.end()));
    }
}

TEST_CASE("the nearest hit of any range is the first of the line's crossings in it") {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        INFO("case " << i);
        const Case c = random.any();
        const std::vector<double> all = parameters(crossings(c.torus(), c.ray));
        if (all.empty()) continue;
        const double length = glm::length(c.ray.direction);
        const double span = 3.0 * c.size() / length;
        for (int k = 0; k < 8; ++k) {
            const double from = all.front() + random.uniform(-0.5, 1.0) * span;
            const Interval range{from, from + random.uniform(0.0, 1.0) * span};
            const auto first =
                std::find_if(all.begin(), all.end(), [&](double t) { return range.contains(t); });
            PrimitiveHit hit;
            REQUIRE(c.torus().intersect(c.ray, range, hit) == (first != all.end()));
            // A grazing root moves by the root of a rounding, hence the wide tolerance.
            if (first != all.end()) CHECK(std::fabs(hit.t - *first) <= 1e-6 * span);
        }
    }
}

TEST_CASE("moving the origin away along the ray moves only the parameter") {
    const Torus torus(Vec3(0.125, -3.0, 2.5), 1.5, 0.375);
    Random random(10);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        INFO("case " << i);
        const auto dyadic = [&](double size) { return std::round(random.uniform(-size, size)); };
        const Vec3 start = Vec3(0.125, -3.0, 2.5) + Vec3(dyadic(32), dyadic(32), dyadic(32)) / 16.0;
        const Vec3 direction = Vec3(dyadic(64), dyadic(64), dyadic(64)) / 64.0;
        if (direction == Vec3(0.0)) continue;
        PrimitiveHit near;
        const bool found = torus.intersect({start, direction}, {-64.0, 1e300}, near);
        for (const double away : {0x1p10, 0x1p20, 0x1p36}) {
            PrimitiveHit far;
            const Ray moved{start - away * direction, direction};
            REQUIRE(torus.intersect(moved, {away - 64.0, 1e300}, far) == found);
            if (!found) continue;
            ++hits;
            const double slant =
                std::fabs(glm::dot(torus.surface(near).normal, direction)) / glm::length(direction);
            CHECK(slant * glm::length(far.local - near.local) <= 16.0 * kUnitRoundoff * 2.0);
            CHECK(std::fabs(far.t - away - near.t) * slant <= kUnitRoundoff * 4.0 * away);
        }
    }
    CHECK(hits > 1000);
}

TEST_CASE("a tube thinner than the roundings of its circle still gives finite answers") {
    Random random(11);
    for (const double thin : {1e-12, 1e-17, 1e-40, 1e-200}) {
        const Torus torus(Vec3(0.0), 1.0, thin);
        for (int i = 0; i < 200; ++i) {
            const double angle = random.uniform(0.0, kTurn);
            const Vec3 target(std::cos(angle), std::sin(angle), 0.0);
            const Vec3 direction = i % 4 == 0 ? -target : random.direction();
            PrimitiveHit hit;
            if (!torus.intersect({target - 3.0 * direction, direction}, {}, hit)) continue;
            const SurfacePoint at = torus.surface(hit);
            CHECK(std::isfinite(hit.t));
            CHECK(std::isfinite(at.error + at.uv.x + at.uv.y));
            CHECK(std::fabs(glm::length(at.normal) - 1.0) <= 1e-14);
        }
    }
}

}  // namespace
