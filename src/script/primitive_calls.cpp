#include "call_table.h"

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Parameter kName{"name", Kind::kText, "What messages call the node."};

CallResult addPrimitive(Call& call, GeometryShape shape) {
    return call.scene.addNode(call.text(0), call.scene.addGeometry(std::move(shape)));
}

CallResult sphere(Call& call) {
    return addPrimitive(call, Sphere(Vec3(0.0), 1.0));
}

CallResult cube(Call& call) {
    return addPrimitive(call, Box(Vec3(0.0), Vec3(1.0)));
}

CallResult cylinder(Call& call) {
    return addPrimitive(call, Cylinder(Vec3(0.0, -1.0, 0.0), 2.0, 1.0));
}

CallResult cone(Call& call) {
    return addPrimitive(call, Cone(Vec3(0.0), 1.0, 1.0));
}

CallResult torus(Call& call) {
    return addPrimitive(call, Torus(Vec3(0.0), call.number(1), call.number(2)));
}

CallResult placedSphere(Call& call) {
    return addPrimitive(call, Sphere(call.tuple(1), call.number(2)));
}

CallResult placedCube(Call& call) {
    return addPrimitive(call, Box(call.tuple(1), Vec3(call.number(2))));
}

CallResult placedBox(Call& call) {
    return addPrimitive(call, Box(call.tuple(1), call.tuple(2)));
}

CallResult placedCylinder(Call& call) {
    return addPrimitive(call, Cylinder(call.tuple(1), call.number(2), call.number(3)));
}

CallResult placedCone(Call& call) {
    return addPrimitive(call, Cone(call.tuple(1), call.number(2), call.number(3)));
}

CallResult placedTorus(Call& call) {
    return addPrimitive(call, Torus(call.tuple(1), call.number(2), call.number(3)));
}

bool sizeIsTable(const Arguments& arguments) {
    return arguments.isTable(Call::slot(2));
}

Parameter point(const char* name, const char* doc) {
    return {name, Kind::kTuple, doc};
}

Parameter length(const char* name, const char* doc) {
    return {name, Kind::kNumber, doc, kPositive};
}

std::vector<CallRow> unitPrimitives() {
    return {
        {"sphere", "A sphere of radius 1 about the origin.", {{{kName}, sphere}}},
        {"cube", "The cube from (0,0,0) to (1,1,1).", {{{kName}, cube}}},
        {"cylinder",
         "A capped cylinder of radius 1 about the y axis, from y = -1 to 1.",
         {{{kName}, cylinder}}},
        {"cone",
         "A capped cone about the y axis: its apex at the origin, its radius 1 at y = 1.",
         {{{kName}, cone}}},
        {"torus",
         "A torus about the z axis, its centre at the origin.",
         {{{kName,
            {"R", Kind::kNumber, "Radius of the circle in the tube's middle.", kPositive, true,
             1.0},
            {"r", Kind::kNumber, "Radius of the tube.", kPositive, true, 0.25}},
           torus}}},
    };
}

}  // namespace

std::vector<CallRow> primitiveCalls() {
    std::vector<CallRow> rows = unitPrimitives();
    rows.push_back({"nh_sphere",
                    "A sphere.",
                    {{{kName, point("centre", "Its centre."), length("radius", "Its radius.")},
                      placedSphere}}});
    rows.push_back(
        {"nh_box",
         "A box: the cube of edge r, or the box of edges {a,b,c}, from its least corner.",
         {{{kName,
            point("corner", "The corner of the least x, y and z."),
            {"size", Kind::kTuple, "The edges along x, y and z.", kPositive}},
           placedBox,
           sizeIsTable},
          {{kName, point("corner", "The corner of the least x, y and z."),
            length("r", "The edge of the cube.")},
           placedCube}}});
    rows.push_back({"nh_cylinder",
                    "A capped cylinder about a line parallel to the y axis.",
                    {{{kName, point("base", "The centre of its lower cap."),
                       length("h", "Its height."), length("r", "Its radius.")},
                      placedCylinder}}});
    rows.push_back({"nh_cone",
                    "A capped cone about a line parallel to the y axis, opening upwards.",
                    {{{kName, point("apex", "Its apex."), length("h", "Its height."),
                       length("r", "Its radius at the cap.")},
                      placedCone}}});
    rows.push_back({"nh_torus",
                    "A torus about a line parallel to the z axis; r > R gives a spindle torus, all "
                    "of whose surface is real.",
                    {{{kName, point("centre", "Its centre."),
                       length("R", "Radius of the circle in the tube's middle."),
                       length("r", "Radius of the tube.")},
                      placedTorus}}});
    for (CallRow& row : rows) row.returns = "gr.node";
    return rows;
}

}  // namespace rt
