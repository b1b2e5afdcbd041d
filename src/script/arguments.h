// Typed reading of what a script passed to a call. Only raw access, none of which can raise a Lua
// error: metamethods do not run, and a table counts for what it holds itself.
#pragma once

#include "lua_access.h"
#include "scene_builder.h"

#include <string>
#include <vector>

namespace rt {

/// The values that are right for a number.
struct Range {
    double min = -kInfinity;
    double max = kInfinity;
    bool minExcluded = false;
    bool maxExcluded = false;

    bool contains(double value) const;
    /// "> 0", "in 0 .. 1"; "" for all numbers.
    std::string text() const;
};

/// A number as a message shows it: the shortest digits that mean it.
std::string numberText(double value);

/// "number -1", "string \"abc\"", "nil", "gr.light": what there is instead of what was wanted.
std::string valueText(lua_State* L, int slot);

/// The name of an argument, or of a part of one: "faces", "faces[3]", "faces[3][1]".
struct Label {
    const char* name;
    std::size_t first = 0;  ///< 1-based; 0 = none
    std::size_t second = 0;

    Label at(std::size_t i) const { return first == 0 ? Label{name, i} : Label{name, first, i}; }
    std::string text() const;
};

/// Reads stack slots; refuses what does not fit with the call's line and the argument's name.
class Arguments {
  public:
    Arguments(lua_State* L, SceneBuilder& builder) : L_(L), builder_(builder) {}

    int count() const { return lua_gettop(L_); }
    bool isGiven(int slot) const { return lua_type(L_, slot) > LUA_TNIL; }
    bool isTable(int slot) const { return lua_type(L_, slot) == LUA_TTABLE; }
    bool isFunction(int slot) const { return lua_type(L_, slot) == LUA_TFUNCTION; }
    bool isNumber(int slot) const { return lua_isnumber(L_, slot) != 0; }
    bool isString(int slot) const { return lua_type(L_, slot) == LUA_TSTRING; }

    double number(int slot, Label label, const Range& range) const;
    double wholeNumber(int slot, Label label, const Range& range) const;
    bool boolean(int slot, Label label) const;
    /// A string; a number stands for its digits.
    std::string text(int slot, Label label) const;
    /// Three numbers; more are ignored with a warning.
    Vec3 tuple(int slot, Label label, const Range& range) const;
    /// As `tuple`; warns of negative channels.
    Color color(int slot, Label label) const;
    /// 0, 1, 2 for x, y, z in either case.
    int axis(int slot, Label label) const;
    Index object(int slot, Label label, ObjectKind kind) const;
    std::vector<Index> objects(int slot, Label label, ObjectKind kind) const;

    void requireTable(int slot, Label label, const char* wanted) const;
    /// Elements 1 .. n of a table without counting what it merely inherits.
    std::size_t length(int slot) const { return lua_rawlen(L_, slot); }
    /// Calls visit(slot of the element) for element `i` of a table.
    template <class Visit>
    void element(int slot, std::size_t i, Visit visit) const {
        lua_rawgeti(L_, slot, static_cast<lua_Integer>(i));
        visit(lua_gettop(L_));
        lua_pop(L_, 1);
    }
    /// The string keys of a table, sorted; refuses any other key.
    std::vector<std::string> fieldNames(int slot, Label label) const;
    /// Calls visit(slot of the value) for the field `name` of a table.
    template <class Visit>
    void field(int slot, const std::string& name, Visit visit) const {
        pushField(L_, slot, name);
        visit(lua_gettop(L_));
        lua_pop(L_, 1);
    }

    lua_State* state() const { return L_; }
    SceneBuilder& builder() const { return builder_; }

  private:
    [[noreturn]] void wrong(int slot, Label label, const std::string& wanted) const;
    [[noreturn]] void tooShort(int slot, Label label, std::size_t firstMissing) const;

    lua_State* L_;
    SceneBuilder& builder_;
};

}  // namespace rt
