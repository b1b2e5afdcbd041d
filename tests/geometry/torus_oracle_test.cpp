// The torus against its quartic, solved in quadruple precision by other means.
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

using Quad = __float128;
using Polynomial = std::vector<Quad>;

Quad valueAt(const Polynomial& p, Quad x) {
    Quad sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
    return sum;
}

/// The roots in [from, to], ascending: between neighbouring roots of the derivative there is at
/// most one, and bisection finds it.
std::vector<Quad> rootsOf(const Polynomial& p, Quad from, Quad to) {
    if (p.size() < 2) return {};
    Polynomial derivative;
    for (std::size_t i = 1; i < p.size(); ++i) {
        derivative.push_back(p[i] * static_cast<Quad>(static_cast<double>(i)));
    }
    std::vector<Quad> ends{from};
    for (const Quad x : rootsOf(derivative, from, to)) ends.push_back(x);
    ends.push_back(to);
    std::vector<Quad> roots;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        Quad a = ends[i - 1];
        Quad b = ends[i];
        const bool rises = valueAt(p, a) < 0;
        if (rises == (valueAt(p, b) < 0)) continue;
        for (int k = 0; k < 110; ++k) {
            const Quad middle = (a + b) / 2;
            ((valueAt(p, middle) < 0) == rises ? a : b) = middle;
        }
        roots.push_back(a);
    }
    return roots;
}

/// The line of a case from the point nearest the centre, in units of the direction.
struct QuadLine {
    Quad origin[3];
    Quad direction[3];
    Quad foot;

    explicit QuadLine(const Case& c) {
        Quad along = 0;
        Quad square = 0;
        for (int i = 0; i < 3; ++i) {
            origin[i] = static_cast<Quad>(c.ray.origin[i]) - static_cast<Quad>(c.centre[i]);
            direction[i] = c.ray.direction[i];
            along += origin[i] * direction[i];
            square += direction[i] * direction[i];
        }
        foot = -along / square;
        for (int i = 0; i < 3; ++i) origin[i] += foot * direction[i];
    }

    Quad product(const Quad (&a)[3], const Quad (&b)[3], int axes) const {
        Quad sum = 0;
        for (int i = 0; i < axes; ++i) sum += a[i] * b[i];
        return sum;
    }

    /// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) along the line.
    Polynomial quartic(Quad major, Quad minor) const {
        const Quad a = product(direction, direction, 3);
        const Quad b = 2 * product(origin, direction, 3);
        const Quad c = product(origin, origin, 3) + (major - minor) * (major + minor);
        const Quad k = 4 * major * major;
        return {c * c - k * product(origin, origin, 2),
                2 * b * c - 2 * k * product(origin, direction, 2),
                b * b + 2 * a * c - k * product(direction, direction, 2), 2 * a * b, a * a};
    }

    Vec3 at(Quad s) const {
        return {static_cast<double>(origin[0] + s * direction[0]),
                static_cast<double>(origin[1] + s * direction[1]),
                static_cast<double>(origin[2] + s * direction[2])};
    }
};

/// How far the line may be moved before its crossings change in number.
double marginOf(const Case& c, const QuadLine& line, const Polynomial& quartic, Quad reach) {
    Polynomial derivative;
    for (std::size_t i = 1; i < quartic.size(); ++i) {
        derivative.push_back(quartic[i] * static_cast<Quad>(static_cast<double>(i)));
    }
    double margin = kInfinity;
    for (const Quad s : rootsOf(derivative, -reach, reach)) {
        const Vec3 p = line.at(s);
        for (const double circle : {c.major, -c.major}) {
            const double w = std::hypot(std::hypot(p.x, p.y) - circle, p.z);
            margin = std::min(margin, std::fabs(w - c.minor));
        }
    }
    return margin;
}

void checkAgainstQuartic(const Case& c) {
    const QuadLine line(c);
    const Polynomial quartic = line.quartic(c.major, c.minor);
    const double length = glm::length(c.ray.direction);
    const Quad reach = 2.0 * c.size() / length;
    const double noise = kUnitRoundoff * c.magnitude();
    if (marginOf(c, line, quartic, reach) < 64.0 * noise) return;
    const std::vector<Quad> expected = rootsOf(quartic, -reach, reach);
    const Torus torus = c.torus();
    const std::vector<PrimitiveHit> got = crossings(torus, c.ray);
    REQUIRE(got.size() == expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        const double off =
            static_cast<double>(static_cast<Quad>(got[i].t) - line.foot - expected[i]) * length;
        const SurfacePoint at = torus.surface(got[i]);
        const double slant = std::fabs(glm::dot(at.normal, c.ray.direction)) / length;
        const double blur = noise + kUnitRoundoff * std::fabs(got[i].t) * length;
        CHECK(std::fabs(off) * slant <= 4.0 * blur);
        const double tangent = glm::length(got[i].local - line.at(expected[i]));
        CHECK(tangent * slant <= 16.0 * kUnitRoundoff * c.size());
    }
}

TEST_CASE("crossings agree with the roots of the quartic in quadruple precision") {
    Random random(21);
    for (int i = 0; i < 1500; ++i) {
        INFO("case " << i);
        checkAgainstQuartic(random.any());
    }
}

/// Turns the ray of a case to `tangent`, through the point `local` of the surface lifted along the
/// normal.
void graze(Case& c, const Vec3& local, const Vec3& lift, const Vec3& tangent) {
    c.ray.direction = tangent;
    c.ray.origin = c.centre + local + lift - 3.0 * c.size() * tangent;
}

TEST_CASE("grazing lines agree with the roots of the quartic") {
    Random random(22);
    for (int i = 0; i < 6000; ++i) {
        INFO("case " << i);
        Case c = random.any();
        c.minor = i % 3 == 0 ? c.minor : c.major * random.uniform(0.05, 0.95);
        PrimitiveHit hit;
        if (!c.torus().intersect(c.ray, kWholeLine, hit)) continue;
        const Vec3 normal = c.torus().surface(hit).normal;
        const Vec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
        const double shallow = random.power(-14.0, -1.0) * (i % 2 == 0 ? 1.0 : -1.0);
        const double lift = i % 5 == 0 ? random.uniform(-0.6, 0.1) : shallow;
        graze(c, hit.local, lift * c.minor * normal, tangent);
        checkAgainstQuartic(c);
    }
}

TEST_CASE("lines along which a ring bends away, nearly triple roots, agree with the quartic") {
    Random random(24);
    for (int i = 0; i < 4000; ++i) {
        INFO("case " << i);
        Case c;
        c.major = random.power(-3.0, 3.0);
        c.minor = c.major * random.uniform(0.05, 0.9);
        // On the inner half the tube's curvature and the ring's have opposite signs; along the
        // direction between, f'' is 0 on the surface.
        const double turn = random.uniform(0.25, 0.75) * kTurn;
        const double rho = c.major + c.minor * std::cos(turn);
        const double bend = std::atan(std::sqrt(rho / (-std::cos(turn) * c.minor)));
        const Vec3 local(rho, 0.0, c.minor * std::sin(turn));
        const Vec3 normal(std::cos(turn), 0.0, std::sin(turn));
        const Vec3 meridian(-std::sin(turn), 0.0, std::cos(turn));
        const Vec3 tangent = std::cos(bend) * meridian + std::sin(bend) * Vec3(0.0, 1.0, 0.0);
        const Vec3 off = random.power(-12.0, -1.0) * random.direction();
        const double lift = random.uniform(-1.0, 1.0) * random.power(-12.0, -1.0);
        graze(c, local, lift * c.minor * normal, glm::normalize(tangent + off));
        checkAgainstQuartic(c);
    }
}

TEST_CASE("lines in the equator, through the axis and along it agree with the quartic") {
    Random random(23);
    const auto dyadic = [&random](int steps) { return random.below(2 * steps + 1) - steps; };
    for (int i = 0; i < 3000; ++i) {
        INFO("case " << i);
        Case c;
        const double ratios[] = {0.25, 0.5, 1.0, 1.5, 2.0};
        c.major = 1.0 + random.below(8) / 4.0;
        c.minor = c.major * ratios[random.below(5)];
        const double steps[] = {0.0, 0.25, 0.5, 1.0};
        c.ray.direction = Vec3(dyadic(2), dyadic(2), dyadic(2)) / 2.0;
        if (c.ray.direction == Vec3(0.0)) continue;
        c.ray.origin = Vec3(dyadic(4), dyadic(4), dyadic(4)) * (c.major * steps[random.below(4)]);
        checkAgainstQuartic(c);
    }
}

}  // namespace
