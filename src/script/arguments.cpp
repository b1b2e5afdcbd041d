#include "arguments.h"

#include "object_types.h"

#include "rt/core/diagnostics.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt {

namespace {

// The most of a script's string that a message repeats.
constexpr std::size_t kShownOfString = 40;

}  // namespace

bool Range::contains(double value) const {
    const bool aboveMin = minExcluded ? value > min : value >= min;
    const bool belowMax = maxExcluded ? value < max : value <= max;
    return aboveMin && belowMax;
}

std::string Range::text() const {
    const bool below = max < kInfinity;
    const bool above = min > -kInfinity;
    if (above && below && !minExcluded && !maxExcluded) {
        return "in " + numberText(min) + " .. " + numberText(max);
    }
    std::string text;
    if (above) text += (minExcluded ? "> " : ">= ") + numberText(min);
    if (above && below) text += " and ";
    if (below) text += (maxExcluded ? "< " : "<= ") + numberText(max);
    return text;
}

std::string numberText(double value) {
    if (std::isnan(value)) return "nan";
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return std::string(digits, end);
}

std::string valueText(lua_State* L, int slot) {
    switch (lua_type(L, slot)) {
        case LUA_TNONE:
            return "nothing";
        case LUA_TBOOLEAN:
            return lua_toboolean(L, slot) ? "true" : "false";
        case LUA_TNUMBER:
            return "number " + numberText(lua_tonumber(L, slot));
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char* bytes = lua_tolstring(L, slot, &size);
            const bool cut = size > kShownOfString;
            const std::string shown(bytes, cut ? kShownOfString : size);
            return "string \"" + printable(shown) + (cut ? "...\"" : "\"");
        }
        case LUA_TUSERDATA:
            return typeNameOf(L, slot);
        default:
            return lua_typename(L, lua_type(L, slot));
    }
}

std::string Label::text() const {
    std::string text = name;
    if (first > 0) text += "[" + std::to_string(first) + "]";
    if (second > 0) text += "[" + std::to_string(second) + "]";
    return text;
}

void Arguments::wrong(int slot, Label label, const std::string& wanted) const {
    builder_.fail(label.text() + " must be " + wanted + " (got " + valueText(L_, slot) + ")");
}

double Arguments::number(int slot, Label label, const Range& range) const {
    int isNumber = 0;
    const double value = lua_tonumberx(L_, slot, &isNumber);
    if (!isNumber) wrong(slot, label, "a number");
    const bool finite = std::isfinite(value);
    if (finite && range.contains(value)) return value;
    builder_.fail(label.text() + " must be " + (finite ? range.text() : "finite") + " (got " +
                  numberText(value) + ")");
}

double Arguments::wholeNumber(int slot, Label label, const Range& range) const {
    int isNumber = 0;
    const double value = lua_tonumberx(L_, slot, &isNumber);
    if (!isNumber) wrong(slot, label, "a whole number");
    if (range.contains(value) && std::floor(value) == value) return value;
    builder_.fail(label.text() + " must be a whole number " + range.text() + " (got " +
                  numberText(value) + ")");
}

bool Arguments::boolean(int slot, Label label) const {
    if (lua_type(L_, slot) != LUA_TBOOLEAN) wrong(slot, label, "true or false");
    return lua_toboolean(L_, slot) != 0;
}

std::string Arguments::text(int slot, Label label) const {
    std::optional<std::string> value = toText(L_, slot);
    if (!value) wrong(slot, label, "a string");
    return *std::move(value);
}

void Arguments::requireTable(int slot, Label label, const char* wanted) const {
    if (!isTable(slot)) wrong(slot, label, wanted);
}

void Arguments::tooShort(int slot, Label label, std::size_t firstMissing) const {
    for (std::size_t i = firstMissing + 1; i <= 3; ++i) {
        element(slot, i, [&](int value) {
            if (!isGiven(value)) return;
            builder_.fail(label.at(firstMissing).text() + " must be a number (got nil)");
        });
    }
    builder_.fail(label.text() + " must have 3 numbers (got " + std::to_string(firstMissing - 1) +
                  ")");
}

Vec3 Arguments::tuple(int slot, Label label, const Range& range) const {
    requireTable(slot, label, "a table of 3 numbers");
    Vec3 result{0.0};
    for (std::size_t i = 1; i <= 3; ++i) {
        element(slot, i, [&](int value) {
            if (!isGiven(value)) tooShort(slot, label, i);
            const Label part = label.second > 0 ? label : label.at(i);
            result[static_cast<int>(i - 1)] = number(value, part, range);
        });
    }
    element(slot, 4, [&](int value) {
        if (!isGiven(value)) return;
        builder_.warnOnce("extra-values",
                          label.text() + " has more than 3 values; the rest is " + "ignored");
    });
    return result;
}

Color Arguments::color(int slot, Label label) const {
    const Color color = tuple(slot, label, Range{});
    for (int i = 0; i < 3; ++i) {
        if (color[i] >= 0.0) continue;
        builder_.warnOnce("negative-colour", label.at(static_cast<std::size_t>(i) + 1).text() +
                                                 " is negative (" + numberText(color[i]) + ")");
    }
    return color;
}

int Arguments::axis(int slot, Label label) const {
    if (isString(slot)) {
        const std::string name = text(slot, label);
        const std::size_t found = std::string("xyzXYZ").find(name);
        if (name.size() == 1 && found != std::string::npos) return static_cast<int>(found % 3);
    }
    wrong(slot, label, "'x', 'y' or 'z'");
}

Index Arguments::object(int slot, Label label, ObjectKind kind) const {
    const auto found = objectAt(L_, slot, builder_);
    if (found && found->kind == kind) return found->index;
    builder_.fail(label.text() + ": " + objectKindName(kind) + " expected, got " +
                  valueText(L_, slot));
}

std::vector<Index> Arguments::objects(int slot, Label label, ObjectKind kind) const {
    requireTable(slot, label, (std::string("a table of ") + objectKindName(kind)).c_str());
    std::vector<Index> all;
    for (std::size_t i = 1; i <= length(slot); ++i) {
        element(slot, i, [&](int value) { all.push_back(object(value, label.at(i), kind)); });
    }
    return all;
}

std::vector<std::string> Arguments::fieldNames(int slot, Label label) const {
    std::vector<std::string> names;
    lua_pushnil(L_);
    while (lua_next(L_, slot) != 0) {
        lua_pop(L_, 1);
        if (!isString(lua_gettop(L_))) {
            builder_.fail(label.text() + " must have names as keys (got " +
                          valueText(L_, lua_gettop(L_)) + ")");
        }
        names.push_back(text(lua_gettop(L_), label));
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace rt
