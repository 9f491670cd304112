// Names and metatables of the object types.
#include "bind/object.h"

#include <algorithm>
#include <limits>

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

void charge_native_memory(lua_State* L, std::size_t bytes) {
    constexpr std::size_t kMost = std::numeric_limits<int>::max() / 1024;
    const auto kilobytes = static_cast<int>(std::min(bytes / 1024, kMost));
    // None at all would ask for a step of any size.
    if (kilobytes > 0) lua_gc(L, LUA_GCSTEP, kilobytes);
}

}  // namespace cairn::scripting
