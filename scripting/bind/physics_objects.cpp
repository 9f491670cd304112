// Identity and lifetime of the physics objects in Lua.
//
// A body's methods must be found without calling a function (that would double the cost of body:position()),
// and `body.data` must be found too. So each body has a metatable of its own whose __index is a small table {
// data = ... }, and the metatable of that table leads on to the methods that all bodies share.
#include "bind/physics_objects.h"

#include <string>

#include "bind/fields.h"
#include "bind/object_data.h"
#include "bind/pair_filter.h"

namespace cairn::scripting {
namespace {

/// Which stand in that small table too, so that they are found in the first place looked at. With `data` they
/// are four, which is what a table with two to the power of something has room for.
constexpr const char* kMethodsAskedMost[] = {"position", "transform", "linear_velocity"};

void push_world_table(lua_State* L, int world_index, WorldTable table) {
    lua_getiuservalue(L, world_index, static_cast<int>(table));
}

/// body.data = t; every other assignment is refused.
int set_body_field(lua_State* L) {
    const char* name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (std::string_view(name) != "data") refuse_field(L, /*has_data=*/true);
    if (!lua_istable(L, 3)) raise(L, "body.data is " + describe_value(L, 3) + "; expected a table");
    lua_getmetatable(L, 1);
    lua_getfield(L, -1, "__index");
    lua_pushvalue(L, 3);
    lua_setfield(L, -2, "data");
    return 0;
}

/// The value on top of the stack is that of the body. A value that had the handle before is of a body that a
/// restore undid: it names nothing any more. Nobody else looks into that table: what is still in it depends
/// on when garbage was collected.
void know_body(lua_State* L, int world_index, physics::BodyId id) {
    const auto key = static_cast<lua_Integer>(id.bits());
    push_world_table(L, world_index, WorldTable::Known);
    lua_rawgeti(L, -1, key);
    if (auto* undone = object_at<BodyObject>(L, -1)) undone->id = {};
    lua_pop(L, 1);
    lua_pushvalue(L, -2);
    lua_rawseti(L, -2, key);
    lua_pop(L, 1);
}

template <class Object>
Object& checked_object(lua_State* L, int index) {
    Object* object = object_at<Object>(L, index);
    if (object == nullptr) argument_error(L, index, std::string("a ") + object_type_name(Object::kTag));
    return *object;
}

[[noreturn]] void stale_error(lua_State* L, const WorldObject& world, const char* what) {
    if (!world.world && readable_world(world) != nullptr) {
        call_error(L,
                   "a pair filter may look at bodies and shapes, and not change anything or look farther; do "
                   "that behind the step");
    }
    if (std::string_view(what) == "world") call_error(L, "this world was destroyed");
    call_error(L, !world.world ? std::string("the world of this ") + what + " was destroyed"
                               : std::string("this ") + what + " was destroyed; is_valid() tells");
}

/// Of an object; or an error is raised.
physics::World& living_world(lua_State* L, WorldObject& object, const char* what) {
    if (object.world) return *object.world;
    if (physics::World* world = world_to_look_at(L, object)) return *world;
    stale_error(L, object, what);
}

/// The world's value of a shape or joint, made when it is first asked for. A dead one, which only events can
/// still name, gets a value that is not kept: its slot may belong to another by now.
template <class Object, class Id>
void push_interned(lua_State* L, int world_index, WorldTable table, WorldObject& world, Id id) {
    world_index = lua_absindex(L, world_index);
    push_world_table(L, world_index, table);
    lua_rawgeti(L, -1, static_cast<lua_Integer>(id.index1));
    const Object* known = object_at<Object>(L, -1);
    if (known != nullptr && known->id == id) {
        lua_remove(L, -2);
        return;
    }
    lua_pop(L, 1);
    if constexpr (std::is_same_v<Object, JointObject>) {
        push_world_table(L, world_index, WorldTable::BrokenJoints);
        lua_rawgeti(L, -1, static_cast<lua_Integer>(id.bits()));
        lua_remove(L, -2);
        if (!lua_isnil(L, -1)) {
            lua_remove(L, -2);
            return;
        }
        lua_pop(L, 1);
    }
    new_object<Object>(L, kDataValue, &world, id);
    lua_pushvalue(L, world_index);
    lua_setiuservalue(L, -2, 1);
    if (const physics::World* living = readable_world(world); living != nullptr && living->contains(id)) {
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, static_cast<lua_Integer>(id.index1));
    }
    lua_remove(L, -2);
}

}  // namespace

WorldRef Argument<WorldRef>::get(lua_State* L, int index) {
    auto& object = checked_object<WorldObject>(L, index);
    return {object, living_world(L, object, "world"), index};
}

BodyRef Argument<BodyRef>::get(lua_State* L, int index) {
    auto& object = checked_object<BodyObject>(L, index);
    const auto body = living_world(L, *object.world, "body").living_body(object.id);
    if (!body) stale_error(L, *object.world, "body");
    return {object, *body, index};
}

ShapeRef Argument<ShapeRef>::get(lua_State* L, int index) {
    auto& object = checked_object<ShapeObject>(L, index);
    auto shape = living_world(L, *object.world, "shape").shape(object.id);
    if (!shape) stale_error(L, *object.world, "shape");
    return {object, *shape, index};
}

JointRef Argument<JointRef>::get(lua_State* L, int index) {
    auto& object = checked_object<JointObject>(L, index);
    auto joint = living_world(L, *object.world, "joint").joint(object.id);
    if (!joint) stale_error(L, *object.world, "joint");
    return {object, *joint, index};
}

std::optional<physics::Body> living_body_at(lua_State* L, int index) {
    const auto* object = object_at<BodyObject>(L, index);
    if (object == nullptr || !object->world->world) return std::nullopt;
    auto body = object->world->world->body(object->id);
    if (!body) return std::nullopt;
    return *body;
}

std::optional<physics::Joint> living_joint_at(lua_State* L, int index) {
    const auto* object = object_at<JointObject>(L, index);
    if (object == nullptr || !object->world->world) return std::nullopt;
    auto joint = object->world->world->joint(object->id);
    if (!joint) return std::nullopt;
    return *joint;
}

void push_ground(lua_State* L, WorldRef world) {
    if (!world.world.contains(world.object.ground)) {
        world.object.ground = value_or_raise(L, world.world.create_body({.type = physics::BodyType::Static}));
        lua_newtable(L);
        push_new_body(L, world.index, world.object, world.object.ground);
        lua_pop(L, 1);
    }
    push_body(L, world.index, world.object.ground);
}

void keep_broken_joints(lua_State* L, WorldRef world) {
    if (world.world.joint_breaks().empty()) return;
    lua_newtable(L);
    for (const physics::JointBreak& event : world.world.joint_breaks()) {
        push_joint(L, world.index, world.object, event.joint);
        lua_rawseti(L, -2, static_cast<lua_Integer>(event.joint.bits()));
    }
    lua_setiuservalue(L, world.index, static_cast<int>(WorldTable::BrokenJoints));
}

void push_new_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id) {
    world_index = lua_absindex(L, world_index);
    const int data = lua_gettop(L);
    void* block = lua_newuserdatauv(L, sizeof(BodyObject), 1);
    new (block) BodyObject{{BodyObject::kTag}, &world, id};
    lua_pushvalue(L, world_index);
    lua_setiuservalue(L, -2, 1);

    lua_createtable(L, 0, 3);                                                   // the body's own metatable
    lua_createtable(L, 0, 1 + static_cast<int>(std::size(kMethodsAskedMost)));  // { data = ... }
    push_metatable(L, ObjectTag::Body);
    lua_getfield(L, -1, "__index");
    for (const char* method : kMethodsAskedMost) {  // before `data`: the first is found at the first look
        lua_getfield(L, -1, method);
        lua_setfield(L, -4, method);
    }
    lua_pop(L, 1);
    lua_pushvalue(L, data);
    lua_setfield(L, -3, "data");  // before the table has its metatable, which takes no fields
    lua_setmetatable(L, -2);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, set_body_field);
    lua_setfield(L, -2, "__newindex");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);

    push_world_table(L, world_index, WorldTable::Bodies);
    lua_pushvalue(L, -2);
    lua_rawseti(L, -2, static_cast<lua_Integer>(id.index1));
    lua_pop(L, 1);
    know_body(L, world_index, id);
    lua_remove(L, data);
    for (const physics::ShapeId shape : value_or_raise(L, world.world->body(id)).shapes())
        value_or_raise(L, world.world->shape(shape)).set_user_data(mark_of(shape));
}

std::uint64_t mark_of(physics::ShapeId id) {
    return physics::ShapeId::make(id.index1, id.generation, 0).bits();
}

void revive_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id) {
    const auto* known = object_at<BodyObject>(L, -1);
    if (known == nullptr || known->world != &world || !(known->id == id)) {
        lua_pop(L, 1);
        lua_newtable(L);
        push_new_body(L, world_index, world, id);
    } else {
        push_world_table(L, world_index, WorldTable::Bodies);
        lua_pushvalue(L, -2);
        lua_rawseti(L, -2, static_cast<lua_Integer>(id.index1));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

void push_body(lua_State* L, int world_index, physics::BodyId id) {
    world_index = lua_absindex(L, world_index);
    push_world_table(L, world_index, WorldTable::Bodies);
    lua_rawgeti(L, -1, static_cast<lua_Integer>(id.index1));
    lua_remove(L, -2);
    const auto* known = object_at<BodyObject>(L, -1);
    if (known != nullptr && known->id == id) return;
    lua_pop(L, 1);
    for (const WorldTable table : {WorldTable::Retired, WorldTable::RetiredBefore}) {
        push_world_table(L, world_index, table);
        lua_rawgeti(L, -1, static_cast<lua_Integer>(id.bits()));
        lua_remove(L, -2);
        if (!lua_isnil(L, -1)) return;
        lua_pop(L, 1);
    }
    lua_pushnil(L);
}

void push_shape(lua_State* L, int world_index, WorldObject& world, physics::ShapeId id) {
    push_interned<ShapeObject>(L, world_index, WorldTable::Shapes, world, id);
}

void push_joint(lua_State* L, int world_index, WorldObject& world, physics::JointId id) {
    push_interned<JointObject>(L, world_index, WorldTable::Joints, world, id);
}

void push_chain(lua_State* L, int world_index, WorldObject& world, physics::ChainId id) {
    push_interned<ChainObject>(L, world_index, WorldTable::Chains, world, id);
}

void retire_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id) {
    world_index = lua_absindex(L, world_index);
    push_world_table(L, world_index, WorldTable::Retired);
    push_body(L, world_index, id);
    lua_rawseti(L, -2, static_cast<lua_Integer>(id.bits()));
    push_world_table(L, world_index, WorldTable::Bodies);
    lua_pushnil(L);
    lua_rawseti(L, -2, static_cast<lua_Integer>(id.index1));
    lua_pop(L, 2);
    world.steps_with_retired = 2;
}

void age_retired(lua_State* L, int world_index, WorldObject& world) {
    if (world.steps_with_retired == 0) return;
    --world.steps_with_retired;
    world_index = lua_absindex(L, world_index);
    push_world_table(L, world_index, WorldTable::Retired);
    lua_setiuservalue(L, world_index, static_cast<int>(WorldTable::RetiredBefore));
    lua_newtable(L);
    lua_setiuservalue(L, world_index, static_cast<int>(WorldTable::Retired));
}

}  // namespace cairn::scripting
