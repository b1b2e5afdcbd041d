// Which refracting solids a path is inside.
#pragma once

#include "rt/trace/render_scene.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rt {

/// A set of instances, kept small: crossing a surface toggles its object, whatever its winding.
class MediumSet {
  public:
    bool contains(Index instance) const {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (at(i) == instance) return true;
        }
        return false;
    }

    /// Enters the object, or leaves it.
    void toggle(Index instance) {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (at(i) != instance) continue;
            at(i) = at(count_ - 1);
            pop();
            return;
        }
        if (count_ < kInline) {
            few_[count_] = instance;
        } else {
            many_.push_back(instance);
        }
        ++count_;
    }

    /// The look of the solid that decides here, the one created last; nullptr outside of all.
    const Look* look(const RenderScene& scene) const {
        const Look* look = nullptr;
        Index highest = 0;
        for (std::uint32_t i = 0; i < count_; ++i) {
            const Instance& instance = scene.instances[at(i)];
            if (look && instance.order < highest) continue;
            highest = instance.order;
            look = &scene.looks[instance.look];
        }
        return look;
    }

    /// The refractive index here: 1 outside of all.
    double index(const RenderScene& scene) const {
        const Look* here = look(scene);
        return here ? here->index : 1.0;
    }

  private:
    static constexpr std::uint32_t kInline = 6;

    Index& at(std::uint32_t i) { return i < kInline ? few_[i] : many_[i - kInline]; }
    Index at(std::uint32_t i) const { return i < kInline ? few_[i] : many_[i - kInline]; }
    void pop() {
        if (count_ > kInline) many_.pop_back();
        --count_;
    }

    std::uint32_t count_ = 0;
    std::array<Index, kInline> few_{};
    std::vector<Index> many_;
};

}  // namespace rt
