// What is wrong with an argument is said with the script's line, the call and the argument's name.
#include "gr_script.h"

#include <doctest/doctest.h>

using namespace rt;
using rt::test::runScene;
using rt::test::ScriptRun;

namespace {

struct Case {
    const char* script;
    std::string message;  ///< what the error starts with
};

const char* const kRender =
    "n = gr.sphere('s')\n"
    "function go(t)\n"
    "  local function or_(v, d) if v == nil then return d end return v end\n"
    "  gr.render(or_(t.node, n), or_(t.file, 'a.png'), or_(t.w, 8), or_(t.h, 8),\n"
    "    or_(t.eye, {0,0,9}), or_(t.view, {0,0,-1}), or_(t.up, {0,1,0}), or_(t.fov, 50),\n"
    "    or_(t.ambient, {0,0,0}), or_(t.lights, {}), t.focal)\n"
    "end\n";

void checkCases(const std::vector<Case>& cases, const std::string& before = "") {
    for (const Case& one : cases) {
        CAPTURE(one.script);
        const ScriptRun run = runScene(before + one.script);
        CHECK(run.code == ExitCode::kScene);
        CAPTURE(run.error);
        CHECK(run.error.substr(0, one.message.size()) == one.message);
    }
}

}  // namespace

TEST_CASE("too few arguments name the one that is missing and show the call") {
    checkCases({
        {"gr.sphere()", "scene.lua:1: gr.sphere: name is missing; the call is gr.sphere(name)"},
        {"\n\ngr.nh_sphere('s', {0,0,0})",
         "scene.lua:3: gr.nh_sphere: radius is missing; the call is gr.nh_sphere(name, centre, "
         "radius)"},
        {"n = gr.node('n')\nn:translate(1, 2)",
         "scene.lua:2: gr.translate: dz is missing; the call is node:translate(dx, dy, dz)"},
        {"n = gr.node('n') n:add_child()",
         "scene.lua:1: gr.add_child: child is missing; the call is node:add_child(child [, "
         "material "
         "[, texture [, bump]]])"},
        {"gr.material({1,1,1}, {0,0,0})", "scene.lua:1: gr.material: exponent is missing"},
        {"gr.light({0,0,0}, {1,1,1})", "scene.lua:1: gr.light: falloff is missing"},
        {"gr.light(0,0,0, 1,1,1, 1,0)", "scene.lua:1: gr.light: c2 is missing"},
        {"gr.focal(10, 1)", "scene.lua:1: gr.focal: a is missing"},
        {"gr.mesh('m')", "scene.lua:1: gr.mesh: file is missing"},
        {"gr.render(gr.node('n'), 'a.png', 8, 8, {0,0,1}, {0,0,-1}, {0,1,0}, 50, {0,0,0})",
         "scene.lua:1: gr.render: lights is missing"},
        {"gr.background()", "scene.lua:1: gr.background: colour is missing"},
        {"gr.options()", "scene.lua:1: gr.options: options is missing"},
        {"gr.param('n')", "scene.lua:1: gr.param: default is missing"},
    });
}

TEST_CASE("a value of the wrong type is shown beside what was wanted") {
    checkCases({
        {"n = gr.node('n')\nn:translate('abc', 0, 0)",
         "scene.lua:2: gr.translate: dx must be a number (got string \"abc\")"},
        {"n = gr.node('n')\nn:translate(1, nil, 0)",
         "scene.lua:2: gr.translate: dy must be a number (got nil)"},
        {"gr.node({})", "scene.lua:1: gr.node: name must be a string (got table)"},
        {"gr.nh_sphere('s', 1, 2)",
         "scene.lua:1: gr.nh_sphere: centre must be a table of 3 numbers (got number 1)"},
        {"gr.nh_box('b', {0,0,0}, true)", "scene.lua:1: gr.nh_box: r must be a number (got true)"},
        {"gr.nh_sphere('s', {0,0,0}, print)",
         "scene.lua:1: gr.nh_sphere: radius must be a number (got function)"},
        {"gr.sphere('s'):set_absorption{0, -1, 0}",
         "scene.lua:1: gr.set_absorption: absorption[2] must be >= 0 (got -1)"},
        {"gr.spot_light{position = {0,0,0}, direction = {0,1,0}, colour = {1,1,1}, inner = 40}",
         "scene.lua:1: gr.spot_light: inner must be <= outer (got inner 40, outer 30)"},
        {"gr.sun_light{direction = {0,0,0}, colour = {1,1,1}}",
         "scene.lua:1: gr.sun_light: direction must not be zero"},
        {"gr.sun_light{direction = {0,1,0}, colour = {1,1,1}, angle = 90}",
         "scene.lua:1: gr.sun_light: angle must be >= 0 and < 90 (got 90)"},
        {"gr.sun_light{directoin = {0,1,0}, colour = {1,1,1}}",
         "scene.lua:1: gr.sun_light: unknown field 'directoin'; did you mean 'direction'?; the "
         "call "
         "is gr.sun_light{direction=, colour= [, angle= [, brightness=]]}"},
        {"gr.sun_light{direction = {0,1,0}}",
         "scene.lua:1: gr.sun_light: colour is missing; the call is "
         "gr.sun_light{direction=, colour= [, angle= [, brightness=]]}"},
        {"gr.sun_light(7)",
         "scene.lua:1: gr.sun_light: its argument must be a table of fields (got number 7)"},
        {"gr.rectangle_light{corner = {0,0,0}, u = {0,0,0}, v = {0,1,0}, colour = {1,1,1}}",
         "scene.lua:1: gr.rectangle_light: u must not be zero"},
        {"gr.nh_disc('d', {0,0,0}, {0,0,0}, 1)",
         "scene.lua:1: gr.nh_disc: normal must not be zero"},
        {"gr.nh_plane('p', {0,0,0}, {0,0,0})", "scene.lua:1: gr.nh_plane: normal must not be zero"},
        {"gr.nh_quad('q', {0,0,0}, {1,2,0}, {2,4,0})",
         "scene.lua:1: gr.nh_quad: u and v must not be parallel"},
        {"gr.nh_quad('q', {0,0,0}, {1,2,0}, {0,0,0})",
         "scene.lua:1: gr.nh_quad: v must not be zero"},
        {"gr.quadric('q', {xx = 1}, {0,0,0}, {1,0,1})",
         "scene.lua:1: gr.quadric: max[2] must be > min[2], 0 (got 0)"},
        {"gr.quadric('q', {xx = 'a'}, {0,0,0}, {1,1,1})",
         "scene.lua:1: gr.quadric: xx must be a number (got string \"a\")"},
        {"gr.quadric('q', {xz = 1}, {0,0,0}, {1,1,1})",
         "scene.lua:1: gr.quadric: unknown coefficient 'xz'"},
        {"gr.quadric('q', {c = -1}, {0,0,0}, {1,1,1})",
         "scene.lua:1: gr.quadric: quadric: one of its coefficients beside c must not be 0"},
        {"gr.height_field('h', {{0, 1}, {1}})",
         "scene.lua:1: gr.height_field: rows must have as many numbers as the first, 2 (rows[2] "
         "has 1)"},
        {"gr.height_field('h', {{0, 1}, {1, 'a'}})",
         "scene.lua:1: gr.height_field: rows[2][2] must be a number (got string \"a\")"},
        {"gr.height_field('h', {{0, 1}, {1, 1}}, {bases = 0})",
         "scene.lua:1: gr.height_field: unknown option 'bases'; did you mean 'base'?"},
        {"gr.height_field('h', {{0, 1}, {1, 1}}, {resolution = 8})",
         "scene.lua:1: gr.height_field: resolution goes with a function alone"},
        {"gr.height_field('h', function(x, z) return 0 end, {resolution = 1})",
         "scene.lua:1: gr.height_field: resolution must be a whole number in 2 .. 4096 (got 1)"},
        {"gr.height_field('h', function(x, z) return x / 0 end)",
         "scene.lua:1: gr.height_field: the function must give a finite number (got number"},
        {"gr.height_field('h', function(x, z) gr.cube('c') return {} end)",
         "scene.lua:1: gr.height_field: the function must give a finite number (got table at x = "
         "0, z = 0)"},
        {"gr.height_field('h', function(x, z)\n return nothing.x end)", "scene.lua:2: "},
        {"gr.union('u', gr.sphere('s'))", "scene.lua:1: gr.union: b is missing"},
        {"gr.union('u', gr.sphere('s'), nil)",
         "scene.lua:1: gr.union: b: gr.node expected, got nil"},
        {"gr.union('u', gr.sphere('s'), gr.cube('c'), nil)",
         "scene.lua:1: gr.union: operand[3]: gr.node expected, got nil"},
        {"gr.nh_frustum('f', {0,0,0}, 1, 0, 2)",
         "scene.lua:1: gr.nh_frustum: r0 must be > 0 (got 0)"},
        {"gr.checker{first = {0,0,0}, second = {0,-1,0}}",
         "scene.lua:1: gr.checker: second[2] must be >= 0 (got -1)"},
        {"gr.noise{first = {0,0,0}, second = {1,1,1}, octaves = 2.5}",
         "scene.lua:1: gr.noise: octaves must be a whole number in 1 .. 16 (got 2.5)"},
        {"gr.wood{first = {0,0,0}, second = {1,1,1}, direction = {0,0,0}}",
         "scene.lua:1: gr.wood: direction must not be zero"},
        {"gr.sphere('s'):set_fresnel(1)",
         "scene.lua:1: gr.set_fresnel: on must be true or false (got number 1)"},
        {"gr.param('n', {})",
         "scene.lua:1: gr.param: default must be a number, a string or a boolean (got table)"},
        {"gr.nh_sphere('s', {0,0,0}, '\\27[31m')",
         "scene.lua:1: gr.nh_sphere: radius must be a number (got string \"\\x1b[31m\")"},
    });
}

TEST_CASE("numbers must be finite and in range") {
    checkCases({
        {"gr.nh_sphere('s', {0,0,0}, -1)",
         "scene.lua:1: gr.nh_sphere: radius must be > 0 (got -1)"},
        {"gr.nh_sphere('s', {0,0,0}, 0)", "scene.lua:1: gr.nh_sphere: radius must be > 0 (got 0)"},
        {"gr.nh_sphere('s', {0,0,0}, 0/0)", "scene.lua:1: gr.nh_sphere: radius must be finite"},
        {"gr.nh_sphere('s', {0,0,0}, 1/0)",
         "scene.lua:1: gr.nh_sphere: radius must be finite (got inf)"},
        {"gr.nh_sphere('s', {0,-1/0,0}, 1)",
         "scene.lua:1: gr.nh_sphere: centre[2] must be finite (got -inf)"},
        {"gr.nh_box('b', {0,0,0}, {1,0,1})", "scene.lua:1: gr.nh_box: size[2] must be > 0 (got 0)"},
        {"gr.nh_cylinder('c', {0,0,0}, -2, 1)",
         "scene.lua:1: gr.nh_cylinder: h must be > 0 (got -2)"},
        {"gr.nh_cone('c', {0,0,0}, 2, 0)", "scene.lua:1: gr.nh_cone: r must be > 0 (got 0)"},
        {"gr.nh_torus('t', {0,0,0}, 0, 1)", "scene.lua:1: gr.nh_torus: R must be > 0 (got 0)"},
        {"gr.torus('t', 1, -0.5)", "scene.lua:1: gr.torus: r must be > 0 (got -0.5)"},
        {"gr.material({1,1,1}, {0,0,0}, -1)",
         "scene.lua:1: gr.material: exponent must be >= 0 (got -1)"},
        {"gr.sphere('s'):set_reflection(1.5)",
         "scene.lua:1: gr.set_reflection: f must be in 0 .. 1 (got 1.5)"},
        {"gr.sphere('s'):set_refraction(0, 0.5)",
         "scene.lua:1: gr.set_refraction: index must be > 0 (got 0)"},
        {"gr.sphere('s'):set_refraction(1.5, -0.1)",
         "scene.lua:1: gr.set_refraction: f must be in 0 .. 1 (got -0.1)"},
        {"gr.light({0,0,0}, {1,1,1}, {1,-1,0})",
         "scene.lua:1: gr.light: falloff[2] must be >= 0 (got -1)"},
        {"gr.light({0,0,0}, {1,1,1}, {1,0,0}, -1)",
         "scene.lua:1: gr.light: radius must be >= 0 (got -1)"},
        {"gr.light(0,0,0, 1,1,1, 1,0,0, 0, 0/0)",
         "scene.lua:1: gr.light: brightness must be finite"},
        {"gr.focal(10, 10, 1)", "scene.lua:1: gr.focal: f must be < p (got f 10, p 10)"},
        {"gr.focal(-1, 1, 1)", "scene.lua:1: gr.focal: p must be > 0 (got -1)"},
        {"gr.focal(10, 0, 1)", "scene.lua:1: gr.focal: f must be > 0 (got 0)"},
        {"gr.focal(10, 1, -1)", "scene.lua:1: gr.focal: a must be >= 0 (got -1)"},
        {"gr.joint('j', {0,0/0,0}, {0,0,0})", "scene.lua:1: gr.joint: x[2] must be finite"},
    });
}

TEST_CASE("a tuple that is short, holed or borrowed from a metatable is refused") {
    checkCases({
        {"gr.nh_sphere('s', {0,0}, 1)",
         "scene.lua:1: gr.nh_sphere: centre must have 3 numbers (got 2)"},
        {"gr.nh_sphere('s', {}, 1)",
         "scene.lua:1: gr.nh_sphere: centre must have 3 numbers (got 0)"},
        {"gr.nh_sphere('s', {0,nil,0}, 1)",
         "scene.lua:1: gr.nh_sphere: centre[2] must be a number (got nil)"},
        {"gr.nh_sphere('s', {0,'x',0}, 1)",
         "scene.lua:1: gr.nh_sphere: centre[2] must be a number (got string \"x\")"},
        {"gr.nh_sphere('s', setmetatable({}, {__index = function() return 1 end}), 1)",
         "scene.lua:1: gr.nh_sphere: centre must have 3 numbers (got 0)"},
        {"gr.light({1,2,3}, {1,1,1}, {1,0})",
         "scene.lua:1: gr.light: falloff must have 3 numbers (got 2)"},
    });
}

TEST_CASE("an axis is one letter of x, y and z") {
    checkCases({
        {"gr.node('n'):rotate('w', 9)",
         "scene.lua:1: gr.rotate: axis must be 'x', 'y' or 'z' (got string \"w\")"},
        {"gr.node('n'):rotate('xy', 9)",
         "scene.lua:1: gr.rotate: axis must be 'x', 'y' or 'z' (got string \"xy\")"},
        {"gr.node('n'):rotate('', 9)", "scene.lua:1: gr.rotate: axis must be 'x', 'y' or 'z'"},
        {"gr.node('n'):rotate(1, 9)",
         "scene.lua:1: gr.rotate: axis must be 'x', 'y' or 'z' (got number 1)"},
    });
}

TEST_CASE("a render's camera, size, lights and file are checked") {
    checkCases(
        {
            {"go{w = 0}",
             "scene.lua:4: gr.render: w must be a whole number in 1 .. 2147483647 (got 0)"},
            {"go{h = -3}", "scene.lua:4: gr.render: h must be a whole number in"},
            {"go{w = 1.5}", "scene.lua:4: gr.render: w must be a whole number in"},
            {"go{w = 0/0}", "scene.lua:4: gr.render: w must be a whole number in"},
            {"go{w = 2^31}", "scene.lua:4: gr.render: w must be a whole number in"},
            {"go{h = 1e300}", "scene.lua:4: gr.render: h must be a whole number in"},
            {"go{view = {0,0,0}}", "scene.lua:4: gr.render: view must not be zero"},
            {"go{up = {0,0,0}}", "scene.lua:4: gr.render: up must not be zero"},
            {"go{fov = 0}", "scene.lua:4: gr.render: fov must be > 0 and < 180 (got 0)"},
            {"go{fov = 180}", "scene.lua:4: gr.render: fov must be > 0 and < 180 (got 180)"},
            {"go{fov = -50}", "scene.lua:4: gr.render: fov must be > 0 and < 180 (got -50)"},
            {"go{eye = {0,0,1/0}}", "scene.lua:4: gr.render: eye[3] must be finite (got inf)"},
            {"go{file = ''}", "scene.lua:4: gr.render: file must not be empty"},
            {"go{file = 'a/b/'}", "scene.lua:4: gr.render: file 'a/b/' names a folder"},
            {"go{file = 'x'}", "scene.lua:4: gr.render: file 'x' must end in one of .png, "},
            {"go{file = 'd.png/x'}", "scene.lua:4: gr.render: file 'd.png/x' must end in one of"},
            {"go{file = 'd/.png'}", "scene.lua:4: gr.render: file 'd/.png' must end in one of"},
            {"go{file = 'x.xyz'}", "scene.lua:4: gr.render: file 'x.xyz' must end in one of"},
            {"go{file = 'a\\0.png'}", "scene.lua:4: gr.render: file 'a\\x00.png' holds a NUL"},
            {"go{lights = 1}",
             "scene.lua:4: gr.render: lights must be a table of gr.light (got number 1)"},
            {"go{lights = {n}}",
             "scene.lua:4: gr.render: lights[1]: gr.light expected, got gr.node"},
            {"l = gr.light({0,0,0},{1,1,1},{1,0,0}) go{lights = {l, nil, l}}",
             "scene.lua:4: gr.render: lights[2]: gr.light expected, got nil"},
            {"go{focal = 3}", "scene.lua:4: gr.render: focal: gr.focal expected, got number 3"},
            {"go{focal = gr.focal({0,0,8}, 1, 0.1)}",
             "scene.lua:4: gr.render: the point to focus on must lie farther along view than the "
             "focal length 1 (got 1)"},
            {"go{node = 'n'}", "scene.lua:4: gr.render: node: gr.node expected, got string \"n\""},
        },
        kRender);
}

TEST_CASE("numeric strings are numbers, as they always were in this language") {
    const ScriptRun run = runScene("n = gr.node(5)\nn:translate('3', ' 0x10 ', 1)");
    CHECK(run.error == "");
    CHECK(run.scene().nodes[0].name == "5");
    CHECK(run.scene().nodes[0].latest().transform.translation == Vec3(3, 16, 1));
}
