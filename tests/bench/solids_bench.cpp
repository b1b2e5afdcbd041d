// What sphere, box, cylinder and cone cost beside the formulas of the textbooks in plain double:
// nearest hit, and nearest hit with its surface point, on rays from outside aimed at a ball a fifth
// larger than the solid. The two take turns, pass by pass, and the medians are compared.
//
//     build/release/solids_bench [passes]
//
// The library's own variant runs here, without FMA instructions unless the program is built with
// them. Built as the renderer's AVX2 variant is:
//
//     g++ -std=c++20 -O2 -mavx2 -mfma -ffp-contract=off -DGLM_FORCE_INLINE -Iinclude
//         -Wl,--wrap=atan2,--wrap=asin tests/bench/solids_bench.cpp src/math/portable*.cpp
//         src/math/wrap_libm.cpp src/geometry/{solid_frame,sphere,box,cylinder,cone}.cpp
#include "rt/geometry/box.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/sphere.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

// The C library's own functions: the program's linker puts its portable ones in their place, and
// the baseline is to have the faster.
extern "C" {
double __real_atan2(double, double);
double __real_asin(double);
}

namespace {

using namespace rt;

constexpr double kPi = 3.14159265358979323846;
constexpr int kCases = 4096;
constexpr int kRounds = 2;  ///< times over all cases in one pass

double angleAboutY(const Vec3& p) {
    return 0.5 + __real_atan2(p.x, p.z) / (2.0 * kPi);
}

SurfacePoint placed(const Vec3& point, const Vec3& normal) {
    SurfacePoint surface;
    surface.point = point;
    surface.shadowOrigin = point;
    surface.normal = normal;
    surface.shadingNormal = normal;
    return surface;
}

SurfacePoint placedOnCap(const Vec3& centre, const Vec3& local, double radius, double up) {
    SurfacePoint surface = placed(centre + local, Vec3(0.0, up, 0.0));
    const double side = std::sqrt(2.0) * radius;
    const double u = 0.5 + local.x / side;
    const double v = 0.5 - up * local.z / side;
    surface.uv = Vec2(u - std::floor(u), v - std::floor(v));
    surface.dpdu = Vec3(side, 0.0, 0.0);
    surface.dpdv = Vec3(0.0, 0.0, -up * side);
    return surface;
}

/// Haines, Essential Ray Tracing Algorithms, in Glassner (ed.), An Introduction to Ray Tracing,
/// 1989, section 2: the quadratic in t from the ray's origin.
class TextbookSphere {
  public:
    TextbookSphere(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {}

    [[gnu::noinline]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
        const Vec3 o = ray.origin - centre_;
        const Vec3& d = ray.direction;
        const double a = glm::dot(d, d);
        const double b = glm::dot(o, d);
        const double c = glm::dot(o, o) - radius_ * radius_;
        const double discriminant = b * b - a * c;
        if (discriminant < 0.0) return false;
        const double root = std::sqrt(discriminant);
        double t = (-b - root) / a;
        if (!range.contains(t)) {
            t = (-b + root) / a;
            if (!range.contains(t)) return false;
        }
        hit.t = t;
        hit.local = o + t * d;
        hit.part = 0;
        return true;
    }

    [[gnu::noinline]] SurfacePoint surface(const PrimitiveHit& hit) const {
        const Vec3& p = hit.local;
        const Vec3 n = glm::normalize(p);
        SurfacePoint surface = placed(centre_ + p, n);
        surface.uv = Vec2(angleAboutY(p), 0.5 + __real_asin(std::clamp(n.y, -1.0, 1.0)) / kPi);
        surface.dpdu = 2.0 * kPi * Vec3(p.z, 0.0, -p.x);
        const double across = std::sqrt(p.x * p.x + p.z * p.z);
        surface.dpdv = kPi * Vec3(-p.y * p.x / across, across, -p.y * p.z / across);
        return surface;
    }

  private:
    Vec3 centre_;
    double radius_;
};

/// Kay and Kajiya, Ray Tracing Complex Scenes, 1986; in the form of Haines 1989, section 3.
class TextbookBox {
  public:
    TextbookBox(const Vec3& lo, const Vec3& size) : lo_(lo), hi_(lo + size) {}

    [[gnu::noinline]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
        double near = -kInfinity;
        double far = kInfinity;
        Index nearPart = 0;
        Index farPart = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double o = ray.origin[axis];
            const double d = ray.direction[axis];
            const Index part = static_cast<Index>(2 * axis);
            if (d == 0.0) {
                if (o < lo_[axis] || o > hi_[axis]) return false;
                continue;
            }
            double t0 = (lo_[axis] - o) / d;
            double t1 = (hi_[axis] - o) / d;
            Index part0 = part;
            Index part1 = part + 1;
            if (t0 > t1) {
                std::swap(t0, t1);
                std::swap(part0, part1);
            }
            if (t0 > near) {
                near = t0;
                nearPart = part0;
            }
            if (t1 < far) {
                far = t1;
                farPart = part1;
            }
            if (near > far) return false;
        }
        const bool first = range.contains(near);
        const double t = first ? near : far;
        if (!range.contains(t)) return false;
        hit.t = t;
        hit.local = ray.origin + t * ray.direction - 0.5 * (lo_ + hi_);
        hit.part = first ? nearPart : farPart;
        return true;
    }

    [[gnu::noinline]] SurfacePoint surface(const PrimitiveHit& hit) const {
        const int axis = static_cast<int>(hit.part / 2);
        const bool positive = hit.part % 2 != 0;
        Vec3 normal(0.0);
        normal[axis] = positive ? 1.0 : -1.0;
        SurfacePoint surface = placed(0.5 * (lo_ + hi_) + hit.local, normal);
        const Vec3 size = hi_ - lo_;
        const Vec3 fraction = 0.5 + hit.local / size;
        const int uAxis = axis == 0 ? 2 : 0;
        const int vAxis = axis == 1 ? 2 : 1;
        const bool uDown = (axis == 0 && positive) || (axis == 2 && !positive);
        const bool vDown = axis == 1 && positive;
        surface.uv = Vec2(uDown ? 1.0 - fraction[uAxis] : fraction[uAxis],
                          vDown ? 1.0 - fraction[vAxis] : fraction[vAxis]);
        surface.dpdu[uAxis] = uDown ? -size[uAxis] : size[uAxis];
        surface.dpdv[vAxis] = vDown ? -size[vAxis] : size[vAxis];
        return surface;
    }

  private:
    Vec3 lo_;
    Vec3 hi_;
};

/// Heckbert, Intersection of a Ray with a Quadric of Revolution, as in Haines 1989, section 4, and
/// Cychosz and Waggenspack, Intersecting a Ray with a Cylinder, Graphics Gems IV, 1994: the
/// quadratic of the side, its roots tried against the ends, then the planes of the caps.
/// x^2 + z^2 = (r + g y)^2: a cylinder with g = 0, a cone with r = 0.
class TextbookRound {
  public:
    TextbookRound(const Vec3& anchor, double height, double radius, bool pointed)
        : anchor_(anchor), height_(height), radius_(radius), pointed_(pointed) {}

    template <bool kPointed>
    bool intersectAs(const Ray& ray, Interval range, PrimitiveHit& hit) const {
        const Vec3 o = ray.origin - anchor_;
        const Vec3& d = ray.direction;
        const double k = kPointed ? radius_ / height_ : 0.0;
        double best = kInfinity;
        Index part = 0;
        double a = d.x * d.x + d.z * d.z;
        double b = o.x * d.x + o.z * d.z;
        double c = o.x * o.x + o.z * o.z;
        if (kPointed) {
            a -= k * k * d.y * d.y;
            b -= k * k * o.y * d.y;
            c -= k * k * o.y * o.y;
        } else {
            c -= radius_ * radius_;
        }
        const double discriminant = b * b - a * c;
        if (discriminant >= 0.0 && a != 0.0) {
            const double root = std::sqrt(discriminant);
            for (const double t : {(-b - root) / a, (-b + root) / a}) {
                const double y = o.y + t * d.y;
                if (range.contains(t) && t < best && y >= 0.0 && y <= height_) best = t;
            }
        }
        if (d.y != 0.0) {
            const auto tryCap = [&](double y, Index number) {
                const double t = (y - o.y) / d.y;
                const double x = o.x + t * d.x;
                const double z = o.z + t * d.z;
                if (range.contains(t) && t < best && x * x + z * z <= radius_ * radius_) {
                    best = t;
                    part = number;
                }
            };
            if (!kPointed) tryCap(0.0, 1);
            tryCap(height_, kPointed ? 1 : 2);
        }
        if (!(best < kInfinity)) return false;
        hit.t = best;
        hit.local = o + best * d;
        hit.part = part;
        return true;
    }

    [[gnu::noinline]] bool intersect(const Ray& ray, Interval range, PrimitiveHit& hit) const {
        return pointed_ ? intersectAs<true>(ray, range, hit) : intersectAs<false>(ray, range, hit);
    }

    [[gnu::noinline]] SurfacePoint surface(const PrimitiveHit& hit) const {
        const Vec3& p = hit.local;
        if (hit.part != 0) {
            return placedOnCap(anchor_, p, radius_, pointed_ || hit.part == 2 ? 1.0 : -1.0);
        }
        const double k = radius_ / height_;
        const double lean = pointed_ ? k * k * p.y : 0.0;
        SurfacePoint surface = placed(anchor_ + p, glm::normalize(Vec3(p.x, -lean, p.z)));
        surface.uv = Vec2(angleAboutY(p), p.y / height_);
        surface.dpdu = 2.0 * kPi * Vec3(p.z, 0.0, -p.x);
        surface.dpdv = pointed_ ? Vec3(p.x, p.y, p.z) * (height_ / p.y) : Vec3(0.0, height_, 0.0);
        return surface;
    }

  private:
    Vec3 anchor_;
    double height_;
    double radius_;
    bool pointed_;
};

class Draws {
  public:
    double uniform(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random_);
    }
    Vec3 unit() {
        std::normal_distribution<double> gauss;
        return glm::normalize(Vec3(gauss(random_), gauss(random_), gauss(random_)));
    }
    Ray aimedAt(const Vec3& centre, double bound) {
        const Vec3 origin = centre + bound * uniform(1.2, 20.0) * unit();
        const double reach = std::max({uniform(0, 1), uniform(0, 1), uniform(0, 1)});
        const Vec3 way = centre + 1.2 * bound * reach * unit() - origin;
        return {origin, uniform(0, 1) < 0.5 ? way : glm::normalize(way)};
    }

  private:
    std::mt19937_64 random_{1};
};

template <class Textbook, class Solid>
struct Cases {
    std::vector<Textbook> textbook;
    std::vector<Solid> solid;
    std::vector<Ray> rays;
};

Cases<TextbookSphere, Sphere> spheres() {
    Draws draws;
    Cases<TextbookSphere, Sphere> cases;
    for (int i = 0; i < kCases; ++i) {
        const Vec3 centre = draws.uniform(0, 5) * draws.unit();
        const double radius = draws.uniform(0.3, 3.0);
        cases.textbook.emplace_back(centre, radius);
        cases.solid.emplace_back(centre, radius);
        cases.rays.push_back(draws.aimedAt(centre, radius));
    }
    return cases;
}

Cases<TextbookBox, Box> boxes() {
    Draws draws;
    Cases<TextbookBox, Box> cases;
    for (int i = 0; i < kCases; ++i) {
        const Vec3 centre = draws.uniform(0, 5) * draws.unit();
        const double scale = draws.uniform(0.3, 3.0);
        const Vec3 size =
            scale * Vec3(draws.uniform(0.3, 1.5), draws.uniform(0.3, 1.5), draws.uniform(0.3, 1.5));
        cases.textbook.emplace_back(centre - 0.5 * size, size);
        cases.solid.emplace_back(centre - 0.5 * size, size);
        cases.rays.push_back(draws.aimedAt(centre, 0.5 * glm::length(size)));
    }
    return cases;
}

template <class Solid>
Cases<TextbookRound, Solid> rounds(bool pointed) {
    Draws draws;
    Cases<TextbookRound, Solid> cases;
    for (int i = 0; i < kCases; ++i) {
        const Vec3 anchor = draws.uniform(0, 5) * draws.unit();
        const double scale = draws.uniform(0.3, 3.0);
        const double height = scale * draws.uniform(0.4, 3.0);
        const double radius = scale * draws.uniform(0.3, 1.0);
        cases.textbook.emplace_back(anchor, height, radius, pointed);
        cases.solid.emplace_back(anchor, height, radius);
        cases.rays.push_back(
            draws.aimedAt(anchor + Vec3(0.0, 0.5 * height, 0.0), std::hypot(0.5 * height, radius)));
    }
    return cases;
}

volatile double sink = 0.0;

/// Nanoseconds of processor time for one ray.
template <bool kSurface, class Solid>
double timePass(const std::vector<Solid>& solids, const std::vector<Ray>& rays) {
    double sum = 0.0;
    const std::clock_t start = std::clock();
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < solids.size(); ++i) {
            PrimitiveHit hit;
            if (!solids[i].intersect(rays[i], {}, hit)) continue;
            sum += hit.t;
            if (kSurface) sum += solids[i].surface(hit).normal.x;
        }
    }
    const double spent = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    sink = sink + sum;
    return spent / static_cast<double>(kRounds * solids.size());
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <bool kSurface, class AllCases>
void compare(const char* name, const AllCases& cases, int passes) {
    std::vector<double> textbook;
    std::vector<double> solid;
    std::vector<double> ratio;
    for (int pass = 0; pass < passes; ++pass) {
        textbook.push_back(timePass<kSurface>(cases.textbook, cases.rays));
        solid.push_back(timePass<kSurface>(cases.solid, cases.rays));
        ratio.push_back(solid.back() / textbook.back());
    }
    std::printf("%-9s %-10s textbook %6.1f ns  here %6.1f ns  ratio %.2f\n", name,
                kSurface ? "+ surface" : "hit", median(textbook), median(solid), median(ratio));
}

template <class AllCases>
void compareBoth(const char* name, const AllCases& cases, int passes) {
    compare<false>(name, cases, passes);
    compare<true>(name, cases, passes);
}

}  // namespace

int main(int argc, char** argv) {
    const int passes = argc > 1 ? std::max(1, std::atoi(argv[1])) : 151;
    compareBoth("sphere", spheres(), passes);
    compareBoth("box", boxes(), passes);
    compareBoth("cylinder", rounds<Cylinder>(false), passes);
    compareBoth("cone", rounds<Cone>(true), passes);
    return 0;
}
