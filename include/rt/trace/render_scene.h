// The compiled scene: flat, built once, then only read.
#pragma once

#include "rt/accel/padded_boxes.h"
#include "rt/accel/wide_tree.h"
#include "rt/core/motion.h"
#include "rt/core/transform.h"
#include "rt/shading/light.h"
#include "rt/shading/light_tree.h"
#include "rt/shading/material.h"
#include "rt/shading/pattern.h"
#include "rt/shading/texture.h"
#include "rt/trace/camera.h"
#include "rt/trace/shape.h"

#include <memory>
#include <vector>

namespace rt {

/// What a surface does with light, all of it resolved.
struct Look {
    Material material;
    std::shared_ptr<const Texture> texture;  ///< replaces material.diffuse where there is one
    std::shared_ptr<const Pattern> pattern;  ///< does so, too
    /// From the object's space to the pattern's, where they differ.
    std::shared_ptr<const Affine> patternSpace;
    std::shared_ptr<const Texture> bump;

    /// Whether what it shows varies from point to point.
    bool isPictured() const { return texture || pattern || bump; }
    /// Whether it mirrors anything, or lets anything through.
    bool sendsOn() const {
        return (reflects && reflectionOwnWeight < 1.0) || (refracts && refractionOwnWeight < 1.0);
    }

    double reflectionOwnWeight = 1.0;  ///< weight of the own colour beside the mirror image
    double refractionOwnWeight = 1.0;  ///< weight of the own colour beside what shines through
    double index = 1.0;
    Color absorption{0.0};  ///< of what shines through, per unit of the world
    bool reflects = false;
    bool refracts = false;
    bool fresnel = false;
};

/// One object in the world.
struct Instance {
    Transform transform;
    Index shape = 0;
    Index look = 0;  ///< of a combined solid that of its first leaf; the others' follow
    /// Order of creation: of overlapping solids, the one of highest order decides the index.
    Index order = 0;
    Index node = 0;  ///< of the description, that it places
    /// Lengths in object space for lengths in the world; 0 where they depend on the direction.
    double objectScale = 0.0;
    /// Bounds a solid; refracting objects that do not are sheets.
    bool closed = true;
    /// Whether boxes in double precision hold under the transform (kBoxedCondition).
    bool boxed = true;
};

/// An instance that moves while the shutter is open.
struct Motion {
    Index instance = 0;
    MotionPath path;
};

class MomentPool;

/// What this scene uses; the renderer's variant is chosen by it.
enum Feature : unsigned {
    kFeatureReflection = 1u << 0,
    kFeatureRefraction = 1u << 1,
    kFeatureImages = 1u << 2,  ///< textures or bump maps
    kFeatureAreaLights = 1u << 3,
    kFeatureLens = 1u << 4,
    kFeatureMeshes = 1u << 5,
    kFeatureAbsorption = 1u << 6,  ///< refracting solids that colour what shines through
    kFeatureLightKinds = 1u << 7,  ///< lights that are no balls
    kFeatureCaustics = 1u << 8,    ///< photons
    kFeatureManyLights = 1u << 9,  ///< more than are looked at from each point
    kFeatureCsg = 1u << 10,        ///< unions, intersections, differences
    kFeatureMotion = 1u << 11,
};

struct Background {
    Color bottom{0.0};
    Color top{0.0};
    std::shared_ptr<const Texture> image;

    Color at(const Vec3& direction) const;
};

struct RenderScene {
    std::vector<Shape> shapes;
    std::vector<Look> looks;
    std::vector<Instance> instances;      ///< those that move as at time 0
    std::vector<Motion> moving;           ///< in the order of the instances
    std::shared_ptr<MomentPool> moments;  ///< where something moves
    WideTree tree;                        ///< over the instances' world bounds at all times
    std::vector<PaddedBox> shapeBoxes;    ///< of each shape, in object space
    std::vector<Index> unbounded;         ///< instances that no box holds, beside the tree
    std::vector<BoxQuad> quads;  ///< world boxes, where they are few: a tree is slower there
    std::vector<Light> lights;
    LightTree lightTree;  ///< where they are many
    Color ambient{0.0};
    Background background;
    Camera camera;
    int width = 0;
    int height = 0;
    unsigned features = 0;
    /// Values of paths differ by no more than this in any channel; infinity where there is no
    /// bound.
    double radianceBound = kInfinity;
    /// The largest share of irradiance that any surface shows.
    double localBound = 1.0;
    /// World bounds of the refracting solids, which may contain the lens.
    Bounds refractingBounds;
    /// The least extent of all solids in their own axes, of those for which it is known.
    double thinnest = kInfinity;
};

/// The least extent of an instance in its own axes, in the world: infinite for meshes, of whose
/// parts it says nothing, and for what is unbounded; 0 where lengths depend on the direction.
double thicknessOf(const RenderScene& scene, const Instance& instance);
/// The same of what is whole: of a combined solid, its parts.
double partThicknessOf(const RenderScene& scene, const Instance& instance);

}  // namespace rt
