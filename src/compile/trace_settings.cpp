#include "rt/compile/trace_settings.h"

#include "rt/core/error.h"

#include <algorithm>
#include <bit>
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

/// Side of the part of a pixel over which textures may be averaged at first, by the error target:
/// the bias of a floor of full contrast is then below a third of it (Documentation/textures.md).
constexpr double kShareSidePerError = 36.0;

std::uint32_t textureSharesFor(double error) {
    const double side = std::min(kShareSidePerError * error, 1.0);
    const double shares = std::min(1.0 / (side * side), static_cast<double>(kDefaultMaxSpp));
    return std::bit_ceil(static_cast<std::uint32_t>(shares));
}

/// Share of an error target, or of the default one, that photons may leave: half of its square, and
/// of the slow truth a sixteenth.
constexpr double kCausticShare = 0x1.6a09e667f3bcdp-1;
constexpr double kTrueCausticShare = 0.25;

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
        settings.textureShares = 0;
        settings.lightsAtPoint = 0;
    }
    return settings;
}

}  // namespace

SamplingGoal samplingGoal(const RenderOptions& options) {
    SamplingGoal goal;
    goal.trace = traceSettings(options);
    goal.adaptive = !options.reference.value_or(false);
    goal.timeLimit = options.time.value_or(0.0);
    goal.causticTarget =
        (goal.adaptive ? kCausticShare : kTrueCausticShare) * options.error.value_or(kDefaultError);
    const bool fixed = needsKnownNumber(goal.trace.sampler);
    if (options.error && fixed) {
        throw UsageError("--error needs --sampler joint or random: the points of " +
                         *options.sampler + " depend on how many there will be; give --spp");
    }
    if (options.spp || fixed) {
        goal.trace.spp = options.spp.value_or(kDefaultSpp);
        if (goal.trace.textureShares > 0) {
            goal.trace.textureShares = static_cast<std::uint32_t>(goal.trace.spp);
        }
        return goal;
    }
    goal.trace.spp = options.maxSpp.value_or(kDefaultMaxSpp);
    if (options.error || !options.time) goal.errorTarget = options.error.value_or(kDefaultError);
    if (goal.trace.textureShares > 0) {
        goal.trace.textureShares = textureSharesFor(options.error.value_or(kDefaultError));
    }
    return goal;
}

}  // namespace rt
