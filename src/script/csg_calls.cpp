#include "call_table.h"

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr std::size_t kFirstOperand = 1;

std::vector<Index> operandsOf(const Call& call) {
    std::vector<Index> operands;
    const Arguments& in = call.arguments();
    const int first = Call::slot(kFirstOperand);
    for (int slot = first; slot <= in.count(); ++slot) {
        const Label label = Label{"operand"}.at(static_cast<std::size_t>(slot - first) + 1);
        operands.push_back(in.object(slot, label, ObjectKind::kNode));
    }
    return operands;
}

template <CsgOperation operation>
CallResult combined(Call& call) {
    return call.scene.addCombined(call.text(0), operation, operandsOf(call));
}

std::vector<Parameter> parameters(const char* first, const char* second) {
    return {{"name", Kind::kText, "What messages call the node."},
            {"a", Kind::kNode, first},
            {"b", Kind::kNode, second},
            {"...", Kind::kNode, "More of them.", {}, true}};
}

CallForm form(const char* first, const char* second, CallResult (*run)(Call&)) {
    CallForm form{parameters(first, second), run};
    form.repeats = true;
    return form;
}

}  // namespace

std::vector<CallRow> csgCalls() {
    return {
        {"union",
         "All that is in one of its solids, as one solid.",
         {form("A solid; a group is the union of what hangs under it.", "Another.",
               combined<CsgOperation::kUnion>)},
         "gr.node"},
        {"intersection",
         "What is in all of its solids.",
         {form("A solid; a group is the union of what hangs under it.", "Another.",
               combined<CsgOperation::kIntersection>)},
         "gr.node"},
        {"difference",
         "What is in the first of its solids, and in none of the others.",
         {form("The solid of which something is taken away.", "What is taken away.",
               combined<CsgOperation::kDifference>)},
         "gr.node"},
    };
}

}  // namespace rt
