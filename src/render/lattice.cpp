#include "rt/render/lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

/// Two corners whose normals are further apart than this (cosine), or that lie further off each
/// other's tangent planes than this share of their distance, see a bend between them.
constexpr float kSmoothBend = 0.94F;
constexpr float kSmoothRise = 0.35F;

/// Positions are single precision, relative to the eye: a rise below this is rounding.
constexpr float kRounding = 1e-6F;

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
    return rise <= kSmoothRise * glm::length(step) + kRounding * glm::length(a.position);
}

glm::vec3 meanOfKnown(const glm::vec3& a, bool hasA, const glm::vec3& b, bool hasB) {
    if (hasA && hasB) return 0.5F * (a + b);
    return hasA ? a : (hasB ? b : glm::vec3(0.0F));
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
    bend.hasAcross = column > 0 && column + 1 < stride && difference(corner, 1, bend.across);
    bend.hasDown = corner >= stride && corner + stride < bends_.size() &&
                   difference(corner, stride, bend.down);
}

bool SmoothPixels::difference(std::size_t corner, std::size_t step, glm::vec3& out) const {
    const Probe& before = lattice_.probes[corner - step];
    const Probe& here = lattice_.probes[corner];
    const Probe& after = lattice_.probes[corner + step];
    if (!continues(before, here) || !continues(here, after) || !continues(before, after)) {
        return false;
    }
    out = before.mean() - 2.0F * here.mean() + after.mean();
    return true;
}

SmoothPixels::Correction SmoothPixels::correction(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    Correction found;
    const auto addAxis = [&](glm::vec3 Bend::*value, bool Bend::*has, std::size_t a, std::size_t b,
                             std::size_t c, std::size_t d) {
        glm::vec3 sum(0.0F);
        int count = 0;
        // Two lines of the axis, from one corner to the next.
        for (const auto& [from, to] : {std::pair(a, b), std::pair(c, d)}) {
            const Bend& first = bends_[from];
            const Bend& second = bends_[to];
            if (!(first.*has) && !(second.*has)) continue;
            // Where only one is known, the other may be its opposite half of a step.
            const glm::vec3 change = (first.*has) && (second.*has) ? second.*value - first.*value
                                     : (first.*has)                ? first.*value
                                                                   : second.*value;
            found.squaredChange =
                std::max(found.squaredChange, static_cast<double>(glm::dot(change, change)) / 3.0);
            for (const Bend* bend : {&first, &second}) {
                if (!(bend->*has)) continue;
                sum += bend->*value;
                ++count;
            }
        }
        if (count > 0) found.value += sum / (12.0F * static_cast<float>(count));
        return count > 0;
    };
    const bool across =
        addAxis(&Bend::across, &Bend::hasAcross, corner, corner + 1, below, below + 1);
    const bool down = addAxis(&Bend::down, &Bend::hasDown, corner, below, corner + 1, below + 1);
    found.known = across && down;
    return found;
}

glm::vec3 SmoothPixels::across(std::size_t corner) const {
    const Bend& a = bends_[corner];
    const Bend& b = bends_[corner + 1];
    return meanOfKnown(a.across, a.hasAcross, b.across, b.hasAcross);
}

glm::vec3 SmoothPixels::down(std::size_t corner) const {
    const Bend& a = bends_[corner];
    const Bend& b = bends_[corner + lattice_.stride()];
    return meanOfKnown(a.down, a.hasDown, b.down, b.hasDown);
}

bool SmoothPixels::isUncertain(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    return ((lattice_.probes[corner].marks | lattice_.probes[corner + 1].marks |
             lattice_.probes[below].marks | lattice_.probes[below + 1].marks) &
            kProbeUncertain) != 0;
}

bool SmoothPixels::isSmooth(std::size_t corner) const {
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
    return isOneSurface(a, d) && isOneSurface(b, c) && correction(corner).known;
}

SmoothPixel SmoothPixels::at(std::size_t corner, double noise) const {
    const std::size_t below = corner + lattice_.stride();
    SmoothPixel pixel;
    for (const std::size_t i : {corner, corner + 1, below, below + 1}) {
        pixel.value += 0.25F * lattice_.probes[i].mean();
    }
    const Correction off = correction(corner);
    const double squared = static_cast<double>(glm::dot(off.value, off.value)) / 3.0;
    if (isUncertain(corner)) {
        pixel.isBiased = squared > kSignificant * kNoiseOfDifferences * noise ||
                         off.squaredChange > kSignificant * kNoiseOfChange * noise;
        if (pixel.isBiased) pixel.squaredBias = squared + kStepInChange * off.squaredChange;
    } else {
        pixel.value -= off.value;
        pixel.squaredBias =
            kLeftByCorrection * kLeftByCorrection * squared + kStepInChange * off.squaredChange;
        pixel.isBiased = true;
    }
    return pixel;
}

}  // namespace rt
