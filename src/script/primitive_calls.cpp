#include "call_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

CallResult hemisphere(Call& call) {
    return addPrimitive(call, Hemisphere(Vec3(0.0), 1.0));
}

CallResult disc(Call& call) {
    return addPrimitive(call, Disc(1.0));
}

CallResult square(Call& call) {
    return addPrimitive(call, Rectangle(1.0, 1.0));
}

CallResult plane(Call& call) {
    return addPrimitive(call, Plane());
}

CallResult placedHemisphere(Call& call) {
    return addPrimitive(call, Hemisphere(call.tuple(1), call.number(2)));
}

CallResult placedFrustum(Call& call) {
    const double height = call.number(2);
    const double base = call.number(3);
    const double top = call.number(4);
    if (base == top) return addPrimitive(call, Cylinder(call.tuple(1), height, base));
    return addPrimitive(call, Frustum(call.tuple(1), height, base, top));
}

/// The coefficients of a table by their names; what is not named is 0.
QuadricCoefficients coefficientsOf(const Call& call, std::size_t i) {
    QuadricCoefficients k;
    const std::pair<const char*, double*> fields[] = {
        {"xx", &k.xx}, {"yy", &k.yy}, {"zz", &k.zz}, {"xy", &k.xy}, {"yz", &k.yz},
        {"zx", &k.zx}, {"x", &k.x},   {"y", &k.y},   {"z", &k.z},   {"c", &k.c}};
    const Arguments& in = call.arguments();
    std::vector<std::string> known;
    for (const auto& field : fields) known.push_back(field.first);
    for (const std::string& name : in.fieldNames(Call::slot(i), {"coefficients"})) {
        const auto field = std::find_if(std::begin(fields), std::end(fields),
                                        [&](const auto& one) { return name == one.first; });
        if (field == std::end(fields)) {
            call.scene.fail("unknown coefficient '" + printable(name, 64) + "'" +
                            didYouMean(name, known) +
                            " (known: xx, yy, zz, xy, yz, zx, x, y, z, c)");
        }
        in.field(Call::slot(i), name,
                 [&](int value) { *field->second = in.number(value, {field->first}, Range{}); });
    }
    return k;
}

CallResult quadric(Call& call) {
    const Vec3& min = call.tuple(2);
    const Vec3& max = call.tuple(3);
    for (int axis = 0; axis < 3; ++axis) {
        if (max[axis] > min[axis]) continue;
        const std::string part = "[" + std::to_string(axis + 1) + "]";
        call.scene.fail("max" + part + " must be > min" + part + ", " + numberText(min[axis]) +
                        " (got " + numberText(max[axis]) + ")");
    }
    return addPrimitive(call, Quadric(coefficientsOf(call, 1), min, max));
}

/// What is flat lies in y = 0, and is brought to its place by the node's own transform.
CallResult addFlat(Call& call, GeometryShape shape, const Vec3& origin, const Vec3& x,
                   const Vec3& normal, const Vec3& z) {
    const ObjectRef node =
        call.scene.addNode(call.text(0), call.scene.addGeometry(std::move(shape)));
    call.scene.edit(node.index).transform = {Mat3(x, normal, z), origin};
    return node;
}

/// A disc or a plane about a point; images stand upright on it.
CallResult addFacing(Call& call, GeometryShape shape) {
    const Vec3 normal = unitArgument(call, 2, "normal");
    const Vec3 level = unitOf(Vec3(normal.z, 0.0, -normal.x)).value_or(Vec3(1.0, 0.0, 0.0));
    return addFlat(call, std::move(shape), call.tuple(1), level, normal, glm::cross(level, normal));
}

CallResult placedDisc(Call& call) {
    return addFacing(call, Disc(call.number(3)));
}

CallResult placedPlane(Call& call) {
    return addFacing(call, Plane());
}

CallResult placedQuad(Call& call) {
    const Vec3& corner = call.tuple(1);
    const Vec3& u = call.tuple(2);
    const Vec3& v = call.tuple(3);
    const Vec3 x = unitArgument(call, 2, "u");
    const Vec3 up = unitArgument(call, 3, "v");
    const std::optional<Vec3> normal = unitOf(glm::cross(x, up));
    if (!normal) call.scene.fail("u and v must not be parallel");
    return addFlat(call, Rectangle(glm::dot(u, x), glm::dot(v, up)), corner + v, x, *normal, -up);
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
        {"hemisphere",
         "The upper half of the ball of radius 1 about the origin, closed below.",
         {{{kName}, hemisphere}}},
        {"disc",
         "The disc of radius 1 about the origin in the plane y = 0, facing +y.",
         {{{kName}, disc}}},
        {"quad", "The square from (0,0,0) to (1,0,1), facing +y.", {{{kName}, square}}},
        {"plane", "The whole plane y = 0, facing +y.", {{{kName}, plane}}},
    };
}

std::vector<CallRow> placedSheets() {
    return {
        {"nh_disc",
         "A disc.",
         {{{kName, point("centre", "Its centre."),
            point("normal", "Where it faces, of any length but zero."),
            length("radius", "Its radius.")},
           placedDisc}}},
        {"nh_quad",
         "A rectangle, or any parallelogram, that faces where u x v points; images are upright on "
         "it, u to their right and v to their top.",
         {{{kName, point("corner", "One of its corners."),
            point("u", "The side from there to the next corner."),
            point("v", "The other side from there.")},
           placedQuad}}},
        {"nh_plane",
         "A whole plane.",
         {{{kName, point("p", "A point of it."),
            point("normal", "Where it faces, of any length but zero.")},
           placedPlane}}},
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
    rows.push_back(
        {"nh_hemisphere",
         "The upper half of a ball, closed below.",
         {{{kName, point("centre", "The centre of the ball."), length("radius", "Its radius.")},
           placedHemisphere}}});
    rows.push_back({"nh_frustum",
                    "A cone without its tip, capped, about a line parallel to the y axis.",
                    {{{kName, point("base", "The centre of its lower cap."),
                       length("h", "Its height."), length("r0", "Its radius at the lower cap."),
                       length("r1", "Its radius at the upper cap.")},
                      placedFrustum}}});
    rows.push_back(
        {"quadric",
         "What lies in a box where xx x^2 + yy y^2 + zz z^2 + xy x y + yz y z + zx z x + x x + y y "
         "+ z z + c <= 0; the box's faces close it.",
         {{{kName,
            {"coefficients",
             Kind::kTable,
             "{xx=, yy=, zz=, xy=, yz=, zx=, x=, y=, z=, c=}; what is left out is 0.",
             {},
             false,
             {},
             "table<string, number>"},
            point("min", "The box's corner of the least x, y and z."),
            point("max", "Its corner of the largest.")},
           quadric}}});
    for (CallRow& row : placedSheets()) rows.push_back(std::move(row));
    for (CallRow& row : rows) row.returns = "gr.node";
    return rows;
}

}  // namespace rt
