// What the calls of a script have said so far. Knows nothing of Lua.
#pragma once

#include "ancestry.h"
#include "asset_search.h"

#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"
#include "rt/script/parameter_file.h"
#include "rt/script/scene_script.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rt {

/// What a script holds of the scene: a kind, and an index into the builder's array of that kind.
enum class ObjectKind { kNode, kMaterial, kTexture, kBump, kLight, kFocal };
inline constexpr std::size_t kObjectKinds = 6;

struct ObjectRef {
    ObjectKind kind;
    Index index;
};

/// An image that is painted when the script has ended, by a function that it has left.
struct PaintedImage {
    Index image = kNone;
    int function = 0;  ///< its number in the registry
    int side = 0;      ///< in texels; 0 = as many as are needed
};

/// "gr.node" and so on.
const char* objectKindName(ObjectKind kind);

class SceneBuilder {
  public:
    /// `folder` is the script's, resolved.
    SceneBuilder(const std::string& name, const std::string& folder, const ScriptSettings& settings,
                 Diagnostics& diagnostics);
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;

    const SceneDesc& scene() const { return scene_; }
    const ScriptSettings& settings() const { return settings_; }

    /// The script line whose call is being carried out; everything that is added remembers it.
    void enterCall(const char* call, SourceLocation where);
    const SourceLocation& where() const { return where_; }

    /// Throw with the line and the call's name in front: "scene.lua:12: gr.sphere: ...".
    [[noreturn]] void fail(const std::string& message) const;
    void warn(const std::string& kind, const std::string& message);
    /// As `warn`, but only the first time that this call site warns of this kind.
    void warnOnce(const std::string& kind, const std::string& message);

    std::size_t count(ObjectKind kind) const;
    /// "gr.node 'cow'", "gr.material 3".
    std::string describe(ObjectRef object) const;

    ObjectRef addNode(const std::string& name, Index geometry = kNone);
    Index addGeometry(GeometryShape shape);
    /// A node of the solid that others make.
    ObjectRef addCombined(const std::string& name, CsgOperation operation,
                          std::vector<Index> operands);
    /// The file's geometry; the same file and smoothing share one.
    Index meshFile(const std::string& file, std::optional<double> smoothAngle);
    /// The file's image; the same file has one image.
    Index image(const std::string& file, AssetRole role);
    /// An image that a function of the script will paint; a side of 0 asks for as many texels as
    /// are needed.
    Index paintedImage(int function, int side);
    const std::vector<PaintedImage>& paintedImages() const { return painted_; }
    void setPainting(Index image, std::shared_ptr<const BakedImage> baked);
    ObjectRef addMaterial(const Material& material);
    ObjectRef addTexture(TextureDesc texture);
    ObjectRef addBump(Index image);
    ObjectRef addLight(const Light& light);
    ObjectRef addFocal(const FocalDesc& focal);

    const NodeDesc& node(Index index) const { return scene_.nodes[index]; }
    const LightDesc& light(Index index) const { return lights_[index]; }
    const FocalDesc& focal(Index index) const { return focals_[index]; }

    /// The node's state, to be changed for the renders to come.
    NodeState& edit(Index node);
    /// Refuses cycles.
    void addChild(Index parent, Index child, const AppearanceDesc& appearance);

    void setBackground(const BackgroundDesc& background) { background_ = background; }
    const RenderOptions& options() const { return options_; }
    void setOptions(const RenderOptions& options) { options_ = options; }
    /// Completes the render with the background and the options of this moment.
    void addRender(RenderDesc render);

    /// Reads the files of parameters; what is wrong with them is a SceneError.
    void readParameters();
    /// What this parameter was set to, if it was; the name counts as read.
    const GivenParameter* givenParameter(const std::string& name);
    /// Lists a parameter; the first gr.param of a name stays.
    void addParameter(const std::string& name, const std::string& value, const std::string& doc);

    /// Counts `bytes` of description against the script's memory.
    void charge(std::size_t bytes);

    /// The assets that were looked for.
    const ScriptFiles& files() const { return files_; }

    /// Warns of what was left unsaid, and hands the scene over.
    ScriptResult finish();

  private:
    std::string resolveAsset(const std::string& file, AssetRole role);
    void judgeUnread(const GivenParameter& given) const;
    [[noreturn]] void failCycle(Index parent, Index child) const;

    const ScriptSettings& settings_;
    Diagnostics& diagnostics_;
    SceneDesc scene_;
    std::vector<LightDesc> lights_;
    std::vector<FocalDesc> focals_;
    BackgroundDesc background_;
    RenderOptions options_;
    std::vector<ScriptParameter> parameters_;
    std::set<std::string> parameterNames_;
    std::map<std::string, GivenParameter> given_;
    std::set<std::string> parametersRead_;

    AssetSearch search_;
    ScriptFiles files_;
    Ancestry ancestry_;
    std::map<std::pair<std::string, AssetRole>, std::string> resolvedFiles_;
    std::map<std::pair<std::string, double>, Index> meshes_;
    std::map<std::string, Index> images_;
    std::vector<PaintedImage> painted_;
    std::unordered_set<std::size_t> nodeNames_;  ///< hashes: a warning may rest on a collision
    std::set<std::string> outputs_;

    const char* call_ = "";
    SourceLocation where_;
    std::set<std::tuple<std::string, int, std::string>> warned_;
    std::size_t charged_ = 0;
};

}  // namespace rt
