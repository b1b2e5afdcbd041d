#include "rt/render/renderer.h"

#include "rt/core/parallel.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double processCpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Samples [first, end) for every pixel.
struct Pass {
    int first;
    int end;
};

/// One pass where nothing can interrupt; under a time limit, passes that double, so that all pixels
/// stay about equally far.
std::vector<Pass> passesOf(const RenderJob& job) {
    const int spp = job.settings.spp;
    if (!(job.timeLimit > 0.0)) return {{0, spp}};
    std::vector<Pass> passes;
    for (int first = 0, end = 1; first < spp; first = end, end = std::min(2 * end, spp)) {
        passes.push_back({first, end});
    }
    return passes;
}

/// The state that the threads of one render share.
class Run {
  public:
    Run(const RenderScene& scene, const RenderJob& job, Film& film)
        : scene_(scene),
          job_(job),
          film_(film),
          tiles_(tilesOf(job.area)),
          counts_(tiles_.size()) {}

    void pass(const Pass& pass) {
        forEachIndex(tiles_.size(), job_.threads, [&](std::size_t index, int) {
            if (stopped()) return;
            renderTile(index, pass);
            report(pass);
        });
    }

    bool cancelled() const { return job_.cancel && job_.cancel->load(std::memory_order_relaxed); }
    bool outOfTime() const {
        return job_.timeLimit > 0.0 && secondsSince(start_) >= job_.timeLimit;
    }
    bool stopped() const { return cancelled() || outOfTime(); }
    double seconds() const { return secondsSince(start_); }

    /// Summed in the order of the tiles, so that the rounding is always the same.
    TraceCounts counts() const {
        TraceCounts total;
        for (const TraceCounts& counts : counts_) total.add(counts);
        return total;
    }

  private:
    void renderTile(std::size_t index, const Pass& pass) {
        const Tile& tile = tiles_[index];
        std::vector<PixelState> pixels;
        pixels.reserve(static_cast<std::size_t>(tile.width() * tile.height()));
        for (int y = tile.y0; y < tile.y1; ++y) {
            const PixelState* row = &film_.at(tile.x0, y);
            pixels.insert(pixels.end(), row, row + tile.width());
        }
        job_.kernel->renderTile(scene_, job_.settings, tile, pass.first, pass.end, pixels.data(),
                                counts_[index]);
        const PixelState* done = pixels.data();
        for (int y = tile.y0; y < tile.y1; ++y, done += tile.width()) {
            std::copy(done, done + tile.width(), &film_.at(tile.x0, y));
        }
    }

    void report(const Pass& pass) {
        if (!job_.onProgress) return;
        const std::lock_guard lock(progressMutex_);
        samplesDone_ += pass.end - pass.first;
        const double all =
            static_cast<double>(tiles_.size()) * static_cast<double>(job_.settings.spp);
        double share = static_cast<double>(samplesDone_) / all;
        if (job_.timeLimit > 0.0) share = std::max(share, seconds() / job_.timeLimit);
        job_.onProgress(std::min(share, 1.0));
    }

    const RenderScene& scene_;
    const RenderJob& job_;
    Film& film_;
    std::vector<Tile> tiles_;
    std::vector<TraceCounts> counts_;
    Clock::time_point start_ = Clock::now();
    std::mutex progressMutex_;
    long long samplesDone_ = 0;
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

RenderOutcome render(const RenderScene& scene, const RenderJob& job) {
    RenderOutcome outcome{Film(job.area), {}, 0.0, 0.0, false, false};
    const double cpuBefore = processCpuSeconds();
    Run run(scene, job, outcome.film);
    for (const Pass& pass : passesOf(job)) {
        run.pass(pass);
        if (run.stopped()) break;
    }
    outcome.counts = run.counts();
    outcome.cancelled = run.cancelled();
    outcome.outOfTime = run.outOfTime();
    outcome.seconds = run.seconds();
    outcome.cpuSeconds = processCpuSeconds() - cpuBefore;
    return outcome;
}

}  // namespace rt
