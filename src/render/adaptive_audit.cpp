// Adaptive's looks at pixels that their corners call smooth: what corners missed is found by
// samples, and among the neighbours of what was found.
#include "adaptive_parts.h"
#include "rt/render/adaptive.h"

namespace rt {
namespace {

/// A round looks at one of so many pixels.
constexpr int kRounds = 16;

/// Squared differences to a neighbour within which a sample of a smooth pixel may lie from its
/// mean: twice as far, for a sample may lie in its corner.
constexpr double kWithinSlope = 4.0;

/// Differences below this share of the target, in squares, are no matter.
constexpr double kNoMatter = 0.25;

/// Another round is due where what others would find is more than this share of the target's
/// square.
constexpr double kMissedShare = 0.125;

/// What is thought to be off a pixel's mean, in squares of what its centre or its neighbour's mean
/// is off by.
constexpr double kShareOfPixel = 0.25;

/// The pixels of a 4 x 4 block by turns, evenly spread (Bayer, An Optimum Method for Two-level
/// Rendition of Continuous-tone Pictures, 1973), starting elsewhere in each block.
int turnOf(int x, int y) {
    constexpr int kOrder[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    return (kOrder[4 * (y & 3) + (x & 3)] + 7 * (x >> 2) + 11 * (y >> 2)) & (kRounds - 1);
}

}  // namespace

Color Adaptive::colorOf(std::size_t pixel) const {
    if (kind_[pixel] != Kind::kUncertain) return film_.pixels[pixel].mean();
    const std::size_t corner = cornerOf(pixel);
    return asColor(wide_[pixel].isChosen ? smoothPixels_->wideMean(corner)
                                         : smoothPixels_->meanOfCorners(corner));
}

/// A smooth pixel whose corners' lights all agree.
bool Adaptive::isSettled(std::size_t pixel) const {
    if (kind_[pixel] == Kind::kUncertain) {
        return wide_[pixel].isKnown && !(wide_[pixel].variance > 0.0F);
    }
    return kind_[pixel] == Kind::kSmooth;
}

/// The squared difference of a sample that the slope to the smooth neighbours explains.
double Adaptive::slopeAt(int x, int y, const Color& color) const {
    const Tile& area = film_.area;
    double most = 0.0;
    const auto look = [&](int u, int v) {
        if (u < area.x0 || u >= area.x1 || v < area.y0 || v >= area.y1) return;
        const std::size_t neighbour = film_.offset(u, v);
        if (!isSmooth(neighbour)) return;
        most = std::max(most, meanSquare(clipped(colorOf(neighbour)) - clipped(color)));
    };
    look(x - 1, y);
    look(x + 1, y);
    look(x, y - 1);
    look(x, y + 1);
    return kWithinSlope * most;
}

std::vector<std::size_t> Adaptive::nextAudit() {
    audited_.clear();
    if (auditRound_ == kRounds) return audited_;
    const Tile& area = film_.area;
    std::size_t pixel = 0;
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x, ++pixel) {
            if (turnOf(x, y) != auditRound_ || !isSettled(pixel) || isSuspect(pixel)) continue;
            audited_.push_back(pixel);
        }
    }
    ++auditRound_;
    return audited_;
}

bool Adaptive::wantsAudit(double squaredTarget) const {
    return classified_ && lattice_ && auditRound_ < kRounds &&
           (auditRound_ == 0 || missed_ > kMissedShare * squaredTarget);
}

void Adaptive::judgeAudit(const std::vector<Probe>& centres, double squaredTarget) {
    squaredTarget_ = squaredTarget;
    double missed = 0.0;
    double looks = 0.0;
    for (std::size_t i = 0; i < audited_.size(); ++i) {
        if (centres[i].samples == 0) continue;
        looks += 1.0;
        const std::size_t pixel = audited_[i];
        const Color expected = colorOf(pixel);
        const double squared = meanSquare(clipped(Color(centres[i].mean())) - clipped(expected));
        const auto [x, y] = film_.area.placeOf(pixel);
        if (squared <= std::max(slopeAt(x, y, expected), kNoMatter * squaredTarget)) continue;
        missed += squared;
        spreading_.push_back({pixel, expected});
    }
    for (const Spreading& wrong : spreading_) {
        if (!isSmooth(wrong.pixel)) continue;
        kind_[wrong.pixel] = Kind::kSampled;
        film_.pixels[wrong.pixel] = {};
    }
    listPlaces();
    // What other rounds would look at is as often wrong as what this one did.
    const double rest = static_cast<double>(kRounds - auditRound_) / kRounds;
    const double smooth = static_cast<double>(film_.pixels.size() - sampled_.size());
    missed_ = looks > 0.0 ? kShareOfPixel * missed / looks * rest * smooth /
                                static_cast<double>(film_.pixels.size())
                          : 0.0;
}

/// Neighbours of what was missed are suspects, and theirs, as far as samples find them wrong.
void Adaptive::spreadSuspicion() {
    std::vector<Spreading> waiting;
    for (const Spreading& from : spreading_) {
        const PixelState& pixel = film_.pixels[from.pixel];
        if (pixel.samples < 2) {
            waiting.push_back(from);
            continue;
        }
        const double squared = meanSquare(clipped(pixel.mean()) - clipped(from.expected));
        if (squared <= kNoMatter * squaredTarget_) continue;
        suspicion_.resize(kind_.size());
        const auto [x, y] = film_.area.placeOf(from.pixel);
        forNeighbourhood(film_.area, x, y, [&](int u, int v) {
            const std::size_t neighbour = film_.offset(u, v);
            if (!isSmooth(neighbour)) return;
            float& suspicion = suspicion_[neighbour];
            if (suspicion == 0.0F) suspects_.push_back(neighbour);
            suspicion = std::max(suspicion, static_cast<float>(kShareOfPixel * squared));
        });
    }
    spreading_ = std::move(waiting);
}

}  // namespace rt
