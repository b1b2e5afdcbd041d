#include "call_table.h"

#include "rt/core/numeric.h"
#include "rt/core/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Range kPixels{1.0, static_cast<double>(std::numeric_limits<int>::max()), false, false};
constexpr Range kFieldOfView{0.0, 180.0, true, true};

const std::vector<std::string>& outputExtensions() {
    static const std::vector<std::string> known{".png", ".exr", ".hdr", ".tif", ".tiff", ".pfm"};
    return known;
}

std::string extensionOf(const std::string& file) {
    const std::string base = file.substr(file.find_last_of('/') + 1);
    const std::size_t dot = base.find_last_of('.');
    if (dot == std::string::npos || dot == 0) return "";
    std::string extension = base.substr(dot);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void checkOutput(const Call& call, const std::string& file) {
    const std::string quoted = "'" + printable(file, 256) + "'";
    if (file.empty()) call.scene.fail("file must not be empty");
    if (file.find('\0') != std::string::npos) call.scene.fail("file " + quoted + " holds a NUL");
    if (file.back() == '/') call.scene.fail("file " + quoted + " names a folder");
    const auto& known = outputExtensions();
    const std::string extension = extensionOf(file);
    if (std::find(known.begin(), known.end(), extension) != known.end()) return;
    call.scene.fail("file " + quoted + " must end in one of " + joined(known));
}

double largest(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Parallel to within the rounding of the components: |a x b| <= gamma(4) |a| |b|.
bool areParallel(const Vec3& view, const Vec3& up) {
    const Vec3 a = view / largest(view);
    const Vec3 b = up / largest(up);
    const Vec3 cross(differenceOfProducts(a.y, b.z, a.z, b.y),
                     differenceOfProducts(a.z, b.x, a.x, b.z),
                     differenceOfProducts(a.x, b.y, a.y, b.x));
    return !(glm::length(cross) > gamma(4) * glm::length(a) * glm::length(b));
}

/// The axis that is farthest from the view (z before x before y), turned so that a camera that
/// tilts down from -z ends with -z at the top of its image, and one that tilts up with +z.
Vec3 otherUp(const Vec3& view) {
    int axis = 2;
    if (std::abs(view.x) < std::abs(view[axis])) axis = 0;
    if (std::abs(view.y) < std::abs(view[axis])) axis = 1;
    Vec3 up(0.0);
    up[axis] = view.y > 0.0 ? 1.0 : -1.0;
    return axis == 2 ? up : glm::abs(up);
}

CameraDesc camera(Call& call) {
    CameraDesc camera;
    camera.eye = call.tuple(4);
    camera.view = call.tuple(5);
    camera.up = call.tuple(6);
    camera.fovDegrees = call.number(7);
    if (camera.view == Vec3(0.0)) call.scene.fail("view must not be zero");
    if (camera.up == Vec3(0.0)) call.scene.fail("up must not be zero");
    if (areParallel(camera.view, camera.up)) {
        camera.up = otherUp(camera.view);
        call.scene.warnOnce("parallel-up", "view and up are parallel; {" + numberText(camera.up.x) +
                                               "," + numberText(camera.up.y) + "," +
                                               numberText(camera.up.z) + "} is taken as up");
    }
    return camera;
}

/// A point to focus on must lie in front of the eye, farther than the focal length.
void checkFocus(const Call& call, const CameraDesc& camera) {
    const Vec3* point = std::get_if<Vec3>(&camera.focal->focus);
    if (!point) return;
    const Vec3 view = camera.view / largest(camera.view);
    const double distance = glm::dot(*point - camera.eye, view) / glm::length(view);
    if (distance > camera.focal->focalLength && std::isfinite(distance)) return;
    call.scene.fail("the point to focus on must lie farther along view than the focal length " +
                    numberText(camera.focal->focalLength) + " (got " + numberText(distance) + ")");
}

CallResult render(Call& call) {
    RenderDesc desc;
    desc.root = call.object(0);
    desc.output = call.text(1);
    checkOutput(call, desc.output);
    desc.width = static_cast<int>(call.number(2));
    desc.height = static_cast<int>(call.number(3));
    desc.camera = camera(call);
    desc.ambient = call.tuple(8);
    for (const Index light : call.objects(9)) desc.lights.push_back(call.scene.light(light));
    if (desc.lights.empty()) {
        call.scene.warnOnce("no-lights", "there are no lights: only ambient light is left");
    }
    if (call.given(10)) {
        desc.camera.focal = call.scene.focal(call.object(10));
        checkFocus(call, desc.camera);
    }
    call.scene.addRender(std::move(desc));
    return {};
}

CallResult plainBackground(Call& call) {
    call.scene.setBackground({call.tuple(0), call.tuple(0), kNone});
    return {};
}

CallResult gradientBackground(Call& call) {
    call.scene.setBackground({call.tuple(0), call.tuple(1), kNone});
    return {};
}

CallResult imageBackground(Call& call) {
    const Index image = call.scene.image(call.text(0), AssetRole::kTexture);
    call.scene.setBackground({Color(0.0), Color(0.0), image});
    return {};
}

bool startsWithString(const Arguments& in) {
    return in.isString(1);
}

bool hasTwo(const Arguments& in) {
    return in.isGiven(2);
}

CallRow backgroundCall() {
    return {"background",
            "What a ray sees that meets nothing: one colour, a gradient by the direction's y, or a "
            "longitude/latitude image. For the renders that follow; black unless it is set.",
            {{{{"file", Kind::kText, "The image: its centre at -z, its right half towards +x."}},
              imageBackground,
              startsWithString},
             {{{"bottom", Kind::kColor, "{r,g,b} straight down."},
               {"top", Kind::kColor, "{r,g,b} straight up."}},
              gradientBackground,
              hasTwo},
             {{{"colour", Kind::kColor, "{r,g,b}."}}, plainBackground}}};
}

}  // namespace

std::vector<CallRow> renderCalls() {
    return {
        {"render",
         "Asks for an image of the node and what hangs under it, as they are now: changes after "
         "the call do not alter it.",
         {{{{"node", Kind::kNode, "The root of the scene."},
            {"file", Kind::kText, "The image file; its ending decides the format."},
            {"w", Kind::kWholeNumber, "Width in pixels.", kPixels},
            {"h", Kind::kWholeNumber, "Height in pixels.", kPixels},
            {"eye", Kind::kTuple, "Where the camera stands."},
            {"view", Kind::kTuple, "Where it looks: a direction of any length."},
            {"up", Kind::kTuple, "What is up in the image; need not be orthogonal to view."},
            {"fov", Kind::kNumber, "Vertical field of view in degrees.", kFieldOfView},
            {"ambient", Kind::kColor, "{r,g,b} of the ambient light."},
            {"lights", Kind::kLights, "A table of lights."},
            {"focal", Kind::kFocal, "The lens; a pinhole without it.", {}, true}},
           render}}},
        backgroundCall(),
    };
}

}  // namespace rt
