// The statistics of a run, for --stats: one JSON object with an entry for each image.
#pragma once

#include "rt/core/cpu_time.h"
#include "rt/render/renderer.h"
#include "rt/trace/trace_kernel.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A feature of the scene that was left out of its render.
struct SkippedFeature {
    std::string what;
    std::string why;
};

/// One image. Times in seconds, sizes in bytes.
struct RenderStats {
    std::string scene;
    std::string output;
    int width = 0;
    int height = 0;
    int threads = 0;
    std::uint64_t seed = 0;
    double sppMean = 0.0;
    std::uint64_t sppMin = 0;
    std::uint64_t sppMax = 0;
    std::optional<double> errorEstimate;    ///< RMSE; none if nothing was estimated
    std::optional<CausticReport> caustics;  ///< none where no photons were asked for
    std::optional<double> errorTarget;      ///< none with --spp or --time alone
    bool converged = false;
    std::uint64_t triangles = 0;
    std::uint64_t primitives = 0;
    std::uint64_t instances = 0;
    std::uint64_t lights = 0;
    double buildSeconds = 0.0;
    double renderSeconds = 0.0;
    double cpuSeconds = 0.0;
    std::uint64_t peakRssBytes = 0;
    RayCounts rays;
    std::uint64_t cutPaths = 0;
    double cutErrorBound = 0.0;
    std::vector<PassRecord> passes;
    std::vector<std::string> features;
    std::vector<SkippedFeature> skipped;
    std::uint64_t warnings = 0;
};

/// {"version": ..., "renders": [...]}; absent and non-finite numbers are null, text that is not
/// UTF-8 is repaired.
std::string statsJson(const std::vector<RenderStats>& renders);

/// Writes it whole or not at all; returns a warning or "", see writeFile. Throws OutputError.
std::string writeStats(const std::string& path, const std::vector<RenderStats>& renders);

/// The most memory of this process that was resident at once, in bytes.
std::uint64_t peakResidentBytes();

}  // namespace rt
