#include "call_table.h"

#include <algorithm>

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Parameter kName{"name", Kind::kText, "What messages call the node."};
constexpr Parameter kNode{"node", Kind::kNode, "The node."};

CallResult node(Call& call) {
    return call.scene.addNode(call.text(0));
}

/// The middle of {min, init, max}, brought into the range with a warning.
double jointAngle(Call& call, std::size_t i, const char* name) {
    const Vec3& range = call.tuple(i);
    const double least = std::min(range.x, range.z);
    const double most = std::max(range.x, range.z);
    if (range.x > range.z) {
        call.scene.warnOnce("joint-range", std::string(name) + ": min " + numberText(range.x) +
                                               " is above max " + numberText(range.z) +
                                               "; they are swapped");
    }
    const double angle = std::clamp(range.y, least, most);
    if (angle != range.y) {
        call.scene.warnOnce("joint-range", std::string(name) + ": the initial angle " +
                                               numberText(range.y) + " lies outside " +
                                               numberText(least) + " .. " + numberText(most) +
                                               "; " + numberText(angle) + " is used");
    }
    return angle;
}

CallResult joint(Call& call) {
    const Affine aboutX = Affine::rotate(0, jointAngle(call, 1, "x"));
    const Affine aboutY = Affine::rotate(1, jointAngle(call, 2, "y"));
    const ObjectRef made = call.scene.addNode(call.text(0));
    call.scene.edit(made.index).transform = compose(aboutY, aboutX);
    return made;
}

bool isInvertible(const Affine& map) {
    Transform unused;
    return Transform::make(map, unused);
}

/// A node that the script has not flattened itself must keep an inverse.
void multiply(Call& call, const Affine& map, bool flattens) {
    NodeState& state = call.scene.edit(call.object(0));
    const bool legacy = call.scene.settings().legacyTransforms;
    const Affine product = legacy ? compose(state.transform, map) : compose(map, state.transform);
    if (!product.isFinite()) call.scene.fail("the node's matrix is no longer finite");
    if (!flattens && !isInvertible(product) && isInvertible(state.transform)) {
        call.scene.fail("the node's matrix has no finite inverse any more");
    }
    state.transform = product;
    MotionPath& motion = state.motion;
    if (!motion.moves()) return;
    Affine& part = legacy ? motion.steps.front().before : motion.last;
    part = legacy ? compose(part, map) : compose(map, part);
}

/// Has the node move, too: after all that was said before, or, by the old order, before it.
void addStep(Call& call, MotionStep step) {
    NodeState& state = call.scene.edit(call.object(0));
    MotionPath& motion = state.motion;
    if (call.scene.settings().legacyTransforms) {
        if (!motion.moves()) motion.last = state.transform;
        motion.steps.insert(motion.steps.begin(), step);
    } else {
        step.before = motion.moves() ? motion.last : state.transform;
        motion.last = {};
        motion.steps.push_back(step);
    }
}

CallResult move(Call& call) {
    const Vec3 by(call.number(1), call.number(2), call.number(3));
    if (by != Vec3(0.0)) addStep(call, {.before = {}, .by = by});
    return {};
}

CallResult spin(Call& call) {
    const double degrees = call.number(2);
    if (degrees != 0.0) {
        addStep(call, {.before = {},
                       .by = Vec3(0.0),
                       .axis = static_cast<int>(call.number(1)),
                       .degrees = degrees});
    }
    return {};
}

CallResult rotate(Call& call) {
    multiply(call, Affine::rotate(static_cast<int>(call.number(1)), call.number(2)), false);
    return {};
}

CallResult translate(Call& call) {
    const Vec3 by(call.number(1), call.number(2), call.number(3));
    multiply(call, Affine::translate(by), false);
    return {};
}

CallResult scale(Call& call) {
    const Vec3 by(call.number(1), call.number(2), call.number(3));
    const bool flattens = by.x == 0.0 || by.y == 0.0 || by.z == 0.0;
    if (flattens) {
        call.scene.warnOnce("flat", "'" + printable(call.scene.node(call.object(0)).name, 64) +
                                        "' is scaled by 0: the object is flat and is skipped");
    }
    multiply(call, Affine::scale(by), flattens);
    return {};
}

CallResult addChild(Call& call) {
    AppearanceDesc appearance{call.object(2), call.object(3), call.object(4)};
    const NodeDesc& child = call.scene.node(call.object(1));
    const bool given = call.given(2) || call.given(3) || call.given(4);
    if (given && child.geometry == kNone) {
        call.scene.warnOnce("group-appearance", "the appearance is ignored: '" +
                                                    printable(child.name, 64) + "' is a group");
        appearance = {};
    }
    call.scene.addChild(call.object(0), call.object(1), appearance);
    return {};
}

}  // namespace

std::vector<CallRow> nodeCalls() {
    const auto number = [](const char* name, const char* doc) {
        return Parameter{name, Kind::kNumber, doc};
    };
    return {
        {"node", "An empty node with the identity transform.", {{{kName}, node}}, "gr.node"},
        {"joint",
         "A node that is turned by its two initial angles in degrees: first about x, then about y.",
         {{{kName,
            {"x", Kind::kTuple, "{min, init, max} of the turn about x."},
            {"y", Kind::kTuple, "{min, init, max} of the turn about y."}},
           joint}},
         "gr.node"},
        {"rotate",
         "Turns the node about an axis, right-handed.",
         {{{kNode,
            {"axis", Kind::kAxis, "'x', 'y' or 'z', in either case."},
            number("degrees", "The angle.")},
           rotate}}},
        {"translate",
         "Moves the node.",
         {{{kNode, number("dx", "Along x."), number("dy", "Along y."), number("dz", "Along z.")},
           translate}}},
        {"move",
         "Has the node move straight on by this much while the shutter is open.",
         {{{kNode, number("dx", "Along x."), number("dy", "Along y."), number("dz", "Along z.")},
           move}}},
        {"spin",
         "Has the node turn evenly about an axis, right-handed, while the shutter is open.",
         {{{kNode,
            {"axis", Kind::kAxis, "'x', 'y' or 'z', in either case."},
            number("degrees", "By how much.")},
           spin}}},
        {"scale",
         "Scales the node about the origin; negative factors mirror it.",
         {{{kNode, number("sx", "Along x."), number("sy", "Along y."), number("sz", "Along z.")},
           scale}}},
        {"add_child",
         "Hangs a node under this one. The appearance belongs to this place in the graph and "
         "overrides the child's own. A cycle is refused.",
         {{{kNode,
            {"child", Kind::kNode, "The node to hang under this one; it may have many parents."},
            {"material", Kind::kMaterial, "Its material here.", {}, true},
            {"texture", Kind::kTexture, "Its texture here.", {}, true},
            {"bump", Kind::kBump, "Its bump map here.", {}, true}},
           addChild}}},
    };
}

}  // namespace rt
