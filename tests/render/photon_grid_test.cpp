#include "render/photon_grid.h"

#include "rt/sampling/random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace rt {
namespace {

constexpr double kPi = 3.14159265358979323846;

double uniform(std::uint64_t key) {
    return toUnit(mixBits(key));
}

/// On two floors, one above the other, far from the origin.
std::vector<Photon> scattered(std::size_t count, const Vec3& origin) {
    std::vector<Photon> photons(count);
    for (std::size_t i = 0; i < count; ++i) {
        Photon& photon = photons[i];
        photon.position = origin + Vec3(10.0 * uniform(5 * i), 10.0 * uniform(5 * i + 1),
                                        i % 3 == 0 ? 0.25 : 0.0);
        photon.flux = glm::vec3(0.5F, 1.0F, static_cast<float>(uniform(5 * i + 2)));
        const double tilt = uniform(5 * i + 3);
        photon.from = glm::vec3(Vec3(std::sqrt(1.0 - tilt * tilt), 0.0, tilt));
        photon.normal = {0.0F, 0.0F, i % 7 == 0 ? -1.0F : 1.0F};
        photon.instance = i % 3 == 0 ? 1 : 0;
        photon.pass = static_cast<std::uint16_t>(i % 4);
    }
    return photons;
}

/// The header's sum over all photons.
Color plainSum(const std::vector<Photon>& photons, const std::vector<double>& radii,
               const PhotonReceiver& to) {
    Color sum(0.0);
    for (const Photon& photon : photons) {
        const double d = glm::distance(photon.position, to.position);
        const double r = radii[photon.pass];
        if (d >= r || photon.instance != to.instance || photon.normal.z < 0.0F) continue;
        const Vec3 w(photon.from);
        const Color local = phong(to.material, to.normal, to.toViewer, w, 0.0) / w.z;
        sum += 2.0 / (kPi * r * r) * (1.0 - d * d / (r * r)) * Vec3(photon.flux) * local;
    }
    return sum / static_cast<double>(radii.size());
}

PhotonReceiver receiverAt(const Vec3& position) {
    PhotonReceiver to;
    to.position = position;
    to.geometricNormal = to.normal = {0.0, 0.0, 1.0};
    to.toViewer = glm::normalize(Vec3(0.3, 0.2, 1.0));
    to.material = {Color(0.5, 0.6, 0.7), Color(0.2), 12.0};
    to.instance = 0;
    return to;
}

}  // namespace

TEST_CASE("A photon map shows at a point what the sum over all photons does") {
    for (const Vec3& origin : {Vec3(0.0), Vec3(-3e6, 2e6, 7e5), Vec3(-5.0, -5.0, 0.0)}) {
        CAPTURE(origin.x);
        const std::vector<Photon> photons = scattered(6000, origin);
        const std::vector<double> radii = shrinkingRadii(0.7, 4);
        for (const double reach : {0.7, 1.4}) {
            PhotonMap map;
            map.photons = photons;
            build(map, radii, reach, 1.0);
            CHECK(map.photons.size() == photons.size());
            for (std::uint64_t i = 0; i < 300; ++i) {
                const PhotonReceiver to =
                    receiverAt(origin + Vec3(12.0 * uniform(9000 + i) - 1.0,
                                             12.0 * uniform(19000 + i) - 1.0, 0.0));
                const Color right = plainSum(photons, radii, to);
                const Color found = map.radianceAt(to);
                CHECK(glm::length(found - right) <= 1e-12 * (1.0 + glm::length(right)));
                CHECK(std::max({found.x, found.y, found.z}) <= 30.0 * map.radianceBound);
            }
        }
    }
}

TEST_CASE("Where photons may light something is never missed") {
    const std::vector<Photon> photons = scattered(40, Vec3(0.0));
    PhotonMap map;
    map.photons = photons;
    build(map, shrinkingRadii(0.3, 4), 0.3, 1.0);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Vec3 at(12.0 * uniform(9000 + i) - 1.0, 12.0 * uniform(19000 + i) - 1.0, 0.1);
        const double margin = 3.0 * uniform(29000 + i);
        bool near = false;
        for (const Photon& photon : photons) {
            near = near || glm::distance(photon.position, at) < margin + 0.3;
        }
        if (near) CHECK(map.mayLight(at, margin));
        if (!near && margin < 1.0) CHECK_FALSE(map.mayLight(at, margin));
    }
    CHECK_FALSE(PhotonMap{}.mayLight(Vec3(0.0), 1.0));
}

TEST_CASE("Radii shrink so that noise and blur go on falling") {
    // r_n^2 / r_1^2 = product of (i + 2/3) / (i + 1): as n^(-1/3), with 1 / Gamma(5/3) before it.
    const std::vector<double> radii = shrinkingRadii(2.0, 4096);
    CHECK(radii[0] == 2.0);
    CHECK(radii[1] * radii[1] == doctest::Approx(4.0 * (5.0 / 3) / 2.0));
    const double last = radii[4095] * radii[4095] / 4.0;
    CHECK(last * std::cbrt(4096.0) == doctest::Approx(1.0 / std::tgamma(5.0 / 3)).epsilon(1e-3));
}

}  // namespace rt
