// The reference describes what the table holds: every call and field, each form of it, no other.
#include "../../src/script/call_table.h"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <set>

using namespace rt;

namespace {

/// The text of each section "### gr.name" of the reference.
std::map<std::string, std::string> sections() {
    std::ifstream in("Documentation/scene_language.md");
    REQUIRE(in);
    std::map<std::string, std::string> all;
    std::string name;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("#", 0) == 0) name.clear();
        if (line.rfind("### gr.", 0) == 0) {
            name = line.substr(7);
            CHECK(all.count(name) == 0);
            all[name] = "";
        } else if (!name.empty()) {
            all[name] += line + "\n";
        }
    }
    return all;
}

}  // namespace

TEST_CASE("every row of the call table has a section of the reference, and the other way round") {
    std::set<std::string> documented, known;
    for (const auto& section : sections()) documented.insert(section.first);
    for (const CallRow& row : callTable()) known.insert(row.name);
    for (const FieldRow& row : fieldTable()) known.insert(row.name);
    CHECK(documented == known);
}

TEST_CASE("a section shows every form of its call, and no other") {
    for (const CallRow& row : callTable()) {
        CAPTURE(row.name);
        const std::string text = sections()[row.name];
        std::size_t shown = 0;
        for (std::size_t at = 0; (at = text.find("\n    ", at)) != std::string::npos; ++at) ++shown;
        CHECK(shown == row.forms.size());
        for (const CallForm& form : row.forms) {
            const std::string usage = "    " + usageText(row, form) + "\n";
            CAPTURE(usage);
            CHECK(text.find(usage) != std::string::npos);
        }
    }
}

TEST_CASE("the section of gr.options lists the option table") {
    const std::string text = sections()["options"];
    std::size_t rows = 0;
    for (const OptionRow& row : optionTable()) {
        std::string name = row.name;
        for (char& c : name) c = c == '-' ? '_' : c;
        CAPTURE(name);
        CHECK(text.find("\n| `" + name + "` |") != std::string::npos);
    }
    for (std::size_t at = 0; (at = text.find("\n| `", at)) != std::string::npos; ++at) ++rows;
    CHECK(rows == optionTable().size());
}

TEST_CASE("every call and parameter says in a sentence what it is") {
    std::set<std::string> names;
    for (const CallRow& row : callTable()) {
        CAPTURE(row.name);
        CHECK(names.insert(row.name).second);
        CHECK(std::string(row.doc).back() == '.');
        REQUIRE_FALSE(row.forms.empty());
        CHECK((row.forms.back().fits == nullptr));
        for (const CallForm& form : row.forms) {
            CHECK(form.parameters.size() <= Call::kMostParameters);
            bool optionalBefore = false;
            for (const Parameter& parameter : form.parameters) {
                CAPTURE(parameter.name);
                CHECK(std::string(parameter.doc).back() == '.');
                CHECK((parameter.optional || !optionalBefore));
                optionalBefore = parameter.optional;
            }
        }
    }
}
