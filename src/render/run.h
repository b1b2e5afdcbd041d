// Work on tiles that the threads of one render share, and what they share.
#pragma once

#include "rt/render/lattice.h"
#include "rt/render/renderer.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

namespace rt {

/// The state that the threads of one render share.
class Run {
  public:
    /// Where the log finds what a pass traced: a later pass changes the film.
    enum class Kept { kInLog, kInFilm };

    Run(const RenderScene& scene, const RenderJob& job, Film& film);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    /// Brings every pixel to its number of samples in `ends`, ordered as the film is. `from` and
    /// `to` are the shares of the whole work before and after.
    void pass(const std::vector<std::uint32_t>& ends, double from, double to,
              Kept kept = Kept::kInLog);

    /// Brings the corners to their numbers of samples in `ends`, ordered as the lattice is.
    void probe(const std::vector<std::uint32_t>& ends, Lattice& lattice, double from, double to);

    /// What is seen through the centres of pixels, given by their places in the film.
    std::vector<Probe> look(const std::vector<std::size_t>& pixels, std::uint32_t samples);

    /// How a snapshot is taken during passes; `view` is not called in between.
    void showAs(std::function<RenderSnapshot()> view) { view_ = std::move(view); }

    bool cancelled() const;
    bool outOfTime() const;
    bool stopped() const { return cancelled() || outOfTime(); }
    double seconds() const;

    /// Summed in the order of the tiles, so that the rounding is always the same.
    TraceCounts counts() const;
    /// The mean bound of what was cut, a sample.
    double cutError() const;
    const std::vector<TraceCounts>& tileCounts() const { return counts_; }

  private:
    using Clock = std::chrono::steady_clock;

    /// A part of a step: its number in the log, where its work is counted, what guards its values.
    struct Place {
        std::size_t part;
        TraceCounts& counts;
        std::mutex* guard;
        Kept kept;
    };
    template <class Grid, class Values, class Trace>
    void onTile(const Place& place, const Tile& tile, const Grid& grid, Values& values,
                const std::vector<std::uint32_t>& ends, const Trace& trace);
    template <class Value, class Trace>
    bool taken(const Place& place, const std::vector<std::size_t>& lacking,
               std::vector<Value>& values, const Trace& trace);

    bool rendersTile(std::size_t index) const {
        return job_.errorTarget > 0.0 || job_.shard.owns(index);
    }
    /// Of how many tiles one is rendered.
    double shareOfTiles() const { return job_.errorTarget > 0.0 ? 1.0 : job_.shard.count; }

    void beginStep(Kept kept);
    std::vector<std::uint8_t> bytesOfTile(std::size_t index) const;
    void lookAt(std::size_t group, const std::vector<std::size_t>& pixels, std::uint32_t samples,
                std::vector<Probe>& probes);
    void offerSnapshot();
    void offerCheckpoint();
    void report(double from, double to);

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
    std::mutex checkpointMutex_;
    Clock::time_point lastCheckpoint_ = start_;
    std::function<RenderSnapshot()> view_;
    std::size_t tilesDone_ = 0;
};

}  // namespace rt
