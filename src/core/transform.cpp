#include "rt/core/transform.h"

#include "rt/core/numeric.h"
#include "rt/math/lanes4.h"
#include "rt/math/portable.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr double kSquareRootOf3 = 1.7320508075688774;
/// A float's rounding of a tail that is at most a double's rounding, four times over.
constexpr double kTailRoundoff = 0x1p-24 * kUnitRoundoff * 4;

/// An unevaluated sum of two doubles, about 106 bits.
struct Long {
    double high = 0.0;
    double low = 0.0;
};

Long normalised(double high, double low) {
    const TwoTerms sum = exactSum(high, low);
    return {sum.value, sum.error};
}

Long operator+(const Long& a, const Long& b) {
    const TwoTerms high = exactSum(a.high, b.high);
    return normalised(high.value, high.error + (a.low + b.low));
}

Long operator*(const Long& a, double b) {
    const TwoTerms high = exactProduct(a.high, b);
    return normalised(high.value, std::fma(a.low, b, high.error));
}

Long quotient(const Long& a, const Long& b) {
    const double rough = a.high / b.high;
    const double rest = std::fma(-rough, b.high, a.high) + (a.low - rough * b.low);
    return normalised(rough, rest / b.high);
}

/// a b - c d
Long minor(double a, double b, double c, double d) {
    const TwoTerms ab = exactProduct(a, b);
    const TwoTerms cd = exactProduct(-c, d);
    return Long{ab.value, ab.error} + Long{cd.value, cd.error};
}

bool isFinite(const Mat3& m) {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(m[column][row])) return false;
        }
    }
    return true;
}

bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double largest(double a, double b, double c) {
    return std::max(std::fabs(a), std::max(std::fabs(b), std::fabs(c)));
}

/// A matrix whose rows and columns have been brought near 1 by powers of two, so that no product of
/// three entries leaves the range of double: m[c][r] = equilibrated[c][r] 2^(row[r] + column[c]).
struct Equilibrated {
    Mat3 matrix{1.0};
    int row[3] = {};
    int column[3] = {};
};

/// False where a row or column is zero.
bool equilibrate(const Mat3& m, Equilibrated& out) {
    for (int r = 0; r < 3; ++r) {
        const double most = largest(m[0][r], m[1][r], m[2][r]);
        if (!(most > 0.0)) return false;
        out.row[r] = std::ilogb(most);
        for (int c = 0; c < 3; ++c) out.matrix[c][r] = std::ldexp(m[c][r], -out.row[r]);
    }
    for (int c = 0; c < 3; ++c) {
        Vec3& entries = out.matrix[c];
        const double most = largest(entries.x, entries.y, entries.z);
        if (!(most > 0.0)) return false;
        out.column[c] = std::ilogb(most);
        for (int r = 0; r < 3; ++r) entries[r] = std::ldexp(entries[r], -out.column[c]);
    }
    return true;
}

/// |a| |b|, the largest row sum.
double absoluteRowSum(const Mat3& a, const Mat3& b) {
    double most = 0.0;
    for (int r = 0; r < 3; ++r) {
        double sum = 0.0;
        for (int c = 0; c < 3; ++c) {
            for (int k = 0; k < 3; ++k) sum += std::fabs(a[k][r]) * std::fabs(b[c][k]);
        }
        most = std::max(most, sum);
    }
    return most;
}

/// A vector and what its rounding left out.
struct LongVec {
    Vec3 high;
    Vec3 low;
};

/// exactProduct and exactSum of numeric.h, four at a time.
struct TwoTermLanes {
    Lanes4 value;
    Lanes4 error;
};

inline TwoTermLanes exactProduct(Lanes4 a, Lanes4 b) {
    const Lanes4 product = a * b;
    return {product, fms(a, b, product)};
}

inline TwoTermLanes exactSum(Lanes4 a, Lanes4 b) {
    const Lanes4 sum = a + b;
    const Lanes4 b2 = sum - a;
    return {sum, (a - (sum - b2)) + (b - b2)};
}

/// Three columns, and what their rounding left out, relative to each entry.
struct LongColumns {
    Lanes4 column[3];
    Lanes4 tail[3];
};

/// The matrix times v, of which `ofVector` is what v's own rounding left out, in twice the
/// precision (Ogita, Rump, Oishi, Accurate Sum and Dot Product, SIAM J. Sci. Comput. 26, 2005),
/// rounded once, near enough.
inline Lanes4 longProduct(const LongColumns& m, const Vec3& v, Lanes4 ofVector) {
    const TwoTermLanes ax = exactProduct(m.column[0], Lanes4::all(v.x));
    const TwoTermLanes by = exactProduct(m.column[1], Lanes4::all(v.y));
    const TwoTermLanes cz = exactProduct(m.column[2], Lanes4::all(v.z));
    const TwoTermLanes first = exactSum(ax.value, by.value);
    const TwoTermLanes all = exactSum(first.value, cz.value);
    const Lanes4 ofMatrix = m.tail[0] * ax.value + m.tail[1] * by.value + m.tail[2] * cz.value;
    const Lanes4 ofRounding = (ax.error + by.error + cz.error) + (first.error + all.error);
    return all.value + (ofMatrix + ofVector + ofRounding);
}

/// Bound on the length of the image of a unit vector: the root of the largest row sum times the
/// largest column sum (Higham 2002, section 6.3), exact for scales along the axes.
double longestImage(const Mat3& m) {
    double row = 0.0;
    double column = 0.0;
    for (int i = 0; i < 3; ++i) {
        row = std::max(row, std::fabs(m[0][i]) + std::fabs(m[1][i]) + std::fabs(m[2][i]));
        column = std::max(column, std::fabs(m[i].x) + std::fabs(m[i].y) + std::fabs(m[i].z));
    }
    return std::sqrt(row) * std::sqrt(column) * (1.0 + gamma(8));
}

/// The adjugate over the determinant, in twice the precision: the entries are then right to about
/// a rounding even where scales of 1e-6 and 1e6 lie between turns. `tails` is what that rounding
/// left out, relative to each entry. False where singular.
bool invert(const Mat3& m, Mat3& inverse, Mat3& tails, double& determinantSign) {
    Equilibrated even;
    if (!equilibrate(m, even)) return false;
    const Mat3& e = even.matrix;
    Long cofactor[3][3];
    for (int c = 0; c < 3; ++c) {
        const int c1 = (c + 1) % 3;
        const int c2 = (c + 2) % 3;
        for (int r = 0; r < 3; ++r) {
            const int r1 = (r + 1) % 3;
            const int r2 = (r + 2) % 3;
            cofactor[c][r] = minor(e[c1][r1], e[c2][r2], e[c1][r2], e[c2][r1]);
        }
    }
    const Long determinant =
        cofactor[0][0] * e[0][0] + cofactor[0][1] * e[0][1] + cofactor[0][2] * e[0][2];
    if (!(std::fabs(determinant.high) > 0.0)) return false;
    Mat3 evenInverse;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            const Long entry = quotient(cofactor[c][r], determinant);
            evenInverse[r][c] = entry.high;
            tails[r][c] = entry.high != 0.0 ? entry.low / entry.high : 0.0;
            inverse[r][c] = std::ldexp(evenInverse[r][c], -even.row[r] - even.column[c]);
        }
    }
    determinantSign = determinant.high;
    return isFinite(inverse) && absoluteRowSum(evenInverse, e) < kLargestCondition;
}

}  // namespace

bool Affine::isFinite() const {
    return rt::isFinite(linear) && rt::isFinite(translation);
}

bool Affine::isIdentity() const {
    return linear == Mat3(1.0) && translation == Vec3(0.0);
}

Affine Affine::translate(const Vec3& by) {
    return {Mat3(1.0), by};
}

Affine Affine::scale(const Vec3& by) {
    Affine map;
    for (int axis = 0; axis < 3; ++axis) map.linear[axis][axis] = by[axis];
    return map;
}

Affine Affine::rotate(int axis, double degrees) {
    const double cosine = portable::cosDegrees(degrees);
    const double sine = portable::sinDegrees(degrees);
    const int next = (axis + 1) % 3;
    const int afterNext = (axis + 2) % 3;
    Affine map;
    map.linear[next][next] = cosine;
    map.linear[next][afterNext] = sine;
    map.linear[afterNext][next] = -sine;
    map.linear[afterNext][afterNext] = cosine;
    return map;
}

Affine compose(const Affine& second, const Affine& first) {
    return {second.linear * first.linear, second.point(first.translation)};
}

bool Transform::make(const Affine& toWorld, Transform& out) {
    if (!toWorld.isFinite()) return false;
    Transform made;
    made.toWorld_ = toWorld;
    if (!toWorld.isIdentity()) {
        double determinantSign = 0.0;
        Mat3 tails;
        if (!invert(toWorld.linear, made.toObject_.linear, tails, determinantSign)) return false;
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) made.tails_[c][r] = static_cast<float>(tails[c][r]);
        }
        made.toObject_.translation = -made.toObject_.vector(toWorld.translation);
        if (!made.toObject_.isFinite()) return false;
        made.stretch_ = longestImage(toWorld.linear);
        // Coming back is rounded once, and the tails as floats.
        const double wayBack =
            gamma(2) + kTailRoundoff * absoluteRowSum(toWorld.linear, made.toObject_.linear);
        made.wayBack_ = std::nextafter(static_cast<float>(wayBack), HUGE_VALF);
        made.identity_ = false;
        made.flips_ = determinantSign < 0.0;
    }
    out = made;
    return true;
}

double Transform::similarityToObject() const {
    const Mat3& m = toObject_.linear;
    const double squared = glm::dot(m[0], m[0]);
    for (int c = 0; c < 3; ++c) {
        const Vec3& next = m[(c + 1) % 3];
        const bool alike = std::fabs(glm::dot(m[c], m[c]) - squared) <= kSimilarityError * squared;
        const bool upright = std::fabs(glm::dot(m[c], next)) <= kSimilarityError * squared;
        if (!alike || !upright) return 0.0;
    }
    return std::sqrt(squared);
}

Ray Transform::toObject(const Ray& world) const {
    if (identity_) return world;
    const Mat3& m = toObject_.linear;
    LongColumns columns;
    for (int c = 0; c < 3; ++c) {
        columns.column[c] = Lanes4::loadThree(&m[c].x);
        columns.tail[c] = Lanes4::load(tails_[c]);
    }
    // Taking the translation off first loses nothing; the inverse's own translation is rounded.
    const TwoTerms x = exactDifference(world.origin.x, toWorld_.translation.x);
    const TwoTerms y = exactDifference(world.origin.y, toWorld_.translation.y);
    const TwoTerms z = exactDifference(world.origin.z, toWorld_.translation.z);
    const Lanes4 ofOrigin = columns.column[0] * Lanes4::all(x.error) +
                            columns.column[1] * Lanes4::all(y.error) +
                            columns.column[2] * Lanes4::all(z.error);
    Ray ray;
    longProduct(columns, Vec3(x.value, y.value, z.value), ofOrigin).storeThree(&ray.origin.x);
    longProduct(columns, world.direction, Lanes4::all(0.0)).storeThree(&ray.direction.x);
    return ray;
}

Vec3 Transform::normalToWorld(const Vec3& normal) const {
    // Brought near 1 before each use of squares or products: lengths may be 1e-150 or 1e150.
    Vec3 n = normal / largest(normal.x, normal.y, normal.z);
    if (!identity_) {
        const Mat3& m = toObject_.linear;
        // Lanes are the columns here: the transpose.
        LongColumns rows;
        for (int r = 0; r < 3; ++r) {
            rows.column[r] = Lanes4(m[0][r], m[1][r], m[2][r], 0.0);
            rows.tail[r] = Lanes4(tails_[0][r], tails_[1][r], tails_[2][r], 0.0);
        }
        longProduct(rows, n, Lanes4::all(0.0)).storeThree(&n.x);
        n /= largest(n.x, n.y, n.z);
    }
    return n / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

Bounds Transform::boundsToWorld(const Bounds& object) const {
    if (identity_ || object.isEmpty()) return object;
    Bounds world;
    for (int r = 0; r < 3; ++r) {
        double low = toWorld_.translation[r];
        double high = low;
        double size = std::fabs(low);
        for (int c = 0; c < 3; ++c) {
            const double a = toWorld_.linear[c][r] * object.min[c];
            const double b = toWorld_.linear[c][r] * object.max[c];
            low += std::min(a, b);
            high += std::max(a, b);
            size += std::max(std::fabs(a), std::fabs(b));
        }
        // A product and up to three sums each; the size itself and the subtraction round too.
        world.min[r] = low - gamma(8) * size;
        world.max[r] = high + gamma(8) * size;
    }
    return world;
}

double Transform::condition() const {
    return std::max(absoluteRowSum(toWorld_.linear, toObject_.linear),
                    absoluteRowSum(toObject_.linear, toWorld_.linear));
}

double Transform::errorToWorld(const Vec3& objectPoint, double objectError) const {
    if (identity_) return objectError;
    const Mat3& m = toWorld_.linear;
    const Vec3 p(std::fabs(objectPoint.x), std::fabs(objectPoint.y), std::fabs(objectPoint.z));
    double size = 0.0;
    for (int r = 0; r < 3; ++r) {
        size = std::max(
            size, std::fabs(m[0][r]) * p.x + std::fabs(m[1][r]) * p.y + std::fabs(m[2][r]) * p.z);
    }
    const Vec3& t = toWorld_.translation;
    const double offset = largest(t.x, t.y, t.z);
    // A product and three sums for each coordinate, and the sums above.
    return stretch_ * objectError * (1.0 + gamma(4)) +
           kSquareRootOf3 * (gamma(7) * (size + offset) + static_cast<double>(wayBack_) * size);
}

}  // namespace rt
