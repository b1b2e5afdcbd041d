#include "rt/render/tiles.h"

#include <algorithm>

namespace rt {

std::vector<Tile> tilesOf(const Tile& area) {
    std::vector<Tile> tiles;
    for (int y = area.y0; y < area.y1; y += kTileSize) {
        for (int x = area.x0; x < area.x1; x += kTileSize) {
            tiles.push_back(
                {x, y, std::min(x + kTileSize, area.x1), std::min(y + kTileSize, area.y1)});
        }
    }
    return tiles;
}

}  // namespace rt
