#include "caustics.h"

#include "caustic_error.h"
#include "photon_grid.h"
#include "photon_plan.h"
#include "rt/core/parallel.h"
#include "rt/trace/seen_pixel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace rt {
namespace {

/// Pixels that tell the error, at most, and the samples of each.
constexpr double kMostPilots = 4096.0;
constexpr int kPilotSamples = 8;

/// Photons that are kept, at most: of 72 bytes, and twice that while they are sorted.
/// Where no error was asked for, a quarter.
constexpr std::size_t kMostPhotons = std::size_t{1} << 22;
constexpr std::size_t kMostUnasked = kMostPhotons / 4;
constexpr std::uint32_t kMostPasses = 1u << 15;

/// The first radius, in pixels of those that photons light, and how often it may be halved or
/// doubled after each round.
constexpr double kFirstRadius = 8.0;
/// The last pass's radius in them, at least: what is smaller slips through between a pixel's first
/// samples. Where that leaves too much bias, half and a quarter of it; more samples then come
/// first.
constexpr double kLeastRadius = 0.5;
constexpr double kFinestRadius = 0.125;
constexpr int kMostSteps = 12;

/// What takes so many times the squared target takes four times the passes, at least.
constexpr double kFarOff = 8.0;

class Tracing {
  public:
    Tracing(const RenderScene& scene, const RenderJob& job)
        : scene_(scene), job_(job), plan_(photonPlan(scene, job.settings.seed)) {
        settings_ = traceSettingsOf(job);
        settings_.photons = nullptr;
    }

    Caustics run() {
        Caustics result;
        if (plan_.sources.empty()) return result;
        lookThroughPixels();
        const double squaredTarget = job_.causticTarget * job_.causticTarget;
        std::uint32_t more = 1;
        CausticReport& report = result.report;
        while (true) {
            if (!trace(more)) break;
            chooseRadius();
            while (isStuck(squaredTarget) && least_ > kFinestRadius && !stopped()) {
                least_ *= 0.5;
                chooseRadius();
            }
            if (cancelled()) break;
            report.noise = std::sqrt(error_.noise[1]);
            report.bias = std::sqrt(error_.bias[1]);
            report.isEnough = error_.at(1) <= squaredTarget;
            if (report.isEnough || isStuck(squaredTarget) || stopped()) break;
            more = error_.at(1) > kFarOff * squaredTarget ? 3 * passes_ : passes_;
            const std::size_t most = isErrorAsked() ? kMostPhotons : kMostUnasked;
            if (map_.photons.size() * (1 + more / passes_) > most) more = passes_;
            if (2 * map_.photons.size() > most || 2 * passes_ > kMostPasses) break;
        }
        report.passes = passes_;
        report.kept = map_.photons.size();
        std::uint64_t sent = 0;
        for (const PhotonSource& source : plan_.sources) sent += source.count;
        report.sent = sent * plan_.groups * passes_;
        if (passes_ > 0 && !map_.isEmpty()) {
            rebuild(1.0);
            report.firstRadius = map_.radius;
            report.lastRadius = map_.leastRadius;
            report.lastRadiusInPixels = map_.leastRadius / footprint_;
            result.map = std::make_shared<const PhotonMap>(std::move(map_));
        }
        return result;
    }

  private:
    bool isErrorAsked() const { return job_.errorTarget > 0.0 || !job_.adaptive; }

    bool cancelled() const { return job_.cancel && job_.cancel->load(std::memory_order_relaxed); }

    bool stopped() const {
        if (cancelled()) return true;
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        return job_.timeLimit > 0.0 && seconds > 0.5 * job_.timeLimit;
    }

    /// One pixel of each square of them.
    void lookThroughPixels() {
        const double all = 1.0 * scene_.width * scene_.height;
        const int step = static_cast<int>(std::ceil(std::sqrt(std::max(all / kMostPilots, 1.0))));
        std::vector<PixelPlace> places;
        for (int y = 0; y < scene_.height; y += step) {
            for (int x = 0; x < scene_.width; x += step) {
                const std::uint64_t bits = pixelKey(job_.settings.seed, x, y);
                const auto side = static_cast<std::uint64_t>(step);
                const PixelPlace place{x + static_cast<int>(bits % side),
                                       y + static_cast<int>((bits >> 32) % side)};
                if (place.x < scene_.width && place.y < scene_.height) places.push_back(place);
            }
        }
        seen_.resize(places.size());
        forEachIndex(places.size(), job_.threads, [&](std::size_t i, int) {
            if (cancelled()) return;
            job_.kernel->seenThrough(scene_, settings_, places[i], kPilotSamples, seen_[i]);
        });
        measureFootprint([](const SeenPoint&) { return true; });
    }

    /// The median side of a pixel where `counts` says so.
    template <class Counts>
    void measureFootprint(const Counts& counts) {
        std::vector<double> sides;
        for (const SeenPixel& pixel : seen_) {
            for (const SeenPoint& seen : pixel.points) {
                if (counts(seen)) sides.push_back(seen.footprint);
            }
        }
        if (sides.empty()) return;
        const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
        std::nth_element(sides.begin(), middle, sides.end());
        footprint_ = *middle;
        radius_ = kFirstRadius * footprint_;
    }

    double leastRadius() const { return least_ * footprint_; }

    /// Whether photons as narrow as they may be are off by more than this, however many there are.
    bool isStuck(double squaredTarget) const {
        return map_.leastRadius <= leastRadius() && error_.bias[1] > squaredTarget;
    }

    /// Whether it came to its end. The first pass is one, whatever the time: without photons
    /// nothing is known of them.
    bool trace(std::uint32_t passes) {
        const auto ends = [this] { return passes_ == 0 ? cancelled() : stopped(); };
        std::vector<std::vector<Photon>> parts(std::size_t{passes} * plan_.groups);
        forEachIndex(parts.size(), job_.threads, [&](std::size_t i, int) {
            if (ends()) return;
            const auto part = static_cast<std::uint32_t>(i);
            job_.kernel->tracePhotons(scene_, settings_, plan_, passes_ + part / plan_.groups,
                                      part % plan_.groups, parts[i]);
        });
        if (ends()) return false;
        std::size_t count = map_.photons.size();
        for (const std::vector<Photon>& part : parts) count += part.size();
        map_.photons.reserve(count);
        for (std::vector<Photon>& part : parts) {
            map_.photons.insert(map_.photons.end(), part.begin(), part.end());
            part = {};
        }
        passes_ += passes;
        return true;
    }

    /// For looks within so many radii.
    void rebuild(double reach) {
        std::vector<double> radii = shrinkingRadii(radius_, passes_);
        for (double& radius : radii) radius = std::max(radius, leastRadius());
        build(map_, radii, reach * radii.front(), scene_.localBound);
    }

    /// The radius of least error, by halves and doubles, and what its error is: that of the last
    /// one looked at, where time runs out.
    void chooseRadius() {
        if (map_.kernels.empty()) {
            rebuild(1.0);
            measureFootprint([this](const SeenPoint& seen) {
                return map_.radianceAt(seen.point) != Color(0.0);
            });
        }
        int direction = 0;
        for (int i = 1;; ++i) {
            rebuild(2.0);
            error_ = causticError(seen_, map_, plan_.groups, job_.threads, job_.cancel);
            const bool mayHalve = 0.5 * radius_ >= leastRadius();
            const int better = mayHalve && error_.at(0) < error_.at(1) ? -1
                               : error_.at(2) < error_.at(1)           ? 1
                                                                       : 0;
            if (better == 0 || better == -direction || i == kMostSteps || stopped()) return;
            direction = better;
            radius_ *= better > 0 ? 2.0 : 0.5;
        }
    }

    using Clock = std::chrono::steady_clock;

    const RenderScene& scene_;
    const RenderJob& job_;
    PhotonPlan plan_;
    TraceSettings settings_;
    Clock::time_point start_ = Clock::now();
    std::vector<SeenPixel> seen_;
    PhotonMap map_;
    double footprint_ = 1.0;
    double least_ = kLeastRadius;
    double radius_ = 1.0;
    std::uint32_t passes_ = 0;
    CausticError error_;
};

}  // namespace

Caustics traceCaustics(const RenderScene& scene, const RenderJob& job) {
    return Tracing(scene, job).run();
}

}  // namespace rt
