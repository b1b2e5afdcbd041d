#include "rt/geometry/quadric.h"

#include "solid_frame.h"
#include "solid_texture.h"

#include <array>
#include <stdexcept>

namespace rt {
namespace {

constexpr Index kSurface = 0;
constexpr Index kFirstFace = 1;
/// Damped steps to the quadric's middle, each of which mends what the one before it left.
constexpr int kAnchorPasses = 3;
/// Of Newton's, which double the digits: from a quarter of the way to the other root to all of
/// them.
constexpr int kMostSteps = 6;

/// A sum of products in twice the precision (Ogita, Rump, Oishi 2005, algorithm 5.3).
class ExactSum {
  public:
    void add(double a, double b) {
        const TwoTerms product = exactProduct(a, b);
        add(product.value);
        rest_ += product.error;
    }
    void add(double a) {
        const TwoTerms sum = exactSum(value_, a);
        value_ = sum.value;
        rest_ += sum.error;
    }
    double rounded() const { return value_ + rest_; }
    double rest() const { return (value_ - rounded()) + rest_; }

  private:
    double value_ = 0.0;
    double rest_ = 0.0;
};

CentredQuadric centredAt(const QuadricCoefficients& k, const Vec3& m) {
    CentredQuadric q;
    q.diagonal = Vec3(k.xx, k.yy, k.zz);
    q.mixed = 0.5 * Vec3(k.yz, k.zx, k.xy);
    const Vec3 half = 0.5 * Vec3(k.x, k.y, k.z);
    ExactSum constant;
    constant.add(k.c);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int l = (i + 2) % 3;
        ExactSum linear;
        linear.add(q.diagonal[i], m[i]);
        linear.add(q.mixed[l], m[j]);
        linear.add(q.mixed[j], m[l]);
        linear.add(half[i]);
        q.linear[i] = linear.rounded();
        constant.add(q.linear[i], m[i]);
        constant.add(linear.rest(), m[i]);
        constant.add(half[i], m[i]);
    }
    q.constant = constant.rounded();
    return q;
}

/// Times 2^exponent, of lengths that are 2^scale times as long.
CentredQuadric scaledQuadric(const CentredQuadric& q, int exponent, int scale) {
    return {scaleByPowerOfTwo(q.diagonal, exponent - 2 * scale),
            scaleByPowerOfTwo(q.mixed, exponent - 2 * scale),
            scaleByPowerOfTwo(q.linear, exponent - scale), std::ldexp(q.constant, exponent)};
}

/// What q adds up within the box, at most.
double reachOf(const CentredQuadric& q, double size) {
    return std::max({largestComponent(q.diagonal) * size * size,
                     largestComponent(q.mixed) * size * size, largestComponent(q.linear) * size,
                     std::fabs(q.constant)});
}

/// From l = 0 to where the gradient is least, and there to the nearest: an ellipsoid's middle, a
/// cone's apex, an axis. Directions along which A bends next to nothing are left alone.
Vec3 stepToMiddle(const CentredQuadric& q) {
    const double steepest = std::max(largestComponent(q.diagonal), largestComponent(q.mixed));
    const double damping = kLeastBend * steepest;
    const Mat3 a(q.times(Vec3(1.0, 0.0, 0.0)), q.times(Vec3(0.0, 1.0, 0.0)),
                 q.times(Vec3(0.0, 0.0, 1.0)));
    return -(glm::inverse(a * a + Mat3(damping * damping)) * q.times(q.linear));
}

/// The point of the box about which q adds up least: its middle, or where the box holds it or
/// nearly, the quadric's.
Vec3 anchorOf(const QuadricCoefficients& k, const Vec3& lo, const Vec3& hi) {
    const Vec3 middle = 0.5 * lo + 0.5 * hi;
    const Vec3 side = hi - lo;
    const int exponent = -std::ilogb(largestComponent(side));
    Vec3 anchor = middle;
    for (int pass = 0; pass < kAnchorPasses; ++pass) {
        const CentredQuadric q = scaledQuadric(centredAt(k, anchor), 0, exponent);
        const double reach = reachOf(q, 1.0);
        if (!(reach > 0.0 && reach < kInfinity)) return middle;
        const Vec3 step = stepToMiddle(scaledQuadric(q, -std::ilogb(reach), 0));
        anchor += scaleByPowerOfTwo(step, -exponent);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::fabs(anchor[axis] - middle[axis]) <= side[axis])) return middle;
        }
    }
    return glm::clamp(anchor, lo, hi);
}

struct QuadricShape {
    const CentredQuadric& q;
    const Vec3& lo;
    const Vec3& hi;
    double size;
};

/// Up to two stretches of the ray, in order, where q <= 0.
struct Stretches {
    std::array<InsideSpan, 2> spans;
    int count = 0;

    void add(double from, double to) {
        spans[static_cast<std::size_t>(count++)] = {{from, kSurface}, {to, kSurface}};
    }
};

/// Where a s^2 + 2 b s + c <= 0, of known roots.
Stretches between(double a, double s1, double s2) {
    Stretches inside;
    const double low = std::min(s1, s2);
    const double high = std::max(s1, s2);
    if (a > 0.0) {
        inside.add(low, high);
    } else {
        inside.add(-kInfinity, low);
        inside.add(high, kInfinity);
    }
    return inside;
}

Stretches withoutRoots(double a) {
    Stretches inside;
    if (!(a > 0.0)) inside.add(-kInfinity, kInfinity);
    return inside;
}

Stretches linear(double b, double c) {
    Stretches inside;
    if (b > 0.0) inside.add(-kInfinity, -0.5 * c / b);
    if (b < 0.0) inside.add(-0.5 * c / b, kInfinity);
    if (b == 0.0 && c <= 0.0) inside.add(-kInfinity, kInfinity);
    return inside;
}

Stretches stretches(const FootRay& near, const QuadricShape& shape) {
    const Vec3& d = near.direction;
    const double a = dot(d, shape.q.times(d));
    const double b = dot(d, shape.q.halfSlope(near.foot));
    const double toMiddle = -b / a;
    const double reach = 2.0 * shape.size;
    if (toMiddle * toMiddle <= reach * reach * near.inverseSquare) {
        const double square = -shape.q.value(along(near, toMiddle)) / a;
        if (!(square >= 0.0)) return withoutRoots(a);
        const double half = std::sqrt(square);
        return between(a, toMiddle - half, toMiddle + half);
    }
    const double c = shape.q.value(near.foot);
    if (a == 0.0) return linear(b, c);
    const double discriminant = differenceOfProducts(b, b, a, c);
    if (!(discriminant >= 0.0)) return withoutRoots(a);
    const double w = -(b + std::copysign(std::sqrt(discriminant), b));
    return between(a, w / a, c / w);
}

/// Newton steps from s on the quadric, each of which is sure to come nearer to the root
/// (Kantorovich) and too short to reach the other; one, unless coefficients that cancel have left
/// more to mend.
double refined(const FootRay& near, double s, const QuadricShape& shape) {
    const Vec3& d = near.direction;
    const double a = dot(d, shape.q.times(d));
    const double reach = kNewtonReach * shape.size;
    for (int i = 0; i < kMostSteps; ++i) {
        const Vec3 p = along(near, s);
        const double slope = dot(d, shape.q.halfSlope(p));
        const double step = 0.5 * shape.q.value(p) / slope;
        if (!(std::fabs(a * step) <= 0.25 * std::fabs(slope))) break;
        s -= step;
        if (step * step <= reach * reach * near.inverseSquare) break;
    }
    return s;
}

bool meet(const FootRay& near, const Crossing& at, const QuadricShape& shape, Interval range,
          PrimitiveHit& hit) {
    if (!(std::fabs(at.s) < kInfinity)) return false;
    const double s = at.part == kSurface ? refined(near, at.s, shape) : at.s;
    const double t = near.tFoot + s;
    if (!range.contains(t)) return false;
    hit.t = t;
    hit.local = along(near, s);
    if (at.part != kSurface) {
        const Index face = at.part - kFirstFace;
        const auto axis = static_cast<int>(face / 2);
        hit.local[axis] = face % 2 != 0 ? shape.hi[axis] : shape.lo[axis];
    }
    hit.part = at.part;
    return true;
}

/// Cut down to the box.
void cut(InsideSpan& span, const FootRay& near, const QuadricShape& shape) {
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1.0 / near.direction[axis];
        const double toLow = (shape.lo[axis] - near.foot[axis]) * inverse;
        const double toHigh = (shape.hi[axis] - near.foot[axis]) * inverse;
        const auto low = kFirstFace + 2 * static_cast<Index>(axis);
        if (inverse >= 0.0) {
            span.enterAt(toLow, low);
            span.leaveAt(toHigh, low + 1);
        } else {
            span.enterAt(toHigh, low + 1);
            span.leaveAt(toLow, low);
        }
    }
}

bool cross(const Vec3& centre, const QuadricShape& shape, const Ray& ray, Interval range,
           PrimitiveHit& hit) {
    const FootRay near = footRay(ray, centre, Vec3(0.0));
    // A NaN is passed over by spans, so that none may come from outside.
    if (!(std::fabs(near.foot.x + near.foot.y + near.foot.z) < kInfinity)) return false;
    InsideSpan box{{-kInfinity, kSurface}, {kInfinity, kSurface}};
    cut(box, near, shape);
    if (box.isEmpty()) return false;
    Stretches inside = stretches(near, shape);
    for (int i = 0; i < inside.count; ++i) {
        InsideSpan& span = inside.spans[static_cast<std::size_t>(i)];
        span.enterAt(box.entry.s, box.entry.part);
        span.leaveAt(box.exit.s, box.exit.part);
        if (span.isEmpty()) continue;
        if (meet(near, span.entry, shape, range, hit)) return true;
        if (meet(near, span.exit, shape, range, hit)) return true;
    }
    return false;
}

/// Longitude and latitude about the centre, and the tangents along which one of them grows alone.
void layAround(SurfacePoint& surface, const Vec3& local, const Vec3& normal) {
    const Radial out = radial(local.x, local.z);
    const Vec3 direction = local == Vec3(0.0) ? Vec3(0.0, 0.0, 1.0) : unitVector(local);
    const double across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    surface.uv = Vec2(turnFraction(out), clampToUnit(latitudeFraction(direction.y, across)));
    const double distance = std::sqrt(dot(local, local));
    const Vec3 ofU = Vec3(out.z, 0.0, -out.x) / (kTurn * out.length);
    const Vec3 ofV =
        Vec3(-direction.y * out.x, across, -direction.y * out.z) / (0.5 * kTurn * distance);
    const double size = glm::dot(normal, glm::cross(ofU, ofV));
    const Vec3 dpdu = glm::cross(ofV, normal) / size;
    const Vec3 dpdv = glm::cross(normal, ofU) / size;
    const double length = glm::dot(dpdu, dpdu) + glm::dot(dpdv, dpdv);
    if (!(length < kInfinity)) return;
    surface.dpdu = dpdu;
    surface.dpdv = dpdv;
}

}  // namespace

Vec3 CentredQuadric::times(const Vec3& l) const {
    return Vec3(diagonal.x * l.x + (mixed.z * l.y + mixed.y * l.z),
                diagonal.y * l.y + (mixed.z * l.x + mixed.x * l.z),
                diagonal.z * l.z + (mixed.y * l.x + mixed.x * l.y));
}

double CentredQuadric::value(const Vec3& l) const {
    const Vec3 slope = times(l) + 2.0 * linear;
    return dot(l, slope) + constant;
}

double CentredQuadric::magnitude(const Vec3& l) const {
    const CentredQuadric all{glm::abs(diagonal), glm::abs(mixed), glm::abs(linear),
                             std::fabs(constant)};
    return all.value(glm::abs(l));
}

Quadric::Quadric(const QuadricCoefficients& k, const Vec3& lo, const Vec3& hi) {
    requireFinite("quadric", "min", lo);
    requireFinite("quadric", "max", hi);
    requireFinite("quadric", "xx, yy, zz", Vec3(k.xx, k.yy, k.zz));
    requireFinite("quadric", "xy, yz, zx", Vec3(k.xy, k.yz, k.zx));
    requireFinite("quadric", "x, y, z", Vec3(k.x, k.y, k.z));
    requireFinite("quadric", "c", Vec3(k.c));
    for (int axis = 0; axis < 3; ++axis) {
        requirePositive("quadric", "max - min", hi[axis] - lo[axis]);
    }
    anchor_ = anchorOf(k, lo, hi);
    lo_ = lo - anchor_;
    hi_ = hi - anchor_;
    size_ = std::max(largestComponent(lo_), largestComponent(hi_));
    q_ = centredAt(k, anchor_);
    const double reach = reachOf(q_, size_);
    if (q_.diagonal == Vec3(0.0) && q_.mixed == Vec3(0.0) && q_.linear == Vec3(0.0)) {
        throw std::invalid_argument("quadric: one of its coefficients beside c must not be 0");
    }
    if (!(reach > 0.0 && reach < kInfinity)) {
        throw std::invalid_argument("quadric: its values in the box are beyond all numbers");
    }
    q_ = scaledQuadric(q_, -std::ilogb(reach), 0);
}

Bounds Quadric::bounds() const {
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        bounds.min[axis] = sumBelow(anchor_[axis], lo_[axis]);
        bounds.max[axis] = sumAbove(anchor_[axis], hi_[axis]);
    }
    return bounds;
}

bool Quadric::intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
    if (isOrdinary(size_, ray.direction)) [[likely]] {
        return cross(anchor_, {q_, lo_, hi_, size_}, ray, range, hit);
    }
    return intersectRescaled(
        size_, ray, range, hit,
        [&](int exponent, const Ray& scaled, Interval scaledRange, PrimitiveHit& found) {
            return cross(scaleByPowerOfTwo(anchor_, exponent),
                         {scaledQuadric(q_, 0, exponent), scaleByPowerOfTwo(lo_, exponent),
                          scaleByPowerOfTwo(hi_, exponent), std::ldexp(size_, exponent)},
                         scaled, scaledRange, found);
        });
}

SurfacePoint Quadric::surface(const PrimitiveHit& hit, SurfaceDetail detail) const {
    SurfacePoint surface;
    const bool parametrised = detail == SurfaceDetail::kParametrised;
    Vec3 local = glm::clamp(hit.local, lo_, hi_);
    if (hit.part != kSurface) {
        const Index face = hit.part - kFirstFace;
        const auto axis = static_cast<int>(face / 2);
        const bool positive = face % 2 != 0;
        Vec3 normal(0.0);
        normal[axis] = positive ? 1.0 : -1.0;
        local[axis] = positive ? hi_[axis] : lo_[axis];
        placeSurface(surface, anchor_, local, normal);
        surface.error = gamma(4) * largestComponent(hi_ - lo_) + placementError(surface.point);
        if (parametrised) layOnBoxFace(surface, local, lo_, hi_ - lo_, face);
        return surface;
    }
    const int exponent = -std::ilogb(size_);
    const CentredQuadric q = scaledQuadric(q_, 0, exponent);
    Vec3 unit = scaleByPowerOfTwo(local, exponent);
    Vec3 slope = q.halfSlope(unit);
    double square = dot(slope, slope);
    const double step = 0.5 * q.value(unit) / square;
    // A hit is off by roundings, and so is a step; what is longer has no slope to go by.
    if (step * step * square <= kNewtonReach * kNewtonReach) {
        unit -= step * slope;
        slope = q.halfSlope(unit);
        square = dot(slope, slope);
    }
    const Vec3 normal = square > 0.0 ? unitVector(unitVector(slope)) : Vec3(0.0, 1.0, 0.0);
    placeSurface(surface, anchor_, scaleByPowerOfTwo(unit, -exponent), normal);
    const double rounding = gamma(16) * q.magnitude(unit);
    const double steepest = std::max(largestComponent(q.diagonal), largestComponent(q.mixed));
    // At least one of them is finite: a quadric has a slope, or else a curvature.
    const double bySlope = square > 0.0 ? 0.5 * rounding / std::sqrt(square) : kInfinity;
    const double byBend = steepest > 0.0 ? std::sqrt(rounding / steepest) : kInfinity;
    surface.error =
        std::ldexp(std::min(bySlope, byBend), -exponent) + placementError(surface.point);
    if (parametrised) layAround(surface, (surface.point - anchor_) - 0.5 * (lo_ + hi_), normal);
    return surface;
}

}  // namespace rt
