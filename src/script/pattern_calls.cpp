#include "call_table.h"

namespace rt {

namespace {

using Kind = ParameterKind;

// What every pattern begins with, and the places of the fields among its parameters.
constexpr std::size_t kSpecularField = 3;
constexpr std::size_t kExponentField = 4;
constexpr std::size_t kOwnFields = 5;

std::vector<Parameter> fieldsOf(std::vector<Parameter> own) {
    std::vector<Parameter> all = {
        {"first", Kind::kTuple, "{r,g,b} of the matt part.", kNotNegative},
        {"second", Kind::kTuple, "{r,g,b} of the matt part.", kNotNegative},
        {"size", Kind::kNumber, "Its scale, in units of the object's own space.", kPositive, true,
         1.0},
        {"specular", Kind::kColor, "{r,g,b} of the highlight; {0,0,0} without it.", {}, true},
        {"exponent", Kind::kNumber, "Phong exponent of the highlight.", kNotNegative, true, 1.0},
    };
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

Pattern patternOf(Call& call, PatternKind kind) {
    Pattern pattern;
    pattern.kind = kind;
    pattern.first = call.tuple(0);
    pattern.second = call.tuple(1);
    pattern.size = call.number(2);
    return pattern;
}

CallResult add(Call& call, const Pattern& pattern) {
    TextureDesc desc;
    desc.pattern = pattern;
    if (call.given(kSpecularField)) desc.specular = call.tuple(kSpecularField);
    desc.exponent = call.number(kExponentField);
    return call.scene.addTexture(desc);
}

Vec3 directionOr(Call& call, std::size_t i, const Vec3& fallback) {
    return call.given(i) ? unitArgument(call, i, "direction") : fallback;
}

CallResult checker(Call& call) {
    return add(call, patternOf(call, PatternKind::kChecker));
}

CallResult stripes(Call& call) {
    Pattern pattern = patternOf(call, PatternKind::kStripes);
    pattern.direction = directionOr(call, kOwnFields, {1.0, 0.0, 0.0});
    return add(call, pattern);
}

CallResult gradient(Call& call) {
    Pattern pattern = patternOf(call, PatternKind::kGradient);
    pattern.direction = directionOr(call, kOwnFields, {0.0, 1.0, 0.0});
    return add(call, pattern);
}

CallResult noise(Call& call) {
    Pattern pattern = patternOf(call, PatternKind::kNoise);
    pattern.octaves = static_cast<int>(call.number(kOwnFields));
    return add(call, pattern);
}

CallResult grained(Call& call, PatternKind kind, const Vec3& direction) {
    Pattern pattern = patternOf(call, kind);
    pattern.direction = directionOr(call, kOwnFields, direction);
    pattern.turbulence = call.number(kOwnFields + 1);
    pattern.octaves = static_cast<int>(call.number(kOwnFields + 2));
    return add(call, pattern);
}

CallResult marble(Call& call) {
    return grained(call, PatternKind::kMarble, {1.0, 0.0, 0.0});
}

CallResult wood(Call& call) {
    return grained(call, PatternKind::kWood, {0.0, 1.0, 0.0});
}

Parameter direction(const char* doc) {
    return {"direction", Kind::kTuple, doc, {}, true};
}

Parameter turbulence(double fallback) {
    return {"turbulence", Kind::kNumber, "How far noise moves it, in sizes.",
            kNotNegative, true,          fallback};
}

Parameter octaves(double fallback) {
    return {"octaves",
            Kind::kWholeNumber,
            "How many noises are summed, each twice as fine and half as strong.",
            {1.0, 16.0, false, false},
            true,
            fallback};
}

CallRow row(const char* name, const char* doc, std::vector<Parameter> own,
            CallResult (*run)(Call&)) {
    return {name, doc, {{fieldsOf(std::move(own)), run, nullptr, true}}, "gr.texture"};
}

}  // namespace

std::vector<CallRow> patternCalls() {
    return {
        row("checker", "Cubes of edge size in two colours.", {}, checker),
        row("stripes", "Layers as thick as size in two colours.",
            {direction("Across the layers; {1,0,0} without it.")}, stripes),
        row("gradient", "From the first colour at 0 to the second at size.",
            {direction("The way that it runs; {0,1,0} without it.")}, gradient),
        row("noise", "Clouds of two colours.", {octaves(4.0)}, noise),
        row("marble", "Waves of two colours, as long as size, in a turbulent stone.",
            {direction("Across the waves; {1,0,0} without it."), turbulence(1.0), octaves(5.0)},
            marble),
        row("wood", "Rings as wide as size about an axis through the object's origin.",
            {direction("The axis; {0,1,0} without it."), turbulence(0.1), octaves(2.0)}, wood),
    };
}

}  // namespace rt
