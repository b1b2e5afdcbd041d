// Neighbouring points ask for nearly the same occluders: those in a wider hull about many of them
// are found once, and only these are tried for each.
#pragma once

#include "shadow_hull.h"

#include <cstdint>
#include <vector>

namespace rt {

/// Answers as occludersIn does; serves one thread.
class OccluderCache {
  public:
    /// The instances that may meet the hull from one light, `except` left out. Points that are
    /// looked at in the same way, so that they may be near each other, have the same `path`.
    Occluders occludersIn(const RenderScene& scene, const ShadowHull& hull, Index light,
                          std::uint32_t path, Index except);

  private:
    /// The radius of the wider hull, in radii of the one that is asked for.
    static constexpr double kReach = 16.0;
    static constexpr double kLeastReach = 2.0;
    /// More candidates than this cost more to try than to find.
    static constexpr std::size_t kMostCandidates = 16;
    static constexpr std::size_t kMostEntries = 8;

    struct Entry {
        Index light;
        std::uint32_t path;
        double reach = kReach;
        ShadowHull hull{};
        std::vector<Index> candidates{};

        bool covers(const ShadowHull& other) const;
    };

    Entry& entryFor(Index light, std::uint32_t path);

    std::vector<Entry> entries_;
    std::size_t next_ = 0;  ///< to be replaced
};

}  // namespace rt
