// Tile arithmetic: pure functions of an area.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <vector>

namespace rt {

inline constexpr int kTileSize = 16;

inline constexpr int kMostShards = 1'000'000;

/// One of several runs that share a picture, by turns of its tiles.
struct Shard {
    int index = 1;  ///< from 1 to count
    int count = 1;

    int ownerOf(std::size_t tile) const {
        return 1 + static_cast<int>(tile % static_cast<std::size_t>(count));
    }
    bool owns(std::size_t tile) const { return ownerOf(tile) == index; }
};

/// The area cut into tiles of at most kTileSize squared, row by row; they cover it exactly once.
std::vector<Tile> tilesOf(const Tile& area);

}  // namespace rt
