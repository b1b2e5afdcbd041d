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
    const std::pair key(file.path, angle);
    const auto known = files_.find(key);
    if (known != files_.end()) return known->second;
    MeshOptions options;
    options.smoothAngleDegrees = angle;
    options.threads = threads_;
    return files_[key] = withTree(loadObj(file.path, options, diagnostics));
}

std::shared_ptr<const MeshShape> AssetCache::mesh(const MeshTableDesc& table, Index key,
                                                  double smoothAngleDegrees,
                                                  const SourceLocation& where,
                                                  Diagnostics& diagnostics) {
    const double angle = table.smoothAngle.value_or(smoothAngleDegrees);
    const std::pair entry(key, angle);
    const auto known = tables_.find(entry);
    if (known != tables_.end()) return known->second;
    MeshOptions options;
    options.smoothAngleDegrees = angle;
    options.threads = threads_;
    return tables_[entry] = withTree(meshFromPolygons(
               table.vertices, table.corners, table.faceSizes, options, where, diagnostics));
}

std::shared_ptr<const Texture> AssetCache::image(const ImageDesc& image,
                                                 const TextureSettings& settings,
                                                 std::uint64_t maxPixels,
                                                 Diagnostics& diagnostics) {
    const std::tuple key(image.path, settings.flipV, settings.srgb, settings.prefilter);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    ImageLimits limits;
    limits.maxPixels = maxPixels;
    return images_[key] = std::make_shared<const Texture>(
               loadImage(image.path, limits, diagnostics), settings);
}

void AssetCache::forgetFile(const std::string& path) {
    std::erase_if(files_, [&](const auto& entry) { return entry.first.first == path; });
    std::erase_if(images_, [&](const auto& entry) { return std::get<0>(entry.first) == path; });
}

}  // namespace rt
