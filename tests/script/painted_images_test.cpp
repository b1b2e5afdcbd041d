// Textures that a function of the script paints.
#include "gr_script.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace rt;
using rt::test::runScene;
using rt::test::ScriptRun;

namespace {

const std::string kRender =
    "\ngr.render(gr.node('n'), 'a.png', 100, 50, {0,0,0}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})\n";

ScriptRun painted(const std::string& function, const std::string& side = "") {
    return runScene("\ngr.texture(" + function + ", {0.1,0.2,0.3}, 5" + side + ")" + kRender);
}

const BakedImage& imageOf(const ScriptRun& run) {
    return *run.scene().images.at(run.scene().textures.at(0).image).baked;
}

}  // namespace

TEST_CASE("a function paints the centres of the texels, v upwards") {
    const ScriptRun run = painted("function(u, v) return u, v, 2 end", ", 5");
    REQUIRE(run.error == "");
    CHECK(run.scene().textures.at(0).specular == Color(0.1, 0.2, 0.3));
    CHECK(run.scene().textures.at(0).exponent == 5.0);
    const BakedImage& image = imageOf(run);
    REQUIRE(image.side == 5);
    REQUIRE(image.samples.size() == 75);
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 5; ++column) {
            const float* texel = image.samples.data() + 3 * (5 * row + column);
            CHECK(texel[0] == static_cast<float>((column + 0.5) / 5));
            CHECK(texel[1] == static_cast<float>(1.0 - (row + 0.5) / 5));
            CHECK(texel[2] == 2.0F);
        }
    }
}

TEST_CASE("one number is grey, a table is a colour") {
    const ScriptRun grey = painted("function(u, v) return 0.25 end", ", 1");
    CHECK(imageOf(grey).samples == std::vector<float>{0.25F, 0.25F, 0.25F});
    const ScriptRun table = painted("function(u, v) return {1, 0.5, u} end", ", 1");
    CHECK(imageOf(table).samples == std::vector<float>{1.0F, 0.5F, 0.5F});
}

TEST_CASE("a painting is as fine as what it shows, up to the image's pixels") {
    CHECK(imageOf(painted("function(u, v) return 0.5 end")).side == 64);
    ScriptSettings large;
    large.largestSide = 1000;
    const auto sideOf = [&](const std::string& function) {
        return imageOf(runScene("gr.texture(" + function + ", {0,0,0}, 1)" + kRender, large)).side;
    };
    // Linear interpolation is off by 3/32 h^2 f'' at the next texels: 1/512 for h = 1/62.
    CHECK(sideOf("function(u, v) return 0.5 + 0.5 * math.cos(4 * math.pi * u) end") == 128);
    // At the border, where the outer texel goes on, by h / 4 of the slope.
    CHECK(sideOf("function(u, v) return u, v, 0 end") == 256);
    // A jump stays a jump: a texel for each pixel is all that can be seen.
    const std::string jump = "function(u, v) return u + v < 0.77 and 1 or 0 end";
    CHECK(sideOf(jump) == 1024);
    CHECK(imageOf(painted(jump)).side == 128);
}

TEST_CASE("the function is called when the script has ended") {
    const ScriptRun run = runScene(
        "shade = 0.25\ngr.texture(function() return shade end, {0,0,0}, 1, 1)\nshade = 0.75" +
        kRender);
    CHECK(imageOf(run).samples.front() == 0.75F);
}

TEST_CASE("what a function gives wrong is an error at the line of its texture") {
    CHECK(painted("function(u, v) end", ", 4").error ==
          "scene.lua:2: gr.texture: the function must give three numbers, a table of them or one "
          "number (got nil at u = 0.125, v = 0.875)");
    CHECK(painted("function(u, v) return 1, 2, 'red' end", ", 1").error ==
          "scene.lua:2: gr.texture: the function must give three numbers, a table of them or one "
          "number (got string \"red\" at u = 0.5, v = 0.5)");
    CHECK(painted("function(u, v) return 0/0 end", ", 1").error.find("finite numbers (got nan") !=
          std::string::npos);
    CHECK(painted("function(u, v) return 1e300 end", ", 1").error.find("finite numbers (got") !=
          std::string::npos);
    CHECK(painted("function(u, v)\n return u.x end", ", 1").error.find("scene.lua:3:") == 0);
    CHECK(painted("function(u, v) return 1 end", ", 0").error.find("side must be") !=
          std::string::npos);
    CHECK(painted("function(u, v) return 1 end", ", 8193").error.find("side must be") !=
          std::string::npos);
    const ScriptRun negative = painted("function(u, v) return u - 0.5 end", ", 8");
    CHECK(negative.error == "");
    CHECK(negative.warnings("scene.lua:2: gr.texture: the function gives negative colours") == 1);
    CHECK(imageOf(negative).samples.front() == 0.0F);
}

TEST_CASE("paintings keep the script's limits") {
    ScriptSettings small;
    small.memoryLimit = std::size_t{8} << 20;
    const std::string large = "gr.texture(function() return 1 end, {0,0,0}, 1, 4096)";
    CHECK(runScene(large + kRender, small).code == ExitCode::kLimit);
    ScriptSettings hurried;
    hurried.timeLimit = 0.2;
    const std::string slow = "gr.texture(function() while true do end end, {0,0,0}, 1)";
    CHECK(runScene(slow + kRender, hurried).code == ExitCode::kLimit);
}
