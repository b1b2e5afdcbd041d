// Rays against a whole scene: the way without a tree, the way through it, and every instance asked
// in turn give the same hits.
#include "trace/scene_intersect.h"

#include "rt/compile/compile.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>

using namespace rt;
using namespace rt::test;

namespace {

/// Solids of every kind, moved, turned, scaled and sheared, some of them sharing faces.
const std::string kSolids = R"(
    m = gr.material({1, 1, 1}, {0, 0, 0}, 10)
    root = gr.node('root')
    local function add(solid, place)
        if place then place(solid) end
        root:add_child(solid, m)
    end
    add(gr.nh_box('floor', {-20, -1, -20}, {40, 1, 40}))
    add(gr.nh_box('on the floor', {1, 0, 1}, {2, 1, 2}))
    add(gr.nh_sphere('s', {0, 1, 0}, 1))
    add(gr.nh_torus('t', {0, 0, 0}, 1, 0.3), function(n)
        n:rotate('x', 50); n:rotate('y', 20); n:translate(-3, 1, 1) end)
    add(gr.nh_cylinder('c', {0, 0, 0}, 2, 0.5), function(n)
        n:rotate('z', 30); n:translate(3, 1, -2) end)
    add(gr.nh_cone('k', {0, 0, 0}, 1, 0.7), function(n) n:scale(1, 2, 0.5); n:translate(0, 0, 3) end)
    add(gr.nh_plane('ground', {0, -1.5, 0}, {0.1, 1, 0.05}))
    add(gr.nh_disc('d', {-4, 2, 0}, {1, 1, 1}, 0.8))
    add(gr.nh_quad('q', {2, 2, -4}, {1, 0, 0}, {0.3, 1, 0.2}))
    add(gr.nh_hemisphere('h', {-2, 0, -3}, 0.9))
    add(gr.nh_frustum('f', {0, 0, -4}, 1, 0.8, 0.3))
    add(gr.nh_sphere('far anchor', {1000, 0, 0}, 1), function(n) n:translate(-1003, 1, -3) end)
    add(gr.nh_sphere('sheared', {0, 0, 0}, 1), function(n)
        n:rotate('z', 40); n:scale(1, 0.05, 1); n:rotate('z', -20); n:translate(4, 2, 4) end)
    add(gr.mesh('mesh', {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}},
                {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {0, 1, 3}}), function(n)
        n:rotate('y', 10); n:translate(-2, 0, 4) end)
)";

RenderScene scene(int extra) {
    const std::string script =
        kSolids + "for i = 1, " + std::to_string(extra) +
        " do add(gr.nh_sphere('e', {i % 7 - 3, 3 + i // 7, i % 5}, 0.4)) end\n" +
        "gr.render(root, 'x.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})";
    const Described run = describe(script);
    AssetCache assets(1);
    Diagnostics diagnostics;
    return compileScene(run.scene, 0, {}, assets, diagnostics);
}

/// The definition: the lowest of the instances whose hits coincide with the nearest.
bool nearestByAsking(const RenderScene& scene, const Ray& ray, SceneHit& hit, bool& shared) {
    std::vector<SceneHit> hits;
    for (Index i = 0; i < scene.instances.size(); ++i) {
        SceneHit found;
        found.instance = i;
        if (intersectInstance(scene, i, ray, {}, found.at)) hits.push_back(found);
    }
    if (hits.empty()) return false;
    double nearest = kInfinity;
    for (const SceneHit& h : hits) nearest = std::min(nearest, h.at.t);
    const double last = nearest + coincidenceInT(ray, nearest);
    std::erase_if(hits, [&](const SceneHit& h) { return !(h.at.t < last); });
    shared = hits.size() > 1;
    hit = hits.front();
    return true;
}

class Rays {
  public:
    Vec3 vector() {
        std::normal_distribution<> normal;
        return Vec3(normal(random_), normal(random_), normal(random_));
    }
    Ray next() {
        Vec3 direction = glm::normalize(vector());
        if (random_() % 4 == 0) direction = Vec3(0, random_() % 2 ? -1 : 1, 0);
        return {6.0 * vector() + Vec3(0, 2, 0), direction};
    }

  private:
    std::mt19937_64 random_{7};
};

void checkSame(const RenderScene& scene, const Ray& ray) {
    SceneHit asked;
    SceneHit found;
    bool askedShared = false;
    bool shared = false;
    const bool isHit = nearestByAsking(scene, ray, asked, askedShared);
    REQUIRE(closestHit(scene, ray, {}, found, &shared) == isHit);
    CHECK(anyHit(scene, ray, {}) == isHit);
    if (!isHit) return;
    CHECK(found.instance == asked.instance);
    CHECK(found.at.t == asked.at.t);
    CHECK(found.at.local == asked.at.local);
    CHECK(shared == askedShared);
    CHECK((found.spread > 0.0) == askedShared);
    CHECK(anyHit(scene, ray, {0.0, std::nextafter(found.at.t, kInfinity)}));
}

}  // namespace

TEST_CASE("few instances, many, and each by itself: the same hits") {
    for (const int extra : {0, 7, 40}) {
        const RenderScene few = scene(extra);
        CHECK(few.quads.empty() == (few.instances.size() > kFewBoxes));
        RenderScene tree = scene(extra);
        tree.quads.clear();
        Rays rays;
        for (int i = 0; i < 20'000; ++i) {
            const Ray ray = rays.next();
            CAPTURE(i);
            checkSame(few, ray);
            checkSame(tree, ray);
        }
    }
}

TEST_CASE("all crossings are the same with and without a tree") {
    const RenderScene few = scene(0);
    RenderScene tree = scene(0);
    tree.quads.clear();
    Rays rays;
    const auto order = [](const SceneHit& a, const SceneHit& b) {
        return a.at.t != b.at.t ? a.at.t < b.at.t : a.instance < b.instance;
    };
    for (int i = 0; i < 5'000; ++i) {
        const Ray ray = rays.next();
        std::vector<SceneHit> a;
        std::vector<SceneHit> b;
        allCrossings(few, ray, {}, a);
        allCrossings(tree, ray, {}, b);
        std::sort(a.begin(), a.end(), order);
        std::sort(b.begin(), b.end(), order);
        REQUIRE(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            CHECK(a[k].at.t == b[k].at.t);
            CHECK(a[k].instance == b[k].instance);
        }
    }
}

TEST_CASE("surfaces that coincide behind the nearest do not count as shared") {
    // The underside of the box on the floor coincides with the floor's top, behind its own top.
    const RenderScene few = scene(0);
    RenderScene tree = scene(0);
    tree.quads.clear();
    const Ray down{Vec3(2, 5, 2), Vec3(0, -1, 0)};
    for (const RenderScene* s : {&few, &std::as_const(tree)}) {
        SceneHit hit;
        bool shared = true;
        REQUIRE(closestHit(*s, down, {}, hit, &shared));
        CHECK(hit.instance == 1);
        CHECK_FALSE(shared);
        const Ray up{Vec3(2, -3, 2), Vec3(0, 1, 0)};
        REQUIRE(closestHit(*s, up, {2.5, kInfinity}, hit, &shared));
        CHECK(hit.instance == 0);
        CHECK(shared);
    }
}
