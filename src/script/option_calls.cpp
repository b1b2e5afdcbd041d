#include "call_table.h"

namespace rt {

namespace {

using Kind = ParameterKind;

const OptionRow& findOption(const Call& call, const std::string& name) {
    std::vector<std::string> known;
    for (const OptionRow& row : optionTable()) {
        known.push_back(scriptSpelling(row));
        if (known.back() == name) return row;
    }
    call.scene.fail("unknown option '" + printable(name, 64) + "'" + didYouMean(name, known));
}

/// The value at a slot as the row wants it, or as it is where it cannot be.
OptionValue readOption(const Arguments& in, int slot, const OptionRow& row) {
    if (row.kind == OptionRow::Kind::kChoice) {
        const auto text = toText(in.state(), slot);
        return text ? OptionValue(*text) : OptionValue(false);
    }
    if (lua_type(in.state(), slot) == LUA_TBOOLEAN) return in.boolean(slot, {row.name});
    const auto number = toNumber(in.state(), slot);
    return number ? OptionValue(*number) : OptionValue(std::string());
}

CallResult options(Call& call) {
    const Arguments& in = call.arguments();
    RenderOptions said;
    for (const std::string& name : in.fieldNames(Call::slot(0), {"options"})) {
        const OptionRow& row = findOption(call, name);
        in.field(Call::slot(0), name, [&](int slot) {
            const OptionValue value = readOption(in, slot, row);
            const std::string wrong = checkOption(row, value);
            if (!wrong.empty()) {
                call.scene.fail(name + " " + wrong + " (got " + valueText(in.state(), slot) + ")");
            }
            row.store(said, value);
        });
    }
    if (said.spp && (said.error || said.time)) {
        call.scene.fail("spp excludes error and time: it asks for the same samples in every pixel");
    }
    call.scene.setOptions(said.over(call.scene.options()));
    return {};
}

}  // namespace

std::vector<CallRow> optionCalls() {
    return {{"options",
             "Sets options for the renders that follow. The names are those of the command line "
             "with underscores for hyphens; the command line wins.",
             {{{{"options", Kind::kTable, "{name = value, ...}.", {}, false, {}, "gr.Options"}},
               options}}}};
}

}  // namespace rt
