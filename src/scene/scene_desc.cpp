#include "rt/scene/scene_desc.h"

#include <algorithm>

namespace rt {

const NodeState& NodeDesc::at(std::size_t render) const {
    const auto later = std::upper_bound(
        versions_.begin(), versions_.end(), render,
        [](std::size_t k, const Version& version) { return k < version.firstRender; });
    return std::prev(later)->state;  // the first version is of render 0
}

NodeState& NodeDesc::edit(std::size_t rendersSoFar) {
    if (versions_.back().firstRender != rendersSoFar) {
        versions_.push_back({rendersSoFar, versions_.back().state});
    }
    return versions_.back().state;
}

}  // namespace rt
