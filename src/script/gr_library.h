// The global table `gr` of scene scripts.
#pragma once

#include "lua_state.h"
#include "scene_builder.h"

namespace rt {

/// Makes `gr` from the call table. The builder must outlive the state's last callback.
void openGr(LuaState& state, SceneBuilder& builder);

}  // namespace rt
