// Pictures of combined solids against pictures of what they come to, and against closed forms.
#include "kept_error.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

const std::string kPrologue = R"(
    red = gr.material({0.8, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)
    blue = gr.material({0.2, 0.3, 0.8}, {0.2, 0.2, 0.2}, 20)
    gr.background({0.1, 0.2, 0.3}, {0.6, 0.7, 0.8})
    lights[1] = gr.light({4, 9, 7}, {0.8, 0.8, 0.8}, {1, 0, 0}, 1)
    root:add_child(gr.nh_box('floor', {-9, -2.1, -9}, {18, 1, 18}), blue)
    function put(solid, material) root:add_child(solid, material) return solid end
)";

Shot shotOf(const std::string& body) {
    Shot shot;
    shot.body = kPrologue + body;
    shot.eye = {1.5, 2.0, 6.0};
    shot.view = {-0.22, -0.3, -1.0};
    shot.fov = 40.0;
    shot.width = 32;
    shot.height = 24;
    shot.ambient = Color(0.3);
    return shot;
}

Picture pictureOf(const std::string& body) {
    return shoot(shotOf(body), 4);
}

double largestDifference(const Picture& a, const Picture& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Color off = glm::abs(a.pixels[i] - b.pixels[i]);
        largest = std::max({largest, off.x, off.y, off.z});
    }
    return largest;
}

void checkAlike(const std::string& a, const std::string& b) {
    CAPTURE(a);
    CAPTURE(b);
    CHECK(largestDifference(pictureOf(a), pictureOf(b)) < 1e-9);
}

void checkSame(const std::string& a, const std::string& b) {
    CAPTURE(a);
    CAPTURE(b);
    CHECK(sameBytes(pictureOf(a), pictureOf(b)));
}

const std::string kThree = R"(
    a = gr.nh_box('a', {-1, -1, -1}, 2)
    b = gr.nh_sphere('b', {0.8, 0.6, 0.7}, 0.9)
    c = gr.nh_cylinder('c', {-0.3, -2, 0.2}, 4, 0.5)
)";

std::string glass(const std::string& solid) {
    return "it = " + solid +
           "\nit:set_refraction(1.5, 0.1) it:set_fresnel(true) it:set_absorption({0.5, 0.2, 0.1})\n"
           "put(it, red)\n";
}

const std::string kCutBox =
    "gr.difference('d', gr.nh_box('a', {-1,-1,-1}, 2), gr.nh_box('b', {-2, 0.25, -2}, 4))";
const std::string kSmallBox = "gr.nh_box('a', {-1,-1,-1}, {2, 1.25, 2})";

/// What is left of white light behind a body, straight on through its middle, `x` aside.
double leftBehind(const std::string& body, double x) {
    Shot shot;
    shot.body = "white = gr.material({1, 1, 1}, {0, 0, 0}, 0)\n" + body +
                "\nit:set_refraction(1, 0) it:set_absorption({0.7, 0.7, 0.7})\n"
                "root:add_child(it, white)\n" +
                place("gr.nh_box('wall', {-900, -900, -21}, {1800, 1800, 1})", 1.0);
    shot.eye.x = x;
    shot.ambient = Color(1.0);
    return grey(shot);
}

}  // namespace

TEST_CASE("a box less a box is the smaller box, matt and of glass") {
    checkAlike("put(" + kCutBox + ", red)", "put(" + kSmallBox + ", red)");
    checkAlike(glass(kCutBox), glass(kSmallBox));
    checkAlike("it = put(" + kCutBox + ", red) it:set_reflection(0.4)",
               "it = put(" + kSmallBox + ", red) it:set_reflection(0.4)");
    checkAlike(
        "put(gr.intersection('i', gr.nh_box('a', {-1,-1,-1}, 2), "
        "gr.nh_box('b', {-2, -2, -2}, {4, 2.25, 4})), red)",
        "put(" + kSmallBox + ", red)");
    checkAlike(
        "put(gr.union('u', gr.nh_box('a', {-1,-1,-1}, {2, 0.5, 2}), "
        "gr.nh_box('b', {-1, -0.5, -1}, {2, 0.75, 2})), red)",
        "put(" + kSmallBox + ", red)");
}

TEST_CASE("a flat height field with a base is a box, alone, of glass and combined") {
    const std::string field =
        "(function() local rows = {} for j = 1, 9 do rows[j] = {} for i = 1, 5 do rows[j][i] = "
        "0.75 "
        "end end local h = gr.height_field('h', rows, {base = 0}) h:scale(2, 1, 2) "
        "h:translate(-1, 0, -1) return h end)()";
    const std::string box = "gr.nh_box('b', {-1, 0, -1}, {2, 0.75, 2})";
    const std::string ball = ", gr.nh_sphere('s', {0.1, 0.6, 0.2}, 0.9))";
    checkAlike("put(" + field + ", red)", "put(" + box + ", red)");
    checkAlike(glass(field), glass(box));
    for (const std::string call :
         {"gr.union('u', ", "gr.intersection('i', ", "gr.difference('d', "}) {
        checkAlike("put(" + call + field + ball + ", red)", "put(" + call + box + ball + ", red)");
        checkAlike(glass(call + field + ball), glass(call + box + ball));
    }
}

TEST_CASE("the thickness of a wedge of glass by a height field is that of its heights") {
    for (const double x : {0.1, 0.35, 0.5, 0.8}) {
        CAPTURE(x);
        const std::string wedge =
            "it = gr.height_field('h', function(x, z) return x end, {base = -0.5, resolution = "
            "5})\n"
            "it:rotate('x', 90) it:translate(0, 0.5, 0)";
        CHECK(std::fabs(leftBehind(wedge, x) - std::exp(-0.7 * (x + 0.5))) < 1e-12);
    }
}

TEST_CASE("De Morgan's laws hold to the bit") {
    for (const std::string material : {"red", "nil"}) {
        const std::string paint =
            material == "nil" ? "a:set_material(red) b:set_material(blue) c:set_material(red)\n"
                              : "";
        const std::string end = ", " + material + ")";
        checkSame(kThree + paint + "put(gr.difference('d', a, gr.union('u', b, c))" + end,
                  kThree + paint +
                      "put(gr.intersection('i', gr.difference('e', a, b), "
                      "gr.difference('f', a, c))" +
                      end);
        checkSame(kThree + paint + "put(gr.difference('d', a, gr.intersection('u', b, c))" + end,
                  kThree + paint +
                      "put(gr.union('i', gr.difference('e', a, b), "
                      "gr.difference('f', a, c))" +
                      end);
        checkSame(kThree + paint + "put(gr.difference('d', a, b, c)" + end,
                  kThree + paint + "put(gr.difference('d', gr.difference('e', a, b), c)" + end);
        checkSame(kThree + paint + "put(gr.union('d', a, b, c)" + end,
                  kThree + paint + "put(gr.union('d', gr.union('e', a, b), c)" + end);
    }
    checkSame(kThree + "put(gr.intersection('d', a, b), red)",
              kThree + "put(gr.difference('d', a, gr.difference('e', a, b)), red)");
}

TEST_CASE("a solid less itself is not there; a union of what lies apart is all of it") {
    checkSame(kThree + "put(gr.difference('d', c, c), red)", "");
    checkSame(kThree + "put(gr.union('u', a, a), red)", kThree + "put(a, red)");
    const std::string apart = R"(
        a = gr.nh_box('a', {-1.6, -1, -1}, 1)
        b = gr.nh_torus('b', {0.8, 0.6, 0.7}, 0.6, 0.2)
        c = gr.nh_cone('c', {0.3, -1, -1}, 1, 0.4)
    )";
    checkSame(apart + "put(gr.union('u', a, b, c), red)",
              apart + "put(a, red) put(b, red) put(c, red)");
    checkSame(apart +
                  "g = gr.node('g') g:add_child(a, red) g:add_child(b, blue) "
                  "c:set_material(red) put(gr.union('u', g, c), nil)",
              apart + "put(a, red) put(b, blue) put(c, red)");
}

TEST_CASE("a combined solid may be placed twice, turned, mirrored and moved as any other") {
    const std::string turn =
        " it:scale(-0.8, 1.1, 0.7) it:rotate('x', 20) it:rotate('z', 30) it:translate(0.3, 0.2, "
        "0)\n";
    const std::string twice =
        " put(it, red) g = gr.node('g') g:translate(-1.2, 0.4, -1) g:add_child(it, blue) "
        "root:add_child(g)";
    checkAlike("it = " + kCutBox + turn + twice, "it = " + kSmallBox + turn + twice);
    checkAlike("it = " + kCutBox + " it:move(0.8, 0.2, 0) put(it, red)",
               "it = " + kSmallBox + " it:move(0.8, 0.2, 0) put(it, red)");
}

TEST_CASE("a cavity shows what was taken away, unless the whole says what it looks like") {
    const auto looksDown = [](const std::string& material) {
        Shot shot;
        shot.body = R"(
            local white = gr.material({0.75, 0.75, 0.75}, {0, 0, 0}, 0)
            local a, b = gr.nh_box('a', {-1,-1,-1}, 2), gr.nh_box('b', {-0.5,-0.5,0}, 2)
            a:set_material(gr.material({0.25, 0.25, 0.25}, {0, 0, 0}, 0))
            b:set_material(gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 0))
            root:add_child(gr.difference('d', a, b), )" +
                    material + ")";
        shot.ambient = Color(1.0);
        shot.eye = {-0.8, -0.8, 10.0};
        const double rim = grey(shot);
        shot.eye = {0.1, 0.1, 10.0};
        return std::pair(rim, grey(shot));
    };
    CHECK(looksDown("nil") == std::pair(0.25, 0.5));
    CHECK(looksDown("white") == std::pair(0.75, 0.75));
}

TEST_CASE("the thickness of a lens, of a shell and of a drilled ball is that of the formulas") {
    const double a = 0.7;
    for (const double x : {0.0, 0.1, 0.3, 0.45}) {
        CAPTURE(x);
        const double chord = 2.0 * (std::sqrt(4.0 - x * x) - 1.5);
        CHECK(std::fabs(leftBehind("it = gr.intersection('lens', gr.nh_sphere('a', {0,0,1.5}, 2), "
                                   "gr.nh_sphere('b', {0,0,-1.5}, 2))",
                                   x) -
                        std::exp(-a * chord)) < 1e-12);
        const double shell = 2.0 * (std::sqrt(1.0 - x * x) - std::sqrt(0.25 - x * x));
        CHECK(std::fabs(leftBehind("it = gr.difference('shell', gr.sphere('a'), "
                                   "gr.nh_sphere('b', {0,0,0}, 0.5))",
                                   x) -
                        std::exp(-a * shell)) < 1e-12);
        const double drilled = x < 0.25 ? 0.0 : 2.0 * std::sqrt(1.0 - x * x);
        CHECK(std::fabs(leftBehind("b = gr.nh_cylinder('b', {0,-2,0}, 4, 0.25) b:rotate('x', 90)\n"
                                   "it = gr.difference('drilled', gr.sphere('a'), b)",
                                   x) -
                        std::exp(-a * drilled)) < 1e-12);
        CHECK(std::fabs(leftBehind("it = gr.union('u', gr.sphere('a'), "
                                   "gr.nh_box('b', {-2,-2,-1.5}, {4, 4, 2}))",
                                   x) -
                        std::exp(-a * (std::sqrt(1.0 - x * x) + 1.5))) < 1e-12);
    }
}

TEST_CASE("from within the glass of a combined solid the way out is found") {
    Shot shot;
    shot.body = R"(
        it = gr.difference('d', gr.nh_box('a', {-5,-5,-5}, 10), gr.nh_box('b', {-1,-1,-1}, 2))
        it:set_refraction(1, 0) it:set_absorption({0.3, 0.3, 0.3})
        root:add_child(it, gr.material({1,1,1}, {0,0,0}, 0))
    )" + place("gr.nh_box('wall', {-900, -900, -21}, {1800, 1800, 1})", 1.0);
    shot.ambient = Color(1.0);
    for (const auto& [z, way] : {std::pair(4.0, 7.0), {0.5, 4.0}, {-3.0, 2.0}, {-6.0, 0.0}}) {
        CAPTURE(z);
        shot.eye = {0.2, 0.3, z};
        CHECK(std::fabs(grey(shot) - std::exp(-0.3 * way)) < 1e-12);
    }
}

TEST_CASE("pictures of combined solids keep their error") {
    const std::string bodies[] = {
        kThree + "put(gr.difference('d', a, b, c), red)",
        "put(gr.difference('moon', gr.nh_sphere('a', {-0.2,0,0}, 1.2), "
        "gr.nh_sphere('b', {0.2,0.1,0.5}, 1.25)), red)",
        "put(gr.quadric('q', {y = 1, xx = -0.8, zz = 0.8, c = -0.3}, {-1, -1, -1}, {1, 1, 1}), "
        "red)",
        "it = put(gr.intersection('i', gr.nh_box('a', {-1,-1,-1}, 2), gr.nh_sphere('b', {0,0,0}, "
        "1.3)), red) it:set_reflection(0.5)",
    };
    for (const std::string& body : bodies) {
        Shot shot = shotOf(body);
        shot.width = 64;
        shot.height = 48;
        checkErrorIsKept(shot, 256, {0.004, 0.012});
    }
}

TEST_CASE("what is left of combined solids keeps its error where it is thinner than a pixel") {
    const std::string solids[] = {
        // A shell that is cut open, a lens, a fin, and what slots and a drill leave of a box.
        "gr.difference('s', gr.nh_sphere('a', {0,0,0}, 0.8), gr.nh_sphere('b', {0,0,0}, 0.79), "
        "gr.nh_box('c', {-2, 0.1, -2}, {4, 4, 4}))",
        "gr.intersection('l', gr.nh_sphere('a', {0,0,3}, 3.02), gr.nh_sphere('b', {0,0,-3}, 3.02))",
        "gr.intersection('f', gr.nh_box('a', {-1,-0.5,0}, {2, 1, 2}), "
        "gr.nh_box('b', {-1,-0.8,-1.99}, {2, 1.6, 2}))",
        "gr.difference('d', gr.nh_box('a', {-0.6,-0.6,-0.6}, 1.2), "
        "gr.nh_box('b', {-0.3,-1,-1}, {0.02, 2, 2}), gr.nh_cylinder('c', {0.2,-1,0.2}, 3, 0.01), "
        "gr.nh_sphere('g', {0.2, 0.1, 1.595}, 1))"};
    for (const double radius : {0.0, 1.0}) {
        std::string body = "lights[1] = gr.light({4, 9, 7}, {0.8, 0.8, 0.8}, {1, 0, 0}, " +
                           std::to_string(radius) + ")\nlocal it\n";
        for (int i = 0; i < 12; ++i) {
            body += "it = put(" + solids[i % 4] + ", red) it:scale(0.6, 0.6, 0.6) it:rotate('x', " +
                    std::to_string(37 * i) + ") it:rotate('z', " + std::to_string(71 * i + 20) +
                    ") it:translate(" + std::to_string(i % 4 - 1.5) + ", " +
                    std::to_string(i / 4 - 1) + ", 0)\n";
        }
        Shot shot = shotOf(body);
        shot.width = 64;
        shot.height = 48;
        checkErrorIsKept(shot, 1024, {0.01, 0.005, 0.002}, 77.0, 5);
    }
}
