// Interpolated normals: they shade, and steer mirrors, glass and Fresnel; but light stays on its
// side of the geometric surface.
#include "closed_forms.h"
#include "optics_shot.h"

#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

/// A slab whose top, z = 0, has a normal that leans towards +y, and whose other faces have theirs.
class LeaningSlab {
  public:
    explicit LeaningSlab(double lean) {
        const std::string top = "vn 0 " + text(std::sin(lean)) + " " + text(std::cos(lean)) + "\n";
        folder_.write("slab.obj",
                      "v -90 -90 0\nv 90 -90 0\nv 90 90 0\nv -90 90 0\n"
                      "v -90 -90 -50\nv 90 -90 -50\nv 90 90 -50\nv -90 90 -50\n" +
                          top +
                          "vn 0 0 -1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0\n"
                          "f 1//1 2//1 3//1 4//1\nf 8//2 7//2 6//2 5//2\nf 1//3 5//3 6//3 2//3\n"
                          "f 2//4 6//4 7//4 3//4\nf 3//5 7//5 8//5 4//5\nf 4//6 8//6 5//6 1//6\n");
    }

    /// What a camera at z = 10 sees of the slab's middle.
    Color see(const std::string& material, const std::string& calls, const std::string& rest,
              const Color& ambient = Color(0.0)) const {
        Shot shot;
        shot.body = "it = gr.mesh('slab', 'slab.obj')\n" + calls + "\nroot:add_child(it, " +
                    material + ")\n" + rest;
        shot.ambient = ambient;
        PictureSettings settings;
        settings.folder = folder_.path().string();
        settings.options.spp = 1;
        settings.options.cutoff = 0.0;
        return renderScript(shot.script(), settings).at(0, 0);
    }

  private:
    TemporaryFolder folder_;
};

const std::string kMatt = "gr.material({1, 1, 1}, {0, 0, 0}, 0)";
const std::string kShiny = "gr.material({0, 0, 0}, {1, 1, 1}, 3)";
const std::string kBlack = "gr.material({0, 0, 0}, {0, 0, 0}, 0)";

/// Far away, `angle` from the vertical towards +y.
std::string lightAt(double angle, double brightness = 0.0) {
    return "lights[1] = gr.light(" + text(1e9 * Vec3(0.0, std::sin(angle), std::cos(angle))) +
           ", {1, 1, 1}, {1, 0, 0}, 0, " + text(brightness) + ")\n";
}

double degrees(double d) {
    return d * kPi / 180.0;
}

}  // namespace

TEST_CASE("an interpolated normal shades: the cosine, its floor, and the highlight are its own") {
    for (const double lean : {degrees(10), degrees(35), degrees(60)}) {
        const LeaningSlab slab(lean);
        for (int d = -89; d < 90; d += 2) {
            CAPTURE(lean);
            CAPTURE(d);
            const double angle = degrees(d);
            const double cosine = std::cos(angle - lean);
            CHECK(std::fabs(slab.see(kMatt, "", lightAt(angle)).x - std::max(cosine, 0.0)) < 1e-7);
            CHECK(std::fabs(slab.see(kMatt, "", lightAt(angle, 0.3)).x - std::max(cosine, 0.3)) <
                  1e-7);
            // The light's mirror image at n stands at 2 lean - angle; the viewer at 0.
            const double lobe = std::max(std::cos(2.0 * lean - angle), 0.0);
            CHECK(std::fabs(slab.see(kShiny, "", lightAt(angle)).x -
                            (cosine > 0.0 ? lobe * lobe * lobe : 0.0)) < 1e-7);
        }
    }
}

TEST_CASE("below the geometric horizon no light comes, however the normal leans") {
    const LeaningSlab slab(degrees(50));
    for (const double d : {90.001, 91.0, 100.0, 130.0}) {
        CAPTURE(d);
        CHECK(slab.see(kMatt, "", lightAt(degrees(d), 1.0)).x == 0.0);
        CHECK(slab.see(kShiny, "", lightAt(degrees(d), 1.0)).x == 0.0);
    }
}

TEST_CASE("a leaning normal steers the mirror image, and never sends it into the surface") {
    const std::string sky = "gr.background({0, 0, 0}, {1, 1, 1})\n";
    for (double d = 0.0; d < 88.0; d += 3.0) {
        CAPTURE(d);
        const LeaningSlab slab(degrees(d));
        // The mirrored view stands 2 d from the vertical, in the plane of y: beyond the horizon it
        // is mirrored at the surface, which keeps its y.
        const double value = slab.see(kBlack, "it:set_reflection(0)", sky).x;
        CHECK(std::fabs(value - (0.5 + 0.5 * std::sin(2.0 * degrees(d)))) < 1e-12);
    }
    // Below the horizon there is a floor, which it does not meet.
    const LeaningSlab slab(degrees(60));
    CHECK(slab.see(kBlack, "it:set_reflection(0)",
                   "gr.background({0.75, 0.75, 0.75})\n" +
                       place("gr.nh_box('floor', {-500, -500, -60}, {1000, 1000, 1})", 0.0))
              .x == 0.75);
}

TEST_CASE("a leaning normal bends the view by Snell's law, and splits it by Fresnel's") {
    for (const double index : {1.33, 1.5, 2.4}) {
        for (double d = 0.0; d < 80.0; d += 5.0) {
            CAPTURE(index);
            CAPTURE(d);
            const double lean = degrees(d);
            const LeaningSlab slab(lean);
            const std::string glass = "it:set_refraction(" + text(index) + ", 0)\n";
            // Within the glass, a wall that is white from where the view should land on.
            const double landing = -5.0 * std::tan(lean - std::asin(std::sin(lean) / index));
            const auto wall = [&](double from) {
                return place("gr.nh_box('wall', {-40, " + text(from) + ", -6}, {80, 40, 1})", 1.0) +
                       place("gr.nh_box('dark', {-40, -40, -9}, {80, 80, 1})", 0.0);
            };
            CHECK(slab.see(kBlack, glass, wall(landing - 1e-9), Color(1.0)).x == 1.0);
            CHECK(slab.see(kBlack, glass, wall(landing + 1e-9), Color(1.0)).x == 0.0);
            const double mirrored =
                slab.see(kBlack, glass + "it:set_fresnel(true)",
                         "gr.background({1, 1, 1})\n" +
                             place("gr.nh_box('dark', {-80, -80, -9}, {160, 160, 1})", 0.0))
                    .x;
            CHECK(std::fabs(mirrored - reflectanceByAngles(lean, 1.0, index)) < 1e-10);
        }
    }
}

TEST_CASE("between three corners the normal is their weighted mean, made unit") {
    const std::vector<Vec3> n = {glm::normalize(Vec3(-0.4, -0.3, 1)),
                                 glm::normalize(Vec3(0.5, -0.2, 1)),
                                 glm::normalize(Vec3(0.1, 0.6, 1))};
    const std::vector<Vec3> corners = {{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}};
    std::string obj;
    for (const Vec3& v : corners)
        obj += "v " + text(v.x) + " " + text(v.y) + " " + text(v.z) + "\n";
    for (const Vec3& v : n) obj += "vn " + text(v.x) + " " + text(v.y) + " " + text(v.z) + "\n";
    const TemporaryFolder folder;
    folder.write("one.obj", obj + "f 1//1 2//2 3//3\n");
    const Vec3 w = glm::normalize(Vec3(0.3, 0.1, 1));
    for (int i = 1; i < 8; ++i) {
        for (int k = 1; i + k < 8; ++k) {
            const Vec3 b(1.0 - (i + k) / 8.0, i / 8.0, k / 8.0);
            Shot shot;
            shot.body = "root:add_child(gr.mesh('one', 'one.obj'), " + kMatt + ")\n" +
                        "lights[1] = gr.light(" + text(1e9 * w) + ", {1, 1, 1}, {1, 0, 0}, 0, 0)\n";
            shot.eye = b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2] + Vec3(0, 0, 10);
            PictureSettings settings;
            settings.folder = folder.path().string();
            settings.options.spp = 1;
            const Vec3 normal = glm::normalize(b[0] * n[0] + b[1] * n[1] + b[2] * n[2]);
            CHECK(std::fabs(renderScript(shot.script(), settings).at(0, 0).x -
                            glm::dot(normal, w)) < 1e-8);
        }
    }
}
