// Copies of a scene in which what moves is put in its place.
#pragma once

#include "rt/trace/render_scene.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rt {

/// Lends out copies, made when all are lent: as many as threads trace at once, not as many as
/// tiles. What is lent shows some moment; the borrower sets its own.
class MomentPool {
  public:
    std::unique_ptr<RenderScene> lend(const RenderScene& scene) {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<RenderScene> copy = std::move(free_.back());
                free_.pop_back();
                return copy;
            }
        }
        auto copy = std::make_unique<RenderScene>(scene);
        copy->moments.reset();  // the pool does not hold itself
        return copy;
    }

    void takeBack(std::unique_ptr<RenderScene> copy) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(copy));
    }

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<RenderScene>> free_;
};

}  // namespace rt
