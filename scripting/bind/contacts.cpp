// Lists of tables, made when they are asked for: for tools and tests of games, and for the odd question. What
// a game wants to know in each step, events tell without garbage.
#include "bind/contacts.h"

#include <algorithm>
#include <vector>

namespace cairn::scripting {
namespace {

void set_number(lua_State* L, const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}

void push_contact(lua_State* L, int world_index, WorldObject& world, const physics::DebugContact& contact) {
    lua_createtable(L, 0, 8);
    push_body(L, world_index, contact.body_a);
    lua_setfield(L, -2, "body_a");
    push_body(L, world_index, contact.body_b);
    lua_setfield(L, -2, "body_b");
    push_shape(L, world_index, world, contact.shape_a);
    lua_setfield(L, -2, "shape_a");
    push_shape(L, world_index, world, contact.shape_b);
    lua_setfield(L, -2, "shape_b");
    set_number(L, "nx", static_cast<double>(contact.normal.x));
    set_number(L, "ny", static_cast<double>(contact.normal.y));
    set_number(L, "friction_impulse", static_cast<double>(contact.friction_impulse_ns));
    lua_createtable(L, contact.count, 0);
    for (int i = 0; i < contact.count; ++i) {
        const physics::DebugContactPoint& point = contact.points[static_cast<std::size_t>(i)];
        lua_createtable(L, 0, 4);
        set_number(L, "x", point.point_m.x);
        set_number(L, "y", point.point_m.y);
        set_number(L, "separation", static_cast<double>(point.separation_m));
        set_number(L, "impulse", static_cast<double>(point.impulse_ns));
        lua_rawseti(L, -2, i + 1);
    }
    lua_setfield(L, -2, "points");
}

/// Those of one body, or, with the null handle, of all.
Pushed push_contacts(lua_State* L, int world_index, WorldObject& world, physics::BodyId body) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::DebugContact& contact : world.world->debug_contacts()) {
        if (body && !(contact.body_a == body) && !(contact.body_b == body)) continue;
        push_contact(L, world_index, world, contact);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

}  // namespace

Pushed joints_of_world(lua_State* L, WorldRef self) {
    std::vector<physics::JointId> all;  // each stands in the lists of two bodies
    for (const physics::BodyId body : self.world.bodies()) {
        for (const physics::JointId joint : value_or_raise(L, self.world.body(body)).joints())
            all.push_back(joint);
    }
    std::sort(all.begin(), all.end(),
              [](physics::JointId a, physics::JointId b) { return a.index1 < b.index1; });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    lua_createtable(L, static_cast<int>(all.size()), 0);
    lua_Integer count = 0;
    for (const physics::JointId joint : all) {
        push_joint(L, self.index, self.object, joint);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed contacts_of_world(lua_State* L, WorldRef self) {
    return push_contacts(L, self.index, self.object, {});
}

Pushed contacts_of_body(lua_State* L, BodyRef self) {
    if (!self.object.world->world) call_error(L, "a pair filter may not ask for contacts");
    push_world_of(L, self.index);
    return push_contacts(L, lua_gettop(L), *self.object.world, self.object.id);
}

Pushed islands_of_world(lua_State* L, WorldRef self) {
    lua_newtable(L);
    const int list = lua_gettop(L);
    for (const physics::DebugIsland& member : self.world.debug_islands()) {
        if (lua_rawgeti(L, list, member.island + 1) != LUA_TTABLE) {
            lua_pop(L, 1);
            lua_createtable(L, 0, 2);
            lua_pushboolean(L, member.is_awake ? 1 : 0);
            lua_setfield(L, -2, "awake");
            lua_newtable(L);
            lua_setfield(L, -2, "bodies");
            lua_pushvalue(L, -1);
            lua_rawseti(L, list, member.island + 1);
        }
        lua_getfield(L, -1, "bodies");
        push_body(L, self.index, member.body);
        lua_rawseti(L, -2, static_cast<lua_Integer>(lua_rawlen(L, -2)) + 1);
        lua_settop(L, list);
    }
    return {1};
}

Pushed boxes_of_world(lua_State* L, WorldRef self) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::DebugBox& box : self.world.debug_boxes()) {
        lua_createtable(L, 0, 5);
        push_shape(L, self.index, self.object, box.shape);
        lua_setfield(L, -2, "shape");
        set_number(L, "x1", box.lower_m.x);
        set_number(L, "y1", box.lower_m.y);
        set_number(L, "x2", box.upper_m.x);
        set_number(L, "y2", box.upper_m.y);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

}  // namespace cairn::scripting
