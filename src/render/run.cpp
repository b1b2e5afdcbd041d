#include "run.h"

#include "rt/core/error.h"
#include "rt/core/parallel.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rt {
namespace {

/// Paths may be cut at this share of the error target: what is cut adds up over a path's branches.
constexpr double kCutShare = 1.0 / 16;

/// Looks that one thread takes at a time.
constexpr std::size_t kTogether = 256;

// A log holds values as they are in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(PixelState) == 56 && sizeof(Probe) == 80);

template <class Value>
void append(std::vector<std::uint8_t>& bytes, const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(Value));
}

template <class Value>
std::vector<std::uint8_t> packed(const std::vector<std::size_t>& places,
                                 const std::vector<Value>& values) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(places.size() * sizeof(Value));
    for (const std::size_t i : places) append(bytes, values[i]);
    return bytes;
}

template <class Value>
void unpack(const std::vector<std::uint8_t>& bytes, const std::vector<std::size_t>& places,
            std::vector<Value>& values) {
    if (bytes.size() != places.size() * sizeof(Value)) {
        throw SceneError("the checkpoint does not fit the scene; remove it, and render anew");
    }
    const std::uint8_t* from = bytes.data();
    for (const std::size_t i : places) {
        std::memcpy(static_cast<void*>(&values[i]), from, sizeof(Value));
        from += sizeof(Value);
    }
}

/// Places of a tile's values that lack samples.
template <class Value>
std::vector<std::size_t> lackingOf(const std::vector<Value>& values,
                                   const std::vector<std::uint32_t>& ends) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (ends[i] != 0 && ends[i] > values[i].samples) places.push_back(i);
    }
    return places;
}

}  // namespace

TraceSettings traceSettingsOf(const RenderJob& job) {
    TraceSettings settings = job.settings;
    settings.cancel = job.cancel;
    if (job.errorTarget > 0.0) {
        settings.cutoff = std::min(settings.cutoff, kCutShare * job.errorTarget);
    }
    return settings;
}

Run::Run(const RenderScene& scene, const RenderJob& job, Film& film)
    : scene_(scene),
      job_(job),
      settings_(traceSettingsOf(job)),
      film_(film),
      tiles_(tilesOf(job.area)),
      counts_(tiles_.size()) {
    if (job_.log) job_.log->rewind();
}

Run::~Run() {
    if (job_.log) job_.log->endRender();
}

void Run::beginStep(Kept kept) {
    tilesDone_ = 0;
    if (!job_.log) return;
    if (kept == Kept::kInLog) return job_.log->beginStep();
    job_.log->beginStep([this](std::size_t tile) { return bytesOfTile(tile); });
}

/// As the log holds a tile all of whose pixels lacked samples.
std::vector<std::uint8_t> Run::bytesOfTile(std::size_t index) const {
    const Tile& tile = tiles_[index];
    std::vector<std::uint8_t> bytes;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) append(bytes, film_.at(x, y));
    }
    return bytes;
}

/// Fills in what `lacking` values lack, from the log where it knows; returns whether they are whole
/// and new to it.
template <class Value, class Trace>
bool Run::taken(const Place& place, const std::vector<std::size_t>& lacking,
                std::vector<Value>& values, const Trace& trace) {
    const RenderLog::Part* known = job_.log ? job_.log->find(place.part) : nullptr;
    if (known) {
        unpack(known->values, lacking, values);
        place.counts = known->counts;
        return place.kept == Kept::kInFilm;
    }
    trace();
    // A render that is cancelled leaves values with some of their samples.
    return job_.log && !cancelled();
}

/// Calls trace(ends, values, counts) with a tile's part of the values, row-major, and puts back
/// what it made of them; not at all where no value lacks samples, or where the log knows what it
/// would make. `grid` knows the places of rows; a guard is held while values change.
template <class Grid, class Values, class Trace>
void Run::onTile(const Place& place, const Tile& tile, const Grid& grid, Values& values,
                 const std::vector<std::uint32_t>& ends, const Trace& trace) {
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
    const std::vector<std::size_t> lacking =
        job_.log ? lackingOf(tileValues, tileEnds) : std::vector<std::size_t>();
    const bool isNew = taken(place, lacking, tileValues,
                             [&] { trace(tileEnds.data(), tileValues.data(), place.counts); });
    {
        const std::unique_lock<std::mutex> lock =
            place.guard ? std::unique_lock(*place.guard) : std::unique_lock<std::mutex>();
        const auto* done = tileValues.data();
        for (int y = tile.y0; y < tile.y1; ++y, done += tile.width()) {
            std::copy(done, done + tile.width(), &values[grid.offset(tile.x0, y)]);
        }
    }
    if (!isNew) return;
    const bool isHere = place.kept == Kept::kInLog;
    job_.log->add(place.part, {place.counts,
                               isHere ? packed(lacking, tileValues) : std::vector<std::uint8_t>()});
}

void Run::pass(const std::vector<std::uint32_t>& ends, double from, double to, Kept kept) {
    beginStep(kept);
    forEachIndex(tiles_.size(), job_.threads, [&](std::size_t index, int) {
        if (stopped() || !rendersTile(index)) return;
        const Tile& tile = tiles_[index];
        const Place place{index, counts_[index], job_.onSnapshot ? &filmMutex_ : nullptr, kept};
        onTile(place, tile, film_, film_.pixels, ends,
               [&](const std::uint32_t* tileEnds, PixelState* pixels, TraceCounts& counts) {
                   job_.kernel->renderTile(scene_, settings_, tile, tileEnds, pixels, counts);
               });
        report(from, to);
        if (job_.onSnapshot) offerSnapshot();
        offerCheckpoint();
    });
}

void Run::probe(const std::vector<std::uint32_t>& ends, Lattice& lattice, double from, double to) {
    beginStep(Kept::kInLog);
    const std::vector<Tile> tiles = tilesOf(lattice.corners);
    probeCounts_.resize(std::max(probeCounts_.size(), tiles.size()));
    forEachIndex(tiles.size(), job_.threads, [&](std::size_t index, int) {
        if (stopped()) return;
        const Tile& tile = tiles[index];
        const Place place{index, probeCounts_[index], nullptr, Kept::kInLog};
        onTile(place, tile, lattice, lattice.probes, ends,
               [&](const std::uint32_t* tileEnds, Probe* probes, TraceCounts& counts) {
                   job_.kernel->probeTile(scene_, settings_, tile, lattice.spacing, tileEnds,
                                          probes, counts);
               });
        if (to > from) report(from, to);
        offerCheckpoint();
    });
}

std::vector<Probe> Run::look(const std::vector<std::size_t>& pixels, std::uint32_t samples) {
    beginStep(Kept::kInLog);
    std::vector<Probe> probes(pixels.size());
    const std::size_t groups = (pixels.size() + kTogether - 1) / kTogether;
    probeCounts_.resize(std::max(probeCounts_.size(), groups));
    forEachIndex(groups, job_.threads, [&](std::size_t group, int) {
        if (stopped()) return;
        lookAt(group, pixels, samples, probes);
        offerCheckpoint();
    });
    return probes;
}

void Run::lookAt(std::size_t group, const std::vector<std::size_t>& pixels, std::uint32_t samples,
                 std::vector<Probe>& probes) {
    std::vector<PixelPlace> places;
    std::vector<std::size_t> all;
    const std::size_t first = group * kTogether;
    for (std::size_t i = first; i < std::min(first + kTogether, pixels.size()); ++i) {
        places.push_back(film_.area.placeOf(pixels[i]));
        all.push_back(i);
    }
    TraceCounts& counts = probeCounts_[group];
    const bool isNew = taken({group, counts, nullptr, Kept::kInLog}, all, probes, [&] {
        job_.kernel->probePixels(scene_, settings_, places, samples, &probes[first], counts);
    });
    if (isNew) job_.log->add(group, {counts, packed(all, probes)});
}

bool Run::cancelled() const {
    return job_.cancel && job_.cancel->load(std::memory_order_relaxed);
}

bool Run::outOfTime() const {
    return job_.timeLimit > 0.0 && seconds() >= job_.timeLimit;
}

double Run::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

TraceCounts Run::counts() const {
    TraceCounts total;
    for (const TraceCounts& counts : probeCounts_) total.add(counts);
    for (const TraceCounts& counts : counts_) total.add(counts);
    return total;
}

double Run::cutError() const {
    const TraceCounts total = counts();
    return total.cutBound / std::max(1.0, static_cast<double>(total.rays.camera));
}

/// Nobody waits while another thread takes one.
void Run::offerSnapshot() {
    if (!job_.wantsSnapshot->load(std::memory_order_relaxed)) return;
    const std::unique_lock taking(snapshotMutex_, std::try_to_lock);
    if (!taking) return;
    RenderSnapshot snapshot = [this] {
        const std::lock_guard lock(filmMutex_);
        return view_();
    }();
    job_.onSnapshot(std::move(snapshot));
}

/// Nobody waits for another thread that saves one.
void Run::offerCheckpoint() {
    if (!(job_.checkpointEvery > 0.0)) return;
    const std::unique_lock saving(checkpointMutex_, std::try_to_lock);
    if (!saving) return;
    const auto since = std::chrono::duration<double>(Clock::now() - lastCheckpoint_).count();
    if (since < job_.checkpointEvery) return;
    job_.onCheckpoint();
    lastCheckpoint_ = Clock::now();
}

void Run::report(double from, double to) {
    if (!job_.onProgress) return;
    const std::lock_guard lock(progressMutex_);
    ++tilesDone_;
    const double tiles = static_cast<double>(tiles_.size()) / shareOfTiles();
    const double done = std::min(static_cast<double>(tilesDone_) / tiles, 1.0);
    double share = from + (to - from) * done;
    if (job_.timeLimit > 0.0) share = std::max(share, seconds() / job_.timeLimit);
    job_.onProgress(std::min(share, 1.0));
}

}  // namespace rt
