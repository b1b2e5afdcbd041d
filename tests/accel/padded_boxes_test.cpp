// Boxes in double precision: none that a ray meets is passed over, and a ray that leaves a face by
// as much as secondary rays do is not held up by it.
#include "rt/accel/padded_boxes.h"

#include "rt/core/transform.h"

#include <doctest/doctest.h>

#include <random>

using namespace rt;

namespace {

/// The same by one box alone and by a quad whose other boxes are met by nothing.
bool meets(const PaddedBox& box, const Ray& ray, Interval range) {
    SlabRay slabs;
    REQUIRE(slabs.make(ray));
    const bool alone = slabs.meets(box, range);
    const std::vector<BoxQuad> quads = boxQuads(std::vector<PaddedBox>{{}, box});
    double entries[4];
    const unsigned met = QuadTester(slabs).meet(quads.front(), range, entries);
    CHECK((met & ~2u) == 0);
    CHECK((met == 2) == alone);
    return alone;
}

class Cases {
  public:
    double signedUnit() { return std::uniform_real_distribution<>(-1.0, 1.0)(random_); }
    double power(int least, int most) {
        return std::ldexp(1.0 + std::fabs(signedUnit()),
                          std::uniform_int_distribution<>(least, most)(random_));
    }
    Vec3 vector(double size) { return size * Vec3(signedUnit(), signedUnit(), signedUnit()); }
    /// Now and then a part that is zero, of either sign, or next to nothing.
    double slope() {
        constexpr double kSpecial[] = {0.0, -0.0, 1e-300, -1e-300, 1e-19, -1e-19};
        const auto pick = std::uniform_int_distribution<std::size_t>(0, 17)(random_);
        return pick < 6 ? kSpecial[pick] : signedUnit();
    }
    Bounds box() {
        const Vec3 corner = vector(power(-10, 10));
        const Vec3 size(power(-20, 6), power(-20, 6), power(-20, 6));
        return {corner, corner + size};
    }
    Vec3 pointOf(const Bounds& box) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            const double share = 0.5 + 0.5 * signedUnit();
            const auto pick = std::uniform_int_distribution<>(0, 5)(random_);
            p[axis] = pick == 0   ? box.min[axis]
                      : pick == 1 ? box.max[axis]
                                  : box.min[axis] + share * (box.max[axis] - box.min[axis]);
        }
        return p;
    }

  private:
    std::mt19937_64 random_{20240611};
};

}  // namespace

TEST_CASE("a padded box is met by every ray through one of its points") {
    Cases cases;
    for (int i = 0; i < 200'000; ++i) {
        const Bounds box = cases.box();
        const Vec3 p = cases.pointOf(box);
        const Vec3 direction =
            cases.power(-30, 30) * Vec3(cases.slope(), cases.slope(), cases.slope());
        if (!(glm::dot(direction, direction) > 1e-30)) continue;
        // Rounding moves the origin off the line by what the pad of the ray allows for.
        const double t = cases.power(-20, 20) * std::copysign(1.0, cases.signedUnit());
        const Ray ray{p - t * direction, direction};
        const double last = t + 1e-9 * std::fabs(t);
        CAPTURE(i);
        CHECK(meets(PaddedBox(box, 0.0), ray, {-kInfinity, last}));
        CHECK(meets(PaddedBox(box, kInfinity), ray, {}));
    }
}

TEST_CASE("a placed box is met by every ray through the image of one of its points") {
    Cases cases;
    for (int i = 0; i < 100'000; ++i) {
        Affine map = Affine::rotate(i % 3, 180.0 * cases.signedUnit());
        map = compose(Affine::rotate((i + 1) % 3, 180.0 * cases.signedUnit()), map);
        map = compose(map, Affine::scale(Vec3(cases.power(-9, 9))));
        map = compose(Affine::translate(cases.vector(cases.power(-5, 9))), map);
        Transform transform;
        REQUIRE(Transform::make(map, transform));
        REQUIRE(transform.condition() < kBoxedCondition);
        const Bounds box = cases.box();
        // Towards the exact image: that the world rounds it is not the box's affair.
        const Vec3 p = cases.pointOf(box);
        const Vec3 origin = map.translation + cases.vector(cases.power(-10, 10));
        Vec3 direction;
        for (int row = 0; row < 3; ++row) {
            __float128 sum = static_cast<__float128>(map.translation[row]) - origin[row];
            for (int c = 0; c < 3; ++c) {
                sum += static_cast<__float128>(map.linear[c][row]) * p[c];
            }
            direction[row] = static_cast<double>(sum);
        }
        const Ray ray{origin, direction};
        SlabRay local;
        REQUIRE(local.make(transform, ray));
        CAPTURE(i);
        CHECK(local.meets(PaddedBox(box, 0.0), {}));
    }
}

TEST_CASE("a ray that leaves a face by the clearance of secondary rays is not held up by it") {
    const PaddedBox floor({Vec3(-40, -1, -40), Vec3(40, 0, 40)}, 0.0);
    Cases cases;
    for (int i = 0; i < 10'000; ++i) {
        Vec3 origin = cases.vector(20.0);
        if (std::fabs(origin.x) < 2.0) continue;
        origin.y = kCoincidence * std::max(std::fabs(origin.x), std::fabs(origin.z));
        Vec3 direction = cases.vector(1.0);
        direction.y = std::fabs(direction.y);
        if (direction.y < 1e-3) continue;
        CAPTURE(i);
        CHECK_FALSE(meets(floor, {origin, direction}, {}));
        CHECK(meets(floor, {origin, -direction}, {}));
    }
}

TEST_CASE("boxes of nothing, boxes beside, behind and beyond are not met") {
    const PaddedBox box({Vec3(1, -1, -1), Vec3(2, 1, 1)}, 0.0);
    const Ray ray{Vec3(0.0), Vec3(1, 0, 0)};
    CHECK(meets(box, ray, {}));
    CHECK_FALSE(meets(PaddedBox(), ray, {}));
    CHECK_FALSE(meets(box, {Vec3(0.0), Vec3(-1, 0, 0)}, {}));
    CHECK_FALSE(meets(box, {Vec3(0, 1.001, 0), Vec3(1, 0, 0)}, {}));
    CHECK_FALSE(meets(box, ray, {0.0, 0.999}));
    CHECK_FALSE(meets(box, ray, {2.001, kInfinity}));
}

TEST_CASE("of rays that are not finite, or of extreme length, boxes know nothing") {
    SlabRay slabs;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, kInfinity, -kInfinity}) {
        CHECK_FALSE(slabs.make({Vec3(0, bad, 0), Vec3(1, 0, 0)}));
        CHECK_FALSE(slabs.make({Vec3(0.0), Vec3(1, 0, bad)}));
    }
    CHECK_FALSE(slabs.make({Vec3(0.0), Vec3(0.0)}));
    CHECK_FALSE(slabs.make({Vec3(0.0), Vec3(1e-200, 0, 0)}));
    CHECK_FALSE(slabs.make({Vec3(0.0), Vec3(0, 1e200, 0)}));
}
