#include "rt/render/renderer.h"

#include "rt/core/cpu_time.h"
#include "rt/core/parallel.h"
#include "rt/render/adaptive.h"
#include "rt/render/coarse_lattice.h"
#include "rt/render/fine_pixels.h"
#include "rt/render/lattice.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

/// Paths may be cut at this share of the error target: what is cut adds up over a path's branches.
constexpr double kCutShare = 1.0 / 16;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

TraceSettings settingsFor(const RenderJob& job) {
    TraceSettings settings = job.settings;
    settings.cancel = job.cancel;
    if (job.errorTarget > 0.0) {
        settings.cutoff = std::min(settings.cutoff, kCutShare * job.errorTarget);
    }
    return settings;
}

/// Calls trace(ends, values) with a tile's part of the values, row-major, and puts back what it
/// made of them; not at all where no value lacks samples. `grid` knows the places of rows; `guard`,
/// if not null, is held while values change.
template <class Grid, class Values, class Trace>
void onTile(const Tile& tile, const Grid& grid, Values& values,
            const std::vector<std::uint32_t>& ends, std::mutex* guard, const Trace& trace) {
    const auto width = static_cast<std::size_t>(tile.width());
    const auto anyLacks = [&](int y) {
        const std::size_t row = grid.offset(tile.x0, y);
        for (std::size_t i = row; i < row + width; ++i) {
            if (ends[i] != 0 && ends[i] > values[i].samples) return true;
        }
        return false;
    };
    int first = tile.y0;
    while (first < tile.y1 && !anyLacks(first)) ++first;
    if (first == tile.y1) return;
    std::vector<typename Values::value_type> tileValues;
    std::vector<std::uint32_t> tileEnds;
    tileValues.reserve(width * static_cast<std::size_t>(tile.height()));
    tileEnds.reserve(tileValues.capacity());
    for (int y = tile.y0; y < tile.y1; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(grid.offset(tile.x0, y));
        const auto end = row + tile.width();
        tileValues.insert(tileValues.end(), values.begin() + row, values.begin() + end);
        tileEnds.insert(tileEnds.end(), ends.begin() + row, ends.begin() + end);
    }
    trace(tileEnds.data(), tileValues.data());
    const std::unique_lock<std::mutex> lock =
        guard ? std::unique_lock(*guard) : std::unique_lock<std::mutex>();
    const auto* done = tileValues.data();
    for (int y = tile.y0; y < tile.y1; ++y, done += tile.width()) {
        std::copy(done, done + tile.width(), &values[grid.offset(tile.x0, y)]);
    }
}

/// The state that the threads of one render share.
class Run {
  public:
    Run(const RenderScene& scene, const RenderJob& job, Film& film)
        : scene_(scene),
          job_(job),
          settings_(settingsFor(job)),
          film_(film),
          tiles_(tilesOf(job.area)),
          counts_(tiles_.size()) {}

    /// Brings every pixel to its number of samples in `ends`, ordered as the film is. `from` and
    /// `to` are the shares of the whole work before and after.
    void pass(const std::vector<std::uint32_t>& ends, double from, double to) {
        tilesDone_ = 0;
        forEachIndex(tiles_.size(), job_.threads, [&](std::size_t index, int) {
            if (stopped() || !rendersTile(index)) return;
            renderTile(index, ends);
            report(from, to);
            if (job_.onSnapshot) offerSnapshot();
        });
    }

    /// Brings the corners to their numbers of samples in `ends`, ordered as the lattice is.
    void probe(const std::vector<std::uint32_t>& ends, Lattice& lattice, double from, double to) {
        tilesDone_ = 0;
        const std::vector<Tile> tiles = tilesOf(lattice.corners);
        probeCounts_.resize(std::max(probeCounts_.size(), tiles.size()));
        forEachIndex(tiles.size(), job_.threads, [&](std::size_t index, int) {
            if (stopped()) return;
            probeTile(tiles[index], ends, lattice, probeCounts_[index]);
            if (to > from) report(from, to);
        });
    }

    /// What is seen through the centres of pixels, given by their places in the film.
    std::vector<Probe> look(const std::vector<std::size_t>& pixels, std::uint32_t samples) {
        constexpr std::size_t kTogether = 256;
        std::vector<Probe> probes(pixels.size());
        const std::size_t groups = (pixels.size() + kTogether - 1) / kTogether;
        probeCounts_.resize(std::max(probeCounts_.size(), groups));
        forEachIndex(groups, job_.threads, [&](std::size_t group, int) {
            if (stopped()) return;
            std::vector<PixelPlace> places;
            const std::size_t first = group * kTogether;
            for (std::size_t i = first; i < std::min(first + kTogether, pixels.size()); ++i) {
                places.push_back(film_.area.placeOf(pixels[i]));
            }
            job_.kernel->probePixels(scene_, settings_, places, samples, &probes[first],
                                     probeCounts_[group]);
        });
        return probes;
    }

    /// How a snapshot is taken during passes; `view` is not called in between.
    void showAs(std::function<RenderSnapshot()> view) { view_ = std::move(view); }

    bool cancelled() const { return job_.cancel && job_.cancel->load(std::memory_order_relaxed); }
    bool outOfTime() const {
        return job_.timeLimit > 0.0 && secondsSince(start_) >= job_.timeLimit;
    }
    bool stopped() const { return cancelled() || outOfTime(); }
    double seconds() const { return secondsSince(start_); }

    /// Summed in the order of the tiles, so that the rounding is always the same.
    TraceCounts counts() const {
        TraceCounts total;
        for (const TraceCounts& counts : probeCounts_) total.add(counts);
        for (const TraceCounts& counts : counts_) total.add(counts);
        return total;
    }

    /// The mean bound of what was cut, a sample.
    double cutError() const {
        const TraceCounts total = counts();
        return total.cutBound / std::max(1.0, static_cast<double>(total.rays.camera));
    }

    const std::vector<TraceCounts>& tileCounts() const { return counts_; }

  private:
    bool rendersTile(std::size_t index) const {
        return job_.errorTarget > 0.0 || job_.shard.owns(index);
    }

    /// Of how many tiles one is rendered.
    double shareOfTiles() const { return job_.errorTarget > 0.0 ? 1.0 : job_.shard.count; }

    void probeTile(const Tile& tile, const std::vector<std::uint32_t>& ends, Lattice& lattice,
                   TraceCounts& counts) {
        const auto trace = [&](const std::uint32_t* tileEnds, Probe* probes) {
            job_.kernel->probeTile(scene_, settings_, tile, lattice.spacing, tileEnds, probes,
                                   counts);
        };
        onTile(tile, lattice, lattice.probes, ends, nullptr, trace);
    }

    void renderTile(std::size_t index, const std::vector<std::uint32_t>& ends) {
        const Tile& tile = tiles_[index];
        const auto trace = [&](const std::uint32_t* tileEnds, PixelState* pixels) {
            job_.kernel->renderTile(scene_, settings_, tile, tileEnds, pixels, counts_[index]);
        };
        onTile(tile, film_, film_.pixels, ends, job_.onSnapshot ? &filmMutex_ : nullptr, trace);
    }

    /// Nobody waits while another thread takes one.
    void offerSnapshot() {
        if (!job_.wantsSnapshot->load(std::memory_order_relaxed)) return;
        const std::unique_lock taking(snapshotMutex_, std::try_to_lock);
        if (!taking) return;
        RenderSnapshot snapshot = [this] {
            const std::lock_guard lock(filmMutex_);
            return view_();
        }();
        job_.onSnapshot(std::move(snapshot));
    }

    void report(double from, double to) {
        if (!job_.onProgress) return;
        const std::lock_guard lock(progressMutex_);
        ++tilesDone_;
        const double tiles = static_cast<double>(tiles_.size()) / shareOfTiles();
        const double done = std::min(static_cast<double>(tilesDone_) / tiles, 1.0);
        double share = from + (to - from) * done;
        if (job_.timeLimit > 0.0) share = std::max(share, seconds() / job_.timeLimit);
        job_.onProgress(std::min(share, 1.0));
    }

    const RenderScene& scene_;
    const RenderJob& job_;
    TraceSettings settings_;
    Film& film_;
    std::vector<Tile> tiles_;
    std::vector<TraceCounts> counts_;
    std::vector<TraceCounts> probeCounts_;
    Clock::time_point start_ = Clock::now();
    std::mutex progressMutex_;
    std::mutex filmMutex_;
    std::mutex snapshotMutex_;
    std::function<RenderSnapshot()> view_;
    std::size_t tilesDone_ = 0;
};

std::vector<std::uint32_t> uniform(const Film& film, std::uint64_t samples) {
    return std::vector<std::uint32_t>(film.pixels.size(), static_cast<std::uint32_t>(samples));
}

/// Exactly spp samples everywhere: in one pass where nothing can interrupt; under a time limit, or
/// where somebody watches, in passes that double, so that all pixels stay about equally far. Each
/// ends at a half of the next, for a pixel remembers its sum at half of its samples.
bool renderUniform(Run& run, const RenderJob& job, const Film& film) {
    const int spp = job.settings.spp;
    run.showAs([&film] { return snapshotOf(film); });
    int halvings = 0;
    if (job.timeLimit > 0.0 || job.onSnapshot) {
        while ((spp >> halvings) > 1) ++halvings;
    }
    int done = 0;
    for (; halvings >= 0 && !run.stopped(); --halvings) {
        const int end = spp >> halvings;
        run.pass(uniform(film, static_cast<std::uint64_t>(end)), 1.0 * done / spp, 1.0 * end / spp);
        done = end;
    }
    return !run.stopped();
}

/// Corners can stand for pixels where a pixel is the plain mean of what is seen through it.
bool mayShareCorners(const RenderScene& scene, const RenderJob& job) {
    return job.adaptive && job.settings.sampler == SamplerKind::kJoint &&
           job.settings.filter == FilterKind::kBox && !scene.camera.hasLens();
}

/// Samples of the lights that a corner gets first.
constexpr std::uint32_t kFirstLightSamples = 2;

/// A smooth pixel's bias, as a share of the error target, above which it is sampled from the start.
constexpr double kBiasLimit = 4.0;

/// The same of a cell of the coarse lattice, above which the corners within it are looked through.
constexpr double kCoarseBias = 0.25;

/// Towards an error target: probes at the corners of pixels, samples where those do not do, and
/// passes that double where that helps most, until the estimate meets the target.
class TowardsTarget {
  public:
    TowardsTarget(const RenderScene& scene, Run& run, const RenderJob& job, Film& film)
        : run_(run), job_(job), film_(film) {
        if (mayShareCorners(scene, job)) {
            lattice_.emplace(job.area);
            fine_ = finePixels(scene, job.area);
        }
        adaptive_.emplace(film_, lattice_ ? &*lattice_ : nullptr, fine_);
        run_.showAs([this] { return adaptive_->snapshot(); });
    }

    bool render() {
        AdaptiveGoal goal;
        goal.maxSamples = static_cast<std::uint32_t>(job_.settings.spp);
        goal.firstSamples = std::min(goal.firstSamples, goal.maxSamples);
        double share = 0.0;
        if (lattice_) {
            share = 0.2;
            const ToldPixels told = probeAll(share);
            const double bias = kBiasLimit * job_.errorTarget;
            if (!run_.stopped()) adaptive_->classify(bias * bias, told);
            audit(job_.errorTarget * job_.errorTarget);
        }
        advance(adaptive_->first(goal.firstSamples), share);
        bool reached = false;
        while (!run_.stopped() && !reached) {
            adaptive_->update();
            passes_.push_back({run_.counts().rays.camera, errorEstimate(), run_.seconds()});
            if (job_.onEstimate && adaptive_->knowsError()) job_.onEstimate(*errorEstimate());
            const double allowed = std::max(job_.errorTarget - run_.cutError(), 0.0);
            goal.squaredTarget = allowed * allowed;
            reached = adaptive_->knowsError() && adaptive_->squaredError() <= goal.squaredTarget;
            if (reached) break;
            audit(goal.squaredTarget);
            const AdaptivePass pass =
                job_.adaptive ? adaptive_->next(goal) : adaptive_->doubled(goal.maxSamples);
            if (pass.more == 0) break;
            advance(pass, share);
        }
        adaptive_->update();
        adaptive_->settle();
        return reached;
    }

    RenderSnapshot snapshot() const { return adaptive_->snapshot(); }

    /// Nothing where too little was gathered to tell.
    std::optional<double> errorEstimate() const {
        if (!adaptive_->knowsError()) return std::nullopt;
        return std::sqrt(adaptive_->squaredError()) + run_.cutError();
    }

    const std::vector<PassRecord>& passes() const { return passes_; }

    std::vector<double> pixelErrors() const {
        if (!adaptive_->knowsError()) return {};
        return adaptive_->squaredErrors();
    }

  private:
    /// Every other corner, and those between which these leave open.
    ToldPixels probeAll(double share) {
        CoarseLattice coarse(job_.area);
        run_.probe(std::vector<std::uint32_t>(coarse.lattice().probes.size(), kFirstLightSamples),
                   coarse.lattice(), 0.0, 0.5 * share);
        const double bias = kCoarseBias * job_.errorTarget;
        CoarseLattice::Told told =
            coarse.refine(*lattice_, film_, fine_, bias * bias, kFirstLightSamples);
        run_.probe(told.ends, *lattice_, 0.5 * share, share);
        return std::move(told.pixels);
    }

    void audit(double squaredTarget) {
        if (run_.stopped() || !adaptive_->wantsAudit(squaredTarget)) return;
        const std::vector<Probe> centres = run_.look(adaptive_->nextAudit(), kFirstLightSamples);
        adaptive_->judgeAudit(centres, squaredTarget);
    }

    void advance(const AdaptivePass& pass, double& share) {
        const double next = 0.5 * (1.0 + share);
        if (lattice_ && !pass.corners.empty()) run_.probe(pass.corners, *lattice_, share, share);
        run_.pass(pass.pixels, share, next);
        share = next;
    }

    Run& run_;
    const RenderJob& job_;
    Film& film_;
    std::optional<Lattice> lattice_;
    std::vector<bool> fine_;
    std::optional<Adaptive> adaptive_;
    std::vector<PassRecord> passes_;
};

}  // namespace

void TraceCounts::add(const TraceCounts& other) {
    rays.camera += other.rays.camera;
    rays.shadow += other.rays.shadow;
    rays.reflection += other.rays.reflection;
    rays.refraction += other.rays.refraction;
    cutPaths += other.cutPaths;
    cutBound += other.cutBound;
    if (nonFinite == 0 && other.nonFinite > 0) {
        nonFiniteX = other.nonFiniteX;
        nonFiniteY = other.nonFiniteY;
    }
    nonFinite += other.nonFinite;
}

std::optional<UniformError> uniformError(Film& film) {
    Adaptive estimate(film, nullptr, {});
    estimate.update();
    if (!estimate.knowsError()) return std::nullopt;
    return UniformError{std::sqrt(estimate.squaredError()), estimate.squaredErrors()};
}

RenderOutcome render(const RenderScene& scene, const RenderJob& job) {
    RenderOutcome outcome(job.area);
    const double cpuBefore = processCpuSeconds();
    Run run(scene, job, outcome.film);
    RenderSnapshot last;
    if (job.errorTarget > 0.0) {
        TowardsTarget towards(scene, run, job, outcome.film);
        outcome.converged = towards.render();
        outcome.errorEstimate = towards.errorEstimate();
        if (job.onSnapshot) last = towards.snapshot();
        if (job.wantsPixelErrors) outcome.pixelErrors = towards.pixelErrors();
        outcome.passes = towards.passes();
    } else {
        outcome.converged = renderUniform(run, job, outcome.film);
        Adaptive estimate(outcome.film, nullptr, {});
        estimate.update();
        if (estimate.knowsError()) {
            outcome.errorEstimate = std::sqrt(estimate.squaredError()) + run.cutError();
            if (job.wantsPixelErrors) outcome.pixelErrors = estimate.squaredErrors();
        }
        if (job.onSnapshot) last = estimate.snapshot();
    }
    outcome.counts = run.counts();
    outcome.tileCounts = run.tileCounts();
    outcome.cancelled = run.cancelled();
    outcome.outOfTime = run.outOfTime();
    if (outcome.cancelled) outcome.errorEstimate.reset();
    if (job.onSnapshot) {
        last.errorEstimate = outcome.errorEstimate;
        job.onSnapshot(std::move(last));
    }
    outcome.seconds = run.seconds();
    if (!(job.errorTarget > 0.0)) {
        outcome.passes = {{outcome.counts.rays.camera, outcome.errorEstimate, outcome.seconds}};
    }
    outcome.cpuSeconds = processCpuSeconds() - cpuBefore;
    return outcome;
}

}  // namespace rt
