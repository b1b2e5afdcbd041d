#include "rt/render/render_log.h"

#include <utility>

namespace rt {
namespace {

void writeCounts(PackedWriter& to, const TraceCounts& counts) {
    for (const std::uint64_t number :
         {counts.rays.camera, counts.rays.shadow, counts.rays.reflection, counts.rays.refraction,
          counts.cutPaths}) {
        to.number(number);
    }
    to.real(counts.cutBound);
    to.number(counts.nonFinite);
    to.word(counts.nonFiniteX);
    to.word(counts.nonFiniteY);
}

TraceCounts readCounts(PackedReader& from) {
    TraceCounts counts;
    for (std::uint64_t* const number :
         {&counts.rays.camera, &counts.rays.shadow, &counts.rays.reflection,
          &counts.rays.refraction, &counts.cutPaths}) {
        *number = from.number<std::uint64_t>();
    }
    counts.cutBound = from.real();
    counts.nonFinite = from.number<std::uint64_t>();
    counts.nonFiniteX = from.word();
    counts.nonFiniteY = from.word();
    return counts;
}

}  // namespace

void RenderLog::rewind() {
    const std::lock_guard lock(mutex_);
    next_ = 0;
}

void RenderLog::beginStep(Gather gather) {
    const std::lock_guard lock(mutex_);
    if (next_ == steps_.size()) steps_.emplace_back();
    steps_[next_].gather = std::move(gather);
    ++next_;
}

const RenderLog::Part* RenderLog::find(std::size_t part) const {
    const std::lock_guard lock(mutex_);
    const auto& parts = steps_[next_ - 1].parts;
    const auto found = parts.find(part);
    return found == parts.end() ? nullptr : &found->second;
}

void RenderLog::add(std::size_t part, Part what) {
    const std::lock_guard lock(mutex_);
    steps_[next_ - 1].parts.insert_or_assign(part, std::move(what));
}

void RenderLog::gather() {
    const std::lock_guard lock(mutex_);
    for (Step& step : steps_) {
        if (!step.gather) continue;
        for (auto& [number, part] : step.parts) {
            if (part.values.empty()) part.values = step.gather(number);
        }
    }
}

void RenderLog::endRender() {
    const std::lock_guard lock(mutex_);
    for (Step& step : steps_) {
        if (!step.gather) continue;
        step.gather = {};
        std::erase_if(step.parts, [](const auto& part) { return part.second.values.empty(); });
    }
}

void RenderLog::write(PackedWriter& to) const {
    const std::lock_guard lock(mutex_);
    to.word(static_cast<int>(steps_.size()));
    for (const Step& step : steps_) {
        to.word(static_cast<int>(step.parts.size()));
        for (const auto& [number, part] : step.parts) {
            const bool isElsewhere = part.values.empty() && step.gather;
            const std::vector<std::uint8_t> gathered =
                isElsewhere ? step.gather(number) : std::vector<std::uint8_t>();
            const std::vector<std::uint8_t>& values = isElsewhere ? gathered : part.values;
            to.number(static_cast<std::uint32_t>(number));
            writeCounts(to, part.counts);
            to.number(static_cast<std::uint32_t>(values.size()));
            to.raw(values);
        }
    }
}

void RenderLog::read(PackedReader& from) {
    std::vector<Step> steps;
    for (auto left = from.number<std::uint32_t>(); left > 0; --left) {
        Step& step = steps.emplace_back();
        for (auto parts = from.number<std::uint32_t>(); parts > 0; --parts) {
            const std::size_t number = from.number<std::uint32_t>();
            Part& part = step.parts[number];
            part.counts = readCounts(from);
            const auto values = from.raw(from.number<std::uint32_t>());
            part.values.assign(values.begin(), values.end());
        }
    }
    const std::lock_guard lock(mutex_);
    steps_ = std::move(steps);
    next_ = 0;
}

}  // namespace rt
