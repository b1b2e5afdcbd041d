// Where light ends on a mesh that stands for a round thing.
#include "optics_shot.h"

#include <array>
#include <optional>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

using Triangle = std::array<std::size_t, 3>;

/// A ball of 12 x 8 facets about the origin, of triangles, wound outwards.
struct Ball {
    std::vector<Vec3> vertices{{0, 1, 0}};
    std::vector<Triangle> faces;

    Ball() {
        for (int i = 1; i < 8; ++i) {
            for (int k = 0; k < 12; ++k) {
                const double a = i * kPi / 8;
                const double b = k * kPi / 6;
                vertices.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                      std::sin(a) * std::sin(b));
            }
        }
        vertices.emplace_back(0, -1, 0);
        for (std::size_t k = 0; k < 12; ++k) {
            const std::size_t n = (k + 1) % 12;
            faces.push_back({0, 1 + n, 1 + k});
            faces.push_back({85, 73 + k, 73 + n});
            for (std::size_t r = 1; r < 73; r += 12) {
                faces.push_back({r + k, r + n, r + 12 + n});
                faces.push_back({r + k, r + 12 + n, r + 12 + k});
            }
        }
    }

    Vec3 normal(const Triangle& f) const {
        return glm::normalize(
            glm::cross(vertices[f[1]] - vertices[f[0]], vertices[f[2]] - vertices[f[0]]));
    }

    /// The faces' normals at a vertex, weighted by their angles there.
    std::vector<Vec3> vertexNormals() const {
        std::vector<Vec3> sums(vertices.size(), Vec3(0.0));
        for (const Triangle& f : faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 a = glm::normalize(vertices[f[(k + 1) % 3]] - vertices[f[k]]);
                const Vec3 b = glm::normalize(vertices[f[(k + 2) % 3]] - vertices[f[k]]);
                sums[f[k]] += std::acos(glm::dot(a, b)) * normal(f);
            }
        }
        for (Vec3& n : sums) n = glm::normalize(n);
        return sums;
    }

    std::string mesh() const {
        std::string v;
        std::string f;
        for (const Vec3& p : vertices) v += text(p) + ", ";
        for (const Triangle& t : faces) {
            f += "{" + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " +
                 std::to_string(t[2]) + "}, ";
        }
        return "gr.mesh('ball', {" + v + "}, {" + f + "}, {smooth = 180})";
    }
};

struct Met {
    std::size_t face;
    Vec3 weights;
};

/// The nearest facet that faces the ray and is met well inside its edges (Moeller and Trumbore,
/// Fast, Minimum Storage Ray/Triangle Intersection, 1997).
std::optional<Met> meet(const Ball& ball, const Vec3& origin, const Vec3& d) {
    for (std::size_t i = 0; i < ball.faces.size(); ++i) {
        const Triangle& f = ball.faces[i];
        if (glm::dot(ball.normal(f), d) >= 0.0) continue;
        const Vec3 e1 = ball.vertices[f[1]] - ball.vertices[f[0]];
        const Vec3 e2 = ball.vertices[f[2]] - ball.vertices[f[0]];
        const Vec3 p = glm::cross(d, e2);
        const Vec3 s = (origin - ball.vertices[f[0]]) / glm::dot(e1, p);
        const double u = glm::dot(s, p);
        const double v = glm::dot(d, glm::cross(s, e1));
        if (std::min({u, v, 1.0 - u - v}) > 1e-6) return Met{i, {1.0 - u - v, u, v}};
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("a smooth ball is lit by its normals wherever its facets face the light") {
    const Ball ball;
    const std::vector<Vec3> normals = ball.vertexNormals();
    const Vec3 toLight = glm::normalize(Vec3(-6, 5, 1.2));
    Shot shot;
    shot.body = place(ball.mesh(), 1.0) + "lights[1] = gr.light(" + text(1e7 * toLight) +
                ", {1, 1, 1}, {1, 0, 0})\n";
    shot.fov = 12.0;
    shot.width = shot.height = 120;
    RenderOptions options;
    options.sampler = "grid";
    const Picture picture = shoot(shot, 1, options);

    const double perPixel = 2.0 * std::tan(6.0 * kPi / 180.0) / shot.width;
    int judged = 0;
    int inTheBand = 0;  // dark, on facets that face away, whatever the normals say
    int off = 0;
    for (int y = 0; y < shot.height; ++y) {
        for (int x = 0; x < shot.width; ++x) {
            const Vec3 d = glm::normalize(Vec3((x + 0.5 - 0.5 * shot.width) * perPixel,
                                               (0.5 * shot.height - y - 0.5) * perPixel, -1.0));
            const auto met = meet(ball, shot.eye, d);
            if (!met) continue;
            const Triangle& f = ball.faces[met->face];
            const Vec3 n =
                glm::normalize(met->weights[0] * normals[f[0]] + met->weights[1] * normals[f[1]] +
                               met->weights[2] * normals[f[2]]);
            if (glm::dot(n, d) > 0.0) continue;
            const bool faced = glm::dot(ball.normal(f), toLight) > 0.0;
            const double expected = faced ? std::max(glm::dot(n, toLight), 0.0) : 0.0;
            const double value = picture.at(x, y).x;
            ++judged;
            if (glm::dot(n, toLight) > 0.03 && !faced) ++inTheBand;
            // The pretended surface may still shade itself where light grazes it.
            const bool grazed = expected < 0.03 && value == 0.0;
            if (!grazed && std::fabs(value - expected) > 1e-6) ++off;
        }
    }
    CHECK(judged > 5000);
    CHECK(inTheBand > 150);
    CHECK(off == 0);
}

TEST_CASE("light does not come through the mesh, nor through a shell") {
    const Ball ball;
    // Lights with a floor under the cosine: the ball's far side and its inside stay black.
    for (const Vec3& position : {Vec3(0, 0, -50), Vec3(0.1, 0.2, 0.1)}) {
        Shot shot;
        shot.body = place(ball.mesh(), 1.0) + "lights[1] = gr.light(" + text(position) +
                    ", {1, 1, 1}, {1, 0, 0}, 0, 1)\n";
        shot.fov = 4.0;
        shot.width = shot.height = 24;
        for (const Color& pixel : shoot(shot, 2).pixels) CHECK(pixel == Color(0.0));
    }
    // A camera between the ball and a shell as wide as the ball pretends to be, and a little more.
    const std::string shell = place("gr.nh_sphere('shell', {0, 0, 0}, 1.01)", 1.0);
    for (int i = 0; i < 12; ++i) {
        CAPTURE(i);
        const double a = 0.5 * i;
        Shot shot;
        shot.body = place(ball.mesh(), 1.0) + shell +
                    "lights[1] = gr.light({30, 20, 10}, {1, 1, 1}, {1, 0, 0}, 0, 1)\n"
                    "lights[2] = gr.light({-30, 10, -20}, {1, 1, 1}, {1, 0, 0}, 1, 1)\n";
        shot.eye = 1.005 * Vec3(std::cos(a), 0.0, std::sin(a));
        shot.view = -shot.eye;
        shot.fov = 170.0;
        shot.width = shot.height = 16;
        for (const Color& pixel : shoot(shot, 2).pixels) CHECK(pixel == Color(0.0));
    }
}
