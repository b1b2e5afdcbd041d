#include "rt/compile/compile.h"

#include "csg_builder.h"
#include "flatten.h"
#include "photon_lights.h"
#include "radiance_bound.h"
#include "rt/core/error.h"
#include "rt/trace/moment_pool.h"
#include "scene_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rt {
namespace {

/// Maps below this size have lost their meaning to underflow, rather than been flattened on
/// purpose.
constexpr double kUnderflown = 1e-150;

/// From so many lights on, a choice of them beats looking at all:
/// Documentation/performance_features.md.
constexpr std::ptrdiff_t kManyLights = 32;

double largestElement(const Mat3& m) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::fabs(m[column][row]));
    }
    return largest;
}

/// Builds one RenderScene, step by step.
class Compiler {
  public:
    Compiler(const SceneDesc& scene, std::size_t render, const CompileSettings& settings,
             AssetCache& assets, Diagnostics& diagnostics)
        : scene_(scene),
          renderIndex_(render),
          render_(scene.renders[render]),
          settings_(settings),
          assets_(assets),
          diagnostics_(diagnostics) {}

    RenderScene compile() {
        refuseTooManyInstances();
        forEachPlaced(scene_, render_.root, renderIndex_,
                      [this](const PlacedNode& placed) { addInstance(placed); });
        if (out_.instances.empty()) {
            diagnostics_.warn("empty-scene", render_.where, "the scene places no object");
        }
        rankByCreation();
        buildSceneTree(out_, settings_.threads);
        addLightsAndSky();
        placeCamera();
        if (settings_.caustics) sendByPhotons(out_, render_.where, diagnostics_);
        out_.radianceBound = radianceBound(out_);
        out_.localBound = localBound(out_);
        return std::move(out_);
    }

  private:
    void refuseTooManyInstances() const {
        const std::uint64_t count = countPlaced(scene_, render_.root, renderIndex_);
        if (count <= settings_.maxInstances) return;
        throw LimitError("gr.render: the scene places " + std::to_string(count) +
                             " objects, more than the limit of " +
                             std::to_string(settings_.maxInstances) + " (see --max-instances)",
                         render_.where);
    }

    void addInstance(const PlacedNode& placed) {
        const NodeDesc& node = scene_.nodes[placed.node];
        Instance instance;
        if (!placeInstance(node, placed.toWorld, instance.transform)) return;
        instance.objectScale = instance.transform.similarityToObject();
        instance.shape = shapeOf(node.geometry);
        if (instance.shape == kNone) return;
        const SolidKind kind = kindOf(out_.shapes[instance.shape]);
        instance.closed = kind.closed;
        if (!kind.bounded) out_.unbounded.push_back(static_cast<Index>(out_.instances.size()));
        if (placed.motion.moves()) addMotion(node, placed);
        instance.look = lookOf(placed, instance.closed);
        instance.order = instance.node = placed.node;
        out_.instances.push_back(instance);
    }

    /// Of the instance that is about to be added.
    void addMotion(const NodeDesc& node, const PlacedNode& placed) {
        out_.moving.push_back({static_cast<Index>(out_.instances.size()), placed.motion});
        Transform end;
        if (!Transform::make(placed.motion.at(1.0), end)) {
            throw SceneError("node '" + printable(node.name, 80) + "' moves out of all bounds",
                             node.where);
        }
        out_.features |= kFeatureMotion;
        if (!out_.moments) out_.moments = std::make_shared<MomentPool>();
    }

    bool placeInstance(const NodeDesc& node, const Affine& toWorld, Transform& out) {
        if (Transform::make(toWorld, out)) return true;
        const double size = largestElement(toWorld.linear);
        if (!toWorld.isFinite() || (size > 0.0 && size < kUnderflown)) {
            throw SceneError("node '" + printable(node.name, 80) +
                                 "': its transforms multiply to a matrix without a finite inverse",
                             node.where);
        }
        diagnostics_.warn("flat-object", node.where,
                          "node '" + printable(node.name, 80) + "' is flat and is skipped");
        return false;
    }

    /// kNone for a mesh without triangles.
    Index shapeOf(Index geometry) {
        const auto [entry, added] = shapes_.try_emplace(geometry, kNone);
        if (!added) return entry->second;
        if (std::optional<Shape> shape = makeShape(geometry)) {
            entry->second = static_cast<Index>(out_.shapes.size());
            out_.shapes.push_back(std::move(*shape));
        }
        return entry->second;
    }

    /// What `load` gives; its errors also name the line of the script.
    template <class Load>
    static auto loaded(const SourceLocation& where, Load&& load) {
        try {
            return load();
        } catch (Error& error) {
            error.namedAt(where);
            throw;
        }
    }

    std::optional<Shape> makeShape(Index geometry) {
        const GeometryDesc& desc = scene_.geometries[geometry];
        const double angle = settings_.smoothAngleDegrees;
        std::shared_ptr<const MeshShape> mesh;
        if (const auto* file = std::get_if<MeshFileDesc>(&desc.shape)) {
            mesh = loaded(desc.where, [&] { return assets_.mesh(*file, angle, diagnostics_); });
        } else if (const auto* table = std::get_if<MeshTableDesc>(&desc.shape)) {
            mesh = assets_.mesh(*table, geometry, angle, desc.where, diagnostics_);
        } else if (const auto* field = std::get_if<HeightFieldDesc>(&desc.shape)) {
            const ImageDesc* image = field->image == kNone ? nullptr : &scene_.images[field->image];
            mesh = loaded(desc.where, [&] {
                return assets_.heightField(*field, image, geometry, settings_.maxPixels, desc.where,
                                           diagnostics_);
            });
        } else if (const auto* csg = std::get_if<CsgDesc>(&desc.shape)) {
            return makeCsg(*csg, geometry);
        } else {
            return solidOf(desc.shape);
        }
        if (!mesh) return std::nullopt;
        out_.features |= kFeatureMeshes;
        return Shape(std::move(mesh));
    }

    static Shape solidOf(const GeometryShape& shape) {
        return std::visit(
            [](const auto& solid) -> Shape {
                if constexpr (std::is_constructible_v<Shape, decltype(solid)>) {
                    return Shape(solid);
                } else {
                    throw std::logic_error("a mesh or a combined solid is made elsewhere");
                }
            },
            shape);
    }

    std::optional<Shape> makeCsg(const CsgDesc& desc, Index geometry) {
        const CsgSources sources{scene_, renderIndex_, diagnostics_,
                                 [this](const NodeDesc& node, const Affine& map, Transform& out) {
                                     return placeInstance(node, map, out);
                                 },
                                 [this](Index leaf) {
                                     const Index shape = shapeOf(leaf);
                                     return shape == kNone ? nullptr : &out_.shapes[shape];
                                 }};
        BuiltCsg built = buildCsg(sources, desc.node);
        if (!built.shape) return std::nullopt;
        out_.features |= kFeatureCsg;
        leafLooks_[geometry] = std::move(built.looks);
        return Shape(std::move(built.shape));
    }

    void requireAppearance(const AppearanceDesc& appearance, const NodeDesc& node) const {
        if (appearance.material != kNone || appearance.texture != kNone) return;
        throw SceneError("node '" + printable(node.name, 80) +
                             "' has neither a material nor a texture: give it one with "
                             "add_child(node, material) or node:set_material(material)",
                         node.where);
    }

    Index lookOf(const PlacedNode& placed, bool closed) {
        const AppearanceDesc& a = placed.appearance;
        const NodeDesc& node = scene_.nodes[placed.node];
        const auto leaves = leafLooks_.find(node.geometry);
        if (leaves == leafLooks_.end()) requireAppearance(a, node);
        const auto [entry, added] =
            looks_.try_emplace(std::tuple(placed.node, a.material, a.texture, a.bump),
                               static_cast<Index>(out_.looks.size()));
        if (!added) return entry->second;
        if (leaves == leafLooks_.end()) {
            out_.looks.push_back(makeLook(a, node.at(renderIndex_)));
        } else {
            for (const CsgLeafLook& leaf : leaves->second) addLeafLook(a, node, leaf);
        }
        addAbsorption(node, closed, entry->second);
        return entry->second;
    }

    /// What the whole says hides what the leaf says.
    void addLeafLook(const AppearanceDesc& whole, const NodeDesc& node, const CsgLeafLook& leaf) {
        const AppearanceDesc appearance = over(whole, leaf.appearance);
        requireAppearance(appearance, scene_.nodes[leaf.node]);
        Look look = makeLook(appearance, node.at(renderIndex_));
        if (leaf.reflection && !look.reflects) addReflection(*leaf.reflection, look);
        const bool isOwn = whole.material == kNone && whole.texture == kNone;
        if (look.pattern && isOwn && !leaf.patternSpace.isIdentity()) {
            look.patternSpace = std::make_shared<const Affine>(leaf.patternSpace);
        }
        out_.looks.push_back(std::move(look));
    }

    /// Of the looks from `first` on.
    void addAbsorption(const NodeDesc& node, bool closed, Index first) {
        const Color& absorption = node.at(renderIndex_).absorption;
        if (absorption == Color(0.0)) return;
        if (!out_.looks[first].refracts || !closed) {
            diagnostics_.warn("unused-absorption", node.where,
                              "node '" + printable(node.name, 80) + "' absorbs nothing: " +
                                  (closed ? "no light shines through it without set_refraction"
                                          : "it is a sheet or an open mesh, which has no inside"));
            return;
        }
        for (Index i = first; i < out_.looks.size(); ++i) out_.looks[i].absorption = absorption;
        out_.features |= kFeatureAbsorption;
    }

    void addReflection(double ownWeight, Look& look) {
        look.reflects = true;
        look.reflectionOwnWeight = ownWeight;
        out_.features |= kFeatureReflection;
    }

    Look makeLook(const AppearanceDesc& appearance, const NodeState& state) {
        Look look;
        if (appearance.texture != kNone) {
            const TextureDesc& texture = scene_.textures[appearance.texture];
            look.material = {Color(0.0), texture.specular, texture.exponent};
            if (texture.image == kNone) {
                look.pattern = std::make_shared<const Pattern>(texture.pattern);
            } else {
                look.texture = image(texture.image, appearance.bump == kNone);
            }
        } else {
            look.material = scene_.materials[appearance.material].material;
        }
        if (appearance.bump != kNone) look.bump = image(scene_.bumps[appearance.bump].image);
        if (look.isPictured()) out_.features |= kFeatureImages;
        if (state.reflection) addReflection(*state.reflection, look);
        if (state.refraction) {
            look.refracts = true;
            look.index = state.refraction->index;
            look.refractionOwnWeight = state.refraction->ownWeight;
            look.fresnel = state.fresnel;
            out_.features |= kFeatureRefraction;
        }
        return look;
    }

    std::shared_ptr<const Texture> image(Index index, bool prefilter = false) {
        TextureSettings settings;
        settings.prefilter = prefilter;
        settings.flipV = settings_.flipV;
        settings.srgb = settings_.srgb;
        const ImageDesc& desc = scene_.images[index];
        return loaded(desc.where, [&] {
            return assets_.image(desc, settings, settings_.maxPixels, diagnostics_);
        });
    }

    /// Makes the orders distinct: nodes by creation, one node's instances by their place in the
    /// graph.
    void rankByCreation() {
        if (!(out_.features & kFeatureRefraction)) return;
        std::vector<Index> byCreation(out_.instances.size());
        std::iota(byCreation.begin(), byCreation.end(), Index{0});
        std::stable_sort(byCreation.begin(), byCreation.end(), [this](Index a, Index b) {
            return out_.instances[a].order < out_.instances[b].order;
        });
        for (Index rank = 0; rank < byCreation.size(); ++rank) {
            out_.instances[byCreation[rank]].order = rank;
        }
    }

    void addLightsAndSky() {
        out_.ambient = render_.ambient;
        for (const LightDesc& desc : render_.lights) {
            out_.lights.push_back(desc.light);
            if (!isPointLike(desc.light)) out_.features |= kFeatureAreaLights;
            if (desc.light.kind != LightKind::kBall) out_.features |= kFeatureLightKinds;
        }
        const auto placed =
            std::count_if(out_.lights.begin(), out_.lights.end(),
                          [](const Light& light) { return light.kind != LightKind::kSun; });
        if (placed >= kManyLights) {
            out_.lightTree = LightTree(out_.lights);
            out_.features |= kFeatureManyLights;
        }
        out_.background.bottom = render_.background.bottom;
        out_.background.top = render_.background.top;
        if (render_.background.image != kNone) {
            out_.background.image = image(render_.background.image);
        }
    }

    void placeCamera() {
        const CameraDesc& desc = render_.camera;
        Camera::Frame frame;
        frame.eye = desc.eye;
        frame.view = desc.view;
        frame.up = desc.up;
        frame.fovDegrees = desc.fovDegrees;
        if (desc.focal && desc.focal->lensRadius > 0.0) {
            frame.lensRadius = desc.focal->lensRadius;
            frame.focusDistance = focusDistance(desc);
            out_.features |= kFeatureLens;
        }
        out_.width = settings_.width > 0 ? settings_.width : render_.width;
        out_.height = settings_.height > 0 ? settings_.height : render_.height;
        out_.camera = Camera(frame, out_.width, out_.height);
    }

    double focusDistance(const CameraDesc& desc) const {
        const auto* point = std::get_if<Vec3>(&desc.focal->focus);
        const double distance = point ? glm::dot(*point - desc.eye, glm::normalize(desc.view))
                                      : std::get<double>(desc.focal->focus);
        if (distance > desc.focal->focalLength) return distance;
        throw SceneError(
            "gr.focal: the point in focus must lie farther along the view direction "
            "than the focal length",
            render_.where);
    }

    const SceneDesc& scene_;
    std::size_t renderIndex_;
    const RenderDesc& render_;
    const CompileSettings& settings_;
    AssetCache& assets_;
    Diagnostics& diagnostics_;
    RenderScene out_;
    std::map<Index, Index> shapes_;  ///< of geometries
    std::map<Index, std::vector<CsgLeafLook>> leafLooks_;
    std::map<std::tuple<Index, Index, Index, Index>, Index> looks_;
};

}  // namespace

RenderScene compileScene(const SceneDesc& scene, std::size_t render,
                         const CompileSettings& settings, AssetCache& assets,
                         Diagnostics& diagnostics) {
    return Compiler(scene, render, settings, assets, diagnostics).compile();
}

}  // namespace rt
