#include "rt/app/stats.h"

#include "rt/core/version.h"
#include "rt/output/atomic_file.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace rt {
namespace {

// Keys in the order in which they are written.
using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json skippedJson(const std::vector<SkippedFeature>& skipped) {
    Json all = Json::array();
    for (const SkippedFeature& feature : skipped) {
        all.push_back({{"what", feature.what}, {"why", feature.why}});
    }
    return all;
}

Json passesJson(const std::vector<PassRecord>& passes) {
    Json all = Json::array();
    for (const PassRecord& pass : passes) {
        all.push_back({{"samples", pass.samples},
                       {"error_estimate", orNull(pass.errorEstimate)},
                       {"seconds", pass.seconds}});
    }
    return all;
}

Json causticsJson(const std::optional<CausticReport>& caustics) {
    if (!caustics) return {};
    return {{"noise", caustics->noise},           {"bias", caustics->bias},
            {"photons_sent", caustics->sent},     {"photons_kept", caustics->kept},
            {"passes", caustics->passes},         {"first_radius", caustics->firstRadius},
            {"last_radius", caustics->lastRadius}};
}

Json renderJson(const RenderStats& stats) {
    const Json rays = {{"camera", stats.rays.camera},
                       {"shadow", stats.rays.shadow},
                       {"reflection", stats.rays.reflection},
                       {"refraction", stats.rays.refraction}};
    return {
        {"scene", stats.scene},
        {"output", stats.output},
        {"width", stats.width},
        {"height", stats.height},
        {"threads", stats.threads},
        {"seed", stats.seed},
        {"spp_mean", stats.sppMean},
        {"spp_min", stats.sppMin},
        {"spp_max", stats.sppMax},
        {"error_estimate", orNull(stats.errorEstimate)},
        {"error_target", orNull(stats.errorTarget)},
        {"converged", stats.converged},
        {"caustics", causticsJson(stats.caustics)},
        {"triangles", stats.triangles},
        {"primitives", stats.primitives},
        {"instances", stats.instances},
        {"lights", stats.lights},
        {"build_seconds", stats.buildSeconds},
        {"render_seconds", stats.renderSeconds},
        {"cpu_seconds", stats.cpuSeconds},
        {"peak_rss_bytes", stats.peakRssBytes},
        {"rays", rays},
        {"cut_paths", stats.cutPaths},
        {"cut_error_bound", stats.cutErrorBound},
        {"passes", passesJson(stats.passes)},
        {"features", stats.features},
        {"skipped", skippedJson(stats.skipped)},
        {"warnings", stats.warnings},
    };
}

}  // namespace

std::string statsJson(const std::vector<RenderStats>& renders) {
    Json all = {{"version", kProgramVersion}, {"renders", Json::array()}};
    for (const RenderStats& stats : renders) all["renders"].push_back(renderJson(stats));
    constexpr int kIndent = 2;
    return all.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string writeStats(const std::string& path, const std::vector<RenderStats>& renders) {
    const std::string text = statsJson(renders);
    return writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::uint64_t peakResidentBytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    constexpr std::uint64_t kKilobyte = 1024;
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kKilobyte;
}

}  // namespace rt
