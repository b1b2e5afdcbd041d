#include "call_table.h"

#include <charconv>
#include <cmath>

namespace rt {

namespace {

using Kind = ParameterKind;

struct ParameterOptions {
    Range range;
    std::string doc;
};

ParameterOptions readOptions(const Call& call) {
    ParameterOptions options;
    if (!call.given(2)) return options;
    const Arguments& in = call.arguments();
    const int table = Call::slot(2);
    for (const std::string& name : in.fieldNames(table, {"options"})) {
        in.field(table, name, [&](int slot) {
            if (name == "min") {
                options.range.min = in.number(slot, {"min"}, kAnyNumber);
            } else if (name == "max") {
                options.range.max = in.number(slot, {"max"}, kAnyNumber);
            } else if (name == "doc") {
                options.doc = in.text(slot, {"doc"});
            } else {
                call.scene.fail("unknown option '" + printable(name, 64) + "'" +
                                didYouMean(name, {"min", "max", "doc"}) +
                                " (known: doc, max, min)");
            }
        });
    }
    return options;
}

[[noreturn]] void refuse(const Call& call, const GivenParameter& given, const std::string& wanted) {
    call.scene.fail(given.text() + " " + wanted);
}

double parseNumber(const Call& call, const GivenParameter& given) {
    const std::string& text = given.value;
    double value = 0.0;
    const char* first = text.data();
    const char* last = first + text.size();
    if (text.size() > 1 && first[0] == '+' && first[1] != '-') ++first;
    const auto parsed = std::from_chars(first, last, value);
    const bool whole = parsed.ec == std::errc() && parsed.ptr == last && std::isfinite(value);
    if (!whole) refuse(call, given, "must be a finite number");
    return value;
}

bool parseBoolean(const Call& call, const GivenParameter& given) {
    for (const char* yes : {"true", "1", "yes", "on"}) {
        if (given.value == yes) return true;
    }
    for (const char* no : {"false", "0", "no", "off"}) {
        if (given.value == no) return false;
    }
    refuse(call, given, "must be true or false");
}

CallResult numberParameter(Call& call, const GivenParameter* given) {
    const ParameterOptions options = readOptions(call);
    lua_State* L = call.arguments().state();
    const int slot = Call::slot(1);
    double value = call.arguments().number(slot, {"default"}, options.range);
    if (given) {
        value = parseNumber(call, *given);
        if (!options.range.contains(value)) {
            refuse(call, *given, "must be " + options.range.text());
        }
    }
    call.scene.addParameter(call.text(0), numberText(value), options.doc);
    lua_Integer whole = 0;
    const bool wasInteger = lua_isinteger(L, slot) != 0;
    if (wasInteger && lua_numbertointeger(value, &whole) && std::floor(value) == value) {
        return whole;
    }
    return value;
}

CallResult parameter(Call& call) {
    const Arguments& in = call.arguments();
    const int slot = Call::slot(1);
    const GivenParameter* given = call.scene.givenParameter(call.text(0));
    switch (lua_type(in.state(), slot)) {
        case LUA_TNUMBER:
            return numberParameter(call, given);
        case LUA_TBOOLEAN: {
            const bool value = given ? parseBoolean(call, *given) : in.boolean(slot, {"default"});
            call.scene.addParameter(call.text(0), value ? "true" : "false", readOptions(call).doc);
            return value;
        }
        case LUA_TSTRING: {
            const std::string value = given ? given->value : in.text(slot, {"default"});
            call.scene.addParameter(call.text(0), value, readOptions(call).doc);
            return value;
        }
        default:
            call.scene.fail("default must be a number, a string or a boolean (got " +
                            valueText(in.state(), slot) + ")");
    }
}

}  // namespace

std::vector<CallRow> parameterCalls() {
    return {
        {"param",
         "A value that -D name=value or --param-file sets on the command line, of the default's "
         "type.",
         {{{{"name", Kind::kText, "Its name."},
            {"default", Kind::kAny, "A number, a string or a boolean.", {}, false, {}, kSameType},
            {"options",
             Kind::kTable,
             "{min = number, max = number, doc = \"one sentence\"}.",
             {},
             true,
             {},
             "{ min?: number, max?: number, doc?: string }"}},
           parameter}},
         kSameType}};
}

}  // namespace rt
