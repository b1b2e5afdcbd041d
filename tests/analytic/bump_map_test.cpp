// Bump maps in pictures, against normals that are worked out in the world from the two tangents
// alone: no inverse transpose, no object space.
#include "optics_shot.h"
#include "rt/shading/bump.h"
#include "support/textured_scene.h"

#include <functional>
#include <random>

using namespace rt;
using namespace rt::test;

namespace {

/// A linear map, and the calls that make it.
struct Placement {
    const char* name;
    const char* calls;
    std::function<Vec3(Vec3)> map;
};

Vec3 turned(const Vec3& v, int axis, double degrees) {
    const double a = degrees * kPi / 180.0;
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    Vec3 out = v;
    out[i] = std::cos(a) * v[i] - std::sin(a) * v[j];
    out[j] = std::sin(a) * v[i] + std::cos(a) * v[j];
    return out;
}

const Placement kPlacements[] = {
    {"as it is", "", [](Vec3 v) { return v; }},
    {"turned", "it:rotate('x', 25) it:rotate('z', 40)",
     [](Vec3 v) { return turned(turned(v, 0, 25), 2, 40); }},
    {"mirrored", "it:scale(-1, 1, 1) it:rotate('y', 15)",
     [](Vec3 v) { return turned(v * Vec3(-1, 1, 1), 1, 15); }},
    {"upside down", "it:scale(1, -1, 1)", [](Vec3 v) { return v * Vec3(1, -1, 1); }},
    {"stretched", "it:scale(3, 0.5, 2) it:rotate('z', 30)",
     [](Vec3 v) { return turned(v * Vec3(3, 0.5, 2), 2, 30); }},
    {"sheared", "it:rotate('z', 45) it:scale(2, 1, 1) it:rotate('y', -20)",
     [](Vec3 v) { return turned(turned(v, 2, 45) * Vec3(2, 1, 1), 1, -20); }},
};

/// The face z = 1 of a box, whose u runs to +x and v to +y over two units each, at its middle.
Vec3 faceNormal(const Placement& placement) {
    const Vec3 n =
        glm::normalize(glm::cross(placement.map(Vec3(1, 0, 0)), placement.map(Vec3(0, 1, 0))));
    // The outside is the side where the image of +z points.
    return glm::dot(n, placement.map(Vec3(0, 0, 1))) > 0.0 ? n : -n;
}

TemporaryFolder& files() {
    static TemporaryFolder folder;
    writePng(folder, "straight.png", 1, 1, 3, {128, 128, 255});
    writePng(folder, "leaning.png", 1, 1, 3, {190, 90, 235});
    std::vector<std::uint8_t> heights;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            heights.push_back(static_cast<std::uint8_t>(9 * x + 4 * (15 - y)));
        }
    }
    writePng(folder, "slope.png", 16, 16, 1, heights);
    return folder;
}

Picture render(const std::string& script, int spp = 1) {
    PictureSettings settings;
    settings.options.spp = spp;
    settings.folder = files().path().string();
    return renderScript(script, settings);
}

/// The normal that the middle of the bumped face shows: three lights of one direction each, along
/// the axes of a frame about the face's normal, measure its three cosines.
Vec3 shownNormal(const Placement& placement, const std::string& bump) {
    const Vec3 middle = placement.map(Vec3(0, 0, 1));
    const Vec3 n = faceNormal(placement);
    const Vec3 t = glm::normalize(placement.map(Vec3(1, 0, 0)));
    const Vec3 b = glm::cross(n, t);
    const Vec3 ways[] = {glm::normalize(n + 0.5 * t), glm::normalize(n - 0.5 * t),
                         glm::normalize(n + 0.5 * b)};
    Vec3 cosines(0.0);
    for (int i = 0; i < 3; ++i) {
        Shot shot;
        shot.body = "it = gr.nh_box('it', {-1, -1, -1}, 2) " + std::string(placement.calls) +
                    "\nroot:add_child(it, gr.material({1, 1, 1}, {0, 0, 0}, 1), nil, "
                    "gr.bumpmap('" +
                    bump + "'))\nlights[1] = gr.light(" + text(middle + 1e7 * ways[i]) +
                    ", {1, 1, 1}, {1, 0, 0})";
        shot.eye = middle + 10.0 * n;
        shot.view = -n;
        shot.up = t;
        cosines[i] = render(shot.script()).at(0, 0).x;
    }
    // cosines = ways . normal, solved by Cramer's rule.
    const double whole = glm::dot(ways[0], glm::cross(ways[1], ways[2]));
    return (cosines[0] * glm::cross(ways[1], ways[2]) + cosines[1] * glm::cross(ways[2], ways[0]) +
            cosines[2] * glm::cross(ways[0], ways[1])) /
           whole;
}

}  // namespace

TEST_CASE("a height map's normal is that of the raised surface, however the object is placed") {
    for (const Placement& placement : kPlacements) {
        const std::string name = placement.name;
        CAPTURE(name);
        // Object space: the point (-1 + 2u, -1 + 2v, 1 + H) with H = kHeightOfWhite 2 h; the
        // tangents of that surface go through the map, and their cross product is the normal.
        const double rise = 2.0 * kHeightOfWhite / 255.0 * 16.0;
        const Vec3 alongU = placement.map(Vec3(2, 0, 9 * rise));
        const Vec3 alongV = placement.map(Vec3(0, 2, 4 * rise));
        Vec3 expected = glm::normalize(glm::cross(alongU, alongV));
        if (glm::dot(expected, faceNormal(placement)) < 0.0) expected = -expected;
        CHECK(glm::length(shownNormal(placement, "slope.png") - expected) < 1e-6);
    }
}

TEST_CASE("a normal map leans along the tangents, however the object is placed") {
    const Vec3 codes(62.0 / 127.0, -38.0 / 127.0, 107.0 / 127.0);
    for (const Placement& placement : kPlacements) {
        const std::string name = placement.name;
        CAPTURE(name);
        // A surface whose normal in the object's own frame is `codes` has these two tangents.
        const Vec3 alongU = placement.map(Vec3(codes.z, 0, -codes.x));
        const Vec3 alongV = placement.map(Vec3(0, codes.z, -codes.y));
        Vec3 expected = glm::normalize(glm::cross(alongU, alongV));
        if (glm::dot(expected, faceNormal(placement)) < 0.0) expected = -expected;
        CHECK(glm::length(shownNormal(placement, "leaning.png") - expected) < 1e-6);
    }
}

TEST_CASE("a normal map of (128, 128, 255) changes no bit of a picture") {
    const auto scene = [](const std::string& bump) {
        return "root = gr.node('root') m = gr.material({0.7, 0.6, 0.5}, {0.4, 0.4, 0.4}, 20)\n" +
               bump + R"(
            local function put(node, x, y)
                node:rotate('y', 30) node:rotate('x', 25) node:scale(0.8, 1.1, -0.9)
                node:translate(x, y, 0)
                root:add_child(node, m, nil, bump)
                return node
            end
            put(gr.sphere('a'), -2.5, 1.3)
            put(gr.cube('b'), 0, 1):set_reflection(0.4)
            put(gr.cylinder('c'), 2.5, 1.3)
            put(gr.cone('d'), -2.5, -1.3)
            put(gr.torus('e', 0.8, 0.3), 0, -1.3)
            glass = put(gr.nh_sphere('f', {0, 0, 0}, 0.9), 2.5, -1.3)
            glass:set_refraction(1.4, 0.2) glass:set_fresnel(true)
            put(gr.mesh('g', {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 1}},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), 0, 0)
            gr.render(root, 'o.png', 60, 40, {0, 0, 12}, {0, 0, -1}, {0, 1, 0}, 40,
                      {0.2, 0.2, 0.2}, {gr.light({5, 8, 9}, {1, 1, 1}, {1, 0, 0}, 1)}))";
    };
    const Picture plain = render(scene(""), 4);
    const Picture straight = render(scene("bump = gr.bumpmap('straight.png')"), 4);
    const Picture leaning = render(scene("bump = gr.bumpmap('leaning.png')"), 4);
    CHECK(sameBytes(plain, straight));
    CHECK_FALSE(sameBytes(plain, leaning));
}
