#include "flatten.h"

#include <limits>
#include <utility>
#include <vector>

namespace rt {
namespace {

std::uint64_t saturatingAdd(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t sum = a + b;
    return sum < a ? std::numeric_limits<std::uint64_t>::max() : sum;
}

}  // namespace

AppearanceDesc over(const AppearanceDesc& edge, const AppearanceDesc& own) {
    AppearanceDesc result = own;
    if (edge.material != kNone || edge.texture != kNone) {
        result.material = edge.material;
        result.texture = edge.texture;
    }
    if (edge.bump != kNone) result.bump = edge.bump;
    return result;
}

std::uint64_t countPlaced(const SceneDesc& scene, Index root, std::size_t render) {
    constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();
    struct Visit {
        Index node;
        std::size_t nextChild;
        std::uint64_t count;
    };
    const auto ownCount = [&](Index node) -> std::uint64_t {
        return scene.nodes[node].geometry != kNone ? 1 : 0;
    };
    std::vector<std::uint64_t> known(scene.nodes.size(), kUnknown);
    std::vector<Visit> stack{{root, 0, ownCount(root)}};
    for (;;) {
        Visit& top = stack.back();
        const auto& children = scene.nodes[top.node].at(render).children;
        if (top.nextChild < children.size()) {
            const Index child = children[top.nextChild].child;
            if (known[child] == kUnknown) {
                stack.push_back({child, 0, ownCount(child)});
            } else {
                top.count = saturatingAdd(top.count, known[child]);
                ++top.nextChild;
            }
            continue;
        }
        // One less than the mark for "not known": a count that large is refused either way.
        known[top.node] = std::min(top.count, kUnknown - 1);
        if (stack.size() == 1) return known[top.node];
        stack.pop_back();
    }
}

void forEachPlaced(const SceneDesc& scene, Index root, std::size_t render,
                   const std::function<void(const PlacedNode&)>& visit) {
    struct Pending {
        Index node;
        Affine toParent;
        MotionPath motion;
        AppearanceDesc edge;
    };
    std::vector<Pending> stack{{root, {}, {}, {}}};
    while (!stack.empty()) {
        const Pending here = std::move(stack.back());
        stack.pop_back();
        const NodeDesc& node = scene.nodes[here.node];
        const NodeState& state = node.at(render);
        const Affine toWorld = compose(here.toParent, state.transform);
        const MotionPath motion =
            compose(here.motion, here.toParent, state.motion, state.transform);
        if (node.geometry != kNone) {
            visit({here.node, toWorld, motion, over(here.edge, state.appearance)});
        }
        for (auto edge = state.children.rbegin(); edge != state.children.rend(); ++edge) {
            stack.push_back({edge->child, toWorld, motion, edge->appearance});
        }
    }
}

}  // namespace rt
