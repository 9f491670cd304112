// Which Lua values belong to a world that went back in time.
//
// A handle names the same body before and after a restore, so a body that is there before and after keeps its
// value. One that was destroyed in between has it from the snapshot, which holds the values of its bodies.
// Invariant: what a script sees does not depend on when garbage is collected.
#include "bind/snapshot.h"

#include "bind/fields.h"

namespace cairn::scripting {
namespace {

/// The list of values beside the bytes, on top of the stack: only bodies, and as a snapshot has it, so
/// without holes.
void check_bodies(lua_State* L) {
    if (lua_isnil(L, -1)) return;
    const std::string rule = "the list that world:snapshot() gave, or nil";
    if (!lua_istable(L, -1)) call_error(L, "bodies is " + describe_value(L, -1) + "; expected " + rule);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        if (!is_object(L, -1, ObjectTag::Body))
            call_error(L, "bodies[" + std::to_string(i) + "] is " + describe_value(L, -1) +
                              "; expected a Body, as in " + rule);
        lua_pop(L, 1);
    }
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
        lua_pop(L, 1);
        if (lua_isinteger(L, -1) == 0 || lua_tointeger(L, -1) < 1 || lua_tointeger(L, -1) > count)
            call_error(L, "bodies has the key " + describe_value(L, -1) + "; expected " + rule);
    }
}

std::string_view bytes_of(lua_State* L, int index) {
    if (lua_type(L, index) == LUA_TTABLE) {
        lua_getfield(L, index, "bytes");
        lua_replace(L, index);
    }
    if (lua_type(L, index) != LUA_TSTRING) {
        argument_error(L, index, "a snapshot: what world:snapshot() gave, or the string in its field bytes");
    }
    return Argument<std::string_view>::get(L, index);
}

}  // namespace

Pushed snapshot(lua_State* L, WorldRef self) {
    check_or_raise(L, self.world.snapshot(self.object.last_snapshot));
    const std::span<const std::byte> bytes = self.object.last_snapshot.bytes();
    lua_createtable(L, 0, 2);
    lua_pushlstring(L, reinterpret_cast<const char*>(bytes.data()), bytes.size());
    lua_setfield(L, -2, "bytes");
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::BodyId id : self.world.bodies()) {
        push_body(L, self.index, id);
        lua_rawseti(L, -2, ++count);
    }
    lua_setfield(L, -2, "bodies");
    return {1};
}

void restore(lua_State* L, WorldRef self, AnyArgument snapshot) {
    lua_settop(L, snapshot.index);
    lua_pushnil(L);
    const int values = lua_gettop(L);  // the list of the snapshot, or nil
    if (lua_type(L, snapshot.index) == LUA_TTABLE) {
        lua_getfield(L, snapshot.index, "bodies");
        check_bodies(L);
        lua_replace(L, values);
    }
    const std::string_view bytes = bytes_of(L, snapshot.index);
    check_or_raise(L, self.world.restore(std::as_bytes(std::span(bytes))));
    adopt_state(L, self, values);
}

void adopt_state(lua_State* L, WorldRef self, int values) {
    lua_getiuservalue(L, self.index, static_cast<int>(WorldTable::Bodies));
    const int before = lua_gettop(L);
    for (const WorldTable table :
         {WorldTable::Bodies, WorldTable::Retired, WorldTable::RetiredBefore, WorldTable::BrokenJoints}) {
        lua_newtable(L);
        lua_setiuservalue(L, self.index, static_cast<int>(table));
    }
    self.object.steps_with_retired = 0;
    lua_Integer place = 0;
    for (const physics::BodyId id : self.world.bodies()) {
        ++place;
        lua_rawgeti(L, before, static_cast<lua_Integer>(id.index1));
        const auto* known = object_at<BodyObject>(L, -1);
        if ((known == nullptr || !(known->id == id)) && values != 0 && lua_type(L, values) == LUA_TTABLE) {
            lua_pop(L, 1);
            lua_rawgeti(L, values, place);
        }
        revive_body(L, self.index, self.object, id);
    }
}

}  // namespace cairn::scripting
