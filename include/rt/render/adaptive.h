// Where the next samples go, and when there are enough: decided between passes, from what was
// gathered alone, in a fixed order, so that neither threads nor tiles can change a byte.
//
// A pixel is smooth (it is what its corners are, see lattice.h) or sampled. The squared error of
// the image is the mean over its pixels of
//
//   sampled   ((A - B) / 2)^2 of the means of the two halves A and B of its well-spread samples,
//             clipped to [0, 1], averaged over the sampled pixels among its neighbours, for one
//             pixel's difference alone is a coin that often falls on 0;
//   smooth    its bias, and a sixteenth of the variance of each of its four corners, estimated in
//             the same way from the halves of their samples of the lights.
//
// Where lights had to be sampled, the mean W of a smooth pixel's 16 nearest corners has a quarter
// of the variance of the mean N of its four. On a surface f it is off by 7/12 (f_xx + f_yy), of
// which W - N holds 1/2: its square, less its variance, in the mean of the neighbours, estimates
// the square of that bias. The mean of less error counts.
#pragma once

#include "rt/core/zeroed_array.h"
#include "rt/render/film.h"
#include "rt/render/smooth_pixels.h"
#include "rt/render/snapshot.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rt {

/// What one look at a doubling has to weigh.
struct AdaptiveGoal {
    double squaredTarget = 0.0;  ///< of the image's mean squared error
    std::uint32_t firstSamples = 4;
    std::uint32_t maxSamples = 4096;
};

/// Numbers of samples that pixels and corners should have after the next pass, or less where they
/// need no more.
struct AdaptivePass {
    std::vector<std::uint32_t> pixels;
    std::vector<std::uint32_t> corners;
    std::uint64_t more = 0;  ///< samples and probes in all; 0 when nothing is left to do
};

/// The state of a render towards an error target.
class Adaptive {
  public:
    /// `lattice` may be null: then every pixel is sampled. `fine` marks pixels that must not be
    /// smooth, and may be empty.
    Adaptive(Film& film, const Lattice* lattice, std::vector<bool> fine);

    /// Tells smooth pixels from others, once all corners have been probed. Those whose bias alone
    /// is above `squaredBiasLimit` are sampled. `told` may be empty: pixels of which all is known
    /// (coarse_lattice.h).
    void classify(double squaredBiasLimit, const ToldPixels& told);

    /// The pixels that the next round looks at through their centres, if any are left, and the
    /// verdict on what was seen there.
    std::vector<std::size_t> nextAudit();
    void judgeAudit(const std::vector<Probe>& centres, double squaredTarget);
    /// Whether another round is due.
    bool wantsAudit(double squaredTarget) const;

    /// Brings the estimates up to date with the film and the lattice.
    void update();
    /// Whether that says something: corners were classified, and every sampled pixel has two
    /// halves.
    bool knowsError() const;
    /// The mean squared error of the image, by `update`.
    double squaredError() const { return squaredError_; }
    /// Estimated squared errors of all pixels, with what is feared or thought to be missed; their
    /// mean is `squaredError`.
    std::vector<double> squaredErrors() const;
    /// Estimated squared error of a pixel.
    double squaredErrorAt(std::size_t pixel) const { return pixelError_[pixel]; }

    /// The next pass: a doubling where that brings most for its price. Pixels and corners double
    /// one after another, most error a sample first, until the image would meet the goal; those
    /// that would double at least once do so now, once. Smooth pixels whose bias costs more than
    /// samples of their own become sampled.
    AdaptivePass next(const AdaptiveGoal& goal);
    /// The first samples of pixels that are not smooth.
    AdaptivePass first(std::uint32_t samples) const;
    /// Twice as many in every pixel.
    AdaptivePass doubled(std::uint32_t most) const;

    /// Gives those smooth pixels their values that more samples of the lights could have changed.
    /// Of a render that stopped before it classified, every pixel gets the mean of what was seen
    /// through its corners, if anything was.
    void settle();

    /// What there is so far, between two calls of the others; without the image's error.
    RenderSnapshot snapshot() const;

  private:
    struct Work;

    std::size_t cornerOf(std::size_t pixel) const { return pixel + pixel / width_; }
    bool isSmooth(std::size_t pixel) const { return kind_[pixel] != Kind::kSampled; }
    void listPlaces();
    void openCorners(const ToldPixels& told);
    void classifyPixel(std::size_t pixel, double squaredBiasLimit);
    void updateCorners();
    void updateVariance(std::size_t corner);
    void updateSmoothPixels();
    void updateSampledPixels();
    void updatePooledError(std::size_t pixel);
    void lookAtSmooth(std::size_t pixel, const SmoothPixel& found, double noise);
    void lookAtWide(std::size_t pixel);
    void chooseCorners(std::size_t pixel);
    bool isAmongSmooth(std::size_t pixel) const;
    void settleUnclassified(std::size_t pixel);
    std::optional<Color> meanSeenThroughCorners(std::size_t pixel) const;
    double noiseAround(std::size_t corner) const;
    double doubtOf(std::size_t pixel) const;
    std::vector<float> cornerWeights() const;
    std::vector<Work> openWork(const AdaptiveGoal& goal) const;
    AdaptivePass standing() const;

    Color colorOf(std::size_t pixel) const;
    bool isSettled(std::size_t pixel) const;
    bool isSuspect(std::size_t pixel) const {
        return !suspicion_.empty() && suspicion_[pixel] > 0.0F;
    }
    double slopeAt(int x, int y, const Color& color) const;
    void spreadSuspicion();

    static bool worthTwo(const Work& item, double price);

    /// Uncertain pixels are smooth, and depend on lights that had to be sampled.
    enum class Kind : std::uint8_t { kSampled, kSmooth, kUncertain };

    /// What one place's own samples say, and when that was last looked at.
    struct Evidence {
        double error = 0.0;          ///< squared, before averaging over neighbours
        std::uint32_t samples = 0;   ///< that it is from
        std::uint32_t lastWork = 0;  ///< the last update that worked on it
    };
    bool isFirstWorkOn(Evidence& place) const;

    /// The mean of a pixel's 16 nearest corners.
    struct Wide {
        bool isKnown = false;      ///< all of them lie on one smooth surface
        bool isChosen = false;     ///< it has less error than the mean of the four
        float squaredStep = 0.0F;  ///< from the mean of the four to it, mean over the channels
        float stepVariance = 0.0F;
        float variance = 0.0F;
    };

    Film& film_;
    const Lattice* lattice_;
    std::optional<SmoothPixels> smoothPixels_;
    std::size_t width_;
    std::vector<bool> fine_;
    std::vector<Kind> kind_;
    std::vector<std::size_t> sampled_;  ///< pixels
    std::vector<std::size_t> uncertainPixels_;
    std::vector<std::size_t> uncertainCorners_;
    std::vector<std::size_t> changed_;  ///< places with more samples than at the last update
    ZeroedArray<Evidence> pixelEvidence_;
    ZeroedArray<Evidence> cornerEvidence_;
    std::uint32_t updates_ = 0;
    std::vector<double> pixelError_;      ///< estimated squared error of each pixel
    std::vector<double> bias_;            ///< squared, of smooth pixels
    std::vector<std::uint8_t> isBiased_;  ///< where `bias_` is more than noise
    ZeroedArray<Wide> wide_;              ///< of uncertain pixels
    ZeroedArray<double> variance_;        ///< of each corner's mean

    std::vector<std::size_t> audited_;
    int auditRound_ = 0;
    double missed_ = 0.0;  ///< thought to be off in pixels that were not looked at, a pixel of all
    /// Sampled pixels whose neighbours are suspect if they are not what was expected.
    struct Spreading {
        std::size_t pixel;
        Color expected;
    };
    std::vector<Spreading> spreading_;
    std::vector<std::size_t> suspects_;
    std::vector<float> suspicion_;  ///< squared error of each pixel that is feared, where any is
    double squaredTarget_ = 0.0;

    double squaredError_ = 0.0;
    bool classified_;
};

}  // namespace rt
