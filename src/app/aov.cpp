#include "rt/app/aov.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {
namespace {

/// One pixel, as an entry of the table sees it.
struct Place {
    const PixelState& state;
    double squaredError;
    const FirstHit& hit;
};

struct AovRow {
    const char* name;
    std::vector<std::string> channels;
    bool isFirstHit;
    /// The channels' values, the last ones unused where there are fewer than three.
    Vec3 (*values)(const Place&);
};

const std::vector<AovRow>& aovRows() {
    static const std::vector<AovRow> table = {
        {"depth", {"Z"}, true, [](const Place& p) { return Vec3(p.hit.depth, 0.0, 0.0); }},
        {"normal", {"X", "Y", "Z"}, true, [](const Place& p) { return p.hit.normal; }},
        {"albedo", {"R", "G", "B"}, true, [](const Place& p) { return Vec3(p.hit.albedo); }},
        {"position", {"X", "Y", "Z"}, true, [](const Place& p) { return p.hit.position; }},
        {"id", {"X"}, true, [](const Place& p) { return Vec3(p.hit.object, 0.0, 0.0); }},
        {"uv", {"U", "V"}, true, [](const Place& p) { return Vec3(p.hit.uv, 0.0); }},
        {"samples",
         {"Y"},
         false,
         [](const Place& p) { return Vec3(static_cast<double>(p.state.samples), 0.0, 0.0); }},
        {"error",
         {"Y"},
         false,
         [](const Place& p) { return Vec3(std::sqrt(p.squaredError), 0.0, 0.0); }},
    };
    return table;
}

const AovRow& rowOf(Aov aov) {
    return aovRows()[static_cast<std::size_t>(aov)];
}

/// Infinity stays, what is finite stays so.
float asFloat(double value) {
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::isinf(value) ? value : std::clamp(value, -kMost, kMost));
}

ImagePlane planeOf(const AovRow& row, const AovSource& source, const Tile& area) {
    static const FirstHit kNoHit;
    ImagePlane plane{row.name, row.channels, {}};
    std::size_t index = 0;
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x, ++index) {
            const std::size_t inFilm = source.film.offset(x, y);
            const Vec3 values =
                row.values({source.film.pixels[inFilm],
                            source.squaredErrors.empty() ? kInfinity : source.squaredErrors[inFilm],
                            source.hits.empty() ? kNoHit : source.hits[index]});
            for (int c = 0; c < static_cast<int>(row.channels.size()); ++c) {
                plane.values.push_back(asFloat(values[c]));
            }
        }
    }
    return plane;
}

}  // namespace

const std::vector<std::string>& aovNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const AovRow& row : aovRows()) all.emplace_back(row.name);
        return all;
    }();
    return names;
}

std::vector<std::string> namesOf(const std::vector<Aov>& aovs) {
    std::vector<std::string> names;
    for (const Aov aov : aovs) names.emplace_back(rowOf(aov).name);
    return names;
}

bool isFirstHit(Aov aov) {
    return rowOf(aov).isFirstHit;
}

std::vector<ImagePlane> planesOf(const std::vector<Aov>& aovs, const AovSource& source,
                                 const Tile& area) {
    std::vector<ImagePlane> planes;
    for (const Aov aov : aovs) planes.push_back(planeOf(rowOf(aov), source, area));
    return planes;
}

}  // namespace rt
