#include "photon_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace rt {
namespace {

/// Alpha of the paper.
constexpr double kAlpha = 2.0 / 3;

/// A ball of half a cell across meets up to so many cells of a surface.
constexpr double kCellsMet = 4.0;

}  // namespace

std::vector<double> shrinkingRadii(double first, std::uint32_t passes) {
    std::vector<double> radii;
    double squared = first * first;
    for (std::uint32_t i = 0; i < passes; ++i) {
        radii.push_back(std::sqrt(squared));
        squared *= (i + 1 + kAlpha) / (i + 2);
    }
    return radii;
}

void build(PhotonMap& map, const std::vector<double>& radii, double reach, double localBound) {
    map.radius = radii.front();
    map.leastRadius = radii.back();
    map.cell = 2.0 * std::max(reach, map.radius);
    map.kernels.clear();
    const auto passes = static_cast<double>(radii.size());
    for (const double radius : radii) {
        const double squared = radius * radius;
        map.kernels.push_back(
            {squared, 1.0 / squared, 2.0 / (std::numbers::pi * squared * passes)});
    }
    const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(map.photons.size(), 1));
    map.begins.assign(buckets + 1, 0);
    std::vector<std::uint32_t> places;
    places.reserve(map.photons.size());
    for (const Photon& photon : map.photons) {
        places.push_back(map.bucketOf(glm::floor(photon.position / map.cell)));
        ++map.begins[places.back() + 1];
    }
    for (std::size_t i = 0; i < buckets; ++i) map.begins[i + 1] += map.begins[i];
    std::vector<Photon> sorted(map.photons.size());
    std::vector<std::uint32_t> next(map.begins.begin(), map.begins.end() - 1);
    for (std::size_t i = 0; i < places.size(); ++i) sorted[next[places[i]]++] = map.photons[i];
    map.photons = std::move(sorted);

    double most = 0.0;
    for (std::size_t i = 0; i < buckets; ++i) {
        Color sum(0.0);
        for (std::uint32_t j = map.begins[i]; j < map.begins[i + 1]; ++j) {
            const Photon& photon = map.photons[j];
            sum += map.kernels[photon.pass].peak * glm::abs(Vec3(photon.flux));
        }
        most = std::max({most, sum.x, sum.y, sum.z});
    }
    map.radianceBound = kCellsMet * most * localBound;
}

}  // namespace rt
