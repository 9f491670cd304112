// Names and metatables of the object types.
#include "bind/object.h"

namespace cairn::scripting {
namespace {

/// Registry keys: the address of one byte per type.
char metatable_keys[kObjectTagCount];

}  // namespace

const char* object_type_name(lua_State* L, int index) {
    return object_type_name(static_cast<ObjectHeader*>(lua_touserdata(L, index))->tag);
}

void push_metatable(lua_State* L, ObjectTag tag) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &metatable_keys[static_cast<int>(tag)]);
}

void set_metatable(lua_State* L, ObjectTag tag) {
    lua_rawsetp(L, LUA_REGISTRYINDEX, &metatable_keys[static_cast<int>(tag)]);
}

}  // namespace cairn::scripting
