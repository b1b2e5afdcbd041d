#include "motion_bounds.h"

#include "rt/core/numeric.h"
#include "rt/math/portable.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr double kTurnOfPiece = 5.0;  // degrees
constexpr int kMostPieces = 144;

struct Span {
    double low = 0.0;
    double high = 0.0;
};

Span operator+(const Span& a, const Span& b) {
    return {a.low + b.low, a.high + b.high};
}

Span operator*(const Span& a, const Span& b) {
    const auto [low, high] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
}

/// A box, and what its corners' roundings are relative to.
struct Box {
    Span axis[3];
    double size = 0.0;
};

/// The cosines of all angles of a span, in degrees.
Span cosines(const Span& degrees) {
    const double a = portable::cosDegrees(degrees.low);
    const double b = portable::cosDegrees(degrees.high);
    const auto holds = [&](double angle) {  // or one that is whole turns away
        return std::floor((degrees.high - angle) / 360.0) >=
               std::ceil((degrees.low - angle) / 360.0);
    };
    return {holds(180.0) ? -1.0 : std::min(a, b), holds(0.0) ? 1.0 : std::max(a, b)};
}

Box mapped(const Affine& map, const Box& box) {
    Box image;
    for (int r = 0; r < 3; ++r) {
        Span sum{map.translation[r], map.translation[r]};
        double size = std::fabs(map.translation[r]);
        for (int c = 0; c < 3; ++c) {
            const double entry = map.linear[c][r];
            sum = sum + Span{entry, entry} * box.axis[c];
            size += std::fabs(entry) * box.size;
        }
        image.axis[r] = sum;
        image.size = std::max(image.size, size);
    }
    return image;
}

Box turned(int axis, const Span& degrees, const Box& box) {
    const Span cosine = cosines(degrees);
    const Span sine = cosines({degrees.low - 90.0, degrees.high - 90.0});
    const Span minusSine{-sine.high, -sine.low};
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    Box image = box;
    image.axis[j] = cosine * box.axis[j] + minusSine * box.axis[k];
    image.axis[k] = sine * box.axis[j] + cosine * box.axis[k];
    image.size = 2.0 * box.size;
    return image;
}

Box moved(const Vec3& by, const Span& time, const Box& box) {
    Box image = box;
    for (int r = 0; r < 3; ++r) {
        image.axis[r] = box.axis[r] + time * Span{by[r], by[r]};
        image.size = std::max(image.size, box.size + std::fabs(by[r]));
    }
    return image;
}

}  // namespace

Bounds sweptBounds(const MotionPath& path, const Bounds& bounds) {
    double mostTurned = 0.0;
    for (const MotionStep& step : path.steps) {
        mostTurned = std::max(mostTurned, std::fabs(step.degrees));
    }
    const int pieces = static_cast<int>(
        std::clamp(std::ceil(mostTurned / kTurnOfPiece), 1.0, static_cast<double>(kMostPieces)));
    Bounds all;
    for (int piece = 0; piece < pieces; ++piece) {
        const Span time{static_cast<double>(piece) / pieces,
                        static_cast<double>(piece + 1) / pieces};
        Box box;
        for (int r = 0; r < 3; ++r) {
            box.axis[r] = {bounds.min[r], bounds.max[r]};
            box.size = std::max({box.size, std::fabs(bounds.min[r]), std::fabs(bounds.max[r])});
        }
        for (const MotionStep& step : path.steps) {
            box = mapped(step.before, box);
            box = step.degrees == 0.0
                      ? moved(step.by, time, box)
                      : turned(step.axis, time * Span{step.degrees, step.degrees}, box);
        }
        box = mapped(path.last, box);
        // Eight roundings in a map, as many in a step, here and where the path is composed.
        const double pad = gamma(32 * (static_cast<int>(path.steps.size()) + 1)) * box.size;
        for (int r = 0; r < 3; ++r) {
            all.min[r] = std::min(all.min[r], box.axis[r].low - pad);
            all.max[r] = std::max(all.max[r], box.axis[r].high + pad);
        }
    }
    return all;
}

}  // namespace rt
