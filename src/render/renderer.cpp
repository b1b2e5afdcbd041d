#include "rt/render/renderer.h"

#include "caustics.h"
#include "rt/core/cpu_time.h"
#include "rt/render/adaptive.h"
#include "rt/render/coarse_lattice.h"
#include "rt/render/fine_pixels.h"
#include "rt/render/lattice.h"
#include "run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace rt {
namespace {

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
    const bool single = halvings == 0;
    int done = 0;
    for (; halvings >= 0 && !run.stopped(); --halvings) {
        const int end = spp >> halvings;
        const auto kept = single ? Run::Kept::kInFilm : Run::Kept::kInLog;
        run.pass(uniform(film, static_cast<std::uint64_t>(end)), 1.0 * done / spp, 1.0 * end / spp,
                 kept);
        done = end;
    }
    return !run.stopped();
}

/// Corners can stand for pixels where a pixel is the plain mean of what is seen through it.
bool mayShareCorners(const RenderScene& scene, const RenderJob& job) {
    return job.adaptive && job.settings.sampler == SamplerKind::kJoint &&
           job.settings.filter == FilterKind::kBox && !scene.camera.hasLens() &&
           scene.moving.empty() && scene.lightTree.isEmpty();
}

std::optional<Lattice> latticeFor(const RenderScene& scene, const RenderJob& job) {
    if (!mayShareCorners(scene, job)) return std::nullopt;
    return std::optional<Lattice>(std::in_place, job.area);
}

/// Samples of the lights that a corner gets first.
constexpr std::uint32_t kFirstLightSamples = 2;

/// A smooth pixel's bias, as a share of the error target, above which it is sampled from the start.
constexpr double kBiasLimit = 4.0;

/// The same of a cell of the coarse lattice, above which the corners within it are looked through.
constexpr double kCoarseBias = 0.25;

/// The least share of the squared target that is left to samples.
constexpr double kLeastShare = 0.25;

/// Light as wide as a photon's kernel must not slip through between a pixel's first samples.
std::uint32_t firstSamplesFor(const CausticReport& caustics) {
    constexpr double kWideEnough = 0.5;
    std::uint32_t samples = AdaptiveGoal{}.firstSamples;
    for (double r = caustics.lastRadiusInPixels; r < kWideEnough && samples < 64; r *= 2.0) {
        samples *= 4;
    }
    return samples;
}

/// What photons are off by may be anywhere.
std::vector<double> withCaustics(std::vector<double> squaredErrors, double causticError) {
    for (double& error : squaredErrors) error += causticError;
    return squaredErrors;
}

/// Towards an error target: probes at the corners of pixels, samples where those do not do, and
/// passes that double where that helps most, until the estimate meets the target.
class TowardsTarget {
  public:
    TowardsTarget(const RenderScene& scene, Run& run, const RenderJob& job, Film& film,
                  const CausticReport& caustics)
        : run_(run),
          job_(job),
          film_(film),
          causticError_(caustics.squaredError()),
          firstSamples_(firstSamplesFor(caustics)),
          lattice_(latticeFor(scene, job)) {
        if (lattice_) fine_ = finePixels(scene, job.area);
        adaptive_.emplace(film_, lattice_ ? &*lattice_ : nullptr, fine_);
        run_.showAs([this] { return adaptive_->snapshot(); });
    }

    bool render() {
        AdaptiveGoal goal;
        goal.maxSamples = static_cast<std::uint32_t>(job_.settings.spp);
        goal.firstSamples = std::min(firstSamples_, goal.maxSamples);
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
            const double left = allowed * allowed - causticError_;
            reached = adaptive_->knowsError() && adaptive_->squaredError() <= left;
            // Of what photons alone exceed, samples still keep their part.
            goal.squaredTarget = std::max(left, kLeastShare * allowed * allowed);
            if (reached || isAsGoodAsItGets(goal)) break;
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
        return std::sqrt(adaptive_->squaredError() + causticError_) + run_.cutError();
    }

    const std::vector<PassRecord>& passes() const { return passes_; }

    std::vector<double> pixelErrors() const {
        if (!adaptive_->knowsError()) return {};
        return withCaustics(adaptive_->squaredErrors(), causticError_);
    }

  private:
    bool isAsGoodAsItGets(const AdaptiveGoal& goal) const {
        return adaptive_->knowsError() && adaptive_->squaredError() <= goal.squaredTarget;
    }

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
    double causticError_;  ///< squared, that all pixels have by photons
    std::uint32_t firstSamples_;
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

namespace {

/// The picture, once its photons are there.
void renderTiles(const RenderScene& scene, const RenderJob& job, const CausticReport& caustics,
                 RenderOutcome& outcome) {
    Run run(scene, job, outcome.film);
    RenderSnapshot last;
    if (job.errorTarget > 0.0) {
        TowardsTarget towards(scene, run, job, outcome.film, caustics);
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
            outcome.errorEstimate =
                std::sqrt(estimate.squaredError() + caustics.squaredError()) + run.cutError();
            if (job.wantsPixelErrors) {
                outcome.pixelErrors =
                    withCaustics(estimate.squaredErrors(), caustics.squaredError());
            }
        }
        if (job.onSnapshot) last = estimate.snapshot();
    }
    outcome.counts = run.counts();
    outcome.tileCounts = run.tileCounts();
    outcome.cancelled = run.cancelled();
    outcome.outOfTime = run.outOfTime();
    if (outcome.cancelled && job.onCheckpoint) job.onCheckpoint();
    if (outcome.cancelled) outcome.errorEstimate.reset();
    if (job.onSnapshot) {
        last.errorEstimate = outcome.errorEstimate;
        job.onSnapshot(std::move(last));
    }
    outcome.seconds = run.seconds();
    if (!(job.errorTarget > 0.0)) {
        outcome.passes = {{outcome.counts.rays.camera, outcome.errorEstimate, outcome.seconds}};
    }
}

}  // namespace

RenderOutcome render(const RenderScene& scene, const RenderJob& job) {
    RenderOutcome outcome(job.area);
    const double cpuBefore = processCpuSeconds();
    if (scene.features & kFeatureCaustics) {
        const auto began = std::chrono::steady_clock::now();
        Caustics caustics = traceCaustics(scene, job);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        outcome.caustics = caustics.report;
        outcome.photons = std::move(caustics.map);
        RenderJob rest = job;
        rest.settings.photons = outcome.photons.get();
        if (job.timeLimit > 0.0)
            rest.timeLimit = std::max(job.timeLimit - seconds, 0.5 * job.timeLimit);
        renderTiles(scene, rest, caustics.report, outcome);
        outcome.seconds += seconds;
        for (PassRecord& pass : outcome.passes) pass.seconds += seconds;
    } else {
        renderTiles(scene, job, {}, outcome);
    }
    outcome.cpuSeconds = processCpuSeconds() - cpuBefore;
    return outcome;
}

}  // namespace rt
