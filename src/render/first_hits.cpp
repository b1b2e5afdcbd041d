#include "rt/render/first_hits.h"

#include "rt/core/parallel.h"

namespace rt {

std::vector<FirstHit> firstHits(const RenderScene& scene, const TraceSettings& settings,
                                const Tile& area, int threads, const TraceKernel& kernel) {
    const auto width = static_cast<std::size_t>(area.width());
    const auto height = static_cast<std::size_t>(area.height());
    std::vector<FirstHit> hits(width * height);
    forEachIndex(height, threads, [&](std::size_t row, int) {
        const int y = area.y0 + static_cast<int>(row);
        kernel.firstHits(scene, settings, {area.x0, y, area.x1, y + 1}, &hits[row * width]);
    });
    return hits;
}

}  // namespace rt
