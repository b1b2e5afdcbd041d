#include "rt/trace/camera.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace rt;

namespace {

Camera::Frame frame() {
    Camera::Frame frame;
    frame.eye = {1, 2, 3};
    frame.view = {0, 0, -7};
    frame.up = {0, 2, 0};
    frame.fovDegrees = 90;
    return frame;
}

void checkDirection(const Vec3& actual, const Vec3& expected) {
    CHECK(glm::distance(actual, glm::normalize(expected)) < 1e-15);
}

}  // namespace

TEST_CASE("the image's centre looks along the view") {
    const Camera camera(frame(), 200, 100);
    const Ray ray = camera.ray(100, 50, Vec2(0.0));
    CHECK(ray.origin == Vec3(1, 2, 3));
    checkDirection(ray.direction, {0, 0, -1});
}

TEST_CASE("the field of view is vertical, row 0 the top, column 0 the left") {
    const Camera camera(frame(), 200, 100);
    checkDirection(camera.ray(100, 0, Vec2(0.0)).direction, {0, 1, -1});
    checkDirection(camera.ray(100, 100, Vec2(0.0)).direction, {0, -1, -1});
    checkDirection(camera.ray(0, 50, Vec2(0.0)).direction, {-2, 0, -1});
    checkDirection(camera.ray(200, 50, Vec2(0.0)).direction, {2, 0, -1});
}

TEST_CASE("view and up need be neither unit nor at right angles") {
    Camera::Frame skew = frame();
    skew.up = {0, 5, -3};
    skew.view = {0, 0, -0.01};
    const Camera camera(skew, 200, 100);
    checkDirection(camera.ray(150, 25, Vec2(0.0)).direction, {1, 0.5, -1});
}

TEST_CASE("all lens points of one image point meet in the plane of focus") {
    Camera::Frame lens = frame();
    lens.lensRadius = 0.3;
    lens.focusDistance = 4;
    const Camera camera(lens, 200, 100);
    const Camera pinhole(frame(), 200, 100);
    CHECK(camera.hasLens());
    CHECK(!pinhole.hasLens());
    const Ray central = pinhole.ray(130, 20, Vec2(0.0));
    const Vec3 focus = central.at(4 / -central.direction.z);
    const Vec2 points[] = {Vec2(1, 0), Vec2(0, 1), Vec2(-0.6, 0.8), Vec2(0.1, -0.2)};
    for (const Vec2& point : points) {
        const Ray ray = camera.ray(130, 20, point);
        CHECK(glm::distance(ray.origin, Vec3(1 + 0.3 * point.x, 2 + 0.3 * point.y, 3)) < 1e-14);
        CHECK(glm::length(ray.direction) == doctest::Approx(1.0).epsilon(1e-14));
        const Vec3 there = ray.at((focus.z - ray.origin.z) / ray.direction.z);
        CHECK(glm::distance(there, focus) < 1e-13);
    }
}
