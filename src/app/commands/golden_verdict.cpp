#include "golden_verdict.h"

#include "rt/core/numeric.h"
#include "rt/core/text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rt {
namespace {

// The portable tier: how far a channel may be apart, from where on a pixel counts as another, and
// the largest share of such pixels. Two roundings lie between a byte and its share of 255.
constexpr double kPortableStep = 1.0 / 255.0 + gamma(4);
constexpr double kPortableOther = 0.5 / 255.0;
constexpr double kPortableShare = 0.001;

// The statistical tier: how many standard deviations of noise a block's mean may be off. Noise
// alone reaches 5.6: the most of 40 renders of eight scenes of tests/golden/ for 0.03 to 1.5
// seconds. A light moved by 1 %, an index raised by 0.01 and one turned normal are at 21 and more.
constexpr double kDeviations = 10.0;
constexpr int kSmallestBlock = 8;
constexpr double kFewestPixels = 32.0;
/// Share of the image's mean variance that every block is taken to have: what four pictures show of
/// a block's noise is itself a guess.
constexpr double kLeastShare = 0.05;
/// The step of floats, on which even a picture without noise may be off.
constexpr double kFinestStep = 1.0 / 65535.0;

double apart(double a, double b) {
    return std::fabs(a - b) / std::max({1.0, std::fabs(a), std::fabs(b)});
}

std::string sizeText(const PixelImage& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// Half the mean square of the differences to the up to four neighbours, by channel: the variance
/// of noise from pixel to pixel, in which what changes slowly over the image does not count.
PixelImage localVariance(const PixelImage& image) {
    PixelImage result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Color squares(0.0);
            double count = 0.0;
            const auto add = [&](int u, int v) {
                if (u < 0 || v < 0 || u >= image.width || v >= image.height) return;
                const Color difference = image.at(x, y) - image.at(u, v);
                squares += difference * difference;
                count += 1.0;
            };
            add(x - 1, y);
            add(x + 1, y);
            add(x, y - 1);
            add(x, y + 1);
            result.at(x, y) = squares / std::max(2.0 * count, 1.0);
        }
    }
    return result;
}

PixelImage sumOf(const PixelImage& a, double factor, const PixelImage& b) {
    PixelImage sum = a;
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += factor * b.pixels[i];
    return sum;
}

PixelImage meanOf(const std::vector<PixelImage>& images) {
    PixelImage sum = images[0];
    for (std::size_t i = 1; i < images.size(); ++i) sum = sumOf(sum, 1.0, images[i]);
    for (Color& pixel : sum.pixels) pixel /= static_cast<double>(images.size());
    return sum;
}

struct Block {
    int x = 0;
    int y = 0;
    int side = 0;
    double pixels = 0.0;
};

/// The squares that a picture falls into, but for slivers at its border; at least one.
std::vector<Block> blocksOf(const PixelImage& image, int side) {
    std::vector<Block> blocks;
    for (int y = 0; y < image.height; y += side) {
        for (int x = 0; x < image.width; x += side) {
            const double pixels = static_cast<double>(std::min(side, image.width - x)) *
                                  static_cast<double>(std::min(side, image.height - y));
            if (pixels >= kFewestPixels || blocks.empty()) blocks.push_back({x, y, side, pixels});
        }
    }
    return blocks;
}

Color meanIn(const PixelImage& image, const Block& block) {
    Color sum(0.0);
    for (int y = block.y; y < std::min(block.y + block.side, image.height); ++y) {
        for (int x = block.x; x < std::min(block.x + block.side, image.width); ++x) {
            sum += image.at(x, y);
        }
    }
    return sum / block.pixels;
}

/// Pictures of one scene with a noise each, and what they say about it.
class Noise {
  public:
    Noise(const std::vector<ComparedImage>& pictures, double step)
        : count_(static_cast<double>(pictures.size())) {
        for (const ComparedImage& picture : pictures) images_.push_back(picture.image);
        mean_ = meanOf(images_);
        std::vector<PixelImage> variances;
        for (const PixelImage& image : images_) {
            variances.push_back(localVariance(sumOf(image, -1.0, mean_)));
        }
        variance_ = meanOf(variances);
        for (Color& pixel : variance_.pixels) pixel *= count_ / (count_ - 1.0);
        const Color all = meanIn(variance_, {0, 0, std::max(mean_.width, mean_.height),
                                             static_cast<double>(variance_.pixels.size())});
        // The variance of the sum of two roundings to a step.
        const double rounding = step * step / 6.0;
        floor_ = kLeastShare * all + Color(rounding);
    }

    const PixelImage& mean() const { return mean_; }
    /// Of one picture's pixels in a block.
    Color varianceIn(const Block& block) const { return meanIn(variance_, block) + floor_; }

    /// How much more a block's mean varies than if its pixels had nothing to do with each other, at
    /// least 1.
    double togetherness(const std::vector<Block>& blocks) const {
        double found = 0.0;
        double expected = 0.0;
        for (const Block& block : blocks) {
            const Color mean = meanIn(mean_, block);
            for (const PixelImage& image : images_) {
                const Color apart = meanIn(image, block) - mean;
                found += block.pixels * glm::dot(apart, apart) / (count_ - 1.0);
            }
            const Color variance = varianceIn(block);
            expected += variance.r + variance.g + variance.b;
        }
        return std::max(1.0, found / expected);
    }

    /// How many times the variance of one picture's pixels a difference from the mean has: one part
    /// is the mean's own, the rest the reference's, whose noise is its own affair. The median over
    /// the blocks that have noise.
    double timesIn(const PixelImage& difference) const {
        const PixelImage variance = localVariance(difference);
        std::vector<double> ratios;
        for (const Block& block : blocksOf(variance, kSmallestBlock)) {
            const Color own = meanIn(variance_, block);
            const Color apart = meanIn(variance, block);
            for (int c = 0; c < 3; ++c) {
                if (own[c] > floor_[c]) ratios.push_back(apart[c] / own[c]);
            }
        }
        const double least = 1.0 + 1.0 / count_;
        if (ratios.empty()) return least;
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        return std::max(least, *middle);
    }

  private:
    double count_;
    std::vector<PixelImage> images_;
    PixelImage mean_;
    PixelImage variance_;
    Color floor_{0.0};
};

}  // namespace

const char* nameOf(GoldenTier tier) {
    switch (tier) {
        case GoldenTier::kExact:
            return "exact";
        case GoldenTier::kPortable:
            return "portable";
        case GoldenTier::kStatistical:
            return "statistical";
    }
    return "";
}

std::string incomparable(const ComparedImage& picture, const ComparedImage& reference) {
    if (picture.image.width != reference.image.width ||
        picture.image.height != reference.image.height) {
        return "the sizes differ: the picture has " + sizeText(picture.image) +
               " pixels, its reference " + sizeText(reference.image);
    }
    if (picture.channels != reference.channels) {
        return "the channels differ: the picture has " + std::to_string(picture.channels) +
               ", its reference " + std::to_string(reference.channels);
    }
    if (picture.floats != reference.floats) {
        return std::string("one holds floats and the other integers: the ") +
               (picture.floats ? "picture" : "reference") + " has the floats";
    }
    if (picture.step != reference.step) {
        return std::string("the picture has ") +
               (picture.step < reference.step ? "more" : "fewer") +
               " bits a channel than its reference (see --bits)";
    }
    if (hasNonFinite(picture.image)) return "the picture holds values that are not finite numbers";
    if (hasNonFinite(reference.image)) {
        return "the reference holds values that are not finite numbers";
    }
    return "";
}

Verdict verdictOf(const ComparedImage& picture, const ComparedImage& reference,
                  GoldenTier weakest) {
    double most = 0.0;
    std::size_t unequal = 0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < picture.image.pixels.size(); ++i) {
        const Color& a = picture.image.pixels[i];
        const Color& b = reference.image.pixels[i];
        const double largest = std::max({apart(a.r, b.r), apart(a.g, b.g), apart(a.b, b.b)});
        most = std::max(most, largest);
        if (a != b) ++unequal;
        if (largest > kPortableOther) ++others;
    }
    if (unequal == 0) return {GoldenTier::kExact, ""};
    const auto pixels = static_cast<double>(picture.image.pixels.size());
    const double share = static_cast<double>(others) / pixels;
    const std::string found =
        std::to_string(unequal) + " pixels differ, by up to " + fixed(255.0 * most, 2) + "/255";
    if (weakest == GoldenTier::kExact) return {weakest, found};
    if (most <= kPortableStep && share <= kPortableShare) return {GoldenTier::kPortable, ""};
    return {weakest, found + ", " + fixed(100.0 * share, 2) +
                         " % by more than half of 1/255 (at most 1/255, in 0.1 %)"};
}

Verdict statisticalVerdict(const std::vector<ComparedImage>& pictures,
                           const ComparedImage& reference) {
    const double step = std::max(reference.step, kFinestStep);
    const Noise noise(pictures, step);
    const PixelImage difference = sumOf(reference.image, -1.0, noise.mean());
    const double times = noise.timesIn(difference);
    double worst = 0.0;
    Block where;
    const int largest = std::max(difference.width, difference.height);
    for (int side = kSmallestBlock; side < 2 * std::max(largest, kSmallestBlock); side *= 2) {
        const std::vector<Block> blocks = blocksOf(difference, side);
        const double together = noise.togetherness(blocks);
        for (const Block& block : blocks) {
            const Color mean = meanIn(difference, block);
            const Color variance = together * times * noise.varianceIn(block) / block.pixels;
            for (int c = 0; c < 3; ++c) {
                // An even surface may lie on the border of two steps, and all of it round one way.
                const double over = std::max(std::fabs(mean[c]) - step, 0.0);
                const double deviations = over / std::sqrt(variance[c]);
                if (deviations <= worst) continue;
                worst = deviations;
                where = block;
            }
        }
    }
    if (worst <= kDeviations) return {GoldenTier::kStatistical, ""};
    return {GoldenTier::kStatistical,
            "the mean of the " + std::to_string(where.side) + " x " + std::to_string(where.side) +
                " pixels from " + std::to_string(where.x) + "," + std::to_string(where.y) +
                " is off by " + fixed(worst, 1) + " standard deviations of the noise (at most " +
                fixed(kDeviations, 0) + ")"};
}

}  // namespace rt
