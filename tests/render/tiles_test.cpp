#include "rt/render/tiles.h"

#include <doctest/doctest.h>

#include <vector>

using namespace rt;

TEST_CASE("tiles cover every pixel of an area exactly once") {
    for (const Tile& area : {Tile{0, 0, 1, 1}, Tile{0, 0, 16, 16}, Tile{0, 0, 17, 15},
                             Tile{5, 7, 100, 41}, Tile{3, 3, 3, 9}}) {
        std::vector<int> covered(static_cast<std::size_t>(area.width() * area.height()), 0);
        for (const Tile& tile : tilesOf(area)) {
            CHECK(tile.width() <= kTileSize);
            CHECK(tile.height() <= kTileSize);
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    REQUIRE((area.x0 <= x && x < area.x1 && area.y0 <= y && y < area.y1));
                    ++covered[static_cast<std::size_t>((y - area.y0) * area.width() + x - area.x0)];
                }
            }
        }
        for (const int count : covered) CHECK(count == 1);
    }
}
