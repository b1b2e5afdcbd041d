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

Light ballLight(const Vec3& position, const Color& colour, const Vec3& falloff, double radius,
                double brightness) {
    Light light;
    light.position = position;
    light.intensity = colour;
    light.c0 = falloff.x;
    light.c1 = falloff.y;
    light.c2 = falloff.z;
    light.radius = radius;
    light.brightness = brightness;
    return light;
}

CallResult light(Call& call) {
    const Vec3& falloff = call.tuple(2);
    return addLight(
        call, ballLight(call.tuple(0), call.tuple(1), falloff, call.number(3), call.number(4)));
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
    return addLight(call, ballLight(triple(0), color, falloff, call.number(9), call.number(10)));
}

Vec3 falloffOr(Call& call, std::size_t i) {
    return call.given(i) ? call.tuple(i) : Vec3(1.0, 0.0, 0.0);
}

CallResult spot(Call& call) {
    const Light ball =
        ballLight(call.tuple(0), call.tuple(2), falloffOr(call, 3), call.number(6), call.number(7));
    const double outer = call.number(5);
    constexpr double kFullShare = 2.0 / 3.0;
    const double inner = call.given(4) ? call.number(4) : kFullShare * outer;
    if (inner > outer) {
        call.scene.fail("inner must be <= outer (got inner " + numberText(inner) + ", outer " +
                        numberText(outer) + ")");
    }
    return addLight(call, spotLight(ball, unitArgument(call, 1, "direction"), inner, outer));
}

CallResult sun(Call& call) {
    return addLight(call, sunLight(unitArgument(call, 0, "direction"), call.tuple(1),
                                   call.number(2), call.number(3)));
}

CallResult rectangle(Call& call) {
    const Light point =
        ballLight(Vec3(0.0), call.tuple(3), falloffOr(call, 4), 0.0, call.number(5));
    unitArgument(call, 1, "u");
    unitArgument(call, 2, "v");
    return addLight(call, rectangleLight(point, call.tuple(0), call.tuple(1), call.tuple(2)));
}

bool startsWithNumber(const Arguments& in) {
    return in.isNumber(1);
}

constexpr Parameter kRadius{
    "radius",     Kind::kNumber, "Radius of the light's sphere; 0 is a point.",
    kNotNegative, true,          0.0};
constexpr Parameter kBrightness{"brightness", Kind::kNumber, "Floor of n.w in the matt part.",
                                kNotNegative, true,          0.0};

constexpr Parameter kColour{"colour", Kind::kColor, "{r,g,b}."};
constexpr Parameter kFalloff{"falloff", Kind::kTuple, "{c0,c1,c2}; {1,0,0} without it.",
                             kNotNegative, true};
constexpr Range kHalfTurn{0.0, 180.0, false, false};

std::vector<CallRow> namedLights() {
    return {
        {"spot_light",
         "A light whose cone fades smoothly from its full light within inner to none beyond outer.",
         {{{{"position", Kind::kTuple, "Its centre."},
            {"direction", Kind::kTuple, "Where it shines, of any length but zero."},
            kColour,
            kFalloff,
            {"inner", Kind::kNumber,
             "Degrees from the axis to the edge of the full light; 2/3 of outer without it.",
             kHalfTurn, true},
            {"outer", Kind::kNumber, "Degrees from the axis to where there is none.", kHalfTurn,
             true, 30.0},
            kRadius,
            kBrightness},
           spot,
           nullptr,
           true}},
         "gr.light"},
        {"sun_light",
         "A light from infinitely far away, its colour the same at every distance.",
         {{{{"direction", Kind::kTuple, "The way that its light goes, of any length but zero."},
            kColour,
            {"angle",
             Kind::kNumber,
             "Degrees from the middle of its disc to the rim; 0 is a point.",
             {0.0, 90.0, false, true},
             true,
             0.0},
            kBrightness},
           sun,
           nullptr,
           true}},
         "gr.light"},
        {"rectangle_light",
         "A light in the form of a parallelogram, each point of it a point light that shines to "
         "both sides.",
         {{{{"corner", Kind::kTuple, "One of its corners."},
            {"u", Kind::kTuple, "The side from there to the next corner."},
            {"v", Kind::kTuple, "The other side from there."},
            kColour,
            kFalloff,
            kBrightness},
           rectangle,
           nullptr,
           true}},
         "gr.light"},
    };
}

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
    std::vector<CallRow> rows = {
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
    for (CallRow& row : namedLights()) rows.insert(rows.end() - 1, std::move(row));
    return rows;
}

}  // namespace rt
