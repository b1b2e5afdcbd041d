#include "call_table.h"
#include "trampoline.h"

#include <cmath>

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Parameter kName{"name", Kind::kText, "What messages call the node."};
constexpr Range kResolution{2.0, 4096.0, false, false};
constexpr std::size_t kUnasked = 129;
const std::vector<std::string> kKnown = {"base", "smooth", "resolution"};

struct Options {
    std::optional<double> base;
    bool smooth = true;
    std::optional<std::size_t> resolution;
};

Options optionsOf(const Call& call, std::size_t i) {
    Options options;
    if (!call.given(i)) return options;
    const Arguments& in = call.arguments();
    for (const std::string& name : in.fieldNames(Call::slot(i), {"options"})) {
        in.field(Call::slot(i), name, [&](int value) {
            if (name == "base") {
                options.base = in.number(value, {"base"}, Range{});
            } else if (name == "smooth") {
                options.smooth = in.boolean(value, {"smooth"});
            } else if (name == "resolution") {
                const double wanted = in.wholeNumber(value, {"resolution"}, kResolution);
                options.resolution = static_cast<std::size_t>(wanted);
            } else {
                call.scene.fail("unknown option '" + printable(name, 64) + "'" +
                                didYouMean(name, kKnown) + " (known: base, smooth, resolution)");
            }
        });
    }
    return options;
}

CallResult addField(Call& call, HeightFieldDesc field, const Options& options) {
    field.base = options.base;
    field.smooth = options.smooth;
    return call.scene.addNode(call.text(0), call.scene.addGeometry(std::move(field)));
}

/// A resolution says how often a function is asked; what a file or a table holds is what it is.
void refuseResolution(const Call& call, const Options& options) {
    if (options.resolution) call.scene.fail("resolution goes with a function alone");
}

CallResult fromFile(Call& call) {
    const Options options = optionsOf(call, 2);
    refuseResolution(call, options);
    HeightFieldDesc field;
    field.image = call.scene.image(call.text(1), AssetRole::kHeights);
    return addField(call, std::move(field), options);
}

CallResult fromRows(Call& call) {
    const Options options = optionsOf(call, 2);
    refuseResolution(call, options);
    const Arguments& in = call.arguments();
    const Label label{"rows"};
    HeightFieldDesc field;
    HeightGrid& grid = field.grid;
    grid.rows = in.length(Call::slot(1));
    for (std::size_t j = 1; j <= grid.rows; ++j) {
        in.element(Call::slot(1), j, [&](int row) {
            in.requireTable(row, label.at(j), "a table of numbers");
            const std::size_t columns = in.length(row);
            if (j == 1) grid.columns = columns;
            if (columns != grid.columns) {
                call.scene.fail("rows must have as many numbers as the first, " +
                                std::to_string(grid.columns) + " (rows[" + std::to_string(j) +
                                "] has " + std::to_string(columns) + ")");
            }
            call.scene.charge(columns * sizeof(double));
            for (std::size_t i = 1; i <= columns; ++i) {
                in.element(row, i, [&](int value) {
                    grid.heights.push_back(in.number(value, label.at(j).at(i), Range{}));
                });
            }
        });
    }
    return addField(call, std::move(field), options);
}

double heightAt(Call& call, const SourceLocation& where, double x, double z) {
    const Arguments& in = call.arguments();
    lua_State* L = in.state();
    const StackGuard guard(L);
    lua_pushvalue(L, Call::slot(1));
    lua_pushnumber(L, x);
    lua_pushnumber(L, z);
    protectedCall(L, 2, 1);
    // The function may have made calls of its own.
    call.scene.enterCall("height_field", where);
    const int slot = lua_gettop(L);
    const bool isFinite = in.isNumber(slot) && std::isfinite(lua_tonumber(L, slot));
    if (isFinite) return lua_tonumber(L, slot);
    call.scene.fail("the function must give a finite number (got " + valueText(L, slot) +
                    " at x = " + numberText(x) + ", z = " + numberText(z) + ")");
}

CallResult fromFunction(Call& call) {
    const SourceLocation where = call.scene.where();
    const Options options = optionsOf(call, 2);
    const std::size_t side = options.resolution.value_or(kUnasked);
    HeightFieldDesc field;
    field.grid.columns = field.grid.rows = side;
    call.scene.charge(side * side * sizeof(double));
    field.grid.heights.reserve(side * side);
    const double last = static_cast<double>(side - 1);
    for (std::size_t j = 0; j < side; ++j) {
        for (std::size_t i = 0; i < side; ++i) {
            const double height =
                heightAt(call, where, static_cast<double>(i) / last, static_cast<double>(j) / last);
            field.grid.heights.push_back(height);
        }
    }
    return addField(call, std::move(field), options);
}

bool hasFunction(const Arguments& in) {
    return lua_type(in.state(), Call::slot(1)) == LUA_TFUNCTION;
}

bool hasRows(const Arguments& in) {
    return in.isTable(Call::slot(1));
}

}  // namespace

std::vector<CallRow> heightFieldCalls() {
    const Parameter file{"file", Kind::kText,
                         "An image, whose grey values are the heights; section \"Files\" says "
                         "where it may lie."};
    const Parameter rows{
        "rows", Kind::kTable, "Rows of as many heights each, the first along z = 0.", {}, false,
        {},     "number[][]"};
    const Parameter function{"height",
                             Kind::kAny,
                             "Gives the height at x and z, from 0 to 1 each.",
                             {},
                             false,
                             {},
                             "fun(x: number, z: number): number"};
    const Parameter options{
        "options",
        Kind::kTable,
        "{base = number, smooth = true | false}: whether walls go down to a bottom at y = base, "
        "and whether it is shaded as one smooth surface.",
        {},
        true,
        {},
        "{ base?: number, smooth?: boolean }"};
    const Parameter more{"options",
                         Kind::kTable,
                         "The same, and resolution: how many heights along a side; 129 without it.",
                         {},
                         true,
                         {},
                         "{ base?: number, smooth?: boolean, resolution?: integer }"};
    return {{"height_field",
             "Heights y over the square from (0,0) to (1,1) in x and z, as a mesh.",
             {{{kName, rows, options}, fromRows, hasRows},
              {{kName, function, more}, fromFunction, hasFunction},
              {{kName, file, options}, fromFile}},
             "gr.node"}};
}

}  // namespace rt
