// What a script said, as plain values with their source positions. References are indices into the
// arrays of SceneDesc. Scripts only append; the compiler only reads.
#pragma once

#include "rt/core/error.h"
#include "rt/core/motion.h"
#include "rt/core/transform.h"
#include "rt/core/vec.h"
#include "rt/geometry/box.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/disc.h"
#include "rt/geometry/frustum.h"
#include "rt/geometry/hemisphere.h"
#include "rt/geometry/plane.h"
#include "rt/geometry/quadric.h"
#include "rt/geometry/rectangle.h"
#include "rt/geometry/sphere.h"
#include "rt/geometry/torus.h"
#include "rt/scene/render_options.h"
#include "rt/shading/light.h"
#include "rt/shading/material.h"
#include "rt/shading/pattern.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rt {

/// What a function of a script gave at the centres of the texels of the unit square: rows from the
/// top, red, green, blue.
struct BakedImage {
    int side = 0;
    std::vector<float> samples;
};

/// An image asset: looked for when it is named, so that a missing file is reported at its line. Or
/// one that a function of the script has painted.
struct ImageDesc {
    std::string path;  ///< resolved, absolute; empty where it is painted
    SourceLocation where;
    std::shared_ptr<const BakedImage> baked = {};
};

/// Diffuse colour from an image, or else by a formula; specular and exponent as given.
struct TextureDesc {
    Index image = kNone;
    Pattern pattern;
    Color specular{0.0};
    double exponent = 0.0;
    SourceLocation where;
};

/// A normal map (three channels) or a height map (one).
struct BumpDesc {
    Index image = kNone;
    SourceLocation where;
};

struct MaterialDesc {
    Material material;
    SourceLocation where;
};

/// A mesh from an OBJ file; the same file and smoothing is the same mesh.
struct MeshFileDesc {
    std::string path;                   ///< resolved, absolute
    std::optional<double> smoothAngle;  ///< degrees; none = as the run says
};

/// A mesh from tables: polygons of any length, 0-based corners.
struct MeshTableDesc {
    std::vector<Vec3> vertices;
    std::vector<Index> corners;  ///< of all faces, one after another
    std::vector<Index> faceSizes;
    std::optional<double> smoothAngle;
};

/// Heights over a square, row by row.
struct HeightGrid {
    std::size_t columns = 0;  ///< along x
    std::size_t rows = 0;     ///< along z
    std::vector<double> heights;
};

/// Heights from an image, or else from the script.
struct HeightFieldDesc {
    Index image = kNone;
    HeightGrid grid;
    std::optional<double> base;  ///< of the solid below them; none = a sheet
    bool smooth = true;
};

enum class CsgOperation { kUnion, kIntersection, kDifference };

/// The solid that the operands of a node make: all of them, what they have in common, or the first
/// without the others.
struct CsgDesc {
    CsgOperation operation = CsgOperation::kUnion;
    Index node = kNone;  ///< whose operands they are
};

using GeometryShape =
    std::variant<Sphere, Box, Cylinder, Cone, Torus, Disc, Rectangle, Plane, Hemisphere, Frustum,
                 Quadric, MeshFileDesc, MeshTableDesc, HeightFieldDesc, CsgDesc>;

struct GeometryDesc {
    GeometryShape shape;
    SourceLocation where;
};

/// What a surface looks like; kNone = not said here.
struct AppearanceDesc {
    Index material = kNone;
    Index texture = kNone;
    Index bump = kNone;
};

struct EdgeDesc {
    Index child = kNone;
    AppearanceDesc appearance;  ///< overrides the child's own
    SourceLocation where;
};

struct RefractionDesc {
    double index = 1.0;
    double ownWeight = 0.0;
};

struct NodeState {
    Affine transform;
    MotionPath motion;  ///< whose place at time 0 is `transform`
    AppearanceDesc appearance;
    std::optional<double> reflection;  ///< weight of the own colour beside the mirror image
    std::optional<RefractionDesc> refraction;
    Color absorption{0.0};  ///< of what shines through, per unit of the world
    bool fresnel = false;
    std::vector<EdgeDesc> children;
};

/// A node keeps the states that earlier renders saw, so that a snapshot is only a number:
/// render k sees, of every node, the last state that was written before render k was called.
class NodeDesc {
  public:
    NodeDesc(std::string nodeName, Index nodeGeometry, SourceLocation created)
        : name(std::move(nodeName)), geometry(nodeGeometry), where(std::move(created)) {}

    std::string name;
    Index geometry;  ///< kNone: a group
    SourceLocation where;
    std::vector<Index> operands;  ///< of a union, an intersection or a difference

    /// The state that render number `render` sees.
    const NodeState& at(std::size_t render) const;
    const NodeState& latest() const { return versions_.back().state; }
    /// The state to change while `rendersSoFar` renders have been asked for.
    NodeState& edit(std::size_t rendersSoFar);
    std::size_t versionCount() const { return versions_.size(); }

  private:
    struct Version {
        std::size_t firstRender;
        NodeState state;
    };
    std::vector<Version> versions_{{0, {}}};
};

struct FocalDesc {
    std::variant<double, Vec3> focus;  ///< distance along the view direction, or a point
    double focalLength = 0.0;
    double lensRadius = 0.0;
};

struct CameraDesc {
    Vec3 eye{0.0};
    Vec3 view{0.0, 0.0, -1.0};
    Vec3 up{0.0, 1.0, 0.0};
    double fovDegrees = 50.0;  ///< vertical
    std::optional<FocalDesc> focal;
};

struct LightDesc {
    Light light;
    SourceLocation where;
};

/// Colour by the direction's y, from `bottom` at -1 to `top` at 1; or an image.
struct BackgroundDesc {
    Color bottom{0.0};
    Color top{0.0};
    Index image = kNone;
};

/// One call of gr.render.
struct RenderDesc {
    Index root = kNone;
    std::string output;  ///< as the script wrote it
    int width = 0;
    int height = 0;
    CameraDesc camera;
    Color ambient{0.0};
    std::vector<LightDesc> lights;
    BackgroundDesc background;
    RenderOptions options;  ///< what gr.options had said by then
    SourceLocation where;
};

/// Everything that one run of a script produced. Node ids are in order of creation.
struct SceneDesc {
    std::string name;    ///< the script's path as given
    std::string folder;  ///< the script's folder, resolved, absolute
    std::vector<NodeDesc> nodes;
    std::vector<GeometryDesc> geometries;
    std::vector<MaterialDesc> materials;
    std::vector<TextureDesc> textures;
    std::vector<BumpDesc> bumps;
    std::vector<ImageDesc> images;
    std::vector<RenderDesc> renders;
};

}  // namespace rt
