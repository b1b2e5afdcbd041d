#include "rt/render/lattice.h"

#include "rt/core/numeric.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

/// Two corners whose normals are further apart than this (cosine), or that lie further off each
/// other's tangent planes than this share of their distance, see a bend between them.
constexpr float kSmoothBend = 0.94F;
constexpr float kSmoothRise = 0.35F;

/// What is left of the correction by second differences, as a share of it.
constexpr double kLeftByCorrection = 0.5;

/// Variance of (f_xx + f_yy) / 12 in that of a corner: 4 (1/2)^2 + 8 (1/4)^2, over 144.
constexpr double kNoiseOfDifferences = 1.5 / 144;

/// Variance of the change of a second difference, 1 3 3 1 squared, in that of a corner.
constexpr double kNoiseOfChange = 20.0;

/// Squared error of a step of T/2 at an unknown place in the pixel: (T/2)^2 / 12.
constexpr double kStepInChange = 1.0 / 48;

/// Squares of noise this many times above their mean are rarer than one in 300 (three deviations).
constexpr double kSignificant = 9.0;

bool continues(const Probe& a, const Probe& b) {
    return a.surfaces == b.surfaces && ((a.lit & b.dark) | (a.dark & b.lit)) == 0;
}

/// Whether the camera's surface goes on from a to b without a fold or a gap.
bool isOneSurface(const Probe& a, const Probe& b) {
    if (!a.has(kProbeHit)) return true;
    if (glm::dot(a.normal, b.normal) < kSmoothBend) return false;
    const glm::vec3 step = b.position - a.position;
    const float rise =
        std::max(std::fabs(glm::dot(a.normal, step)), std::fabs(glm::dot(b.normal, step)));
    if (rise == 0.0F) return true;
    return rise <= kSmoothRise * glm::length(step) + kProbePositionError * glm::length(a.position);
}

}  // namespace

SmoothPixels::SmoothPixels(const Lattice& lattice)
    : lattice_(lattice), bends_(lattice.probes.size()) {}

void SmoothPixels::measure() {
    for (std::size_t corner = 0; corner < bends_.size(); ++corner) measure(corner);
}

void SmoothPixels::measure(std::size_t corner) {
    const std::size_t stride = lattice_.stride();
    const std::size_t column = corner % stride;
    Bend& bend = bends_[corner];
    bend = {};
    if (column > 0 && column + 1 < stride) bend.across = difference(corner, 1);
    if (corner >= stride && corner + stride < bends_.size()) {
        bend.down = difference(corner, stride);
    }
}

SmoothPixels::Difference SmoothPixels::difference(std::size_t corner, std::size_t step) const {
    const Probe& before = lattice_.probes[corner - step];
    const Probe& here = lattice_.probes[corner];
    const Probe& after = lattice_.probes[corner + step];
    if (!continues(before, here) || !continues(here, after) || !continues(before, after)) {
        return {};
    }
    return {before.mean() - 2.0F * here.mean() + after.mean(), true};
}

void SmoothPixels::Correction::addLine(const Difference& first, const Difference& second,
                                       glm::vec3& sum, int& count) {
    glm::vec3 change(0.0F);
    if (first.known && second.known) {
        change = second.value - first.value;
        sum += first.value + second.value;
        count += 2;
    } else if (first.known || second.known) {
        // The one that is not known may be the opposite half of a step.
        change = first.known ? first.value : second.value;
        sum += change;
        ++count;
    }
    squaredChange = std::max(squaredChange, glm::dot(change, change));
}

SmoothPixels::Correction SmoothPixels::correction(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    const Bend& a = bends_[corner];
    const Bend& b = bends_[corner + 1];
    const Bend& c = bends_[below];
    const Bend& d = bends_[below + 1];
    Correction found;
    glm::vec3 across(0.0F);
    glm::vec3 down(0.0F);
    int acrossCount = 0;
    int downCount = 0;
    found.addLine(a.across, b.across, across, acrossCount);
    found.addLine(c.across, d.across, across, acrossCount);
    found.addLine(a.down, c.down, down, downCount);
    found.addLine(b.down, d.down, down, downCount);
    found.known = acrossCount > 0 && downCount > 0;
    if (found.known) {
        found.value = across * (1.0F / (12.0F * static_cast<float>(acrossCount))) +
                      down * (1.0F / (12.0F * static_cast<float>(downCount)));
    }
    return found;
}

glm::vec3 SmoothPixels::meanOfKnown(const Difference& a, const Difference& b) {
    if (a.known && b.known) return 0.5F * (a.value + b.value);
    return a.known ? a.value : b.value;
}

glm::vec3 SmoothPixels::across(std::size_t corner) const {
    return meanOfKnown(bends_[corner].across, bends_[corner + 1].across);
}

glm::vec3 SmoothPixels::down(std::size_t corner) const {
    return meanOfKnown(bends_[corner].down, bends_[corner + lattice_.stride()].down);
}

bool SmoothPixels::isUncertain(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    return ((lattice_.probes[corner].marks | lattice_.probes[corner + 1].marks |
             lattice_.probes[below].marks | lattice_.probes[below + 1].marks) &
            kProbeUncertain) != 0;
}

bool SmoothPixels::isOfOnePiece(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    const Probe& a = lattice_.probes[corner];
    const Probe& b = lattice_.probes[corner + 1];
    const Probe& c = lattice_.probes[below];
    const Probe& d = lattice_.probes[below + 1];
    const std::uint64_t lit = a.lit | b.lit | c.lit | d.lit;
    const std::uint64_t dark = a.dark | b.dark | c.dark | d.dark;
    const bool same = a.surfaces == b.surfaces && a.surfaces == c.surfaces &&
                      a.surfaces == d.surfaces && (lit & dark) == 0;
    if (!same || ((a.marks | b.marks | c.marks | d.marks) & kProbeDetail)) return false;
    return isOneSurface(a, d) && isOneSurface(b, c);
}

std::optional<SmoothPixel> SmoothPixels::find(std::size_t corner, double noise) const {
    if (!isOfOnePiece(corner)) return std::nullopt;
    const Correction off = correction(corner);
    if (!off.known) return std::nullopt;
    return at(corner, noise, off);
}

SmoothPixel SmoothPixels::at(std::size_t corner, double noise, const Correction& off) const {
    const std::size_t below = corner + lattice_.stride();
    SmoothPixel pixel;
    for (const std::size_t i : {corner, corner + 1, below, below + 1}) {
        pixel.value += 0.25F * lattice_.probes[i].mean();
    }
    const double squaredChange = static_cast<double>(off.squaredChange) / 3.0;
    const double squared = static_cast<double>(glm::dot(off.value, off.value)) / 3.0;
    if (isUncertain(corner)) {
        pixel.isBiased = squared > kSignificant * kNoiseOfDifferences * noise ||
                         squaredChange > kSignificant * kNoiseOfChange * noise;
        if (pixel.isBiased) pixel.squaredBias = squared + kStepInChange * squaredChange;
    } else {
        pixel.value -= off.value;
        pixel.squaredBias =
            kLeftByCorrection * kLeftByCorrection * squared + kStepInChange * squaredChange;
        pixel.isBiased = true;
    }
    return pixel;
}

}  // namespace rt
