#include "rt/compile/trace_settings.h"

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

}  // namespace

TraceSettings traceSettings(const RenderOptions& options) {
    TraceSettings settings;
    settings.spp = options.spp.value_or(kDefaultSpp);
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

}  // namespace rt
