// Names and metatables of the object types.
#include "bind/object.h"

#include "bind/fields.h"
#include "lua/errors.h"

namespace cairn::scripting {
namespace {

/// Registry keys: the address of one byte per type.
char metatable_keys[kObjectTagCount];

int set_field(lua_State* L) {
    refuse_field(L, /*has_data=*/false);
}

}  // namespace

const char* object_type_name(lua_State* L, int index) {
    return object_type_name(static_cast<ObjectHeader*>(lua_touserdata(L, index))->tag);
}

std::string object_type_with_article(lua_State* L, int index) {
    const std::string type = object_type_name(L, index);
    const bool is_vowel = std::string_view("AEIO").find(type[0]) != std::string_view::npos;  // not a Ui
    return (is_vowel ? "an " : "a ") + type;
}

void refuse_field(lua_State* L, bool has_data) {
    std::string type = object_type_name(L, 1);
    std::string place = "a table, of which the " + type + " may be a key";
    if (has_data) {
        type[0] = static_cast<char>(type[0] + ('a' - 'A'));
        place = type + ".data";
    }
    raise(L, object_type_with_article(L, 1) + " has no field " + describe_value(L, 2) +
                 " to set; keep values of your own in " + place);
}

void refuse_fields(lua_State* L) {
    lua_pushcfunction(L, set_field);
    lua_setfield(L, -2, "__newindex");
}

void push_metatable(lua_State* L, ObjectTag tag) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &metatable_keys[static_cast<int>(tag)]);
}

void set_metatable(lua_State* L, ObjectTag tag) {
    lua_rawsetp(L, LUA_REGISTRYINDEX, &metatable_keys[static_cast<int>(tag)]);
}

}  // namespace cairn::scripting
