#include "rt/compile/asset_cache.h"

#include "height_field.h"
#include "rt/compile/mesh_file.h"
#include "rt/image/image.h"

#include <utility>

namespace rt {
namespace {

/// What is known under a key, or else what `load` gives; a load that fails leaves nothing.
template <class Map, class Load>
typename Map::mapped_type remembered(Map& known, const typename Map::key_type& key,
                                     const Load& load) {
    const auto entry = known.find(key);
    if (entry != known.end()) return entry->second;
    return known[key] = load();
}

/// The function was asked for v itself, and for values: nothing is to be turned or decoded.
std::shared_ptr<const Texture> painted(const BakedImage& baked, bool prefilter) {
    TextureSettings settings;
    settings.heldEdges = true;
    settings.prefilter = prefilter;
    return std::make_shared<const Texture>(Image{baked.side, baked.side, 3, baked.samples},
                                           settings);
}

}  // namespace

std::shared_ptr<const MeshShape> AssetCache::withTree(TriangleMesh mesh) const {
    if (mesh.triangles.empty()) return nullptr;
    MeshTree tree = MeshTree::build(mesh, threads_);
    return std::make_shared<const MeshShape>(MeshShape{std::move(mesh), std::move(tree)});
}

MeshOptions AssetCache::optionsFor(double angle) const {
    MeshOptions options;
    options.smoothAngleDegrees = angle;
    options.threads = threads_;
    return options;
}

std::shared_ptr<const MeshShape> AssetCache::mesh(const MeshFileDesc& file,
                                                  double smoothAngleDegrees,
                                                  Diagnostics& diagnostics) {
    const double angle = file.smoothAngle.value_or(smoothAngleDegrees);
    return remembered(files_, {file.path, angle},
                      [&] { return withTree(loadObj(file.path, optionsFor(angle), diagnostics)); });
}

std::shared_ptr<const MeshShape> AssetCache::mesh(const MeshTableDesc& table, Index key,
                                                  double smoothAngleDegrees,
                                                  const SourceLocation& where,
                                                  Diagnostics& diagnostics) {
    const double angle = table.smoothAngle.value_or(smoothAngleDegrees);
    return remembered(tables_, {key, angle}, [&] {
        return withTree(meshFromPolygons(table.vertices, table.corners, table.faceSizes,
                                         optionsFor(angle), where, diagnostics));
    });
}

std::shared_ptr<const MeshShape> AssetCache::heightField(const HeightFieldDesc& field,
                                                         const ImageDesc* image, Index key,
                                                         std::uint64_t maxPixels,
                                                         const SourceLocation& where,
                                                         Diagnostics& diagnostics) {
    return remembered(tables_, {key, 0.0}, [&] {
        const HeightFieldOptions options{field.base, field.smooth};
        if (!image) return withTree(heightFieldMesh(field.grid, options, where));
        ImageLimits limits;
        limits.maxPixels = maxPixels;
        const HeightGrid grid = gridOf(loadImage(image->path, limits, diagnostics));
        return withTree(heightFieldMesh(grid, options, where));
    });
}

std::shared_ptr<const Texture> AssetCache::image(const ImageDesc& image,
                                                 const TextureSettings& settings,
                                                 std::uint64_t maxPixels,
                                                 Diagnostics& diagnostics) {
    if (image.baked) {
        return remembered(painted_, {image.baked.get(), settings.prefilter},
                          [&] { return painted(*image.baked, settings.prefilter); });
    }
    return remembered(images_, {image.path, settings.flipV, settings.srgb, settings.prefilter},
                      [&] {
                          ImageLimits limits;
                          limits.maxPixels = maxPixels;
                          return std::make_shared<const Texture>(
                              loadImage(image.path, limits, diagnostics), settings);
                      });
}

void AssetCache::forgetFile(const std::string& path) {
    std::erase_if(files_, [&](const auto& entry) { return entry.first.first == path; });
    std::erase_if(images_, [&](const auto& entry) { return std::get<0>(entry.first) == path; });
}

}  // namespace rt
