#include "call_table.h"

namespace rt {

namespace {

using Kind = ParameterKind;

CallResult addLight(Call& call, Light light) {
    if (light.c0 == 0.0 && light.c1 == 0.0 && light.c2 == 0.0) {
        call.scene.warnOnce("zero-falloff", "falloff {0,0,0} is taken as {1,0,0}");
        light.c0 = 1.0;
    }
    return call.scene.addLight(light);
}

CallResult light(Call& call) {
    const Vec3& falloff = call.tuple(2);
    return addLight(call, {call.tuple(0), call.tuple(1), falloff.x, falloff.y, falloff.z,
                           call.number(3), call.number(4)});
}

CallResult scalarLight(Call& call) {
    const auto triple = [&](std::size_t i) {
        return Vec3(call.number(i), call.number(i + 1), call.number(i + 2));
    };
    const Vec3 color = triple(3);
    if (!(color.x >= 0.0 && color.y >= 0.0 && color.z >= 0.0)) {
        call.scene.warnOnce("negative-colour", "the colour has a negative channel");
    }
    const Vec3 falloff = triple(6);
    return addLight(
        call, {triple(0), color, falloff.x, falloff.y, falloff.z, call.number(9), call.number(10)});
}

bool startsWithNumber(const Arguments& in) {
    return in.isNumber(1);
}

constexpr Parameter kRadius{
    "radius",     Kind::kNumber, "Radius of the light's sphere; 0 is a point.",
    kNotNegative, true,          0.0};
constexpr Parameter kBrightness{"brightness", Kind::kNumber, "Floor of n.w in the matt part.",
                                kNotNegative, true,          0.0};

CallForm scalarForm() {
    const auto number = [](const char* name, const char* doc, Range range) {
        return Parameter{name, Kind::kNumber, doc, range};
    };
    return {{number("x", "Position.", kAnyNumber), number("y", "Position.", kAnyNumber),
             number("z", "Position.", kAnyNumber), number("r", "Red.", kAnyNumber),
             number("g", "Green.", kAnyNumber), number("b", "Blue.", kAnyNumber),
             number("c0", "Falloff, constant.", kNotNegative),
             number("c1", "Falloff, by distance.", kNotNegative),
             number("c2", "Falloff, by the square of the distance.", kNotNegative), kRadius,
             kBrightness},
            scalarLight,
            startsWithNumber};
}

CallResult focal(Call& call) {
    FocalDesc desc;
    if (call.arguments().isTable(Call::slot(0))) {
        desc.focus = call.arguments().tuple(Call::slot(0), {"p"}, kAnyNumber);
    } else {
        desc.focus = call.arguments().number(Call::slot(0), {"p"}, kPositive);
    }
    desc.focalLength = call.number(1);
    desc.lensRadius = call.number(2);
    const double* distance = std::get_if<double>(&desc.focus);
    if (distance && !(desc.focalLength < *distance)) {
        call.scene.fail("f must be < p (got f " + numberText(desc.focalLength) + ", p " +
                        numberText(*distance) + ")");
    }
    return call.scene.addFocal(desc);
}

}  // namespace

std::vector<CallRow> lightCalls() {
    return {
        {"light",
         "A light in the form of a sphere, itself invisible. At distance d it gives its colour / "
         "(c0 + c1 d + c2 d^2).",
         {scalarForm(),
          {{{"position", Kind::kTuple, "Its centre."},
            {"colour", Kind::kColor, "{r,g,b}."},
            {"falloff", Kind::kTuple, "{c0,c1,c2}.", kNotNegative},
            kRadius,
            kBrightness},
           light}},
         "gr.light"},
        {"focal",
         "A thin lens.",
         {{{{"p",
             Kind::kAny,
             "Distance to the plane in focus along the view direction, or the point {x,y,z} to "
             "focus on.",
             {},
             false,
             {},
             "number|gr.tuple"},
            {"f", Kind::kNumber, "Focal length, below p; kept, but without effect on the picture.",
             kPositive},
            {"a", Kind::kNumber, "Radius of the lens; 0 is a pinhole.", kNotNegative}},
           focal}},
         "gr.focal"},
    };
}

}  // namespace rt
