// The scene language as one table: names, parameters, ranges, defaults, a sentence for each, and
// what carries a call out. Registration, argument checks, messages, spelling hints and the
// reference all come from it.
#pragma once

#include "arguments.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rt {

enum class ParameterKind {
    kText,
    kNumber,
    kWholeNumber,
    kBoolean,
    kTuple,
    kColor,
    kAxis,
    kNode,
    kMaterial,
    kTexture,
    kBump,
    kFocal,
    kLights,
    kTable,
    kAny,  ///< read by the handler
};

struct Parameter {
    const char* name;
    ParameterKind kind;
    const char* doc;
    Range range = {};
    bool optional = false;
    std::optional<double> fallback = {};  ///< of an optional number; objects fall back to none
    const char* type = "";  ///< of a kTable or kAny, as editors spell it: "gr.tuple[]"
};

/// What a parameter became; nothing where an optional one was left out.
using ArgumentValue =
    std::variant<std::monostate, bool, double, Vec3, std::string, Index, std::vector<Index>>;

using CallResult = std::variant<std::monostate, ObjectRef, bool, double, lua_Integer, std::string>;

/// One call on its way: the checked arguments, by the position of their parameter, from 0.
class Call {
  public:
    static constexpr std::size_t kMostParameters = 11;

    Call(const Arguments& arguments, SceneBuilder& builder)
        : scene(builder), arguments_(arguments) {}

    bool given(std::size_t i) const { return values_[i].index() != 0; }
    bool boolean(std::size_t i) const { return std::get<bool>(values_[i]); }
    double number(std::size_t i) const { return std::get<double>(values_[i]); }
    const Vec3& tuple(std::size_t i) const { return std::get<Vec3>(values_[i]); }
    const std::string& text(std::size_t i) const { return std::get<std::string>(values_[i]); }
    /// kNone for an optional object that was left out.
    Index object(std::size_t i) const { return given(i) ? std::get<Index>(values_[i]) : kNone; }
    const std::vector<Index>& objects(std::size_t i) const {
        return std::get<std::vector<Index>>(values_[i]);
    }

    /// For kTable and kAny: the stack slot of parameter i.
    static int slot(std::size_t i) { return static_cast<int>(i) + 1; }
    const Arguments& arguments() const { return arguments_; }

    void set(std::size_t i, ArgumentValue value) { values_[i] = std::move(value); }

    SceneBuilder& scene;

  private:
    const Arguments& arguments_;
    std::array<ArgumentValue, kMostParameters> values_;
};

/// One way to write a call.
struct CallForm {
    std::vector<Parameter> parameters;
    CallResult (*run)(Call&);
    /// Whether these arguments mean this form; nullptr for the form that is left.
    bool (*fits)(const Arguments&) = nullptr;
    /// Whether the call takes one table, whose fields are the parameters.
    bool named = false;
    /// Whether any number of arguments may follow that are like the last parameter, which the
    /// handler reads.
    bool repeats = false;
};

struct CallRow {
    const char* name;
    const char* doc;
    std::vector<CallForm> forms;
    const char* returns = "";  ///< as editors spell it: "gr.node"; "" for nothing

    bool isMethod() const { return forms.front().parameters.front().kind == ParameterKind::kNode; }
};

/// A plain field of gr.
struct FieldRow {
    const char* name;
    const char* type;
    const char* doc;
};

/// Calls of one concept, under the title that the reference gives them.
struct CallGroup {
    const char* title;
    std::vector<CallRow> (*rows)();
};

/// Stands for the one type that a call both takes and returns: a number, a string or a boolean.
inline constexpr const char* kSameType = "T";

const std::vector<CallGroup>& callGroups();
/// The rows of all groups.
const std::vector<CallRow>& callTable();
const std::vector<FieldRow>& fieldTable();
std::vector<std::string> callNames();

/// "gr.nh_sphere(name, centre, radius)", "node:translate(dx, dy, dz)", "gr.sun_light{direction=,
/// colour= [, angle=]}".
std::string usageText(const CallRow& row, const CallForm& form);

/// "; did you mean 'sphere'?", or "" where nothing is near.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

/// Checks the arguments on the stack against the row and carries the call out.
CallResult runCall(const CallRow& row, const Arguments& arguments, SceneBuilder& builder);

/// A vector at length 1; nothing for zero.
std::optional<Vec3> unitOf(const Vec3& v);
/// Argument i of this name at length 1; refuses zero.
Vec3 unitArgument(Call& call, std::size_t i, const char* name);

// The rows by concept; callTable is all of them.
std::vector<CallRow> primitiveCalls();
std::vector<CallRow> meshCalls();
std::vector<CallRow> heightFieldCalls();
std::vector<CallRow> csgCalls();
std::vector<CallRow> nodeCalls();
std::vector<CallRow> appearanceCalls();
std::vector<CallRow> patternCalls();
std::vector<CallRow> lightCalls();
std::vector<CallRow> renderCalls();
std::vector<CallRow> optionCalls();
std::vector<CallRow> parameterCalls();

inline constexpr Range kAnyNumber{};
inline constexpr Range kPositive{0.0, kInfinity, true, false};
inline constexpr Range kNotNegative{0.0, kInfinity, false, false};
inline constexpr Range kUnit{0.0, 1.0, false, false};

}  // namespace rt
