#include "rt/scene/render_options.h"

#include "rt/core/ray.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <stdexcept>

using namespace rt;

namespace {

const OptionRow& row(const std::string& name) {
    for (const OptionRow& candidate : optionTable()) {
        if (candidate.name == name) return candidate;
    }
    throw std::out_of_range(name);
}

/// A value that the row takes.
OptionValue goodValue(const OptionRow& row) {
    switch (row.kind) {
        case OptionRow::Kind::kFlag:
            return true;
        case OptionRow::Kind::kChoice:
            return row.choices.back();
        default:
            return row.max < kInfinity ? row.max : 1.0;
    }
}

}  // namespace

TEST_CASE("every row stores what it checks, and loads what it stored, and nothing else") {
    for (const OptionRow& one : optionTable()) {
        CAPTURE(one.name);
        RenderOptions options;
        CHECK_FALSE(one.load(options));
        CHECK(checkOption(one, goodValue(one)) == "");
        one.store(options, goodValue(one));
        REQUIRE(one.load(options));
        CHECK(*one.load(options) == goodValue(one));
        int filled = 0;
        for (const OptionRow& other : optionTable()) filled += other.load(options) ? 1 : 0;
        CHECK(filled == 1);
        CHECK(std::string(one.help).size() > 0);
    }
}

TEST_CASE("the rows have names of their own and cover every field") {
    std::set<std::string> names;
    for (const OptionRow& one : optionTable()) names.insert(one.name);
    CHECK(names == std::set<std::string>{"spp", "error", "time", "max-spp", "reference", "caustics",
                                         "sampler", "filter", "seed", "max-depth", "cutoff",
                                         "smooth-angle", "bits", "transfer", "flip-v"});
}

TEST_CASE("values at the ends of a range fit, those beyond do not") {
    CHECK(checkOption(row("spp"), 1.0) == "");
    CHECK(checkOption(row("spp"), 1048576.0) == "");
    CHECK(checkOption(row("spp"), 0.0) == "must be a whole number in 1 .. 1048576");
    CHECK(checkOption(row("spp"), 1048577.0) != "");
    CHECK(checkOption(row("spp"), 1.5) != "");
    CHECK(checkOption(row("seed"), 9007199254740992.0) == "");
    CHECK(checkOption(row("seed"), 9007199254740994.0) ==
          "must be a whole number in 0 .. 9007199254740992");
    CHECK(checkOption(row("seed"), -1.0) != "");
    CHECK(checkOption(row("error"), 0.0) == "must be a number > 0 and <= 1");
    CHECK(checkOption(row("error"), 1e-9) == "");
    CHECK(checkOption(row("error"), 1.0) == "");
    CHECK(checkOption(row("time"), 0.0) == "must be a number > 0");
    CHECK(checkOption(row("time"), 1e9) == "");
    CHECK(checkOption(row("smooth-angle"), 0.0) == "");
    CHECK(checkOption(row("smooth-angle"), 180.5) == "must be a number in 0 .. 180");
    CHECK(checkOption(row("max-depth"), 0.0) == "");
    CHECK(checkOption(row("cutoff"), 0.0) == "");
}

TEST_CASE("no row takes what is not a number, or a value of another type") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const OptionRow& one : optionTable()) {
        CAPTURE(one.name);
        CHECK(checkOption(one, nan) != "");
        CHECK(checkOption(one, kInfinity) != "");
        CHECK(checkOption(one, std::string("sobol")) != "");
        CHECK((checkOption(one, true) == "") == (one.kind == OptionRow::Kind::kFlag));
    }
    CHECK(checkOption(row("sampler"), std::string("grid")) == "");
    CHECK(checkOption(row("sampler"), std::string("")) ==
          "must be one of joint, jitter, grid, random");
    CHECK(checkOption(row("bits"), std::string("16")) == "");
    CHECK(checkOption(row("bits"), 16.0) == "must be one of 8, 16");
    CHECK(checkOption(row("flip-v"), 1.0) == "must be true or false");
}

TEST_CASE("the stronger options win, and their stopping rule replaces the weaker's") {
    RenderOptions weak;
    weak.error = 0.01;
    weak.time = 5.0;
    weak.maxDepth = 3;
    weak.bits = 16;
    weak.flipV = true;
    RenderOptions strong;
    CHECK(strong.over(weak).error == 0.01);
    CHECK(strong.over(weak).time == 5.0);
    strong.maxDepth = 7;
    strong.flipV = false;
    RenderOptions merged = strong.over(weak);
    CHECK(merged.maxDepth == 7);
    CHECK(merged.bits == 16);
    CHECK(merged.flipV == false);
    CHECK(merged.error == 0.01);
    strong.time = 1.0;
    merged = strong.over(weak);
    CHECK(merged.time == 1.0);
    CHECK_FALSE(merged.error);
    CHECK_FALSE(merged.spp);
    strong = {};
    strong.spp = 4;
    merged = strong.over(weak);
    CHECK(merged.spp == 4);
    CHECK_FALSE(merged.error);
    CHECK_FALSE(merged.time);
    weak = {};
    weak.spp = 9;
    strong = {};
    strong.error = 0.1;
    CHECK_FALSE(strong.over(weak).spp);
}

TEST_CASE("the nearest name is within a third of the word's length in edits") {
    const std::vector<std::string> known{"sphere", "scale", "threads", "max_depth", "spp", "width"};
    CHECK(nearestName("sphear", known) == "sphere");
    CHECK(nearestName("treads", known) == "threads");
    CHECK(nearestName("widht", known) == "width");
    CHECK(nearestName("wdith", known) == "width");
    CHECK(nearestName("scal", known) == "scale");
    CHECK(nearestName("maxdepth", known) == "max_depth");
    CHECK(nearestName("max_detph", known) == "max_depth");
    CHECK(nearestName("sp", known) == "spp");
    CHECK(nearestName("sphere", known) == "sphere");
    CHECK(nearestName("cube", known) == "");
    CHECK(nearestName("heap", known) == "");
    CHECK(nearestName("spXXXX", known) == "");
    CHECK(nearestName("sphXXe", known) == "sphere");
    CHECK(nearestName("x", known) == "");
    CHECK(nearestName("", known) == "");
    CHECK(nearestName("sphere", {}) == "");
    CHECK(nearestName(std::string(1000000, 's'), known) == "");
}

TEST_CASE("of equally near names the first is taken, of all the nearest") {
    CHECK(nearestName("cat", {"bat", "cot"}) == "bat");
    CHECK(nearestName("rotates", {"rotated!", "rotate"}) == "rotate");
}
