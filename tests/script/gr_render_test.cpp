// Renders, their snapshots, backgrounds, options and parameters.
#include "gr_script.h"

#include <doctest/doctest.h>

using namespace rt;
using rt::test::runScene;
using rt::test::ScriptRun;

namespace {

// go(node, file): a render with a light, where only these two matter.
const std::string kGo =
    "lamp = gr.light({0,9,0}, {1,1,1}, {1,0,0}) "
    "function go(n, f) gr.render(n, f or 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, "
    "{lamp}) end\n";

ScriptSettings withParameters(std::map<std::string, std::string> parameters) {
    ScriptSettings settings;
    settings.parameters = std::move(parameters);
    return settings;
}

}  // namespace

TEST_CASE("a render keeps what it was given, as a function and as a method") {
    const ScriptRun run = runScene(R"(
        n = gr.node('n') l = gr.light({1,2,3}, {1,1,1}, {1,0,0})
        gr.render(n, 'out/a.png', 640, '480', {1,2,3}, {0,0,-800}, {0,2,0}, 45, {.1,.2,.3}, {l})
        n:render('b.EXR', 1, 1, {0,0,0}, {0,1,0}, {0,0,1}, 179.5, {0,0,0}, {l, l}))");
    REQUIRE(run.error == "");
    CHECK(run.diagnostics.total() == 0);
    const auto& renders = run.scene().renders;
    REQUIRE(renders.size() == 2);
    CHECK(renders[0].root == 0);
    CHECK(renders[0].output == "out/a.png");
    CHECK(renders[0].width == 640);
    CHECK(renders[0].height == 480);
    CHECK(renders[0].camera.eye == Vec3(1, 2, 3));
    CHECK(renders[0].camera.view == Vec3(0, 0, -800));
    CHECK(renders[0].camera.up == Vec3(0, 2, 0));
    CHECK(renders[0].camera.fovDegrees == 45.0);
    CHECK(renders[0].ambient == Color(.1, .2, .3));
    CHECK(renders[0].lights.size() == 1);
    CHECK(renders[0].where.line == 3);
    CHECK(renders[1].output == "b.EXR");
    CHECK(renders[1].lights.size() == 2);
}

TEST_CASE("a render is a snapshot: what changes afterwards is seen by the next alone") {
    const ScriptRun run = runScene(kGo + R"(
        n = gr.node('n') s = gr.sphere('s') n:add_child(s)
        go(n, '0.png')
        s:translate(1, 0, 0) n:add_child(gr.sphere('t'))
        go(n, '1.png') go(n, '2.png')
        s:translate(1, 0, 0) s:set_reflection(0.5)
        go(n, '3.png')
        s:translate(1, 0, 0))");
    REQUIRE(run.error == "");
    const NodeDesc& n = run.scene().nodes.at(0);
    const NodeDesc& s = run.scene().nodes.at(1);
    const double x[] = {0, 1, 1, 2};
    const std::size_t children[] = {1, 2, 2, 2};
    for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        CHECK(s.at(k).transform.translation.x == x[k]);
        CHECK(n.at(k).children.size() == children[k]);
        CHECK(s.at(k).reflection.has_value() == (k == 3));
    }
    CHECK(s.latest().transform.translation.x == 3.0);
    CHECK(s.at(1).transform.translation.y == 0.0);
}

TEST_CASE("background and options are frozen at each render") {
    const ScriptRun run = runScene(kGo + R"(
        n = gr.node('n') go(n, '0.png')
        gr.background({.1,.2,.3}) gr.options{spp = 4, max_depth = 3} go(n, '1.png')
        gr.background({1,0,0}, {0,0,1}) gr.options{filter = 'gaussian'} go(n, '2.png')
        gr.options{error = 0.01} go(n, '3.png'))");
    REQUIRE(run.error == "");
    const auto& renders = run.scene().renders;
    CHECK(renders.at(0).background.top == Color(0));
    CHECK_FALSE(renders[0].options.spp);
    CHECK(renders.at(1).background.bottom == Color(.1, .2, .3));
    CHECK(renders[1].background.top == Color(.1, .2, .3));
    CHECK(renders[1].options.spp == 4);
    CHECK(renders[1].options.maxDepth == 3);
    CHECK_FALSE(renders[1].options.filter);
    CHECK(renders.at(2).background.bottom == Color(1, 0, 0));
    CHECK(renders[2].background.top == Color(0, 0, 1));
    CHECK(renders[2].options.spp == 4);
    CHECK(renders[2].options.filter == "gaussian");
    CHECK_FALSE(renders.at(3).options.spp);
    CHECK(renders[3].options.error == 0.01);
    CHECK(renders[3].options.maxDepth == 3);
}

TEST_CASE("every option of the table is known by its name with underscores") {
    const ScriptRun run = runScene(kGo + R"(
        gr.options{error = '0.01', time = 10, max_spp = 64, reference = true, sampler = 'grid',
                   filter = 'blackman-harris', seed = 7, max_depth = 0, cutoff = 0,
                   smooth_angle = 180, bits = 16, transfer = 'srgb', flip_v = true,
                   caustics = true}
        go(gr.node('n')))");
    REQUIRE(run.error == "");
    const RenderOptions& options = run.scene().renders.at(0).options;
    CHECK(options.error == 0.01);
    CHECK(options.bits == 16);
    CHECK(options.flipV == true);
    CHECK(options.sampler == "grid");
    for (const OptionRow& row : optionTable()) {
        CAPTURE(row.name);
        CHECK(row.load(options).has_value() == (std::string(row.name) != "spp"));
    }
}

TEST_CASE("a wrong option is refused with what would be right") {
    const auto error = [](const std::string& options) {
        return runScene("\ngr.options{" + options + "}").error;
    };
    CHECK(error("max_detph = 3") ==
          "scene.lua:2: gr.options: unknown option 'max_detph'; did you mean 'max_depth'?");
    CHECK(error("widht = 3") == "scene.lua:2: gr.options: unknown option 'widht'");
    CHECK(error("spp = 0") ==
          "scene.lua:2: gr.options: spp must be a whole number in 1 .. 1048576 "
          "(got number 0)");
    CHECK(error("spp = true").find("spp must be a whole number in 1 .. 1048576 (got true)") !=
          std::string::npos);
    CHECK(error("spp = {}").find("spp must be a whole number in 1 .. 1048576 (got table)") !=
          std::string::npos);
    CHECK(error("spp = 1.5").find("(got number 1.5)") != std::string::npos);
    CHECK(error("error = 0/0").find("error must be a number > 0 and <= 1 (got number nan)") !=
          std::string::npos);
    CHECK(error("time = 1/0").find("time must be a number > 0 (got number inf)") !=
          std::string::npos);
    CHECK(error("sampler = 'sobol'")
              .find("sampler must be one of joint, jitter, grid, random (got "
                    "string \"sobol\")") != std::string::npos);
    CHECK(error("flip_v = 1").find("flip_v must be true or false (got number 1)") !=
          std::string::npos);
    CHECK(error("bits = 12").find("bits must be one of 8, 16 (got number 12)") !=
          std::string::npos);
    CHECK(error("spp = 3, error = 0.1").find("spp excludes error and time") != std::string::npos);
    CHECK(error("3").find("options must have names as keys (got number 1)") != std::string::npos);
}

TEST_CASE("a view along up gets another up, with a warning") {
    const auto up = [](const std::string& view, const std::string& given) {
        const ScriptRun run =
            runScene("gr.render(gr.node(''), 'a.png', 4, 4, {0,0,0}, " + view + ", " + given +
                     ", 50, {0,0,0}, {gr.light({0,0,0},{1,1,1},{1,0,0})})");
        REQUIRE(run.error == "");
        CHECK(run.warnings("gr.render: view and up are parallel") == 1);
        return run.scene().renders.at(0).camera.up;
    };
    CHECK(up("{0,-3,0}", "{0,1,0}") == Vec3(0, 0, -1));
    CHECK(up("{0,1,0}", "{0,1e-200,0}") == Vec3(0, 0, 1));
    CHECK(up("{0,0,-1}", "{0,0,1}") == Vec3(1, 0, 0));
    CHECK(up("{1,0,0}", "{2,0,0}") == Vec3(0, 0, -1));
    CHECK(up("{0.1,0.2,0.3}", "{0.3,0.6,0.9}") == Vec3(1, 0, 0));
    CHECK(up("{1e300,1e300,0}", "{1e-300,1e-300,0}") == Vec3(0, 0, 1));
}

TEST_CASE("a steep view is not taken for a parallel one") {
    const ScriptRun run = runScene(
        "gr.render(gr.node(''), 'a.png', 4, 4, {0,0,0}, {1e-9,-1,0}, {0,1,0}, 50, {0,0,0}, "
        "{gr.light({0,0,0},{1,1,1},{1,0,0})})");
    CHECK(run.error == "");
    CHECK(run.diagnostics.total() == 0);
}

TEST_CASE("no lights, no render, and the same file twice are worth a warning") {
    const ScriptRun dark = runScene(
        "gr.render(gr.node(''), 'a.png', 4, 4, {0,0,0}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})");
    CHECK(dark.error == "");
    CHECK(dark.warnings("scene.lua:1: gr.render: there are no lights") == 1);
    const ScriptRun nothing = runScene("-- only a comment");
    CHECK(nothing.error == "");
    CHECK(nothing.warnings("nothing was rendered") == 1);
    const ScriptRun twice = runScene(kGo + "n = gr.node('')\ngo(n) go(n, 'b.png')\ngo(n)");
    CHECK(twice.error == "");
    CHECK(twice.warnings("'a.png' is the name of an earlier render") == 1);
    CHECK(twice.diagnostics.total() == 1);
}

TEST_CASE("a thousand renders are a thousand renders") {
    const ScriptRun run = runScene(kGo +
                                   "n = gr.node('') for i = 1, 1000 do n:translate(1, 0, 0) "
                                   "go(n, 'f' .. i .. '.png') end");
    REQUIRE(run.error == "");
    REQUIRE(run.scene().renders.size() == 1000);
    CHECK(run.scene().nodes[0].at(0).transform.translation.x == 1.0);
    CHECK(run.scene().nodes[0].at(999).transform.translation.x == 1000.0);
}

TEST_CASE("a parameter has the type of its default, and the value of -D") {
    const std::string script = R"(
        n = gr.param('n', 5, {min = 1, max = 100, doc = 'How many.'})
        x = gr.param('x', 0.5) s = gr.param('s', 'red') b = gr.param('b', false) again = gr.param('n', 7)
        gr.node(table.concat({tostring(n), tostring(x), s, tostring(b)}, ' ')))";
    const ScriptRun plain = runScene(script);
    REQUIRE(plain.error == "");
    CHECK(plain.scene().nodes[0].name == "5 0.5 red false");
    const ScriptRun given =
        runScene(script, withParameters({{"n", "12"}, {"x", "-1e3"}, {"s", ""}, {"b", "yes"}}));
    REQUIRE(given.error == "");
    CHECK(given.scene().nodes[0].name == "12 -1000.0  true");
    const auto& list = given.result->parameters;
    REQUIRE(list.size() == 4);
    CHECK(list[0].name == "n");
    CHECK(list[0].value == "12");
    CHECK(list[0].doc == "How many.");
    CHECK(list[0].where.line == 2);
    CHECK(list[3].value == "true");
    CHECK(given.diagnostics.total() == 1);
    const ScriptRun fraction = runScene(script, withParameters({{"n", "2.5"}}));
    CHECK(fraction.scene().nodes[0].name == "2.5 0.5 red false");
}

TEST_CASE("a bad -D value is an error at the line of gr.param") {
    const auto error = [](const std::string& call, const std::string& value) {
        return runScene("\n" + call, withParameters({{"n", value}})).error;
    };
    CHECK(error("gr.param('n', 1)", "abc") ==
          "scene.lua:2: gr.param: -D n=abc must be a finite number");
    for (const char* bad : {"", "1x", "nan", "inf", "1e999", "0x10", " 1", "1,5", "+-1", "+"}) {
        CAPTURE(bad);
        CHECK(error("gr.param('n', 1)", bad).find("must be a finite number") != std::string::npos);
    }
    CHECK(error("gr.param('n', 1)", "+1.5") == "");
    CHECK(error("gr.param('n', 1, {min = 0, max = 2})", "3") ==
          "scene.lua:2: gr.param: -D n=3 must be in 0 .. 2");
    CHECK(error("gr.param('n', true)", "maybe") ==
          "scene.lua:2: gr.param: -D n=maybe must be true or false");
    CHECK(error("gr.param('n', 5, {max = 2})", "1") ==
          "scene.lua:2: gr.param: default must be <= 2 (got 5)");
    CHECK(
        error("gr.param('n', 1, {mim = 2})", "1") ==
        "scene.lua:2: gr.param: unknown option 'mim'; did you mean 'min'? (known: doc, max, min)");
}

TEST_CASE("a -D name that nothing reads is worth a warning") {
    const ScriptRun run =
        runScene("gr.param('count', 1) gr.node('')", withParameters({{"cuont", "3"}}));
    CHECK(run.error == "");
    CHECK(run.warnings("unused parameter -D cuont: no gr.param reads it; did you mean 'count'?") ==
          1);
}

TEST_CASE("the frame and its time are fields of gr") {
    ScriptSettings settings;
    settings.frame = 12;
    settings.time = 0.25;
    CHECK(runScene("assert(gr.frame == 12 and gr.time == 0.25 and "
                   "math.type(gr.frame) == 'integer')",
                   settings)
              .error == "");
    CHECK(runScene("assert(gr.frame == 1 and gr.time == 0)").error == "");
}

TEST_CASE("the script's arguments are in arg and in its dots") {
    ScriptSettings settings;
    settings.arguments = {"one", "two words"};
    CHECK(runScene("assert(#arg == 2 and arg[1] == 'one' and arg[2] == 'two words')\n"
                   "assert(arg[0]:find('scene.lua', 1, true) and select(2, ...) == 'two words')",
                   settings)
              .error == "");
    CHECK(runScene("assert(#arg == 0)").error == "");
}
