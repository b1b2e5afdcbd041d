#include "call_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rt {

namespace {

std::vector<CallRow> allRows() {
    std::vector<CallRow> all;
    for (const CallGroup& group : callGroups()) {
        std::vector<CallRow> more = group.rows();
        std::move(more.begin(), more.end(), std::back_inserter(all));
    }
    return all;
}

ArgumentValue readObject(const Arguments& in, int slot, Label label, const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::kMaterial:
            return in.object(slot, label, ObjectKind::kMaterial);
        case ParameterKind::kTexture:
            return in.object(slot, label, ObjectKind::kTexture);
        case ParameterKind::kBump:
            return in.object(slot, label, ObjectKind::kBump);
        case ParameterKind::kFocal:
            return in.object(slot, label, ObjectKind::kFocal);
        case ParameterKind::kLights:
            return in.objects(slot, label, ObjectKind::kLight);
        default:
            return in.object(slot, label, ObjectKind::kNode);
    }
}

ArgumentValue readValue(const Arguments& in, int slot, const Parameter& parameter) {
    const Label label{parameter.name};
    switch (parameter.kind) {
        case ParameterKind::kText:
            return in.text(slot, label);
        case ParameterKind::kNumber:
            return in.number(slot, label, parameter.range);
        case ParameterKind::kWholeNumber:
            return in.wholeNumber(slot, label, parameter.range);
        case ParameterKind::kBoolean:
            return in.boolean(slot, label);
        case ParameterKind::kTuple:
            return in.tuple(slot, label, parameter.range);
        case ParameterKind::kColor:
            return in.color(slot, label);
        case ParameterKind::kAxis:
            return static_cast<double>(in.axis(slot, label));
        case ParameterKind::kTable:
            in.requireTable(slot, label, "a table");
            return true;
        case ParameterKind::kAny:
            return true;
        default:
            return readObject(in, slot, label, parameter);
    }
}

const CallForm& formOf(const CallRow& row, const Arguments& arguments) {
    const auto fits = [&](const CallForm& form) { return !form.fits || form.fits(arguments); };
    const auto form = std::find_if(row.forms.begin(), row.forms.end(), fits);
    return form != row.forms.end() ? *form : row.forms.back();
}

void warnOfExtra(const CallForm& form, const Arguments& arguments, SceneBuilder& builder) {
    const int most = static_cast<int>(form.parameters.size());
    for (int slot = most + 1; slot <= arguments.count(); ++slot) {
        if (!arguments.isGiven(slot)) continue;
        builder.warnOnce("extra-arguments", "takes " + std::to_string(most) +
                                                (most == 1 ? " argument" : " arguments") +
                                                "; the rest is ignored");
        return;
    }
}

/// Puts the fields of the only argument in its place, in the order of the parameters.
void spreadFields(const CallRow& row, const CallForm& form, const Arguments& in,
                  SceneBuilder& builder) {
    lua_State* L = in.state();
    const std::string usage = usageText(row, form);
    if (in.count() == 0) builder.fail("a table of fields is missing; the call is " + usage);
    in.requireTable(1, {"its argument"}, "a table of fields");
    lua_settop(L, 1);
    std::vector<std::string> known;
    for (const Parameter& parameter : form.parameters) known.push_back(parameter.name);
    for (const std::string& name : in.fieldNames(1, {"its argument"})) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        builder.fail("unknown field '" + printable(name, 64) + "'" + didYouMean(name, known) +
                     "; the call is " + usage);
    }
    ensureStack(L, static_cast<int>(known.size()));
    for (const std::string& name : known) pushField(L, 1, name);
    lua_remove(L, 1);
}

void requireNode(const CallRow& row, const Arguments& arguments, SceneBuilder& builder) {
    const int type = lua_type(arguments.state(), 1);
    if (!row.isMethod() || type == LUA_TUSERDATA) return;
    builder.fail("node: gr.node expected, got " + valueText(arguments.state(), 1) +
                 "; the call is " + usageText(row, row.forms.front()));
}

}  // namespace

const std::vector<CallGroup>& callGroups() {
    static const std::vector<CallGroup> groups = {
        {"Nodes", nodeCalls},           {"Primitives", primitiveCalls},
        {"Meshes", meshCalls},          {"Height fields", heightFieldCalls},
        {"Combined solids", csgCalls},  {"Appearance", appearanceCalls},
        {"Patterns", patternCalls},     {"Lights and lens", lightCalls},
        {"Images", renderCalls},        {"Options", optionCalls},
        {"Parameters", parameterCalls},
    };
    return groups;
}

const std::vector<CallRow>& callTable() {
    static const std::vector<CallRow> table = allRows();
    return table;
}

const std::vector<FieldRow>& fieldTable() {
    static const std::vector<FieldRow> table = {
        {"frame", "integer", "The number of the frame, 1 without --frames."},
        {"time", "number", "From 0 at the first frame to 1 at the last."},
    };
    return table;
}

std::vector<std::string> callNames() {
    std::vector<std::string> names;
    for (const CallRow& row : callTable()) names.push_back(row.name);
    for (const FieldRow& row : fieldTable()) names.push_back(row.name);
    return names;
}

std::string usageText(const CallRow& row, const CallForm& form) {
    const std::size_t first = row.isMethod() ? 1 : 0;
    std::string text =
        (row.isMethod() ? "node:" : "gr.") + std::string(row.name) + (form.named ? "{" : "(");
    std::string closing = form.named ? "}" : ")";
    for (std::size_t i = first; i < form.parameters.size(); ++i) {
        const Parameter& parameter = form.parameters[i];
        if (parameter.optional) {
            text += i > first ? " [" : "[";
            closing = "]" + closing;
        }
        text += i > first ? ", " : "";
        text += parameter.name;
        if (form.named) text += "=";
    }
    return text + closing;
}

std::optional<Vec3> unitOf(const Vec3& v) {
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(largest > 0.0)) return std::nullopt;
    return glm::normalize(v / largest);
}

Vec3 unitArgument(Call& call, std::size_t i, const char* name) {
    const std::optional<Vec3> unit = unitOf(call.tuple(i));
    if (!unit) call.scene.fail(std::string(name) + " must not be zero");
    return *unit;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearestName(word, known);
    return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

CallResult runCall(const CallRow& row, const Arguments& arguments, SceneBuilder& builder) {
    requireNode(row, arguments, builder);
    const CallForm& form = formOf(row, arguments);
    if (form.named) spreadFields(row, form, arguments, builder);
    Call call(arguments, builder);
    const std::size_t read = form.parameters.size() - (form.repeats ? 1 : 0);
    for (std::size_t i = 0; i < read; ++i) {
        const Parameter& parameter = form.parameters[i];
        const int slot = Call::slot(i);
        const bool missing = form.named ? !arguments.isGiven(slot) : slot > arguments.count();
        if (missing && !parameter.optional) {
            builder.fail(std::string(parameter.name) + " is missing; the call is " +
                         usageText(row, form));
        }
        if (parameter.optional && !arguments.isGiven(slot)) {
            if (parameter.fallback) call.set(i, *parameter.fallback);
            continue;
        }
        call.set(i, readValue(arguments, slot, parameter));
    }
    if (!form.repeats) warnOfExtra(form, arguments, builder);
    return form.run(call);
}

}  // namespace rt
