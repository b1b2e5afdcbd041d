#include "scene_builder.h"

#include <filesystem>
#include <functional>
#include <new>
#include <system_error>

namespace rt {

namespace {

constexpr const char* kKindNames[kObjectKinds] = {"gr.node",    "gr.material", "gr.texture",
                                                  "gr.bumpmap", "gr.light",    "gr.focal"};

// The longest way round a cycle that a message spells out.
constexpr std::size_t kCycleNamesShown = 12;
constexpr double kSmoothUnsaid = -1.0;

template <class Desc>
Index append(std::vector<Desc>& all, Desc desc) {
    all.push_back(std::move(desc));
    return static_cast<Index>(all.size() - 1);
}

std::size_t bytesOf(const GeometryShape& shape) {
    const auto* table = std::get_if<MeshTableDesc>(&shape);
    if (!table) return sizeof(GeometryDesc);
    return sizeof(GeometryDesc) + table->vertices.size() * sizeof(Vec3) +
           (table->corners.size() + table->faceSizes.size()) * sizeof(Index);
}

std::size_t bytesOf(const NodeState& state) {
    return sizeof(NodeState) + state.children.size() * sizeof(EdgeDesc);
}

std::filesystem::path currentFolder() {
    std::error_code failure;
    std::filesystem::path folder = std::filesystem::current_path(failure);
    if (failure == std::errc::not_enough_memory) throw std::bad_alloc();
    if (failure) throw SceneError("the current folder cannot be found: " + failure.message());
    return folder;
}

}  // namespace

const char* objectKindName(ObjectKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

SceneBuilder::SceneBuilder(const std::string& name, const std::string& folder,
                           const ScriptSettings& settings, Diagnostics& diagnostics)
    : settings_(settings),
      diagnostics_(diagnostics),
      search_(currentFolder(), folder, settings.trust),
      ancestry_(scene_.nodes) {
    scene_.name = name;
    scene_.folder = folder;
}

void SceneBuilder::enterCall(const char* call, SourceLocation where) {
    call_ = call;
    where_ = std::move(where);
}

void SceneBuilder::fail(const std::string& message) const {
    throw SceneError(std::string("gr.") + call_ + ": " + message, where_);
}

void SceneBuilder::warn(const std::string& kind, const std::string& message) {
    diagnostics_.warn(kind, where_, std::string("gr.") + call_ + ": " + message);
}

void SceneBuilder::warnOnce(const std::string& kind, const std::string& message) {
    const bool first = warned_.emplace(where_.file, where_.line, kind + " " + call_).second;
    if (first) warn(kind, message);
}

std::size_t SceneBuilder::count(ObjectKind kind) const {
    const std::size_t counts[kObjectKinds] = {scene_.nodes.size(),    scene_.materials.size(),
                                              scene_.textures.size(), scene_.bumps.size(),
                                              lights_.size(),         focals_.size()};
    return counts[static_cast<std::size_t>(kind)];
}

std::string SceneBuilder::describe(ObjectRef object) const {
    const std::string kind = objectKindName(object.kind);
    if (object.kind != ObjectKind::kNode) return kind + " " + std::to_string(object.index + 1);
    return kind + " '" + printable(scene_.nodes[object.index].name, 64) + "'";
}

void SceneBuilder::charge(std::size_t bytes) {
    charged_ += bytes;
    if (charged_ <= settings_.memoryLimit) return;
    throw LimitError("the scene needs more than the " + std::to_string(settings_.memoryLimit) +
                         " bytes that a script may use (see --script-memory)",
                     where_);
}

ObjectRef SceneBuilder::addNode(const std::string& name, Index geometry) {
    charge(sizeof(NodeDesc) + sizeof(NodeState) + name.size() + where_.file.size());
    const bool fresh = nodeNames_.insert(std::hash<std::string>()(name)).second;
    if (!fresh && !name.empty()) {
        warnOnce("duplicate-name", "another node is called '" + printable(name, 64) + "' too");
    }
    const Index index = append(scene_.nodes, NodeDesc(name, geometry, where_));
    return {ObjectKind::kNode, index};
}

Index SceneBuilder::addGeometry(GeometryShape shape) {
    charge(bytesOf(shape) + where_.file.size());
    return append(scene_.geometries, GeometryDesc{std::move(shape), where_});
}

ObjectRef SceneBuilder::addCombined(const std::string& name, CsgOperation operation,
                                    std::vector<Index> operands) {
    charge(operands.size() * sizeof(Index));
    const auto next = static_cast<Index>(scene_.nodes.size());
    const ObjectRef node = addNode(name, addGeometry(CsgDesc{operation, next}));
    for (const Index operand : operands) ancestry_.add(node.index, operand);
    scene_.nodes[node.index].operands = std::move(operands);
    return node;
}

std::string SceneBuilder::resolveAsset(const std::string& file, AssetRole role) {
    const auto known = resolvedFiles_.find({file, role});
    if (known != resolvedFiles_.end()) return known->second;
    const AssetSearch::Found found = search_.find(file, role);
    files_.absent.insert(files_.absent.end(), found.absent.begin(), found.absent.end());
    if (found.path.empty()) fail(found.error);
    files_.read.push_back(found.path);
    resolvedFiles_[{file, role}] = found.path;
    return found.path;
}

Index SceneBuilder::meshFile(const std::string& file, std::optional<double> smoothAngle) {
    const std::string path = resolveAsset(file, AssetRole::kMesh);
    const auto key = std::make_pair(path, smoothAngle.value_or(kSmoothUnsaid));
    const auto known = meshes_.find(key);
    if (known != meshes_.end()) return known->second;
    return meshes_[key] = addGeometry(MeshFileDesc{path, smoothAngle});
}

Index SceneBuilder::image(const std::string& file, AssetRole role) {
    const std::string path = resolveAsset(file, role);
    const auto known = images_.find(path);
    if (known != images_.end()) return known->second;
    charge(sizeof(ImageDesc) + path.size());
    return images_[path] = append(scene_.images, ImageDesc{path, where_});
}

Index SceneBuilder::paintedImage(int function, int side) {
    charge(sizeof(ImageDesc) + sizeof(PaintedImage));
    const Index image = append(scene_.images, ImageDesc{"", where_});
    painted_.push_back({image, function, side});
    return image;
}

void SceneBuilder::setPainting(Index image, std::shared_ptr<const BakedImage> baked) {
    scene_.images[image].baked = std::move(baked);
}

ObjectRef SceneBuilder::addMaterial(const Material& material) {
    charge(sizeof(MaterialDesc));
    return {ObjectKind::kMaterial, append(scene_.materials, MaterialDesc{material, where_})};
}

ObjectRef SceneBuilder::addTexture(TextureDesc texture) {
    charge(sizeof(TextureDesc));
    texture.where = where_;
    return {ObjectKind::kTexture, append(scene_.textures, std::move(texture))};
}

ObjectRef SceneBuilder::addBump(Index image) {
    charge(sizeof(BumpDesc));
    return {ObjectKind::kBump, append(scene_.bumps, BumpDesc{image, where_})};
}

ObjectRef SceneBuilder::addLight(const Light& light) {
    charge(sizeof(LightDesc));
    return {ObjectKind::kLight, append(lights_, LightDesc{light, where_})};
}

ObjectRef SceneBuilder::addFocal(const FocalDesc& focal) {
    charge(sizeof(FocalDesc));
    return {ObjectKind::kFocal, append(focals_, FocalDesc(focal))};
}

NodeState& SceneBuilder::edit(Index node) {
    NodeDesc& desc = scene_.nodes[node];
    const std::size_t before = desc.versionCount();
    NodeState& state = desc.edit(scene_.renders.size());
    if (desc.versionCount() > before) charge(bytesOf(state));
    return state;
}

void SceneBuilder::addChild(Index parent, Index child, const AppearanceDesc& appearance) {
    if (ancestry_.closesCycle(parent, child)) failCycle(parent, child);
    charge(sizeof(EdgeDesc) + where_.file.size());
    edit(parent).children.push_back({child, appearance, where_});
    ancestry_.add(parent, child);
}

void SceneBuilder::failCycle(Index parent, Index child) const {
    std::vector<Index> path = ancestry_.pathDown(child, parent);
    path.push_back(child);
    std::string names;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool skipped = i >= kCycleNamesShown && i + 2 < path.size();
        if (skipped && i > kCycleNamesShown) continue;
        names += i == 0 ? "" : " -> ";
        names += skipped ? "..." : printable(scene_.nodes[path[i]].name, 64);
    }
    fail("cycle: " + names);
}

void SceneBuilder::addRender(RenderDesc render) {
    charge(sizeof(RenderDesc) + render.lights.size() * sizeof(LightDesc));
    if (!outputs_.insert(render.output).second) {
        warnOnce("overwritten", "'" + printable(render.output, 256) +
                                    "' is the name of an earlier render, which is overwritten");
    }
    render.background = background_;
    render.options = options_;
    render.where = where_;
    scene_.renders.push_back(std::move(render));
}

void SceneBuilder::readParameters() {
    for (const std::string& file : settings_.parameterFiles) {
        std::error_code failed;
        const bool exists = std::filesystem::exists(file, failed);
        const std::filesystem::path resolved = std::filesystem::weakly_canonical(file, failed);
        (exists ? files_.read : files_.absent).push_back(failed ? file : resolved.string());
        for (GivenParameter& given : readParameterFile(file, settings_.memoryLimit)) {
            given_.insert_or_assign(given.name, given);
        }
    }
    for (const auto& [name, value] : settings_.parameters) {
        given_.insert_or_assign(name, GivenParameter{name, value, {}});
    }
}

const GivenParameter* SceneBuilder::givenParameter(const std::string& name) {
    const auto given = given_.find(name);
    if (given == given_.end()) return nullptr;
    parametersRead_.insert(name);
    return &given->second;
}

void SceneBuilder::addParameter(const std::string& name, const std::string& value,
                                const std::string& doc) {
    if (!parameterNames_.insert(name).second) return;
    charge(sizeof(ScriptParameter) + name.size() + value.size() + doc.size());
    parameters_.push_back({name, value, doc, where_});
}

/// A file is written for a scene, so that a name too many is a mistake; -D may be meant for others
/// of several scenes.
void SceneBuilder::judgeUnread(const GivenParameter& given) const {
    std::vector<std::string> known;
    for (const ScriptParameter& parameter : parameters_) known.push_back(parameter.name);
    const std::string nearest = nearestName(given.name, known);
    const std::string hint =
        ": no gr.param reads it" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
    const std::string name = printable(given.name, 64);
    if (!given.where.file.empty()) {
        throw SceneError("unknown parameter '" + name + "'" + hint, given.where);
    }
    diagnostics_.warn("unused-parameter", {scene_.name, 0}, "unused parameter -D " + name + hint);
}

ScriptResult SceneBuilder::finish() {
    const SourceLocation script{scene_.name, 0};
    for (const auto& [name, given] : given_) {
        if (parametersRead_.count(name) == 0) judgeUnread(given);
    }
    if (scene_.renders.empty()) {
        diagnostics_.warn("no-render", script, "nothing was rendered");
    }
    ScriptResult result;
    result.parameters = std::move(parameters_);
    result.scene = std::move(scene_);
    return result;
}

}  // namespace rt
