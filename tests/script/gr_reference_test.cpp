// The reference describes what the table holds: every call and field, each form of it, no other.
#include "../../src/script/call_table.h"

#include "gr_script.h"
#include "rt/script/language_documents.h"

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

/// A call of each row, for what it returns.
const std::map<std::string, std::string>& sampleCalls() {
    static const std::map<std::string, std::string> calls = {
        {"node", "gr.node('a')"},
        {"joint", "gr.joint('a', {0, 1, 2}, {0, 1, 2})"},
        {"rotate", "gr.rotate(ball, 'x', 1)"},
        {"translate", "ball:translate(1, 2, 3)"},
        {"move", "ball:move(1, 2, 3)"},
        {"spin", "ball:spin('y', 30)"},
        {"scale", "ball:scale(1, 2, 3)"},
        {"add_child", "group:add_child(ball)"},
        {"sphere", "gr.sphere('a')"},
        {"cube", "gr.cube('a')"},
        {"cylinder", "gr.cylinder('a')"},
        {"cone", "gr.cone('a')"},
        {"torus", "gr.torus('a')"},
        {"hemisphere", "gr.hemisphere('a')"},
        {"disc", "gr.disc('a')"},
        {"quad", "gr.quad('a')"},
        {"plane", "gr.plane('a')"},
        {"nh_hemisphere", "gr.nh_hemisphere('a', {0, 0, 0}, 1)"},
        {"nh_frustum", "gr.nh_frustum('a', {0, 0, 0}, 1, 1, 2)"},
        {"quadric", "gr.quadric('a', {xx = 1, zz = 1, y = -1}, {-1, 0, -1}, {1, 2, 1})"},
        {"nh_disc", "gr.nh_disc('a', {0, 0, 0}, {0, 1, 0}, 1)"},
        {"nh_quad", "gr.nh_quad('a', {0, 0, 0}, {1, 0, 0}, {0, 1, 0})"},
        {"nh_plane", "gr.nh_plane('a', {0, 0, 0}, {0, 1, 0})"},
        {"nh_sphere", "gr.nh_sphere('a', {0, 0, 0}, 1)"},
        {"nh_box", "gr.nh_box('a', {0, 0, 0}, 1)"},
        {"nh_cylinder", "gr.nh_cylinder('a', {0, 0, 0}, 1, 1)"},
        {"nh_cone", "gr.nh_cone('a', {0, 0, 0}, 1, 1)"},
        {"nh_torus", "gr.nh_torus('a', {0, 0, 0}, 1, 0.2)"},
        {"height_field", "gr.height_field('a', {{0, 1}, {1, 0}})"},
        {"union", "gr.union('a', gr.sphere('b'), gr.cube('c'))"},
        {"intersection", "gr.intersection('a', gr.sphere('b'), gr.cube('c'), gr.cone('d'))"},
        {"difference", "gr.difference('a', gr.sphere('b'), gr.cube('c'))"},
        {"mesh", "gr.mesh('a', {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})"},
        {"material", "gr.material({1, 1, 1}, {0, 0, 0}, 1)"},
        {"texture", "gr.texture('x.png', {0, 0, 0}, 1)"},
        {"checker", "gr.checker{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"stripes", "gr.stripes{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"gradient", "gr.gradient{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"noise", "gr.noise{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"marble", "gr.marble{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"wood", "gr.wood{first = {0, 0, 0}, second = {1, 1, 1}}"},
        {"bumpmap", "gr.bumpmap('x.png')"},
        {"set_material", "ball:set_material(grey)"},
        {"set_texture", "ball:set_texture(gr.texture('x.png', {0, 0, 0}, 1))"},
        {"set_bumpmap", "ball:set_bumpmap(gr.bumpmap('x.png'))"},
        {"set_reflection", "ball:set_reflection(0.5)"},
        {"set_refraction", "ball:set_refraction(1.5, 0.5)"},
        {"set_fresnel", "ball:set_fresnel(true)"},
        {"set_absorption", "ball:set_absorption({0.1, 0.2, 0.3})"},
        {"light", "gr.light({0, 0, 0}, {1, 1, 1}, {1, 0, 0})"},
        {"spot_light",
         "gr.spot_light{position = {0, 0, 0}, direction = {0, 1, 0}, colour = {1, 1, 1}}"},
        {"sun_light", "gr.sun_light{direction = {0, 1, 0}, colour = {1, 1, 1}}"},
        {"rectangle_light",
         "gr.rectangle_light{corner = {0, 0, 0}, u = {1, 0, 0}, v = {0, 1, 0}, "
         "colour = {1, 1, 1}}"},
        {"focal", "gr.focal(5, 1, 0.1)"},
        {"render",
         "gr.render(group, 'a.png', 1, 1, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40, "
         "{1, 1, 1}, {})"},
        {"background", "gr.background({1, 1, 1})"},
        {"options", "gr.options{spp = 1}"},
        {"param", "gr.param('a', 1)"},
    };
    return calls;
}

std::string fileText(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    REQUIRE(in);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
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

TEST_CASE("Documentation/reference.md is what --print reference prints") {
    CHECK(fileText("Documentation/reference.md") == languageReference());
}

TEST_CASE("the stubs hold every call and field, as function and as method") {
    const std::string stubs = editorStubs();
    for (const CallRow& row : callTable()) {
        CAPTURE(row.name);
        CHECK(holds(stubs, "\nfunction gr." + std::string(row.name) + "("));
        CHECK(holds(stubs, "\nfunction node:" + std::string(row.name) + "(") == row.isMethod());
        for (const CallForm& form : row.forms) {
            for (const Parameter& parameter : form.parameters) {
                const bool own = parameter.kind == ParameterKind::kTable ||
                                 parameter.kind == ParameterKind::kAny;
                CAPTURE(parameter.name);
                CHECK((*parameter.type != '\0') == own);
            }
        }
    }
    for (const FieldRow& row : fieldTable()) {
        CHECK(holds(stubs, "---@field " + std::string(row.name) + " " + row.type + " "));
    }
    for (const OptionRow& row : optionTable()) {
        if (std::string(row.name).find('-') != std::string::npos) continue;
        CHECK(holds(stubs, "\n---@field " + std::string(row.name) + "? "));
    }
}

TEST_CASE("the stubs say how an argument is left out, what it may be, and how else to call") {
    const std::string stubs = editorStubs();
    CHECK(holds(stubs,
                "---@param R? number Radius of the circle in the tube's middle. "
                "(> 0; 1 without it)\n"));
    CHECK(holds(stubs,
                "---@overload fun(name: string, corner: gr.tuple, size: gr.tuple): "
                "gr.node\n"));
    CHECK(holds(stubs, "---@generic T: number|string|boolean\n---@param name string"));
    CHECK(holds(stubs, "---@class gr.sun_light_fields\n---@field direction gr.tuple "));
    CHECK(holds(stubs, "\nfunction gr.sun_light(fields) end\n"));
    CHECK(holds(stubs, "---@field bits? 8|16 "));
    CHECK(holds(stubs, "---@field max_spp? integer "));
}

TEST_CASE("every call returns what its row says") {
    test::SceneFolder folder;
    folder.write("x.png");
    for (const CallRow& row : callTable()) {
        CAPTURE(row.name);
        REQUIRE(sampleCalls().count(row.name) == 1);
        const std::string returns = row.returns;
        std::string wanted =
            "tostring(got):sub(1, " + std::to_string(returns.size()) + ") == '" + returns + "'";
        if (returns.empty()) wanted = "count == 0";
        if (returns == kSameType) wanted = "got == 1";
        const test::ScriptRun run =
            test::runScene(folder,
                           "local function counted(...) return select('#', ...), ... end\n"
                           "local group, ball = gr.node('group'), gr.sphere('ball')\n"
                           "local grey = gr.material({1, 1, 1}, {0, 0, 0}, 1)\n"
                           "local count, got = counted(" +
                               sampleCalls().at(row.name) + ")\nassert(" + wanted + ")\n");
        CHECK(run.error == "");
    }
}
