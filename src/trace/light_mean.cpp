#include "light_mean.h"

#include "rt/core/numeric.h"
#include "rt/math/portable.h"
#include "rt/sampling/warp.h"
#include "rt/shading/fresnel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

/// A place on the unit disc and its share of the area.
struct DiscNode {
    double x;
    double y;
    double weight;
};

constexpr double kRootTwoThirds = 0.816496580927726;
constexpr double kHalfRootTwoThirds = 0.408248290463863;
constexpr double kRootHalf = 0.7071067811865476;

/// Degree 5: the centre and a hexagon.
constexpr std::array<DiscNode, 7> kBlunt = {{
    {0.0, 0.0, 0.25},
    {kRootTwoThirds, 0.0, 0.125},
    {-kRootTwoThirds, 0.0, 0.125},
    {kHalfRootTwoThirds, kRootHalf, 0.125},
    {-kHalfRootTwoThirds, kRootHalf, 0.125},
    {kHalfRootTwoThirds, -kRootHalf, 0.125},
    {-kHalfRootTwoThirds, -kRootHalf, 0.125},
}};

/// Gauss-Legendre over r^2 in [0, 1], equal angles, turned by half a step from ring to ring.
template <std::size_t Rings, std::size_t Angles>
std::array<DiscNode, Rings * Angles> ringRule(const std::array<double, Rings>& squaredRadii,
                                              const std::array<double, Rings>& weights) {
    std::array<DiscNode, Rings * Angles> nodes{};
    for (std::size_t ring = 0; ring < Rings; ++ring) {
        for (std::size_t k = 0; k < Angles; ++k) {
            const double turn = (static_cast<double>(k) + (ring % 2 ? 0.5 : 0.0)) * 360.0 /
                                static_cast<double>(Angles);
            const double r = std::sqrt(squaredRadii[ring]);
            nodes[ring * Angles + k] = {r * portable::cosDegrees(turn),
                                        r * portable::sinDegrees(turn),
                                        weights[ring] / static_cast<double>(Angles)};
        }
    }
    return nodes;
}

const std::array<DiscNode, 24>& sharpRule() {
    static const std::array<DiscNode, 24> nodes = ringRule<3, 8>(
        {0.1127016653792583, 0.5, 0.8872983346207417}, {5.0 / 18, 8.0 / 18, 5.0 / 18});
    return nodes;
}

const std::array<DiscNode, 96>& sharpestRule() {
    static const std::array<DiscNode, 96> nodes =
        ringRule<6, 16>({0.0337652428984240, 0.1693953067668678, 0.3806904069584016,
                         0.6193095930415985, 0.8306046932331322, 0.9662347571015760},
                        {0.0856622461895852, 0.1803807865240693, 0.2339569672863455,
                         0.2339569672863455, 0.1803807865240693, 0.0856622461895852});
    return nodes;
}

/// p (1 - cos A) up to which each rule is used.
constexpr double kBluntUpTo = 0.5;
constexpr double kSharpUpTo = 6.0;
constexpr double kSharpestUpTo = 64.0;

/// A lobe that is below this everywhere in the cone is nothing: 8 of them are a 16-bit step.
constexpr double kNoLobe = 1.0 / (1 << 19);

template <class Nodes>
double meanOf(const Nodes& nodes, const Vec3& mirrored, double exponent, const LightView& view) {
    const Basis basis = orthonormalBasis(view.axis);
    const double along = glm::dot(mirrored, view.axis);
    const double right = glm::dot(mirrored, basis.tangent);
    const double up = glm::dot(mirrored, basis.bitangent);
    const double h = view.oneMinusCos;
    double sum = 0.0;
    for (const DiscNode& node : nodes) {
        const double squared = node.x * node.x + node.y * node.y;
        const double lowered = squared * h;
        const double scale = std::sqrt(h * (2.0 - lowered));
        const double cosine = (1.0 - lowered) * along + scale * (node.x * right + node.y * up);
        if (cosine > 0.0) {
            sum += node.weight * portable::powUnit(std::min(cosine, 1.0), exponent);
        }
    }
    return sum;
}

/// Mean of max(w . mirrored, 0)^p over the cone.
std::optional<double> lobeMean(const Vec3& mirrored, double exponent, const LightView& view) {
    const double sharpness = exponent * view.oneMinusCos;
    const double cosine = glm::dot(mirrored, view.axis);
    // The greatest w . mirrored in the cone: cos(angle - A), or 1 within it.
    const double cosA = 1.0 - view.oneMinusCos;
    const double sinA = std::sqrt(view.oneMinusCos * (1.0 + cosA));
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    const double greatest = cosine >= cosA ? 1.0 : cosine * cosA + sine * sinA;
    if (!(greatest > 0.0) && exponent > 0.0) return 0.0;
    if (portable::powUnit(std::clamp(greatest, 0.0, 1.0), exponent) < kNoLobe) return 0.0;
    if (view.isPoint()) return portable::powUnit(std::clamp(cosine, 0.0, 1.0), exponent);
    if (sharpness <= kBluntUpTo) return meanOf(kBlunt, mirrored, exponent, view);
    if (sharpness <= kSharpUpTo) return meanOf(sharpRule(), mirrored, exponent, view);
    if (sharpness <= kSharpestUpTo) return meanOf(sharpestRule(), mirrored, exponent, view);
    return std::nullopt;
}

double sineOf(const LightView& view) {
    return std::sqrt(view.oneMinusCos * (2.0 - view.oneMinusCos));
}

}  // namespace

LightHorizon horizonOf(const LightView& view, const Vec3& geometricNormal, const Vec3& normal) {
    const double sine = sineOf(view);
    const double geometric = glm::dot(geometricNormal, view.axis);
    if (geometric <= -sine - kUnitDotError) return LightHorizon::kBelow;
    const double least = std::min(geometric, glm::dot(normal, view.axis));
    return least >= sine + kUnitDotError ? LightHorizon::kAbove : LightHorizon::kCut;
}

std::optional<Color> unoccludedMean(const Material& material, const Vec3& normal,
                                    const Vec3& toViewer, const Light& light, const LightView& view,
                                    LightHorizon horizon) {
    if (horizon != LightHorizon::kAbove || view.distance <= view.radius) return std::nullopt;
    double cosine = glm::dot(normal, view.axis);
    if (light.brightness > 0.0) {
        const double sine = sineOf(view);
        const double across = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        const double cosA = 1.0 - view.oneMinusCos;
        const double most = cosine >= cosA ? 1.0 : cosine * cosA + across * sine;
        if (light.brightness >= most) {
            cosine = light.brightness * view.weight;
        } else if (light.brightness > cosine * cosA - across * sine) {
            return std::nullopt;
        }
    }
    Color sum = material.diffuse * cosine;
    if (material.specular != Color(0.0)) {
        const Vec3 mirrored = 2.0 * glm::dot(normal, toViewer) * normal - toViewer;
        const std::optional<double> lobe = lobeMean(mirrored, material.exponent, view);
        if (!lobe) return std::nullopt;
        sum += material.specular * (*lobe * view.weight);
    }
    return view.irradiance * sum;
}

}  // namespace rt
