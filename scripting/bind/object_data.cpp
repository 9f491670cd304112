// Methods are found first, by the metatable's function; then `data`.
#include "bind/object_data.h"

#include "bind/fields.h"

namespace cairn::scripting {
namespace {

bool is_data(lua_State* L) {
    return lua_type(L, 2) == LUA_TSTRING && std::string_view(lua_tostring(L, 2)) == "data";
}

/// object.name; upvalue 1 is the table of the methods, which itself raises for what it lacks.
int get_field(lua_State* L) {
    lua_settop(L, 2);
    if (!is_data(L)) {
        lua_gettable(L, lua_upvalueindex(1));
        return 1;
    }
    if (lua_getiuservalue(L, 1, kDataValue) == LUA_TTABLE) return 1;
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, 1, kDataValue);
    return 1;
}

/// object.data = t; every other assignment is refused.
int set_field(lua_State* L) {
    if (!is_data(L)) refuse_field(L, /*has_data=*/true);
    if (!lua_istable(L, 3))
        raise(L, std::string(object_type_name(L, 1)) + ".data is " + describe_value(L, 3) +
                     "; expected a table");
    lua_settop(L, 3);
    lua_setiuservalue(L, 1, kDataValue);
    return 0;
}

}  // namespace

void register_type_with_data(lua_State* L, ObjectTag tag, const Module& methods, lua_CFunction finalize) {
    register_type(L, tag, methods, finalize);
    push_metatable(L, tag);
    lua_getfield(L, -1, "__index");
    lua_pushcclosure(L, get_field, 1);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, set_field);
    lua_setfield(L, -2, "__newindex");
    lua_pop(L, 1);
}

void set_data(lua_State* L) {
    lua_setiuservalue(L, -2, kDataValue);
}

}  // namespace cairn::scripting
