#include "rt/app/stats.h"

#include "rt/core/error.h"
#include "rt/core/version.h"

#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using namespace rt;
using nlohmann::json;

namespace {

RenderStats sample() {
    RenderStats s;
    s.scene = "scene.lua";
    s.output = "a.png";
    s.width = 640;
    s.height = 480;
    s.threads = 2;
    s.seed = 9007199254740992;
    s.sppMean = 4.5;
    s.sppMin = 4;
    s.sppMax = 64;
    s.errorEstimate = 0.00297;
    s.errorTarget = 0.003;
    s.converged = true;
    s.triangles = 1;
    s.primitives = 2;
    s.instances = 3;
    s.lights = 4;
    s.buildSeconds = 0.5;
    s.renderSeconds = 0.1;
    s.cpuSeconds = 0.25;
    s.peakRssBytes = 5;
    s.rays = {6, 7, 8, 9};
    s.cutPaths = 10;
    s.cutErrorBound = 1e-9;
    s.caustics = {0.25, 0.125, 14, 15, 16, 0.75, 0.375, true};
    s.passes = {{12, std::nullopt, 0.05}, {13, 0.00297, 0.1}};
    s.features = {"texture", "focal"};
    s.skipped = {{"bump", "no \"uv\""}};
    s.warnings = 11;
    return s;
}

}  // namespace

TEST_CASE("Every key of the contract is there with its value, and no other") {
    const json all = json::parse(statsJson({sample()}));
    CHECK(all["version"] == kProgramVersion);
    REQUIRE(all["renders"].size() == 1);
    const json expected = json::parse(R"({
        "scene": "scene.lua", "output": "a.png", "width": 640, "height": 480, "threads": 2,
        "seed": 9007199254740992, "spp_mean": 4.5, "spp_min": 4, "spp_max": 64,
        "error_estimate": 0.00297, "error_target": 0.003, "converged": true,
        "caustics": {"noise": 0.25, "bias": 0.125, "photons_sent": 14, "photons_kept": 15,
                     "passes": 16, "first_radius": 0.75, "last_radius": 0.375}, "triangles": 1,
        "primitives": 2, "instances": 3, "lights": 4, "build_seconds": 0.5, "render_seconds": 0.1,
        "cpu_seconds": 0.25, "peak_rss_bytes": 5,
        "rays": {"camera": 6, "shadow": 7, "reflection": 8, "refraction": 9}, "cut_paths": 10,
        "cut_error_bound": 1e-9,
        "passes": [{"samples": 12, "error_estimate": null, "seconds": 0.05},
                   {"samples": 13, "error_estimate": 0.00297, "seconds": 0.1}],
        "features": ["texture", "focal"],
        "skipped": [{"what": "bump", "why": "no \"uv\""}], "warnings": 11})");
    CHECK(all["renders"][0] == expected);
}

TEST_CASE("What was not measured is null, and lists may be empty") {
    RenderStats s;
    s.cutErrorBound = std::numeric_limits<double>::infinity();
    const json all = json::parse(statsJson({s, s}));
    REQUIRE(all["renders"].size() == 2);
    const json& one = all["renders"][1];
    CHECK(one["error_estimate"].is_null());
    CHECK(one["error_target"].is_null());
    CHECK(one["cut_error_bound"].is_null());
    CHECK(one["features"] == json::array());
    CHECK(one["skipped"] == json::array());
    CHECK(json::parse(statsJson({}))["renders"] == json::array());
}

TEST_CASE("Names of any bytes give valid JSON") {
    RenderStats s;
    s.scene = "a\xff\"\n\x1b.lua";
    const json all = json::parse(statsJson({s}));
    CHECK(all["renders"][0]["scene"] == "a\xef\xbf\xbd\"\n\x1b.lua");
}

TEST_CASE("The file is the text, and a file that cannot be written is an output error") {
    const std::string path =
        (std::filesystem::temp_directory_path() / "stats_test_folder" / "s.json").string();
    CHECK(writeStats(path, {sample()}).empty());
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    CHECK(text == statsJson({sample()}));
    std::filesystem::remove_all(std::filesystem::path(path).parent_path());
    CHECK_THROWS_AS(writeStats("/proc/s.json", {sample()}), OutputError);
}

TEST_CASE("Memory and processor time are those of this process") {
    const std::uint64_t before = peakResidentBytes();
    std::vector<char> block(64 << 20, 1);
    CHECK(peakResidentBytes() >= before);
    CHECK(peakResidentBytes() >= block.size());
    CHECK(peakResidentBytes() < (std::uint64_t{1} << 40));
    CHECK(block.back() == 1);
    const double start = processCpuSeconds();
    const auto began = std::chrono::steady_clock::now();
    const auto waited = [&] { return std::chrono::steady_clock::now() - began; };
    while (processCpuSeconds() - start < 0.02 && waited() < std::chrono::seconds(30)) {
    }
    const double used = processCpuSeconds() - start;
    CHECK(used >= 0.02);
    CHECK(used < 1.0);
}

TEST_CASE("The documentation names every key") {
    std::ifstream file("Documentation/command_line.md");
    REQUIRE_MESSAGE(file, "run from the top folder");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const json stats = json::parse(statsJson({sample()}))["renders"][0];
    for (const auto& [key, value] : stats.items()) {
        CAPTURE(key);
        CHECK(text.find("`" + key + "`") != std::string::npos);
    }
}
