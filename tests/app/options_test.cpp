#include "rt/app/options.h"

#include "rt/core/error.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;

namespace {

using Words = std::vector<std::string>;

/// The exit code and message that a command line is refused with; code 0 if it is accepted.
struct Refusal {
    int code = 0;
    std::string message;
};

Refusal refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return {static_cast<int>(error.code()), error.what()};
    }
    return {};
}

Refusal refusal(const Words& words) {
    return refusal([&] { parseOptions(words); });
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Each run of blanks and line ends as one space.
std::string unbroken(const std::string& text) {
    std::istringstream words(text);
    std::string all;
    for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
    return all;
}

std::string join(const Words& words) {
    std::string all;
    for (const std::string& word : words) all += word + " ";
    return all;
}

}  // namespace

TEST_CASE("Without arguments the scene is project.lua, and everything else is left open") {
    const Options o = parseOptions({});
    CHECK(o.command == Command::kRender);
    CHECK(o.scenes == Words{"project.lua"});
    CHECK(o.defaultScene);
    CHECK(o.scriptArguments.empty());
    CHECK_FALSE(o.output);
    CHECK_FALSE(o.render.spp);
    CHECK(o.threads == 0);
    CHECK(o.scriptMemory == 2147483648u);
    CHECK(o.color == ColorMode::kAuto);
}

TEST_CASE("Every option reaches its field") {
    struct Case {
        Words words;
        std::function<bool(const Options&)> reached;
    };
    const std::vector<Case> cases = {
        {{"-o", "a.png"}, [](const Options& o) { return o.output == "a.png"; }},
        {{"-o", "-"}, [](const Options& o) { return o.output == "-"; }},
        {{"-oa.png"}, [](const Options& o) { return o.output == "a.png"; }},
        {{"-o", "a b\n[c].png"}, [](const Options& o) { return o.output == "a b\n[c].png"; }},
        {{"-o", "[x]"}, [](const Options& o) { return o.output == "[x]"; }},
        {{"-o", "\"q\""}, [](const Options& o) { return o.output == "\"q\""; }},
        {{"-o", "-odd.png"}, [](const Options& o) { return o.output == "-odd.png"; }},
        {{"-o", "a", "-o", "b"}, [](const Options& o) { return o.output == "b"; }},
        {{"--size", "640x48"},
         [](const Options& o) { return o.size->width == 640 && o.size->height == 48; }},
        {{"--size=1x2147483647"}, [](const Options& o) { return o.size->height == 2147483647; }},
        {{"--crop", "-3,1,20,4"},
         [](const Options& o) {
             return o.crop->x0 == -3 && o.crop->y0 == 1 && o.crop->x1 == 20 && o.crop->y1 == 4;
         }},
        {{"-j", "4"}, [](const Options& o) { return o.threads == 4; }},
        {{"-j4"}, [](const Options& o) { return o.threads == 4; }},
        {{"--threads=1024"}, [](const Options& o) { return o.threads == 1024; }},
        {{"-j", "4", "--threads", "0"}, [](const Options& o) { return o.threads == 0; }},
        {{"-D", "n=3"}, [](const Options& o) { return o.parameters.at("n") == "3"; }},
        {{"-Dn=3", "-D", "n=a=b", "-D", "m="},
         [](const Options& o) {
             return o.parameters.at("n") == "a=b" && o.parameters.at("m").empty() &&
                    o.parameters.size() == 2;
         }},
        {{"--param-file", "a", "--param-file", "b"},
         [](const Options& o) {
             return o.parameterFiles == Words{"a", "b"};
         }},
        {{"--pixel", "3,0"}, [](const Options& o) { return o.pixel->x == 3 && o.pixel->y == 0; }},
        {{"--frames", "3-12"},
         [](const Options& o) { return o.frames->first == 3 && o.frames->last == 12; }},
        {{"--subset", "4", "--frames", "3-12"},
         [](const Options& o) {
             return o.frames->last == 12 && o.subset->first == 4 && o.subset->last == 4;
         }},
        {{"--frames", "7"},
         [](const Options& o) { return o.frames->first == 7 && o.frames->last == 7; }},
        {{"--frames", "1-1000000"}, [](const Options& o) { return o.frames->last == 1000000; }},
        {{"--shard", "2/5"},
         [](const Options& o) { return o.shard->index == 2 && o.shard->count == 5; }},
        {{"--resume"},
         [](const Options& o) { return o.resume == Resume::kIfSound && !o.checkpointEvery; }},
        {{"--resume=require"}, [](const Options& o) { return o.resume == Resume::kRequired; }},
        {{"--resume", "--resume=false"}, [](const Options& o) { return o.resume == Resume::kNo; }},
        {{"--checkpoint", "0.5"}, [](const Options& o) { return o.checkpointEvery == 0.5; }},
        {{"--aov", "uv,depth,uv"},
         [](const Options& o) {
             return o.aovs == std::vector{Aov::kDepth, Aov::kUv};
         }},
        {{"--stats", "s.json"}, [](const Options& o) { return o.stats == "s.json"; }},
        {{"--deps", "s.d"}, [](const Options& o) { return o.deps == "s.d"; }},
        {{"--watch"}, [](const Options& o) { return o.watch && !o.preview; }},
        {{"--preview"}, [](const Options& o) { return o.preview && o.previewPort == 8318; }},
        {{"--preview-port", "0"}, [](const Options& o) { return o.previewPort == 0; }},
        {{"--explain"}, [](const Options& o) { return o.explain; }},
        {{"--check"}, [](const Options& o) { return o.check; }},
        {{"--trust"}, [](const Options& o) { return o.trust; }},
        {{"--trust=false"}, [](const Options& o) { return !o.trust; }},
        {{"--script-memory", "64M"}, [](const Options& o) { return o.scriptMemory == 67108864; }},
        {{"--script-memory", "1024K"}, [](const Options& o) { return o.scriptMemory == 1048576; }},
        {{"--script-memory", "3G"}, [](const Options& o) { return o.scriptMemory == 3221225472; }},
        {{"--script-memory", "1048577"},
         [](const Options& o) { return o.scriptMemory == 1048577; }},
        {{"--script-time", "0.5"}, [](const Options& o) { return o.scriptTime == 0.5; }},
        {{"--max-pixels", "10"}, [](const Options& o) { return o.maxPixels == 10; }},
        {{"--max-instances", "11"}, [](const Options& o) { return o.maxInstances == 11; }},
        {{"--legacy-transforms"}, [](const Options& o) { return o.legacyTransforms; }},
        {{"--werror"}, [](const Options& o) { return o.werror; }},
        {{"--list-params"}, [](const Options& o) { return o.listParams; }},
        {{"--fail-fast"}, [](const Options& o) { return o.failFast; }},
        {{"--isa", "avx2"}, [](const Options& o) { return o.isa == "avx2"; }},
        {{"-q"}, [](const Options& o) { return o.quiet && !o.verbose; }},
        {{"-qv"}, [](const Options& o) { return o.quiet && o.verbose; }},
        {{"-v"}, [](const Options& o) { return o.verbose && !o.quiet; }},
        {{"--print", "man"},
         [](const Options& o) { return o.command == Command::kPrint && o.document == "man"; }},
        {{"--color", "never"}, [](const Options& o) { return o.color == ColorMode::kNever; }},
        {{"--color=always"}, [](const Options& o) { return o.color == ColorMode::kAlways; }},
        {{"--help"}, [](const Options& o) { return o.command == Command::kHelp; }},
        {{"--version"}, [](const Options& o) { return o.command == Command::kVersion; }},
        {{"--spp", "16"}, [](const Options& o) { return o.render.spp == 16; }},
        {{"--error", ".5e-2"}, [](const Options& o) { return o.render.error == 0.005; }},
        {{"--seed", "9007199254740992"},
         [](const Options& o) { return o.render.seed == 9007199254740992.0; }},
        {{"--filter", "mitchell"}, [](const Options& o) { return o.render.filter == "mitchell"; }},
        {{"--bits", "16"}, [](const Options& o) { return o.render.bits == 16; }},
        {{"--flip-v"}, [](const Options& o) { return o.render.flipV == true; }},
        {{"--flip-v=false"}, [](const Options& o) { return o.render.flipV == false; }},
    };
    std::set<std::string> tried;
    for (const Case& c : cases) {
        CAPTURE(join(c.words));
        CHECK(c.reached(parseOptions(c.words)));
        tried.insert(c.words[0].substr(0, c.words[0].find('=')));
    }
    for (const OptionHelp& row : optionHelp()) {
        const bool shared =
            holds(row.section, "Quality") || row.section == "Compare" || row.section == "Golden";
        const std::string name = row.flags.substr(0, row.flags.find(','));
        CAPTURE(name);
        if (!shared && name != "-h") CHECK(tried.count(name) == 1);
    }
}

TEST_CASE("Every shared option of the table is a flag of the command line") {
    for (const OptionRow& row : optionTable()) {
        CAPTURE(row.name);
        Words words{"--" + std::string(row.name)};
        OptionValue expected = true;
        if (row.kind == OptionRow::Kind::kChoice) {
            words.push_back(row.choices.back());
            expected = row.choices.back();
        } else if (row.kind != OptionRow::Kind::kFlag) {
            words.push_back("1");
            expected = 1.0;
        }
        const auto loaded = row.load(parseOptions(words).render);
        REQUIRE(loaded);
        CHECK(*loaded == expected);
    }
}

TEST_CASE("Nonsense is refused with exit code 2 and words that say what would be right") {
    struct Case {
        Words words;
        std::string said;
    };
    const std::vector<Case> cases = {
        {{"--treads", "4"}, "unknown option --treads; did you mean --threads?"},
        {{"--treads=4"}, "did you mean --threads?"},
        {{"--szie", "4x4"}, "did you mean --size?"},
        {{"--max-sp", "4"}, "did you mean --max-spp?"},
        {{"--qqqqqqqq"}, "--help lists all options"},
        {{"-Z"}, "unknown option -Z"},
        {{"--isa", "avx"}, "must be one of baseline, avx2, avx512; did you mean avx2?"},
        {{"--print", "mna"}, "did you mean man?"},
        {{"-qZ"}, "unknown option -Z"},
        {{"a.lua", "-5"}, "unknown option -5"},
        {{"--esc\x1b[31m"}, "unknown option --esc"},
        {{"--threads", "-1"}, "in 0 .. 1024"},
        {{"--threads", "abc"}, "in 0 .. 1024"},
        {{"--threads", "1e9"}, "in 0 .. 1024"},
        {{"--threads", "1025"}, "in 0 .. 1024"},
        {{"--threads", "2.0"}, "in 0 .. 1024"},
        {{"--threads", " 2"}, "in 0 .. 1024"},
        {{"--threads", ""}, "in 0 .. 1024"},
        {{"--threads"}, "--threads"},
        {{"-o"}, "-o"},
        {{"-o", ""}, "empty"},
        {{"--stats="}, "--stats"},
        {{"--deps="}, "--deps"},
        {{"--watch", "-"}, "standard input"},
        {{"--watch", "-o", "-"}, "standard output"},
        {{"--resume", "-o", "-"}, "standard output"},
        {{"--resume", "--watch"}, "--watch"},
        {{"--checkpoint", "5", "--preview"}, "--preview"},
        {{"--resume", "--time", "5"}, "--time"},
        {{"--resume=maybe"}, "true, false, require"},
        {{"--checkpoint", "-1"}, "a number >= 0"},
        {{"--preview-port", "65536"}, "--preview-port"},
        {{"--preview-port", "-1"}, "--preview-port"},
        {{"-o", "--spp", "4"}, "-o needs a value, FILE, before --spp"},
        {{"--size", "0x10"}, "WxH"},
        {{"--size", "-5x10"}, "WxH"},
        {{"--size", "10x"}, "WxH"},
        {{"--size", "x10"}, "WxH"},
        {{"--size", "1e3x2"}, "WxH"},
        {{"--size", "10X10"}, "WxH"},
        {{"--size", "10x10x10"}, "WxH"},
        {{"--size", "10 x10"}, "WxH"},
        {{"--size", "2147483648x1"}, "WxH"},
        {{"--size", "99999999999999999999x1"}, "WxH"},
        {{"--crop", "0,0,10"}, "x0,y0,x1,y1"},
        {{"--crop", "0,0,nan,10"}, "x0,y0,x1,y1"},
        {{"--crop", "0,0,1.5,10"}, "x0,y0,x1,y1"},
        {{"--crop", "0,0,10,10,"}, "x0,y0,x1,y1"},
        {{"--crop", "10,0,0,10"}, "x0 < x1"},
        {{"--crop", "0,10,10,10"}, "x0 < x1"},
        {{"-D", "n"}, "name=value"},
        {{"-D", "=3"}, "name=value"},
        {{"--frames", "10-1"}, "A <= B"},
        {{"--frames", "1-1e12"}, "A <= B"},
        {{"--frames", "a-b"}, "A <= B"},
        {{"--frames", "-1-5"}, "A <= B"},
        {{"--frames", "1-2-3"}, "A <= B"},
        {{"--script-memory", "2T"}, "512M"},
        {{"--script-memory", "1.5G"}, "512M"},
        {{"--script-memory", "G"}, "512M"},
        {{"--script-memory", "0"}, "512M"},
        {{"--script-memory", "-1"}, "512M"},
        {{"--script-memory", "17179869184G"}, "512M"},
        {{"--script-memory", "17179869185G"}, "512M"},
        {{"--script-time", "-1"}, ">= 0"},
        {{"--script-time", "nan"}, ">= 0"},
        {{"--script-time", "inf"}, ">= 0"},
        {{"--max-pixels", "0"}, "whole number"},
        {{"--isa", "sse"}, "baseline, avx2, avx512"},
        {{"--color", "yes"}, "auto, always, never"},
        {{"--trust=perhaps"}, "true, false"},
        {{"--spp", "0"}, "--spp 0: must be a whole number"},
        {{"--spp", "1.5"}, "must be a whole number"},
        {{"--error", "0"}, "must be a number"},
        {{"--error", "0,003"}, "must be a number"},
        {{"--error", "0x1p-3"}, "must be a number"},
        {{"--error", "nan"}, "must be a number"},
        {{"--time", "inf"}, "must be a number"},
        {{"--seed", "-1"}, "must be a whole number"},
        {{"--bits", "12"}, "8, 16"},
        {{"--filter", "Box"}, "one of box"},
        {{"--flip-v=maybe"}, "true or false"},
        {{"--spp", "4", "--error", "0.01"}, "--error"},
        {{"--time", "4", "--spp", "4"}, "--time"},
        {{"compare", "a.png"}, "two images"},
        {{"compare", "a.png", "b.png", "c.png"}, "two images"},
        {{"compare", "a.png", "b.png", "--tolerance", "-1"}, ">= 0"},
        {{"compare", "a.png", "b.png", "--tolerance", "nan"}, ">= 0"},
        {{"compare", "a.png", "b.png", "--tolerence", "1"}, "did you mean --tolerance?"},
        {{"compare", "a.png", "b.png", "--spp", "1"}, "unknown option --spp"},
        {{"golden"}, "one folder"},
        {{"golden", "a", "b"}, "one folder"},
        {{"golden", "a", "--tier", "loose"}, "exact, portable, statistical"},
        {{"golden", "a", "--report", ""}, "--report"},
        {{"golden", "a", "-o", "x.png"}, "unknown option -o"},
        {{"golden", "a", "--updat"}, "did you mean --update?"},
        {{"golden", "a", "--spp", "1", "--time", "1"}, "--time"},
    };
    for (const Case& c : cases) {
        CAPTURE(join(c.words));
        const Refusal refused = refusal(c.words);
        CAPTURE(refused.message);
        CHECK(refused.code == 2);
        CHECK(holds(refused.message, c.said));
        CHECK_FALSE(holds(refused.message, "\x1b"));
    }
}

TEST_CASE("Too many frames are a limit, not a mistake of usage") {
    CHECK(refusal(Words{"--frames", "1-1000001"}).code == 4);
    CHECK(refusal(Words{"--frames", "0-9007199254740992"}).code == 4);
}

TEST_CASE("Error and time go together; spp alone goes with neither") {
    const Options o = parseOptions({"--error", "0.01", "--time", "5", "--max-spp", "64"});
    CHECK(o.render.error == 0.01);
    CHECK(o.render.time == 5.0);
    CHECK(parseOptions({"--spp", "4", "--max-spp", "64"}).render.spp == 4);
}

TEST_CASE("Scenes and script arguments keep their order and every byte") {
    const Options o = parseOptions(
        {"a b.lua", "--spp", "4", "-", "\xc3\xa4\n.lua", "[c].lua", "--", "-x", "--", "--spp", ""});
    CHECK(o.scenes == Words{"a b.lua", "-", "\xc3\xa4\n.lua", "[c].lua"});
    CHECK_FALSE(o.defaultScene);
    CHECK(o.scriptArguments == Words{"-x", "--", "--spp", ""});
    CHECK(parseOptions({"./-odd.lua"}).scenes == Words{"./-odd.lua"});
    CHECK(parseOptions({"--", "-x"}).scenes == Words{"project.lua"});
    CHECK(parseOptions({"./compare"}).command == Command::kRender);
    CHECK(parseOptions({"a.lua", "compare"}).command == Command::kRender);
}

TEST_CASE("Golden takes a folder, its own options, and those of a render that name no file") {
    const Options plain = parseOptions({"golden", "scenes"});
    CHECK(plain.command == Command::kGolden);
    CHECK(plain.golden.folder == "scenes");
    CHECK_FALSE(plain.golden.update);
    CHECK(plain.golden.tier == GoldenTier::kPortable);
    CHECK(plain.golden.report == "golden_report");
    const Options all =
        parseOptions({"golden", "--update", "--tier", "exact", "--report", "r", "-D", "a=1",
                      "--spp", "4", "-j", "2", "--size", "8x6", "-q", "scenes", "--", "-x"});
    CHECK(all.golden.folder == "scenes");
    CHECK(all.scriptArguments == Words{"-x"});
    CHECK(all.golden.update);
    CHECK(all.golden.tier == GoldenTier::kExact);
    CHECK(all.golden.report == "r");
    CHECK(all.parameters.at("a") == "1");
    CHECK(all.render.spp == 4);
    CHECK(all.threads == 2);
    CHECK(all.size->width == 8);
    CHECK(all.quiet);
    CHECK(parseOptions({"golden", "a", "--tier", "statistical"}).golden.tier ==
          GoldenTier::kStatistical);
    CHECK(parseOptions({"golden", "--help"}).command == Command::kHelp);
    CHECK(parseOptions({"./golden"}).command == Command::kRender);
}

TEST_CASE("Compare takes two files and a tolerance, and names with a dash after --") {
    const Options o = parseOptions({"compare", "a.png", "--tolerance", "0.01", "b.png"});
    CHECK(o.command == Command::kCompare);
    CHECK(o.compare.first == "a.png");
    CHECK(o.compare.second == "b.png");
    CHECK(o.compare.tolerance == 0.01);
    CHECK_FALSE(parseOptions({"compare", "a", "b"}).compare.tolerance);
    CHECK(parseOptions({"compare", "--help"}).command == Command::kHelp);
}

TEST_CASE("Numbers have a decimal point in every locale") {
    const char* locale = nullptr;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
        if (!locale) locale = std::setlocale(LC_ALL, name);
    }
    CHECK(parseOptions({"--error", "0.25"}).render.error == 0.25);
    CHECK(refusal(Words{"--error", "0,25"}).code == 2);
    std::setlocale(LC_ALL, "C");
}

TEST_CASE("A crop is clipped to the image, and refused when nothing of it is inside") {
    const auto same = clipped({1, 2, 3, 4}, 10, 10);
    CHECK_FALSE(same.second);
    CHECK(same.first.x0 == 1);
    CHECK(same.first.y1 == 4);
    const auto less = clipped({-5, 5, 30, 40}, 20, 10);
    CHECK(less.second);
    CHECK(less.first.x0 == 0);
    CHECK(less.first.y0 == 5);
    CHECK(less.first.x1 == 20);
    CHECK(less.first.y1 == 10);
    CHECK_FALSE(clipped({0, 0, 20, 10}, 20, 10).second);
    for (const Crop& outside :
         {Crop{20, 0, 30, 10}, Crop{0, 10, 5, 20}, Crop{-5, 0, 0, 5}, Crop{0, -5, 5, 0}}) {
        CHECK(refusal([&] { clipped(outside, 20, 10); }).code == 2);
    }
}

TEST_CASE("A missing default scene is a scene error that names it and hints at the usage") {
    const auto before = std::filesystem::current_path();
    std::string folder = (std::filesystem::temp_directory_path() / "options-XXXXXX").string();
    REQUIRE(::mkdtemp(folder.data()) != nullptr);
    std::filesystem::current_path(folder);
    const Refusal refused = refusal([] { requireDefaultScene(parseOptions({})); });
    CHECK(refused.code == 1);
    CHECK(holds(refused.message, "project.lua: No such file"));
    CHECK(holds(refused.message, "Usage: ./Project"));
    CHECK(refusal([] { requireDefaultScene(parseOptions({"other.lua"})); }).code == 0);
    std::ofstream("project.lua") << "";
    CHECK(refusal([] { requireDefaultScene(parseOptions({})); }).code == 0);
    std::filesystem::current_path(before);
    std::filesystem::remove_all(folder);
}

TEST_CASE("--help lists every option within 100 columns") {
    const std::string help = helpText();
    for (const OptionHelp& row : optionHelp()) {
        CAPTURE(row.flags);
        CHECK(holds(help, row.flags + (row.valueName.empty() ? "" : " " + row.valueName)));
        CHECK(holds(unbroken(help), row.text));
        CHECK_FALSE(row.text.empty());
    }
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        CHECK(line.size() <= 100);
    }
}

TEST_CASE("The documentation has a row for every option, and no row for any other") {
    std::ifstream file("Documentation/command_line.md");
    REQUIRE_MESSAGE(file, "run from the top folder");
    std::set<std::string> documented;
    for (std::string line; std::getline(file, line);) {
        if (line.compare(0, 4, "| `-") != 0) continue;
        documented.insert(line.substr(2, line.find(" |", 2) - 2));
    }
    std::set<std::string> known;
    for (const OptionHelp& row : optionHelp()) {
        const std::string value = row.valueName.empty() ? "" : " " + row.valueName;
        std::string cell;
        std::istringstream flags(row.flags);
        for (std::string flag; std::getline(flags, flag, ',');) {
            flag.erase(0, flag.find('-'));
            cell += (cell.empty() ? "`" : ", `") + flag + value + "`";
        }
        known.insert(cell);
    }
    for (const std::string& cell : known) {
        CAPTURE(cell);
        CHECK(documented.count(cell) == 1);
    }
    for (const std::string& cell : documented) {
        CAPTURE(cell);
        CHECK(known.count(cell) == 1);
    }
}
