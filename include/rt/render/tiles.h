// Tile arithmetic: pure functions of an area.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <vector>

namespace rt {

inline constexpr int kTileSize = 16;

/// The area cut into tiles of at most kTileSize squared, row by row; they cover it exactly once.
std::vector<Tile> tilesOf(const Tile& area);

}  // namespace rt
