// A description of many is a list of what the calls for one take, each with the name of its shape.
#include "bind/make_body.h"

#include <algorithm>
#include <set>
#include <vector>

#include "bind/fields.h"
#include "bind/function.h"
#include "data/nearest.h"

namespace cairn::scripting {
namespace {

constexpr Field kShape =
    choice_field("shape", "", "box circle capsule polygon segment", "absent: a body without shapes");
constexpr const Field* kShapeName[] = {&kShape};

std::string place_of_member(lua_Integer index) {
    return "bodies[" + std::to_string(index) + "]";
}

/// (world, description) -> Body. Its upvalues are those of the binding, so that messages name that.
int add_one(lua_State* L) {
    const auto world = Argument<WorldRef>::get(L, 1);
    lua_getfield(L, 2, kShape.name);
    const bool has_shape = !lua_isnil(L, -1);
    lua_pop(L, 1);
    if (!has_shape) {
        push_bare_body(L, world, FieldReader(L, 2, kNewBodyFields));
        return 1;
    }
    std::string_view wanted;
    if (lua_getfield(L, 2, kShape.name) == LUA_TSTRING) wanted = lua_tostring(L, -1);
    const std::vector<std::string> names = words_of(kShape.choices);
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end())
        call_error(L, "shape = " + describe_value(L, -1) + ": no such shape" + suggestion(wanted, names));
    lua_pop(L, 1);
    const auto kind = static_cast<GeometryKind>(found - names.begin());
    const FieldSet fields{kShapeName, {&fields_of_world_add(kind)}};
    push_described_body(L, world, FieldReader(L, 2, fields), kind);
    return 1;
}

/// The message of a call for one, without the name of the binding and the place before it.
std::string bare_message(lua_State* L) {
    const char* text = lua_tostring(L, -1);
    std::string message = text == nullptr ? "an error" : text;
    const std::string name = running_name(L) + ": ";
    const std::size_t at = message.find(name);
    if (at != std::string::npos) message.erase(0, at + name.size());
    return message;
}

}  // namespace

void push_described_body(lua_State* L, WorldRef world, const FieldReader& reader, GeometryKind kind) {
    OwnedGeometry geometry;
    read_geometry(L, reader, kind, {}, geometry);
    const physics::ShapeDef shape = read_shape_def(reader);
    push_data_table(L, reader);
    const physics::BodyId id = value_or_raise(L, world.world.create_body(read_body_def(reader)));
    for (const physics::Geometry& part : geometry.parts) {
        const auto made = world.world.create_shape(id, part, shape);
        if (made) continue;
        check_or_raise(L, world.world.destroy_body(id));
        call_error(L, made.error());
    }
    push_new_body(L, world.index, world.object, id);
}

void push_bare_body(lua_State* L, WorldRef world, const FieldReader& reader) {
    push_data_table(L, reader);
    const physics::BodyId id = value_or_raise(L, world.world.create_body(read_body_def(reader)));
    push_new_body(L, world.index, world.object, id);
}

Pushed add_bodies(lua_State* L, WorldRef self, TableArgument descriptions) {
    lua_settop(L, descriptions.index);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, descriptions.index));
    lua_createtable(L, static_cast<int>(std::min<lua_Integer>(count, 1 << 20)), 0);
    const int made = lua_gettop(L);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_pushvalue(L, lua_upvalueindex(1));
        lua_pushvalue(L, lua_upvalueindex(2));
        lua_pushcclosure(L, add_one, 2);
        lua_pushvalue(L, self.index);
        lua_rawgeti(L, descriptions.index, i);
        std::string message;
        if (!lua_istable(L, -1)) {
            message = place_of_member(i) + " is " + describe_value(L, -1) + "; expected a table";
        } else if (lua_pcall(L, 2, 1, 0) != LUA_OK) {
            message = place_of_member(i) + ": " + bare_message(L);
        }
        if (message.empty()) {
            lua_rawseti(L, made, i);
            continue;
        }
        for (lua_Integer other = i - 1; other > 0; --other) {
            lua_rawgeti(L, made, other);
            const auto* body = object_at<BodyObject>(L, -1);
            check_or_raise(L, self.world.destroy_body(body->id));
            retire_body(L, self.index, self.object, body->id);
            lua_pop(L, 1);
        }
        call_error(L, message);
    }
    return {1};
}

void destroy_bodies(lua_State* L, WorldRef self, TableArgument bodies) {
    std::vector<physics::BodyId> ids;
    std::set<std::uint64_t> named;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, bodies.index));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, bodies.index, i);
        const auto* body = object_at<BodyObject>(L, -1);
        if (body == nullptr)
            call_error(L, place_of_member(i) + " is " + describe_value(L, -1) + "; expected a Body");
        // Said here, because the physics counts from 0.
        if (body->world != &self.object) call_error(L, place_of_member(i) + " belongs to another world");
        if (const auto living = self.world.body(body->id); !living)
            call_error(L, place_of_member(i) + ": " + living.error().message);
        if (!named.insert(body->id.bits()).second)
            call_error(L, place_of_member(i) + " stands in the list twice");
        ids.push_back(body->id);
        lua_pop(L, 1);
    }
    check_or_raise(L, self.world.destroy_bodies(ids));
    for (const physics::BodyId id : ids) retire_body(L, self.index, self.object, id);
}

}  // namespace cairn::scripting
