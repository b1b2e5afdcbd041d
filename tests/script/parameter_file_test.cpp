// Files of parameters: what is read, what is refused, and that a list can be read again.
#include "rt/script/parameter_file.h"

#include "gr_script.h"

#include <doctest/doctest.h>

#include <map>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

constexpr std::size_t kMost = 1000;

std::map<std::string, std::string> valuesOf(const std::string& text) {
    const SceneFolder folder;
    std::map<std::string, std::string> values;
    for (const auto& given : readParameterFile(folder.write("a.params", text), kMost)) {
        CHECK(values.emplace(given.name, given.value).second);
    }
    return values;
}

/// The message, less the folder.
std::string refusalOf(const std::string& text) {
    const SceneFolder folder;
    try {
        readParameterFile(folder.write("a.params", text), kMost);
    } catch (const Error& error) {
        const std::string message = error.what();
        return message.substr(message.find("a.params"));
    }
    return "";
}

ScriptRun runWith(const SceneFolder& folder, const std::string& script, const std::string& text,
                  std::map<std::string, std::string> more = {}) {
    ScriptSettings settings;
    settings.parameters = std::move(more);
    settings.parameterFiles = {folder.write("a.params", text)};
    return runScene(folder, script, settings);
}

}  // namespace

TEST_CASE("a line of a parameter file is a name and a value, bare or quoted") {
    const auto values = valuesOf(
        "# a comment = no value\n\n  count =  12 \t\r\nempty=\nname = a = b # c\n"
        "quoted = \" a \\\"b\\\\\\n\\x41\\t\\r \"\n\"n = \\\"x\\\"\" = yes\nlast = 1");
    CHECK(values.size() == 6);
    CHECK(values.at("count") == "12");
    CHECK(values.at("empty").empty());
    CHECK(values.at("name") == "a = b # c");
    CHECK(values.at("quoted") == " a \"b\\\nA\t\r ");
    CHECK(values.at("n = \"x\"") == "yes");
    CHECK(values.at("last") == "1");
    CHECK(valuesOf("").empty());
}

TEST_CASE("what is no such line is refused with its number") {
    CHECK(refusalOf("\ncount 12\n") == "a.params:2: 'count 12' must be name = value");
    CHECK(refusalOf("= 12") == "a.params:1: '= 12' must be name = value");
    CHECK(refusalOf("n = 1\n\nn = 1\n") == "a.params:3: 'n' is set in line 1 already");
    for (const char* bad : {"n = \"a", "n = \"a\" b", "n = \"\\q\"", "n = \"\\x4\"", "n = \"\\"}) {
        CAPTURE(bad);
        CHECK(refusalOf(bad).find("has quotes that do not match or an escape") !=
              std::string::npos);
    }
    CHECK(refusalOf("\"n = 1").find("must be name = value") != std::string::npos);
    CHECK(refusalOf(std::string(kMost, '#')).empty());
    CHECK(refusalOf(std::string(kMost + 1, '#')).find("more than 1000 bytes") != std::string::npos);
}

TEST_CASE("a list of parameters is a file that gives the same values again") {
    const std::vector<ScriptParameter> listed = {
        {"count", "12", "How many\nballs.", {}},
        {"a b", "x = y # z", "", {}},
        {"a=b", "", "", {}},
        {"#", "\"quoted\"", "", {}},
        {"blank", "  x ", "", {}},
        {"lines", "a\nb", "Two\nlines.", {}},
        {"\xc3\xa4", "line\nline\t\\ \xff\x7f", "", {}},
        {"hash", "#fff", "", {}},
    };
    const std::string text = parameterFileText(listed);
    CHECK(text.rfind("# How many\n# balls.\ncount = 12\na b = x = y # z\n", 0) == 0);
    const auto values = valuesOf(text);
    CHECK(values.size() == listed.size());
    for (const ScriptParameter& parameter : listed) {
        CAPTURE(parameter.name);
        CHECK(values.at(parameter.name) == parameter.value);
    }
}

TEST_CASE("a scene reads its parameters from a file, and -D counts more") {
    const SceneFolder folder;
    const std::string script = "gr.node(gr.param('n', 1) .. gr.param('s', 'red'))";
    const ScriptRun run = runWith(folder, script, "n = 3\ns = blue\n", {{"s", "green"}});
    REQUIRE(run.error == "");
    CHECK(run.scene().nodes[0].name == "3green");
    CHECK(run.diagnostics.total() == 1);  // nothing was rendered
    const auto& read = run.result->filesRead;
    CHECK(std::find(read.begin(), read.end(), folder.path() / "a.params") != read.end());
}

TEST_CASE("an unknown name in a file is an error at its line, a bad value one at gr.param") {
    const SceneFolder folder;
    const std::string script = "gr.param('radius', 1)";
    CHECK(runWith(folder, script, "\nradus = 2").error ==
          "a.params:2: unknown parameter 'radus': no gr.param reads it; did you mean "
          "'radius'?");
    const std::string bad = runWith(folder, script, "radius = big").error;
    CHECK(bad.rfind("scene.lua:1: gr.param: radius = big (", 0) == 0);
    CHECK(bad.find("a.params:1) must be a finite number") != std::string::npos);
}

TEST_CASE("a file of parameters that is missing is an error, and among what was looked for") {
    const SceneFolder folder;
    ScriptSettings settings;
    settings.parameterFiles = {(folder.path() / "none.params").string()};
    Diagnostics diagnostics;
    ScriptFiles files;
    const std::string scene = folder.write("scene.lua", "");
    CHECK_THROWS_AS(runScript(scene, settings, diagnostics, &files), SceneError);
    REQUIRE(files.absent.size() >= 1);
    CHECK(files.absent[0] == folder.path() / "none.params");
}
