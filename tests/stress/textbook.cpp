// What the textbooks' formulas answer to the questions of tests/vectors: plain double, from the
// ray's own origin. Shows by how much they are off; nothing else uses it.
//
//     g++ -std=c++20 -O2 -ffp-contract=off tests/stress/textbook.cpp -o build/textbook
//     python3 tests/vectors/check.py build/textbook
//
// Sphere, cylinder, cone: Haines, Essential Ray Tracing Algorithms, in An Introduction to Ray
// Tracing, 1989. Box: Kay, Kajiya, Ray Tracing Complex Scenes, 1986. Torus: the quartic in t,
// solved by Ferrari's method as in Schwarze, Cubic and Quartic Roots, Graphics Gems, 1990.
// Triangles: Moeller, Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997, with its
// epsilon.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Vec {
    double x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(double s, Vec a) {
    return {s * a.x, s * a.y, s * a.z};
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit(Vec a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}

struct Hit {
    double t = INFINITY;
    Vec normal;
};

struct Ray {
    Vec o, d;
    double tMin = 0;

    void offer(Hit& hit, double t, Vec normal) const {
        if (t > tMin && t < hit.t) hit = {t, normal};
    }
};

using Numbers = std::vector<double>;

Vec vec(const Numbers& n, std::size_t at) {
    return {n[at], n[at + 1], n[at + 2]};
}

/// The roots of a t^2 + 2 b t + c.
std::vector<double> quadratic(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return {};
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

Hit sphere(const Numbers& n, const Ray& ray) {
    const Vec o = ray.o - vec(n, 0);
    Hit hit;
    for (double t : quadratic(dot(ray.d, ray.d), dot(o, ray.d), dot(o, o) - n[3] * n[3])) {
        ray.offer(hit, t, unit(o + t * ray.d));
    }
    return hit;
}

Hit box(const Numbers& n, const Ray& ray) {
    const std::array<double, 3> o{ray.o.x, ray.o.y, ray.o.z};
    const std::array<double, 3> d{ray.d.x, ray.d.y, ray.d.z};
    double near = -INFINITY, far = INFINITY;
    Vec nearNormal, farNormal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double t0 = (n[axis] - o[axis]) / d[axis];
        double t1 = (n[axis] + n[3 + axis] - o[axis]) / d[axis];
        const double sign = t0 > t1 ? 1 : -1;
        if (t0 > t1) std::swap(t0, t1);
        const Vec normal{axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
        if (t0 > near) near = t0, nearNormal = normal;
        if (t1 < far) far = t1, farNormal = -1.0 * normal;
    }
    Hit hit;
    if (near > far) return hit;
    ray.offer(hit, near, nearNormal);
    ray.offer(hit, far, farNormal);
    return hit;
}

void cap(const Ray& ray, Vec o, double y, double radius, double up, Hit& hit) {
    const double t = (y - o.y) / ray.d.y;
    const Vec p = o + t * ray.d;
    if (p.x * p.x + p.z * p.z <= radius * radius) ray.offer(hit, t, {0, up, 0});
}

Hit cylinder(const Numbers& n, const Ray& ray) {
    const Vec o = ray.o - vec(n, 0);
    const Vec d = ray.d;
    Hit hit;
    for (double t : quadratic(d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z,
                              o.x * o.x + o.z * o.z - n[4] * n[4])) {
        const Vec p = o + t * d;
        if (p.y >= 0 && p.y <= n[3]) ray.offer(hit, t, unit({p.x, 0, p.z}));
    }
    cap(ray, o, 0, n[4], -1, hit);
    cap(ray, o, n[3], n[4], 1, hit);
    return hit;
}

Hit cone(const Numbers& n, const Ray& ray) {
    const Vec o = ray.o - vec(n, 0);
    const Vec d = ray.d;
    const double k = n[4] * n[4] / (n[3] * n[3]);
    Hit hit;
    for (double t :
         quadratic(d.x * d.x + d.z * d.z - k * d.y * d.y, o.x * d.x + o.z * d.z - k * o.y * d.y,
                   o.x * o.x + o.z * o.z - k * o.y * o.y)) {
        const Vec p = o + t * d;
        if (p.y >= 0 && p.y <= n[3]) ray.offer(hit, t, unit({p.x, -k * p.y, p.z}));
    }
    cap(ray, o, n[3], n[4], 1, hit);
    return hit;
}

/// One root of x^3 + a x^2 + b x + c.
double cubicRoot(double a, double b, double c) {
    const double p = (b - a * a / 3) / 3;
    const double q = (2.0 / 27 * a * a * a - a * b / 3 + c) / 2;
    const double discriminant = q * q + p * p * p;
    if (discriminant < 0) {
        return 2 * std::sqrt(-p) * std::cos(std::acos(-q / std::sqrt(-p * p * p)) / 3) - a / 3;
    }
    const double root = std::sqrt(discriminant);
    return std::cbrt(root - q) - std::cbrt(root + q) - a / 3;
}

std::vector<double> quartic(double a, double b, double c, double d) {
    const double square = a * a;
    const double p = b - 3.0 / 8 * square;
    const double q = square * a / 8 - a * b / 2 + c;
    const double r = -3.0 / 256 * square * square + square * b / 16 - a * c / 4 + d;
    const double z = cubicRoot(-p / 2, -r, r * p / 2 - q * q / 8);
    const double u = z * z - r;
    const double v = 2 * z - p;
    if (!(u >= 0 && v >= 0)) return {};
    const double rootV = q < 0 ? -std::sqrt(v) : std::sqrt(v);
    std::vector<double> roots = quadratic(1, rootV / 2, z - std::sqrt(u));
    for (double x : quadratic(1, -rootV / 2, z + std::sqrt(u))) roots.push_back(x);
    for (double& x : roots) x -= a / 4;
    return roots;
}

Hit torus(const Numbers& n, const Ray& ray) {
    const Vec o = ray.o - vec(n, 0);
    const Vec d = ray.d;
    const double major = n[3];
    const double dd = dot(d, d);
    const double od = dot(o, d);
    const double k = dot(o, o) + major * major - n[4] * n[4];
    const double four = 4 * major * major;
    const double leading = dd * dd;
    Hit hit;
    for (double t : quartic(4 * dd * od / leading,
                            (2 * dd * k + 4 * od * od - four * (d.x * d.x + d.y * d.y)) / leading,
                            (4 * od * k - 2 * four * (o.x * d.x + o.y * d.y)) / leading,
                            (k * k - four * (o.x * o.x + o.y * o.y)) / leading)) {
        const Vec p = o + t * d;
        const double m = dot(p, p) - major * major - n[4] * n[4];
        ray.offer(hit, t, unit({p.x * m, p.y * m, p.z * (m + 2 * major * major)}));
    }
    return hit;
}

void triangle(Vec a, Vec b, Vec c, const Ray& ray, Hit& hit) {
    constexpr double kEpsilon = 1e-9;
    const Vec e1 = b - a, e2 = c - a;
    const Vec p = cross(ray.d, e2);
    const double determinant = dot(e1, p);
    if (std::fabs(determinant) < kEpsilon) return;
    const Vec s = ray.o - a;
    const double u = dot(s, p) / determinant;
    const Vec q = cross(s, e1);
    const double v = dot(ray.d, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return;
    const double t = dot(e2, q) / determinant;
    if (t > kEpsilon) ray.offer(hit, t, unit(cross(e1, e2)));
}

Hit oneTriangle(const Numbers& n, const Ray& ray) {
    Hit hit;
    triangle(vec(n, 0), vec(n, 3), vec(n, 6), ray, hit);
    return hit;
}

Hit fan(const Numbers& n, const Ray& ray) {
    Hit hit;
    const std::size_t count = static_cast<std::size_t>(n[0]);
    for (std::size_t i = 0; i < count; ++i) {
        triangle(vec(n, 1), vec(n, 4 + 3 * i), vec(n, 4 + 3 * ((i + 1) % count)), ray, hit);
    }
    return hit;
}

/// Row-major 3 x 4, point or vector; and the way back by the adjugate.
struct Map {
    std::array<Vec, 3> rows, inverse;
    Vec shift;

    explicit Map(const Numbers& m)
        : rows{vec(m, 0), vec(m, 4), vec(m, 8)}, shift{m[3], m[7], m[11]} {
        const std::array<Vec, 3> c{cross(rows[1], rows[2]), cross(rows[2], rows[0]),
                                   cross(rows[0], rows[1])};
        const double inverseDeterminant = 1 / dot(rows[0], c[0]);
        inverse = {inverseDeterminant * Vec{c[0].x, c[1].x, c[2].x},
                   inverseDeterminant * Vec{c[0].y, c[1].y, c[2].y},
                   inverseDeterminant * Vec{c[0].z, c[1].z, c[2].z}};
    }
    Vec back(Vec v) const { return {dot(inverse[0], v), dot(inverse[1], v), dot(inverse[2], v)}; }
    Vec normal(Vec v) const { return unit(v.x * inverse[0] + v.y * inverse[1] + v.z * inverse[2]); }
};

struct Kind {
    const char* name;
    std::size_t parameters;
    Hit (*closest)(const Numbers&, const Ray&);
};

constexpr Kind kKinds[] = {{"sphere", 4, sphere}, {"box", 6, box},     {"cylinder", 5, cylinder},
                           {"cone", 5, cone},     {"torus", 5, torus}, {"triangle", 9, oneTriangle},
                           {"fan", 0, fan}};

Hit answer(const Kind& kind, const std::string& name, Numbers numbers) {
    if (kind.parameters == 0) {
        const std::size_t end = numbers.size();
        return kind.closest(numbers, {vec(numbers, end - 6), vec(numbers, end - 3)});
    }
    const std::size_t end = numbers.size();
    Ray ray{vec(numbers, end - 7), vec(numbers, end - 4), numbers[end - 1]};
    if (name != "affine") return kind.closest(numbers, ray);
    const Map map(
        Numbers(numbers.begin() + static_cast<std::ptrdiff_t>(kind.parameters), numbers.end()));
    ray.o = map.back(ray.o - map.shift);
    ray.d = map.back(ray.d);
    Hit hit = kind.closest(numbers, ray);
    hit.normal = map.normal(hit.normal);
    return hit;
}

}  // namespace

int main(int argc, char** argv) {
    const Kind* kind = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const Kind& k) {
        return argc > 1 && std::string(argv[1]) == k.name;
    });
    if (kind == std::end(kKinds)) return 2;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string name, word;
        words >> name;
        Numbers numbers;
        while (words >> word) numbers.push_back(std::strtod(word.c_str(), nullptr));
        const Hit hit = answer(*kind, name, numbers);
        if (hit.t < INFINITY) {
            std::printf("%a %a %a %a\n", hit.t, hit.normal.x, hit.normal.y, hit.normal.z);
        } else {
            std::puts("miss");
        }
    }
}
