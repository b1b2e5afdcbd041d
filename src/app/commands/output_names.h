// Which file each render goes to.
#pragma once

#include "rt/app/options.h"
#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// A name before its extension, and that with its dot; "" if it has none.
std::pair<std::string, std::string> splitExtension(const std::string& name);

/// Hands out the names of one run of the program, and sees to it that none is used twice unnoticed.
class OutputNames {
  public:
    explicit OutputNames(const Options& options) : options_(options) {}

    /// The names of a script's renders, in order. Runs of '#' become the frame's number, or without
    /// frames the number of the render in this run. Throws UsageError where -o, or two frames,
    /// would write one file twice; a script that does so itself is warned.
    std::vector<std::string> namesFor(const SceneDesc& scene, std::int64_t frame,
                                      Diagnostics& diagnostics);

  private:
    std::string nameFor(const RenderDesc& render, std::int64_t frame);
    void refuseTwice(const std::string& name, const RenderDesc& render, Diagnostics& diagnostics);

    const Options& options_;
    std::int64_t rendersSoFar_ = 0;
    std::set<std::string> used_;
};

}  // namespace rt
