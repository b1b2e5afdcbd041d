#include "object_types.h"

#include "call_table.h"
#include "lua_access.h"
#include "lua_state.h"

#include "rt/core/diagnostics.h"

#include <array>

namespace rt {

namespace {

// The registry keeps each kind's metatable under the address of its tag, and the table of methods
// under the address of kLibraryTag: a script reaches neither.
std::array<char, kObjectKinds> kKindTags;
char kLibraryTag;

constexpr ObjectKind kAllKinds[] = {ObjectKind::kNode, ObjectKind::kMaterial, ObjectKind::kTexture,
                                    ObjectKind::kBump, ObjectKind::kLight,    ObjectKind::kFocal};

void* tagOf(ObjectKind kind) {
    return &kKindTags[static_cast<std::size_t>(kind)];
}

const SceneBuilder& builderOf(lua_State* L) {
    return *static_cast<const SceneBuilder*>(contextOf(L));
}

int objectToString(lua_State* L) {
    const auto object = objectAt(L, 1, builderOf(L));
    pushText(L, object ? builderOf(L).describe(*object) : typeNameOf(L, 1));
    return 1;
}

std::string fieldName(lua_State* L, int slot) {
    return printable(toText(L, slot).value_or(typeNameOf(L, slot)), 64);
}

/// Methods are looked up in gr; a name that is not there is a spelling mistake, never nil.
int nodeIndex(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &kLibraryTag);
    lua_pushvalue(L, 2);
    lua_rawget(L, -2);
    if (!lua_isnil(L, -1)) return 1;
    const std::string name = fieldName(L, 2);
    throw SceneError("gr.node has no method '" + name + "'" + didYouMean(name, callNames()),
                     callerLocation(L));
}

int objectIndex(lua_State* L) {
    const auto object = objectAt(L, 1, builderOf(L));
    const std::string kind = object ? objectKindName(object->kind) : typeNameOf(L, 1);
    throw SceneError(kind + " has no field '" + fieldName(L, 2) + "'", callerLocation(L));
}

int refuseField(lua_State* L) {
    const auto object = objectAt(L, 1, builderOf(L));
    const std::string kind = object ? objectKindName(object->kind) : typeNameOf(L, 1);
    throw SceneError(kind + " takes no fields of its own (tried to set '" + fieldName(L, 2) +
                         "'); keep such values in a table",
                     callerLocation(L));
}

}  // namespace

void registerObjectTypes(lua_State* L, int library) {
    lua_pushvalue(L, library);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &kLibraryTag);
    for (const ObjectKind kind : kAllKinds) {
        lua_newtable(L);
        const int metatable = lua_gettop(L);
        for (const char* key : {"__name", "__metatable"}) {
            pushText(L, objectKindName(kind));
            assignField(L, metatable, key);
        }
        assignFunction(L, metatable, "__tostring", guarded<objectToString>);
        assignFunction(L, metatable, "__newindex", guarded<refuseField>);
        const bool isNode = kind == ObjectKind::kNode;
        assignFunction(L, metatable, "__index", isNode ? guarded<nodeIndex> : guarded<objectIndex>);
        lua_rawsetp(L, LUA_REGISTRYINDEX, tagOf(kind));
    }
}

void pushObject(lua_State* L, ObjectRef object) {
    *static_cast<ObjectRef*>(lua_newuserdata(L, sizeof(ObjectRef))) = object;
    lua_rawgetp(L, LUA_REGISTRYINDEX, tagOf(object.kind));
    lua_setmetatable(L, -2);
}

std::optional<ObjectRef> objectAt(lua_State* L, int slot, const SceneBuilder& builder) {
    const bool candidate =
        lua_type(L, slot) == LUA_TUSERDATA && lua_rawlen(L, slot) == sizeof(ObjectRef);
    if (!candidate || !lua_getmetatable(L, slot)) return std::nullopt;
    std::optional<ObjectRef> found;
    for (const ObjectKind kind : kAllKinds) {
        lua_rawgetp(L, LUA_REGISTRYINDEX, tagOf(kind));
        const bool same = lua_rawequal(L, -1, -2) != 0;
        lua_pop(L, 1);
        if (!same) continue;
        // With debug.setmetatable another userdata may wear our metatable: believe no index.
        const ObjectRef object = *static_cast<const ObjectRef*>(lua_touserdata(L, slot));
        if (object.kind == kind && object.index < builder.count(kind)) found = object;
        break;
    }
    lua_pop(L, 1);
    return found;
}

}  // namespace rt
