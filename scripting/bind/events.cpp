// The iterators of world:events, world:joint_breaks and world:breaks. They make no garbage: cursors are kept
// by their world and handed back when a loop ends, which Lua reports through the to-be-closed value of the
// generic `for`, also after `break` and errors.
#include <algorithm>
#include <array>
#include <string>

#include "bind/joint_fields.h"
#include "bind/physics_objects.h"
#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

enum class EventKind { Begin, Hit, End };

/// Where a loop stands. User value 1 is the world.
struct EventCursor : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::EventCursor;
    WorldObject* world;
    std::uint64_t step;  ///< whose events are read
    EventKind kind;      ///< read now
    EventKind last_kind;
    std::size_t next;
    bool in_use;
    bool with_shapes;
};

template <class Event>
void push_bodies(lua_State* L, const Event& event) {
    lua_getiuservalue(L, 1, 1);
    const int world = lua_gettop(L);
    push_body(L, world, event.body_a);
    push_body(L, world, event.body_b);
    lua_remove(L, world);
}

void push_numbers(lua_State* L, std::initializer_list<double> numbers) {
    for (const double number : numbers) lua_pushnumber(L, number);
}

/// Pushes what is told of an event besides its kind; the number of values, with the kind.
template <class Event>
int finish_event(lua_State* L, const EventCursor& cursor, const Event& event,
                 std::initializer_list<double> numbers) {
    push_bodies(L, event);
    push_numbers(L, numbers);
    if (!cursor.with_shapes) return 9;
    lua_getiuservalue(L, 1, 1);
    const int world = lua_gettop(L);
    push_shape(L, world, *cursor.world, event.shape_a);
    push_shape(L, world, *cursor.world, event.shape_b);
    lua_remove(L, world);
    return 11;
}

/// The iterator function of the loop: (cursor, previous kind) -> kind, a, b, impulse, x, y, nx, ny, speed,
/// and the two shapes when they are asked for.
int next_event(lua_State* L) {
    auto* cursor = object_at<EventCursor>(L, 1);
    if (cursor == nullptr || !cursor->in_use) return 0;
    const auto& world = cursor->world->world;
    if (!world || world->step_count() != cursor->step) return 0;
    while (true) {
        const std::size_t i = cursor->next++;
        if (cursor->kind == EventKind::Begin && i < world->contact_begins().size()) {
            const physics::ContactBegin& event = world->contact_begins()[i];
            lua_pushliteral(L, "begin");
            return finish_event(L, *cursor, event,
                                {0, event.point_m.x, event.point_m.y, static_cast<double>(event.normal.x),
                                 static_cast<double>(event.normal.y), 0});
        }
        if (cursor->kind == EventKind::Hit && i < world->contact_hits().size()) {
            const physics::ContactHit& event = world->contact_hits()[i];
            lua_pushliteral(L, "hit");
            return finish_event(L, *cursor, event,
                                {static_cast<double>(event.impulse_ns), event.point_m.x, event.point_m.y,
                                 static_cast<double>(event.normal.x), static_cast<double>(event.normal.y),
                                 static_cast<double>(event.approach_speed_m_s)});
        }
        if (cursor->kind == EventKind::End && i < world->contact_ends().size()) {
            lua_pushliteral(L, "end");
            return finish_event(L, *cursor, world->contact_ends()[i], {0, 0, 0, 0, 0, 0});
        }
        if (cursor->kind == cursor->last_kind) return 0;
        cursor->kind = static_cast<EventKind>(static_cast<int>(cursor->kind) + 1);
        cursor->next = 0;
    }
}

/// The iterator function of breaks: (cursor, previous joint) -> joint, a, b, x, y, fx, fy, torque, kind.
int next_break(lua_State* L) {
    auto* cursor = object_at<EventCursor>(L, 1);
    if (cursor == nullptr || !cursor->in_use) return 0;
    const auto& world = cursor->world->world;
    if (!world || world->step_count() != cursor->step) return 0;
    const std::size_t i = cursor->next++;
    if (i >= world->joint_breaks().size()) return 0;
    const physics::JointBreak event = world->joint_breaks()[i];
    lua_getiuservalue(L, 1, 1);
    push_joint(L, -1, *cursor->world, event.joint);
    lua_remove(L, -2);
    push_bodies(L, event);
    push_numbers(L, {event.point_m.x, event.point_m.y, static_cast<double>(event.force_n.x),
                     static_cast<double>(event.force_n.y), static_cast<double>(event.torque_nm)});
    lua_pushstring(L, fields_of(event.kind).name);
    return 9;
}

/// The iterator function of bodies that break: (cursor, previous body) -> body, other, impulse, x, y, nx, ny,
/// speed, pieces.
int next_body_break(lua_State* L) {
    auto* cursor = object_at<EventCursor>(L, 1);
    if (cursor == nullptr || !cursor->in_use) return 0;
    const auto& world = cursor->world->world;
    if (!world || world->step_count() != cursor->step) return 0;
    const std::size_t i = cursor->next++;
    if (i >= world->body_breaks().size()) return 0;
    const physics::BodyBreak event = world->body_breaks()[i];
    lua_getiuservalue(L, 1, 1);
    const int world_index = lua_gettop(L);
    push_body(L, world_index, event.body);
    push_body(L, world_index, event.other);
    push_numbers(L, {static_cast<double>(event.impulse_ns), event.point_m.x, event.point_m.y,
                     static_cast<double>(event.normal.x), static_cast<double>(event.normal.y),
                     static_cast<double>(event.approach_speed_m_s)});
    lua_createtable(L, static_cast<int>(event.pieces.size()), 0);
    lua_Integer count = 0;
    for (const physics::BodyId piece : event.pieces) {
        push_body(L, world_index, piece);
        lua_rawseti(L, -2, ++count);
    }
    lua_remove(L, world_index);
    return 9;
}

template <class Event>
int push_sensor_event(lua_State* L, const char* kind, WorldObject& world, const Event& event) {
    lua_getiuservalue(L, 1, 1);
    const int world_index = lua_gettop(L);
    lua_pushstring(L, kind);
    push_body(L, world_index, event.sensor_body);
    push_body(L, world_index, event.visitor_body);
    push_shape(L, world_index, world, event.sensor);
    push_shape(L, world_index, world, event.visitor);
    return 5;
}

/// The iterator function of sensors: (cursor, previous kind) -> kind, sensor, visitor, their shapes.
int next_sensor_event(lua_State* L) {
    auto* cursor = object_at<EventCursor>(L, 1);
    if (cursor == nullptr || !cursor->in_use) return 0;
    const auto& world = cursor->world->world;
    if (!world || world->step_count() != cursor->step) return 0;
    const std::size_t i = cursor->next++;
    const std::size_t begins = world->sensor_begins().size();
    if (i < begins) return push_sensor_event(L, "begin", *cursor->world, world->sensor_begins()[i]);
    if (i - begins >= world->sensor_ends().size()) return 0;
    return push_sensor_event(L, "end", *cursor->world, world->sensor_ends()[i - begins]);
}

int close_cursor(lua_State* L) {
    object_at<EventCursor>(L, 1)->in_use = false;
    return 0;
}

/// Pushes a cursor of the world that no loop uses, a new one if need be.
EventCursor& push_free_cursor(lua_State* L, WorldRef world) {
    lua_getiuservalue(L, world.index, static_cast<int>(WorldTable::Cursors));
    const int list = lua_gettop(L);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, list));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, list, i);
        auto* cursor = object_at<EventCursor>(L, -1);
        if (!cursor->in_use) {
            lua_remove(L, list);
            return *cursor;
        }
        lua_pop(L, 1);
    }
    auto& cursor = new_object<EventCursor>(L, 1, &world.object, std::uint64_t{0}, EventKind::Begin,
                                           EventKind::End, std::size_t{0}, false, false);
    lua_pushvalue(L, world.index);
    lua_setiuservalue(L, -2, 1);
    lua_pushvalue(L, -1);
    lua_rawseti(L, list, count + 1);
    lua_remove(L, list);
    return cursor;
}

/// The four values of a generic `for`: iterator, cursor, nothing, and the cursor as what is closed.
int push_loop(lua_State* L, WorldRef world, lua_CFunction iterator, EventKind first = EventKind::Begin,
              EventKind last = EventKind::End, bool with_shapes = false) {
    lua_pushcfunction(L, iterator);
    EventCursor& cursor = push_free_cursor(L, world);
    cursor.step = world.world.step_count();
    cursor.kind = first;
    cursor.last_kind = last;
    cursor.next = 0;
    cursor.in_use = true;
    cursor.with_shapes = with_shapes;
    lua_pushnil(L);
    lua_pushvalue(L, -2);
    return 4;
}

}  // namespace

void register_event_cursor(lua_State* L) {
    lua_createtable(L, 0, 2);
    lua_pushcfunction(L, close_cursor);
    lua_setfield(L, -2, "__close");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    set_metatable(L, ObjectTag::EventCursor);
}

int push_events(lua_State* L, WorldRef world, std::optional<std::string_view> kind, bool with_shapes) {
    EventKind first = EventKind::Begin;
    EventKind last = EventKind::End;
    if (kind) {
        static const std::vector<std::string> kinds = {"begin", "hit", "end"};
        const auto found = std::find(kinds.begin(), kinds.end(), *kind);
        if (found == kinds.end()) {
            call_error(L,
                       "kind is " + quote_text(*kind) + ": no such kind of event" + suggestion(*kind, kinds));
        }
        first = last = static_cast<EventKind>(found - kinds.begin());
    }
    return push_loop(L, world, next_event, first, last, with_shapes);
}

int push_joint_breaks(lua_State* L, WorldRef world) {
    return push_loop(L, world, next_break);
}

int push_sensor_events(lua_State* L, WorldRef world) {
    return push_loop(L, world, next_sensor_event);
}

int push_body_breaks(lua_State* L, WorldRef world) {
    return push_loop(L, world, next_body_break);
}

}  // namespace cairn::scripting
