// The userdata that scripts hold: nodes, materials, textures, bump maps, lights and lenses. Each is
// a kind and an index; what it stands for lives in the builder and outlives every Lua value.
#pragma once

#include "scene_builder.h"
#include "trampoline.h"

#include <optional>

namespace rt {

/// Makes the metatables of all kinds, locked and without finalisers. `library` is the stack slot of
/// the table whose functions are the methods of nodes.
void registerObjectTypes(lua_State* L, int library);

/// Pushes a userdata.
void pushObject(lua_State* L, ObjectRef object);

/// The object at a stack slot, if it is a userdata that pushObject made in this state.
std::optional<ObjectRef> objectAt(lua_State* L, int slot, const SceneBuilder& builder);

}  // namespace rt
