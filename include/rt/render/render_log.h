// What a render has traced, so that it can go on later as if it had not been stopped.
//
// A render is a row of steps: each brings tiles of pixels, tiles of corners or groups of looks to
// more samples, and what was traced alone decides what the next step is to do. So a render that
// takes the results of its steps from a log, instead of tracing them, comes to the same decisions
// by itself, and nothing of how it decides needs to be kept.
#pragma once

#include "rt/core/packed_bytes.h"
#include "rt/trace/trace_kernel.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace rt {

/// One render at a time adds to it, from any of its threads.
class RenderLog {
  public:
    /// What a part of a step, such as a tile, came to.
    struct Part {
        TraceCounts counts;  ///< of all steps so far, where they are counted together
        /// The values that lacked samples, in order, as they are in memory.
        std::vector<std::uint8_t> values;
    };
    /// The values of a part that a step left where they were.
    using Gather = std::function<std::vector<std::uint8_t>(std::size_t part)>;

    /// Before a render: from its first step on.
    void rewind();
    /// With `gather`, parts without values stay where they are until the log is written.
    void beginStep(Gather gather = {});
    /// Of this step, or null. It stays until it is added again.
    const Part* find(std::size_t part) const;
    void add(std::size_t part, Part what);
    /// Gathers the parts that were left where they are: they outlive the render.
    void gather();
    /// Nothing can be gathered any more: parts that were left where they are are forgotten.
    void endRender();

    /// Appends all of it, in the layout
    ///   u4 steps; of each u4 parts; of each part u4 its number, u8 x 5 rays (camera, shadow,
    ///   reflection, refraction) and cut paths, f8 cut bound, u8 samples that were not finite, u4 x
    ///   2 the first of them, u4 length, the values.
    /// May be called while a render adds.
    void write(PackedWriter& to) const;
    /// Instead of what it holds. Throws DamagedBytes.
    void read(PackedReader& from);

  private:
    struct Step {
        std::map<std::size_t, Part> parts;
        Gather gather;
    };

    mutable std::mutex mutex_;
    std::vector<Step> steps_;
    std::size_t next_ = 0;  ///< the step that beginStep begins
};

}  // namespace rt
