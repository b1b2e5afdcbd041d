#include "rt/compile/asset_cache.h"

#include "rt/compile/mesh_file.h"
#include "rt/image/image.h"

#include <utility>

namespace rt {

std::shared_ptr<const MeshShape> AssetCache::withTree(TriangleMesh mesh) const {
    if (mesh.triangles.empty()) return nullptr;
    MeshTree tree = MeshTree::build(mesh, threads_);
    return std::make_shared<const MeshShape>(MeshShape{std::move(mesh), std::move(tree)});
}

std::shared_ptr<const MeshShape> AssetCache::mesh(const MeshFileDesc& file,
                                                  double smoothAngleDegrees,
                                                  Diagnostics& diagnostics) {
    const double angle = file.smoothAngle.value_or(smoothAngleDegrees);
    const auto [entry, added] = files_.try_emplace({file.path, angle});
    if (added) {
        MeshOptions options;
        options.smoothAngleDegrees = angle;
        options.threads = threads_;
        entry->second = withTree(loadObj(file.path, options, diagnostics));
    }
    return entry->second;
}

std::shared_ptr<const MeshShape> AssetCache::mesh(const MeshTableDesc& table, Index key,
                                                  double smoothAngleDegrees,
                                                  const SourceLocation& where,
                                                  Diagnostics& diagnostics) {
    const double angle = table.smoothAngle.value_or(smoothAngleDegrees);
    const auto [entry, added] = tables_.try_emplace({key, angle});
    if (added) {
        MeshOptions options;
        options.smoothAngleDegrees = angle;
        options.threads = threads_;
        entry->second = withTree(meshFromPolygons(table.vertices, table.corners, table.faceSizes,
                                                  options, where, diagnostics));
    }
    return entry->second;
}

std::shared_ptr<const Texture> AssetCache::image(const ImageDesc& image,
                                                 const TextureSettings& settings,
                                                 std::uint64_t maxPixels,
                                                 Diagnostics& diagnostics) {
    const auto [entry, added] =
        images_.try_emplace({image.path, settings.flipV, settings.srgb, settings.prefilter});
    if (added) {
        ImageLimits limits;
        limits.maxPixels = maxPixels;
        entry->second =
            std::make_shared<const Texture>(loadImage(image.path, limits, diagnostics), settings);
    }
    return entry->second;
}

}  // namespace rt
