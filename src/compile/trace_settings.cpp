#include "rt/compile/trace_settings.h"

#include "rt/core/error.h"

#include <limits>
#include <stdexcept>
#include <utility>

namespace rt {
namespace {

constexpr std::pair<const char*, SamplerKind> kSamplers[] = {
    {"joint", SamplerKind::kJoint},
    {"jitter", SamplerKind::kJitter},
    {"grid", SamplerKind::kGrid},
    {"random", SamplerKind::kRandom},
};

constexpr std::pair<const char*, FilterKind> kFilters[] = {
    {"box", FilterKind::kBox},
    {"gaussian", FilterKind::kGaussian},
    {"mitchell", FilterKind::kMitchell},
    {"blackman-harris", FilterKind::kBlackmanHarris},
};

template <class Kind, std::size_t N>
Kind named(const std::pair<const char*, Kind> (&table)[N], const std::string& name) {
    for (const auto& [known, kind] : table) {
        if (name == known) return kind;
    }
    throw std::logic_error("the option table let \"" + name + "\" through");
}

/// Points of these depend on how many there will be.
bool needsKnownNumber(SamplerKind sampler) {
    return sampler == SamplerKind::kJitter || sampler == SamplerKind::kGrid;
}

TraceSettings traceSettings(const RenderOptions& options) {
    TraceSettings settings;
    settings.maxDepth = options.maxDepth.value_or(settings.maxDepth);
    settings.cutoff = options.cutoff.value_or(settings.cutoff);
    settings.seed = static_cast<std::uint64_t>(options.seed.value_or(0.0));
    settings.sampler = named(kSamplers, options.sampler.value_or("joint"));
    settings.filter = named(kFilters, options.filter.value_or("box"));
    if (options.reference.value_or(false)) {
        settings.cutoff = 0.0;
        settings.raysPerSample = std::numeric_limits<std::uint64_t>::max();
    }
    return settings;
}

}  // namespace

SamplingGoal samplingGoal(const RenderOptions& options) {
    SamplingGoal goal;
    goal.trace = traceSettings(options);
    goal.adaptive = !options.reference.value_or(false);
    goal.timeLimit = options.time.value_or(0.0);
    const bool fixed = needsKnownNumber(goal.trace.sampler);
    if (options.error && fixed) {
        throw UsageError("--error needs --sampler joint or random: the points of " +
                         *options.sampler + " depend on how many there will be; give --spp");
    }
    if (options.spp || fixed) {
        goal.trace.spp = options.spp.value_or(kDefaultSpp);
        return goal;
    }
    goal.trace.spp = options.maxSpp.value_or(kDefaultMaxSpp);
    if (options.error || !options.time) goal.errorTarget = options.error.value_or(kDefaultError);
    return goal;
}

}  // namespace rt
