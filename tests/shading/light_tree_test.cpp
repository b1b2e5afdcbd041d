#include "rt/shading/light_tree.h"

#include "rt/shading/light_sample.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

using namespace rt;

namespace {

std::vector<Light> anyLights(int count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<Light> lights(static_cast<std::size_t>(count));
    for (Light& light : lights) {
        light.position = {5.0 * any(random), 5.0 * any(random), 5.0 * any(random)};
        light.intensity = Color(1.0 + any(random), 0.5, 0.2);
        light.c0 = random() % 2 ? 1.0 : 0.0;
        light.c2 = random() % 2 ? 1.0 : 0.1;
        light.radius = random() % 3 ? 0.0 : 0.2;
    }
    return lights;
}

struct Surface {
    Vec3 at{0.3, -0.2, 0.1};
    Vec3 normal = glm::normalize(Vec3(0.2, 1.0, -0.3));
};

struct Weights {
    std::vector<double> mean;   ///< of each light, over the shifts
    std::vector<double> grain;  ///< by how much one shift more would raise it
};

Weights meanWeights(const std::vector<Light>& lights, const Surface& surface, int count,
                    int shifts) {
    const LightTree tree(lights);
    Weights weights{std::vector<double>(lights.size(), 0.0),
                    std::vector<double>(lights.size(), 0.0)};
    for (int i = 0; i < shifts; ++i) {
        const LightTree::Choice choice =
            tree.choose(surface.at, surface.normal, surface.normal, count, (i + 0.5) / shifts);
        for (int k = 0; k < choice.count; ++k) {
            const ChosenLight& chosen = choice.lights[static_cast<std::size_t>(k)];
            weights.mean[chosen.light] += chosen.weight / shifts;
            weights.grain[chosen.light] = chosen.weight / shifts;
        }
    }
    return weights;
}

double irradianceOf(const Light& light, const Vec3& from) {
    const std::optional<LightView> view = viewOf(light, from);
    return view ? view->irradiance.x : 0.0;
}

/// Whether some of a light lies above the surface.
bool isAbove(const Light& light, const Surface& surface) {
    return glm::dot(light.position - surface.at, surface.normal) > -light.radius;
}

}  // namespace

TEST_CASE("in the mean over the shifts each light above the surface counts once, the others not") {
    for (const int lightCount : {1, 2, 3, 7, 40, 300}) {
        for (const int count : {1, 2, 5, 16, 32}) {
            CAPTURE(lightCount);
            CAPTURE(count);
            const auto lights = anyLights(lightCount, 5u + static_cast<unsigned>(lightCount));
            constexpr int kShifts = 20'000;
            const Surface surface;
            const Weights weights = meanWeights(lights, surface, count, kShifts);
            const std::vector<double>& means = weights.mean;
            for (std::size_t i = 0; i < lights.size(); ++i) {
                if (isAbove(lights[i], surface)) {
                    CHECK(std::fabs(means[i] - 1.0) <= 1.01 * weights.grain[i]);
                } else {
                    CHECK(means[i] == 0.0);
                }
            }
            double sum = 0.0;
            double expected = 0.0;
            for (std::size_t i = 0; i < lights.size(); ++i) {
                const double value = irradianceOf(lights[i], surface.at);
                sum += means[i] * value;
                if (isAbove(lights[i], surface)) expected += value;
            }
            CHECK(sum == doctest::Approx(expected).epsilon(2e-3));
        }
    }
}

TEST_CASE("choices are few, of different lights, and near ones come first") {
    const auto lights = anyLights(1000, 77);
    const LightTree tree(lights);
    const Surface surface;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto distance = [&](std::size_t k) {
            return glm::length(lights[k].position - surface.at);
        };
        if (isAbove(lights[i], surface) && distance(i) < distance(nearest)) nearest = i;
    }
    int found = 0;
    for (int i = 0; i < 100; ++i) {
        const LightTree::Choice choice =
            tree.choose(surface.at, surface.normal, surface.normal, 16, i / 100.0);
        CHECK(choice.count <= 16);
        std::vector<Index> chosen;
        for (int k = 0; k < choice.count; ++k) {
            chosen.push_back(choice.lights[static_cast<std::size_t>(k)].light);
            found += chosen.back() == nearest;
        }
        std::sort(chosen.begin(), chosen.end());
        CHECK(std::unique(chosen.begin(), chosen.end()) == chosen.end());
    }
    CHECK(found >= 5);  // 1 or 2 if all were alike
}

TEST_CASE("suns stand beside the tree; one place for all, and no power, are taken") {
    std::vector<Light> lights = anyLights(3, 9);
    lights.push_back(sunLight({0.0, -1.0, 0.0}, Color(1.0), 1.0, 0.0));
    const LightTree tree(lights);
    CHECK(tree.suns() == std::vector<Index>{3});
    CHECK(LightTree({&lights[3], 1}).isEmpty());

    std::vector<Light> same(50);
    for (Light& light : same) light.position = {0.0, 3.0, 0.0};
    const LightTree dark(same);
    CHECK(dark.choose({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, 8, 0.5).count == 0);
    for (Light& light : same) light.intensity = Color(-1.0);
    const LightTree negative(same);
    const LightTree::Choice choice =
        negative.choose({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, 8, 0.5);
    CHECK(choice.count == 8);
    CHECK(choice.lights[0].weight == doctest::Approx(50.0 / 8.0));
    // At the lights' own place.
    CHECK(negative.choose({0.0, 3.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, 8, 0.5).count > 0);
}
