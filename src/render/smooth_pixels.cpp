#include "rt/render/smooth_pixels.h"

#include "rt/core/numeric.h"

#include <algorithm>
#include <cmath>

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

/// The same of the difference of two corners; and of a step from one to the other.
constexpr double kNoiseOfSpan = 2.0;
constexpr double kStepInSpan = 1.0 / 12;

/// Squares of noise this many times above their mean are rarer than one in 300 (three deviations).
constexpr double kSignificant = 9.0;

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

double squaredLength(const ColorLanes& c) {
    const ColorLanes squares = c * c;
    return static_cast<double>(squares[0] + squares[1] + squares[2]);
}

}  // namespace

struct SmoothPixels::Line {
    ColorLanes sum{};
    int count = 0;
    float squaredChange = 0.0F;
};

SmoothPixels::SmoothPixels(const Lattice& lattice)
    : lattice_(lattice), corners_(lattice.probes.size()) {}

void SmoothPixels::readColor(std::size_t corner) {
    const Probe& probe = lattice_.probes[corner];
    if (probe.samples == 0) return;
    const ColorLanes sum{probe.sum.x, probe.sum.y, probe.sum.z, 0.0F};
    corners_[corner].color = sum * (1.0F / static_cast<float>(probe.samples));
}

void SmoothPixels::measureAll() {
    for (std::size_t corner = 0; corner < corners_.size(); ++corner) readColor(corner);
    for (std::size_t corner = 0; corner < corners_.size(); ++corner) measure(corner);
}

void SmoothPixels::measure(std::size_t corner) {
    const std::size_t stride = lattice_.stride();
    const std::size_t column = corner % stride;
    Corner& here = corners_[corner];
    here.knowsAcross = column > 0 && column + 1 < stride && difference(corner, 1, here.across);
    here.knowsDown = corner >= stride && corner + stride < corners_.size() &&
                     difference(corner, stride, here.down);
}

bool SmoothPixels::difference(std::size_t corner, std::size_t step, ColorLanes& found) const {
    const Probe& before = lattice_.probes[corner - step];
    const Probe& here = lattice_.probes[corner];
    const Probe& after = lattice_.probes[corner + step];
    const std::uint64_t lit = before.lit | here.lit | after.lit;
    const std::uint64_t dark = before.dark | here.dark | after.dark;
    const bool known =
        before.surfaces == here.surfaces && here.surfaces == after.surfaces && (lit & dark) == 0;
    found = known ? corners_[corner - step].color - 2.0F * corners_[corner].color +
                        corners_[corner + step].color
                  : ColorLanes{};
    return known;
}

SmoothPixels::Line SmoothPixels::lineOf(const ColorLanes& first, bool knowsFirst,
                                        const ColorLanes& second, bool knowsSecond) {
    Line line;
    line.count = int{knowsFirst} + int{knowsSecond};
    line.sum = first + second;
    // One that is not known, 0 here, may be the opposite half of a step.
    const ColorLanes change = line.count == 2 ? second - first : line.sum;
    line.squaredChange = static_cast<float>(squaredLength(change));
    return line;
}

SmoothPixels::Correction SmoothPixels::correction(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    const Corner& a = corners_[corner];
    const Corner& b = corners_[corner + 1];
    const Corner& c = corners_[below];
    const Corner& d = corners_[below + 1];
    const Line top = lineOf(a.across, a.knowsAcross, b.across, b.knowsAcross);
    const Line bottom = lineOf(c.across, c.knowsAcross, d.across, d.knowsAcross);
    const Line left = lineOf(a.down, a.knowsDown, c.down, c.knowsDown);
    const Line right = lineOf(b.down, b.knowsDown, d.down, d.knowsDown);
    const int across = top.count + bottom.count;
    const int down = left.count + right.count;
    Correction found;
    found.known = across > 0 && down > 0;
    if (!found.known) return found;
    found.squaredChange = std::max(
        {top.squaredChange, bottom.squaredChange, left.squaredChange, right.squaredChange});
    found.value = (top.sum + bottom.sum) * (1.0F / (12.0F * static_cast<float>(across))) +
                  (left.sum + right.sum) * (1.0F / (12.0F * static_cast<float>(down)));
    return found;
}

ColorLanes SmoothPixels::middle(const Corner& a, const Corner& b, const Line& line) {
    const float eighth = 0.125F / static_cast<float>(std::max(line.count, 1));
    return 0.5F * (a.color + b.color) - eighth * line.sum;
}

ColorLanes SmoothPixels::middleOfTop(std::size_t corner) const {
    const Corner& a = corners_[corner];
    const Corner& b = corners_[corner + 1];
    return middle(a, b, lineOf(a.across, a.knowsAcross, b.across, b.knowsAcross));
}

ColorLanes SmoothPixels::middleOfLeft(std::size_t corner) const {
    const Corner& a = corners_[corner];
    const Corner& c = corners_[corner + lattice_.stride()];
    return middle(a, c, lineOf(a.down, a.knowsDown, c.down, c.knowsDown));
}

ColorLanes SmoothPixels::centreOf(std::size_t corner) const {
    return meanOfCorners(corner) - 1.5F * correction(corner).value;
}

ColorLanes SmoothPixels::meanOfCorners(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    return 0.25F * (corners_[corner].color + corners_[corner + 1].color + corners_[below].color +
                    corners_[below + 1].color);
}

ColorLanes SmoothPixels::wideMean(std::size_t corner) const {
    const std::size_t stride = lattice_.stride();
    ColorLanes sum{};
    for (std::size_t row = corner - stride - 1; row < corner + 3 * stride - 1; row += stride) {
        sum += corners_[row].color + corners_[row + 1].color + corners_[row + 2].color +
               corners_[row + 3].color;
    }
    return sum * (1.0F / 16.0F);
}

float SmoothPixels::squaredStepToWide(std::size_t corner) const {
    return static_cast<float>(squaredLength(wideMean(corner) - meanOfCorners(corner)) / 3.0);
}

/// Of the wider diagonal, mean over the channels.
double SmoothPixels::squaredSpanOfCorners(std::size_t corner) const {
    const std::size_t below = corner + lattice_.stride();
    const double falling = squaredLength(corners_[below + 1].color - corners_[corner].color);
    const double rising = squaredLength(corners_[below].color - corners_[corner + 1].color);
    return std::max(falling, rising) / 3.0;
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
    SmoothPixel pixel;
    pixel.value = meanOfCorners(corner);
    const double squaredChange = static_cast<double>(off.squaredChange) / 3.0;
    const double squared = squaredLength(off.value) / 3.0;
    if (!off.known) {
        const double squaredSpan = squaredSpanOfCorners(corner);
        pixel.isBiased = squaredSpan > kSignificant * kNoiseOfSpan * noise;
        if (pixel.isBiased) pixel.squaredBias = kStepInSpan * squaredSpan;
    } else if (isUncertain(corner)) {
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
