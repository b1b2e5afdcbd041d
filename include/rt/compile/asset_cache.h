// Meshes and images, loaded once and shared by all that use them.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"
#include "rt/trace/render_scene.h"

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace rt {

struct MeshOptions;

class AssetCache {
  public:
    explicit AssetCache(int threads) : threads_(threads) {}

    /// Null for a mesh without triangles.
    std::shared_ptr<const MeshShape> mesh(const MeshFileDesc& file, double smoothAngleDegrees,
                                          Diagnostics& diagnostics);
    /// `key` names the table within the run of one script.
    std::shared_ptr<const MeshShape> mesh(const MeshTableDesc& table, Index key,
                                          double smoothAngleDegrees, const SourceLocation& where,
                                          Diagnostics& diagnostics);
    /// `image` is the file of its heights, where they come from one.
    std::shared_ptr<const MeshShape> heightField(const HeightFieldDesc& field,
                                                 const ImageDesc* image, Index key,
                                                 std::uint64_t maxPixels,
                                                 const SourceLocation& where,
                                                 Diagnostics& diagnostics);
    std::shared_ptr<const Texture> image(const ImageDesc& image, const TextureSettings& settings,
                                         std::uint64_t maxPixels, Diagnostics& diagnostics);

    /// Forgets what came from a script itself, not from files: before another script runs.
    void forgetTables() {
        tables_.clear();
        painted_.clear();
    }
    /// Forgets what came from a file: it has changed.
    void forgetFile(const std::string& path);

  private:
    MeshOptions optionsFor(double smoothAngleDegrees) const;
    std::shared_ptr<const MeshShape> withTree(TriangleMesh mesh) const;

    int threads_;
    std::map<std::pair<std::string, double>, std::shared_ptr<const MeshShape>> files_;
    std::map<std::pair<Index, double>, std::shared_ptr<const MeshShape>> tables_;
    std::map<std::tuple<std::string, bool, bool, bool>, std::shared_ptr<const Texture>> images_;
    std::map<std::pair<const BakedImage*, bool>, std::shared_ptr<const Texture>> painted_;
};

}  // namespace rt
