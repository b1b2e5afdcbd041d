// Whitted ray tracing of one sample: the own colour of what is hit, what it mirrors, and what
// shines through. Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980.
#pragma once

#include "medium_set.h"
#include "occluder_cache.h"
#include "photon_start.h"
#include "ray_differential.h"
#include "rt/sampling/sampler.h"
#include "rt/shading/light_sample.h"
#include "rt/trace/moment_pool.h"
#include "rt/trace/photon_map.h"
#include "rt/trace/seen_pixel.h"
#include "rt/trace/trace_kernel.h"
#include "rt/trace/traced_sample.h"
#include "scene_intersect.h"
#include "shade_point.h"
#include "shadow_hull.h"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

namespace rt {

/// Beside the features: a Tracer of its own for what is asked for beside a picture. If it shared
/// functions with those of renders, the compiler would inline fewer of them there.
inline constexpr unsigned kBeside = 1u << 31;
/// Beside the features: one that tells what it does.
inline constexpr unsigned kTelling = 1u << 30;

/// `Features` are those that the scene uses: what it does not use is not compiled into its variant.
/// One Tracer works on one thread.
template <unsigned Features>
class Tracer {
  public:
    Tracer(const RenderScene& scene, const TraceSettings& settings, TraceCounts& counts);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// The value of sample number `index` of pixel (x, y), times its filter weight.
    Color sample(int x, int y, int index);

    /// The same, and how it came about.
    TracedSample tracedSample(int x, int y, int index);

    /// Looks through corner (x, y) once and samples the lights there until they have `end` samples.
    /// The next corners are `spacing` pixels away.
    void probeCorner(int x, int y, int spacing, std::uint32_t end, Probe& probe);
    /// The same through the centre of pixel (x, y).
    void probeCentre(int x, int y, std::uint32_t end, Probe& probe);

    /// What the centre of pixel (x, y) shows.
    FirstHit firstHit(int x, int y);

    /// Adds sample number `index` of pixel (x, y), without photons, and where they would add to it.
    void see(int x, int y, int index, SeenPixel& seen);

    /// Follows one photon along the light's way, and appends what comes down of it where something
    /// has mirrored or refracted it. `key` is its own.
    void photon(const PhotonStart& start, std::uint64_t key, const Photon& like,
                std::vector<Photon>& photons);

  private:
    static constexpr bool kImages = (Features & kFeatureImages) != 0;
    static constexpr bool kAreaLights = (Features & kFeatureAreaLights) != 0;
    static constexpr bool kReflection = (Features & kFeatureReflection) != 0;
    static constexpr bool kRefraction = (Features & kFeatureRefraction) != 0;
    static constexpr bool kLightKinds = (Features & kFeatureLightKinds) != 0;
    static constexpr bool kManyLights = (Features & kFeatureManyLights) != 0;
    static constexpr bool kAbsorption = (Features & kFeatureAbsorption) != 0;
    static constexpr bool kCaustics = (Features & kFeatureCaustics) != 0;
    static constexpr bool kTells = (Features & kTelling) != 0;
    /// Corners and centres have other points on the lights than the pixels' samples.
    static constexpr int kOtherPixels = 1 << 30;
    /// Of a pixel of side 1.
    static constexpr double kHalfDiagonal = 0.7071067811865476;
    static constexpr bool kSecondary = kReflection || kRefraction;

    struct Nothing {};
    template <class Type>
    using WithImages = std::conditional_t<kImages, Type, Nothing>;

    /// A share of light: one for all channels, where nothing colours what shines through.
    using Share = std::conditional_t<kAbsorption, Color, double>;

    /// A ray that still has to be followed.
    struct Path {
        Ray ray;
        Share weight{1.0};  ///< of its value in the sample
        int depth = 0;
        double travelled = 0.0;  ///< from the eye to the ray's origin
        /// Names the place in the tree of paths: what n mirrors is 2n, what shines through is 2n+1.
        std::uint32_t node = 1;
        MediumSet media;  ///< the solids that the ray is inside
        [[no_unique_address]] WithImages<RayDifferential> differential;
    };

    /// How the value at a hit is made up; the weights add up to 1.
    struct Split {
        double own = 1.0;
        double reflected = 0.0;
        double refracted = 0.0;
        Vec3 reflectedDirection{0.0};
        Vec3 refractedDirection{0.0};
        double indexRatio = 1.0;  ///< of the refracted ray, from over to
    };

    /// The value of one sample.
    struct SampleSum {
        Color value{0.0};
    };

    /// What one sample shows without photons.
    struct SeenSum {
        Color value{0.0};
        std::vector<SeenPoint>* points;
    };

    /// What one look gathers for a probe: samples [begin, middle) and [middle, end).
    struct ProbeSum {
        std::uint32_t begin, middle, end;
        Color first{0.0};
        Color second{0.0};
        unsigned lightsSeen = 0;
        double spacing;
        Probe* evidence;

        void addToAll(const Color& c) {
            first += static_cast<double>(middle - begin) * c;
            second += static_cast<double>(end - middle) * c;
        }
    };

    Path pathThrough(const Vec2& at);
    FilterSample startSample(int x, int y, int index, Path& path);
    /// Puts what moves where it is at time s.
    void turnTo(double s);
    void look(const Vec2& at, int spacing, std::uint32_t end, Probe& probe);
    /// All values along the tree of paths that starts with `path`.
    template <class Sum>
    void gather(Path path, Sum& sum);
    template <class Sum>
    void follow(Path path, Sum& sum);
    void addMiss(const Path& path, SampleSum& sum);
    void addMiss(const Path& path, ProbeSum& sum) const;
    void addMiss(const Path& path, SeenSum& sum) const;
    void addOwn(const Path& path, double own, const SceneHit& hit, const ShadePoint& point,
                SampleSum& sum);
    void addOwn(const Path& path, double own, const SceneHit& hit, const ShadePoint& point,
                ProbeSum& sum);
    void addOwn(const Path& path, double own, const SceneHit& hit, const ShadePoint& point,
                SeenSum& sum);
    Color caustics(const Path& path, const SceneHit& hit, const ShadePoint& point) const;
    void putDown(const PhotonStart& start, const Path& path, const SceneHit& hit,
                 const ShadePoint& point, const Photon& like, std::vector<Photon>& photons) const;
    bool nextHit(const Ray& ray, const MediumSet& media, Interval range, SceneHit& hit);
    MediumSet beyondHit(const MediumSet& media) const;
    Split split(const Path& path, const SceneHit& hit, const ShadePoint& point,
                const MediumSet& beyond) const;
    void shineThrough(const Path& path, const SceneHit& hit, const ShadePoint& point,
                      const MediumSet& beyond, Split& parts) const;
    void cutSmall(const Path& path, double& part, Split& parts);
    Path spawn(const Path& from, const SceneHit& hit, const ShadePoint& point,
               const Vec3& direction, double part, unsigned branch) const;
    ShadePoint pointAt(const Path& path, const SceneHit& hit) const;

    /// What a telling Tracer writes down.
    TracedRay& toldRay() { return told_.rays.back(); }
    void tellRay(const Path& path);
    void tellHit(const Path& path, const SceneHit& hit, const ShadePoint& point);
    void tellLight(Index light, const Vec3& w, double reach, const Color& unhidden,
                   const Share& visible, const ShadePoint& point);

    Color ownColor(const Path& path, double own, const ShadePoint& point);
    Color fromChosen(const Path& path, double own, const ShadePoint& point);
    /// Counted `weight` times.
    Color lightFrom(Index light, double weight, const Path& path, const ShadePoint& point);
    std::optional<LightView> viewOfLight(const Light& light, const Vec3& from) const;
    Color lightAlong(const LightRay& ray, double brightness, const Path& path,
                     const ShadePoint& point) const;
    void probeLight(Index light, const Path& path, double own, const SceneHit& hit,
                    const ShadePoint& point, ProbeSum& sum);
    Share probeOccluded(Index light, const LightView& view, const Occluders& occluders,
                        const Path& path, double own, const ShadePoint& point, ProbeSum& sum);
    Share visibilityOf(Index light, const Vec3& w, double reach, const MediumSet& media,
                       const ShadePoint& point, const Occluders* occluders);
    Share visibilityPast(const Occluders& occluders, Index light, const Ray& ray, double reach,
                         const MediumSet& media);
    ShadowHull hullTowards(const Light& light, const LightView& view, const Vec3& from,
                           double margin) const;
    double wayOut(const Vec3& from) const;
    /// What is left of combined solids along the camera's ray.
    void noteParts(const Path& path, double reach, ProbeSum& sum) const;
    void markNarrow(const Path& path, double distance, ProbeSum& sum) const;
    double footprint(const Path& path, const ShadePoint& point) const;
    bool allOpaque(const Occluders& occluders) const;
    Share visibility(Index light, const Ray& ray, double reach, const MediumSet& media);
    Share visibilityThroughGlass(Index light, Ray ray, double reach, MediumSet media);
    double transmitted(const Vec3& direction, const SceneHit& hit, const ShadePoint& point,
                       const MediumSet& media, const MediumSet& beyond) const;
    MediumSet mediaAt(const Vec3& point);
    bool absorbs(const MediumSet& media) const;
    /// Takes what the media absorb of `share` on a way of this length.
    void absorb(const MediumSet& media, double distance, Share& share) const;

    static double largestOf(double share) { return share; }
    static double largestOf(const Color& share) { return std::max({share.x, share.y, share.z}); }
    bool isSheet(Index instance) const { return !scene_.instances[instance].closed; }
    bool isEntered(Index instance, const MediumSet& media) const {
        return isSheet(instance) || !media.contains(instance);
    }
    const Look& lookOf(Index instance) const {
        return scene_.looks[scene_.instances[instance].look];
    }

    MomentPool* moments_;  ///< nullptr where nothing moves
    /// The scene as of one moment, where something moves.
    std::unique_ptr<RenderScene> moment_;
    const RenderScene& scene_;
    const TraceSettings& settings_;
    TraceCounts& counts_;
    Sampler sampler_;
    std::uint64_t raysLeft_ = 0;
    double filterWeight_ = 1.0;  ///< of the sample, without its sign
    [[no_unique_address]] WithImages<PixelShare> share_;
    std::vector<Path> pending_;
    /// The crossings at the last hit: one, or several where surfaces coincide.
    std::vector<SceneHit> together_;
    OccluderCache occluderCache_;
    std::vector<LastBlocker> lastBlockers_;  ///< opaque ones, of each light
    [[no_unique_address]] std::conditional_t<kTells, TracedSample, Nothing> told_;
};

}  // namespace rt
