#include "rt/script/language_documents.h"

#include "call_table.h"

#include "rt/core/text.h"

namespace rt {

namespace {

constexpr const char* kSameTypes = "number|string|boolean";

std::string typeOf(const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::kText:
            return "string";
        case ParameterKind::kNumber:
            return "number";
        case ParameterKind::kWholeNumber:
            return "integer";
        case ParameterKind::kBoolean:
            return "boolean";
        case ParameterKind::kTuple:
            return "gr.tuple";
        case ParameterKind::kColor:
            return "gr.colour";
        case ParameterKind::kAxis:
            return "gr.axis";
        case ParameterKind::kNode:
            return objectKindName(ObjectKind::kNode);
        case ParameterKind::kMaterial:
            return objectKindName(ObjectKind::kMaterial);
        case ParameterKind::kTexture:
            return objectKindName(ObjectKind::kTexture);
        case ParameterKind::kBump:
            return objectKindName(ObjectKind::kBump);
        case ParameterKind::kFocal:
            return objectKindName(ObjectKind::kFocal);
        case ParameterKind::kLights:
            return std::string(objectKindName(ObjectKind::kLight)) + "[]";
        case ParameterKind::kTable:
        case ParameterKind::kAny:
            break;
    }
    return parameter.type;
}

/// "must be > 0; 1 without it", or "".
std::string limitsOf(const Parameter& parameter) {
    std::string text = parameter.range.text();
    if (parameter.fallback) {
        text += (text.empty() ? "" : "; ") + numberText(*parameter.fallback) + " without it";
    }
    return text;
}

std::string optionType(const OptionRow& row) {
    switch (row.kind) {
        case OptionRow::Kind::kFlag:
            return "boolean";
        case OptionRow::Kind::kInteger:
            return "integer";
        case OptionRow::Kind::kNumber:
            return "number";
        case OptionRow::Kind::kChoice:
            break;
    }
    std::string all;
    for (const std::string& choice : row.choices) {
        const bool isNumber = wholeNumber<int>(choice).has_value();
        all += (all.empty() ? "" : "|") + (isNumber ? choice : "\"" + choice + "\"");
    }
    return all;
}

// Stubs

/// "name, centre, radius", from the parameter at `first`.
std::string namesOf(const CallForm& form, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < form.parameters.size(); ++i) {
        text += (i > first ? ", " : "") + std::string(form.parameters[i].name);
    }
    return text;
}

/// `tag` is "param" or "field".
std::string annotation(const char* tag, const Parameter& parameter) {
    std::string line = "---@" + std::string(tag) + " " + parameter.name +
                       (parameter.optional ? "? " : " ") + typeOf(parameter) + " " + parameter.doc;
    const std::string limits = limitsOf(parameter);
    return line + (limits.empty() ? "" : " (" + limits + ")") + "\n";
}

std::string overloadLine(const CallRow& row, const CallForm& form, std::size_t first) {
    std::string line = "---@overload fun(";
    for (std::size_t i = first; i < form.parameters.size(); ++i) {
        const Parameter& parameter = form.parameters[i];
        line += (i > first ? ", " : "") + std::string(parameter.name) +
                (parameter.optional ? "?: " : ": ") + typeOf(parameter);
    }
    return line + ")" + (*row.returns ? ": " + std::string(row.returns) : "") + "\n";
}

std::string fieldsName(const CallRow& row) {
    return "gr." + std::string(row.name) + "_fields";
}

std::string fieldsClass(const CallRow& row, const CallForm& form) {
    std::string text = "\n---@class " + fieldsName(row) + "\n";
    for (const Parameter& parameter : form.parameters) text += annotation("field", parameter);
    return text;
}

/// Of a call that takes a table of fields.
std::string namedStubOf(const CallRow& row) {
    return fieldsClass(row, row.forms.back()) + "\n---" + row.doc + "\n---@param fields " +
           fieldsName(row) + "\n" +
           (*row.returns ? "---@return " + std::string(row.returns) + "\n" : "") + "function gr." +
           row.name + "(fields) end\n";
}

/// `gr.scale(node, ...)`, or as a method, whose node stands before the colon.
std::string stubOf(const CallRow& row, bool asMethod) {
    const std::size_t first = asMethod ? 1 : 0;
    const CallForm& last = row.forms.back();
    if (last.named) return namedStubOf(row);
    std::string text = "\n---" + std::string(row.doc) + "\n";
    if (row.returns == std::string(kSameType)) {
        text += "---@generic " + std::string(kSameType) + ": " + kSameTypes + "\n";
    }
    for (std::size_t i = first; i < last.parameters.size(); ++i) {
        text += annotation("param", last.parameters[i]);
    }
    if (*row.returns) text += "---@return " + std::string(row.returns) + "\n";
    for (const CallForm& form : row.forms) {
        if (&form != &last) text += overloadLine(row, form, first);
    }
    return text + "function " + (asMethod ? "node:" : "gr.") + row.name + "(" +
           namesOf(last, first) + ") end\n";
}

std::string typeStubs() {
    std::string text =
        "---@alias gr.tuple { [1]: number, [2]: number, [3]: number }\n"
        "---@alias gr.colour gr.tuple\n"
        "---@alias gr.axis \"x\"|\"y\"|\"z\"|\"X\"|\"Y\"|\"Z\"\n";
    for (const ObjectKind kind : {ObjectKind::kNode, ObjectKind::kMaterial, ObjectKind::kTexture,
                                  ObjectKind::kBump, ObjectKind::kLight, ObjectKind::kFocal}) {
        text += std::string("\n---@class ") + objectKindName(kind) + "\n";
        if (kind == ObjectKind::kNode) text += "local node = {}\n";
    }
    text += "\n---@class gr.Options\n";
    for (const OptionRow& row : optionTable()) {
        text += "---@field " + scriptSpelling(row) + "? " + optionType(row) + " " + row.help + "\n";
    }
    return text;
}

// Reference

/// A cell of a table must not hold its separator.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += (c == '|' ? "\\" : "") + std::string(1, c);
    return safe;
}

std::string shownType(const std::string& type) {
    return type == kSameType ? kSameTypes : type;
}

std::string parameterTable(const CallRow& row, const CallForm& form) {
    const std::size_t first = row.isMethod() ? 1 : 0;
    if (form.parameters.size() == first) return "";
    std::string text = std::string(form.named ? "\n| field" : "\n| argument") +
                       " | type | values | meaning |\n|---|---|---|---|\n";
    for (std::size_t i = first; i < form.parameters.size(); ++i) {
        const Parameter& parameter = form.parameters[i];
        text += "| `" + std::string(parameter.name) + "`" +
                (parameter.optional ? " (optional)" : "") + " | `" +
                cell(shownType(typeOf(parameter))) + "` | " + limitsOf(parameter) + " | " +
                cell(parameter.doc) + " |\n";
    }
    return text;
}

std::string optionReference() {
    std::string text = "\n| option | values | meaning |\n|---|---|---|\n";
    for (const OptionRow& row : optionTable()) {
        text += "| `" + scriptSpelling(row) + "` | `" + cell(optionType(row)) + "` | " + row.help +
                " |\n";
    }
    return text;
}

std::string sectionOf(const CallRow& row) {
    std::string text = "\n### gr." + std::string(row.name) + "\n\n" + row.doc + "\n";
    for (const CallForm& form : row.forms) {
        text += "\n    " + usageText(row, form) +
                (*row.returns ? "  ->  " + shownType(row.returns) : "") + "\n" +
                parameterTable(row, form);
    }
    return text + (row.name == std::string("options") ? optionReference() : "");
}

}  // namespace

std::string editorStubs() {
    std::string text =
        "---@meta\n\n"
        "-- The scene language for the Lua language server, made by `./Project --print "
        "stubs`.\n\n" +
        typeStubs() + "\n---@class gr\n";
    for (const FieldRow& row : fieldTable()) {
        text += "---@field " + std::string(row.name) + " " + row.type + " " + row.doc + "\n";
    }
    text += "gr = {}\n";
    for (const CallRow& row : callTable()) {
        text += stubOf(row, false);
        if (row.isMethod()) text += stubOf(row, true);
    }
    return text;
}

std::string languageReference() {
    std::string text =
        "# Reference\n\n"
        "Every call of the scene language, made by `./Project --print reference` from the table\n"
        "that checks the arguments. Pictures and more words are in\n"
        "[the scene language](scene_language.md). `gr.tuple` is a table of three numbers,\n"
        "`gr.colour` one of red, green and blue. What is written `node:call(...)` can be written\n"
        "`gr.call(node, ...)`, too.\n\n"
        "## Fields\n\n| field | type | meaning |\n|---|---|---|\n";
    for (const FieldRow& row : fieldTable()) {
        text += "| `gr." + std::string(row.name) + "` | `" + row.type + "` | " + row.doc + " |\n";
    }
    for (const CallGroup& group : callGroups()) {
        text += "\n## " + std::string(group.title) + "\n";
        for (const CallRow& row : group.rows()) text += sectionOf(row);
    }
    return text;
}

}  // namespace rt
