#include "rt/geometry/torus.h"

#include "rt/core/numeric.h"
#include "rt/math/portable.h"
#include "torus_line.h"
#include "torus_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace rt {
namespace {

using torus::Line;
using torus::Search;
using torus::Sheet;
using torus::Window;

constexpr Index kOuterSheet = 0;
constexpr Index kLemon = 1;

/// For directions so short or long that their powers would leave the doubles: the same with the
/// direction scaled by a power of two.
bool intersectRescaled(const Torus& torus, const Ray& ray, Interval range, PrimitiveHit& hit) {
    const Vec3 size = glm::abs(ray.direction);
    if (!(size.x < kInfinity && size.y < kInfinity && size.z < kInfinity)) return false;
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) return false;
    int exponent = 0;
    std::frexp(longest, &exponent);
    const Vec3 direction(std::ldexp(ray.direction.x, -exponent),
                         std::ldexp(ray.direction.y, -exponent),
                         std::ldexp(ray.direction.z, -exponent));
    const Interval scaled{std::ldexp(range.min, exponent), std::ldexp(range.max, exponent)};
    PrimitiveHit found;
    if (!torus.intersect({ray.origin, direction}, scaled, found)) return false;
    found.t = std::ldexp(found.t, -exponent);
    if (!range.contains(found.t)) return false;
    hit = found;
    return true;
}

/// Narrows [from, to] to where |f + s d| <= limit, one coordinate. A NaN, from a line in the very
/// face, narrows nothing.
void clipToSlab(double f, double d, double limit, double& from, double& to) {
    const double perD = 1.0 / d;
    const double a = (-limit - f) * perD;
    const double b = (limit - f) * perD;
    const double first = b < a ? b : a;
    const double last = b < a ? a : b;
    if (first > from) from = first;
    if (last < to) to = last;
}

/// The angle of (x, y) in turns, in [0, 1).
double turns(double y, double x) {
    const double angle = portable::atan2(y, x) / (2.0 * std::numbers::pi);
    const double positive = angle < 0.0 ? angle + 1.0 : angle;
    return positive < 1.0 ? positive : 0.0;
}

/// The stretch of the line inside the sphere of radius R + r and between the planes z = -r and r,
/// a little widened, so that its ends are outside the torus. False where there is none, or where it
/// passes through the hole.
bool enclose(const Line& line, double major, double minor, double perDd, double& from, double& to) {
    const Vec3& f = line.foot;
    const Vec3& d = line.direction;
    const double outer = major + minor;
    const double slack = outer * kTorusSlack;
    const double reach = outer + slack;
    const double h = std::fma(f.x, d.x, std::fma(f.y, d.y, f.z * d.z));
    const double away = std::fma(f.x, f.x, std::fma(f.y, f.y, f.z * f.z));
    const double chord = std::fma(h, h, line.directionSquared * (reach * reach - away));
    if (!(chord > 0.0)) return false;
    const double root = std::sqrt(chord);
    from = (-h - root) * perDd;
    to = (-h + root) * perDd;
    clipToSlab(f.z, d.z, minor + slack, from, to);
    if (!(from < to)) return false;
    const double hole = major - minor - slack;
    return !(hole > 0.0 && line.axisDistanceSquared(from) < hole * hole &&
             line.axisDistanceSquared(to) < hole * hole);
}

}  // namespace

Torus::Torus(const Vec3& centre, double majorRadius, double minorRadius)
    : centre_(centre), major_(majorRadius), minor_(minorRadius) {
    if (!(major_ > 0.0 && major_ < kInfinity && minor_ > 0.0 && minor_ < kInfinity)) {
        std::ostringstream message;
        message << "torus: the radii must be positive and finite, got major " << major_
                << ", minor " << minor_;
        throw std::invalid_argument(message.str());
    }
    int exponent = 0;
    std::frexp(std::max(major_, minor_), &exponent);
    unit_ = std::ldexp(1.0, exponent);
    perUnit_ = std::ldexp(1.0, -exponent);
    scaledMajor_ = major_ * perUnit_;
    scaledMinor_ = minor_ * perUnit_;
}

Bounds Torus::bounds() const {
    const double across = std::nextafter(major_ + minor_, kInfinity);
    const Vec3 reach(across, across, minor_);
    Bounds box{centre_ - reach, centre_ + reach};
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::nextafter(box.min[axis], -kInfinity);
        box.max[axis] = std::nextafter(box.max[axis], kInfinity);
    }
    return box;
}

bool Torus::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    const Vec3& d = ray.direction;
    const double dd = std::fma(d.x, d.x, std::fma(d.y, d.y, d.z * d.z));
    if (!(kTorusLeastSpeed < dd && dd < 1.0 / kTorusLeastSpeed)) {
        return intersectRescaled(*this, ray, range, hit);
    }
    const TwoTerms qx = exactDifference(ray.origin.x, centre_.x);
    const TwoTerms qy = exactDifference(ray.origin.y, centre_.y);
    const TwoTerms qz = exactDifference(ray.origin.z, centre_.z);
    const double along = std::fma(qx.value, d.x, std::fma(qy.value, d.y, qz.value * d.z));
    const double perDd = 1.0 / dd;
    const double tFoot = -along * perDd;
    const Vec3 foot((std::fma(tFoot, d.x, qx.value) + qx.error) * perUnit_,
                    (std::fma(tFoot, d.y, qy.value) + qy.error) * perUnit_,
                    (std::fma(tFoot, d.z, qz.value) + qz.error) * perUnit_);

    const Line line(foot, d, dd);
    double from = 0.0;
    double to = 0.0;
    if (!enclose(line, scaledMajor_, scaledMinor_, perDd, from, to)) return false;
    const Window window{tFoot, unit_, range};
    if (window.startsAfter(to) || window.endsBefore(from)) return false;

    const Sheet sheet(line, scaledMajor_, scaledMinor_);
    Search outside(sheet, window);
    bool found = outside.between(from, to);
    double s = outside.root();
    Index part = kOuterSheet;
    if (scaledMinor_ > scaledMajor_ && window.startsAfter(from)) {
        // Only from within the outer sheet is the inner one met first.
        const Sheet lemon(line, -scaledMajor_, scaledMinor_);
        Window before = window;
        if (found) before.range.max = window.t(s);
        Search inside(lemon, before);
        if (inside.between(from, to)) {
            s = inside.root();
            part = kLemon;
            found = true;
        }
    }
    if (!found) return false;
    hit.t = window.t(s);
    hit.local = line.at(s) * unit_;
    hit.part = part;
    return true;
}

SurfacePoint Torus::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    // The lemon is the part of the tube beyond the axis: its meridian is seen from there.
    const double side = hit.part == kLemon ? -1.0 : 1.0;
    const Vec3 p = hit.local * perUnit_;
    const double rho = std::sqrt(std::fma(p.x, p.x, p.y * p.y));
    const double cosine = rho > 0.0 ? p.x / rho : 1.0;
    const double sine = rho > 0.0 ? p.y / rho : 0.0;
    const double radial = rho - side * scaledMajor_;
    const double fromCircle = std::sqrt(std::fma(radial, radial, p.z * p.z));
    // A tube far thinner than the roundings of R has no side.
    const double across = fromCircle > 0.0 ? radial / fromCircle : 1.0;
    const double up = fromCircle > 0.0 ? p.z / fromCircle : 0.0;

    SurfacePoint at;
    at.point = centre_ + hit.local;
    const double residual = std::fabs(fromCircle - scaledMinor_);
    const double inside = residual + kTorusPointError * (scaledMajor_ + scaledMinor_ + residual);
    at.error = inside * unit_ +
               gamma(2) * (std::fabs(at.point.x) + std::fabs(at.point.y) + std::fabs(at.point.z));
    at.normal = side * Vec3(cosine * across, sine * across, up);
    at.shadingNormal = at.normal;
    at.shadowOrigin = at.point;
    if (detail == SurfaceDetail::kShape) return at;
    const double turn = 2.0 * std::numbers::pi * unit_;
    at.uv = Vec2(turns(p.y, p.x), turns(p.z, side * radial));
    at.dpdu = turn * Vec3(-p.y, p.x, 0.0);
    at.dpdv = turn * side * Vec3(-p.z * cosine, -p.z * sine, radial);
    return at;
}

}  // namespace rt
