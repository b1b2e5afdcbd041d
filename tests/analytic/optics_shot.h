// Scripts for pictures of one point: a camera of a tiny field of view, and a wall that tells where
// a ray met it.
#pragma once

#include "rt/core/vec.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace rt::test {

inline constexpr double kPi = 3.14159265358979323846;

inline std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.17g", x);
    return buffer;
}

inline std::string text(const Vec3& v) {
    return "{" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + "}";
}

/// A picture of what `body` adds to `root` and to the list `lights`. As it stands a pixel is one
/// ray, to within 1e-14 of its direction.
struct Shot {
    std::string body;
    Vec3 eye{0.0, 0.0, 10.0};
    Vec3 view{0.0, 0.0, -1.0};
    Vec3 up{0.0, 1.0, 0.0};
    double fov = 1e-12;
    int width = 1;
    int height = 1;
    Color ambient{0.0};
    std::string focal;  ///< the arguments of gr.focal

    std::string script() const {
        return "root = gr.node('root')\nlights = {}\n" + body + "\ngr.render(root, 'out.png', " +
               std::to_string(width) + ", " + std::to_string(height) + ", " + text(eye) + ", " +
               text(view) + ", " + text(up) + ", " + text(fov) + ", " + text(ambient) + ", lights" +
               (focal.empty() ? "" : ", gr.focal(" + focal + ")") + ")\n";
    }
};

inline Picture shoot(const Shot& shot, int spp = 1, RenderOptions options = {}) {
    PictureSettings settings;
    settings.options = std::move(options);
    settings.options.spp = spp;
    return renderScript(shot.script(), settings);
}

/// The only pixel of a picture of grey things, without any cut.
inline double grey(const Shot& shot, int spp = 1) {
    RenderOptions options;
    options.cutoff = 0.0;
    return shoot(shot, spp, options).at(0, 0).x;
}

inline bool sameBytes(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

/// Adds a node to the root under a matt material of one colour, which ambient light of 1 shows.
/// `calls` are methods of `it`.
inline std::string place(const std::string& node, double grey, const std::string& calls = "") {
    return "it = " + node + "\n" + calls + "\nroot:add_child(it, gr.material({" + text(grey) +
           ", " + text(grey) + ", " + text(grey) + "}, {0, 0, 0}, 0))\n";
}

/// The wall z = `z`, facing up, under a light whose brightness lifts every cosine to 1: a point of
/// it shows 1 / (squared distance to the light).
inline std::string ruler(double z, const Vec3& light) {
    return place("gr.nh_box('ruler', {-1000, -1000, " + text(z - 1.0) + "}, {2000, 2000, 1})",
                 1.0) +
           "lights[1] = gr.light(" + text(light) + ", {1, 1, 1}, {0, 0, 1}, 0, 1)\n";
}

/// How far along x from the light's foot the ruler says that a ray in the plane y = light.y met it.
inline double readRuler(double value, double z, const Vec3& light) {
    const double height = light.z - z;
    return std::sqrt(1.0 / value - height * height);
}

}  // namespace rt::test
