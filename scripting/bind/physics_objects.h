// Worlds, bodies, shapes and joints as Lua values. Invariant: one physics body is one Lua value for as long
// as the script can see it, so == and table keys work; the world keeps the values of its living bodies.
#pragma once

#include <lua.hpp>
#include <optional>
#include <set>
#include <utility>

#include <cairn/physics/world.h>

#include "bind/function.h"
#include "bind/object.h"

namespace cairn::scripting {

class FilteredStep;

struct WorldObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::World;

    std::optional<physics::World> world;  ///< empty after world:destroy(), and while its pair filter is asked
    int reference = 0;                    ///< of the world itself in the registry, while it lives
    int steps_with_retired = 0;           ///< for how many more steps the tables of retired bodies matter
    physics::BodyId ground{};             ///< what world:ground() gave last
    std::set<std::uint64_t> warned{};     ///< handle bits of bodies that the log has called halted
    physics::Snapshot last_snapshot{};    ///< kept for its memory
    FilteredStep* filtered_step = nullptr;  ///< while it steps
    bool is_profiled = false;               ///< the script wants it, whatever tools want
};

/// The Lua tables that a world keeps as user values.
enum class WorldTable {
    Bodies = 1,     ///< slot number -> Body
    Retired,        ///< handle bits -> Body: those destroyed since the last step, which events may still name
    RetiredBefore,  ///< those destroyed between the last two steps: the last step reports that they ceased to
                    ///< touch
    Shapes,         ///< slot number -> Shape
    Joints,         ///< slot number -> Joint
    Cursors,        ///< list of EventCursor, for reuse
    BrokenJoints,   ///< handle bits -> Joint: those that broke in the last step
    Chains,         ///< slot number -> Chain
    Known,  ///< handle bits -> Body: all that somebody still holds (weak), also of bodies that are gone
};
inline constexpr int kWorldTableCount = 9;
/// The user value behind them: what world:set_pair_filter got.
inline constexpr int kPairFilterValue = kWorldTableCount + 1;

/// User value 1 is the world; user value 2 of shapes, chains and joints is their data (object_data.h).
struct BodyObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Body;
    WorldObject* world;
    physics::BodyId id;
};
struct ShapeObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Shape;
    WorldObject* world;
    physics::ShapeId id;
};
struct JointObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Joint;
    WorldObject* world;
    physics::JointId id;
};

struct ChainObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Chain;
    WorldObject* world;
    physics::ChainId id;
};

// ---- What bindings take: the living thing, or an error is raised.

struct WorldRef {
    WorldObject& object;
    physics::World& world;
    int index;  ///< where the world stands on the stack
};
struct BodyRef {
    BodyObject& object;
    physics::Body body;
    int index;
};
/// Where a living body is: what scripts ask most, found without a view.
struct OriginOf {
    physics::Position position;
};
struct ShapeRef {
    ShapeObject& object;
    physics::Shape shape;
    int index;
};
struct JointRef {
    JointObject& object;
    physics::Joint joint;
    int index;
};

template <>
struct Argument<WorldRef> {
    static constexpr std::string_view kType = "World";
    static WorldRef get(lua_State* L, int index);
};
template <>
struct Argument<BodyRef> {
    static constexpr std::string_view kType = "Body";
    static BodyRef get(lua_State* L, int index);
};
template <>
struct Argument<OriginOf> {
    static constexpr std::string_view kType = "Body";
    static OriginOf get(lua_State* L, int index) {
        if (const auto* object = object_at<BodyObject>(L, index); object != nullptr && object->world->world) {
            if (const auto position = object->world->world->position_of(object->id)) return {*position};
        }
        return {Argument<BodyRef>::get(L, index).body.position()};  // in a pair filter; or raises why not
    }
};
template <>
struct Argument<ShapeRef> {
    static constexpr std::string_view kType = "Shape";
    static ShapeRef get(lua_State* L, int index);
};
template <>
struct Argument<JointRef> {
    static constexpr std::string_view kType = "Joint";
    static JointRef get(lua_State* L, int index);
};

/// An object of a type that may be stale: for is_valid.
template <class T>
struct Maybe {
    T& object;
};
template <class T>
struct Argument<Maybe<T>> {
    static constexpr std::string_view kType = object_type_name(T::kTag);
    static Maybe<T> get(lua_State* L, int index) {
        T* object = object_at<T>(L, index);
        if (object == nullptr) argument_error(L, index, std::string("a ") + object_type_name(T::kTag));
        return {*object};
    }
};

// ---- Making and finding Lua values. `world_index` is where the world stands on the stack.

/// Pushes the value of a new body and marks its shapes; its data is the table on top of the stack, which is
/// popped.
void push_new_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id);
/// After a restore: what is on top of the stack, which is popped, is the value of the living body if it ever
/// was; else it gets a new one, with empty data.
void revive_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id);
/// Pushes the value of a body that lives, or lived until after the last step; nil for any other.
void push_body(lua_State* L, int world_index, physics::BodyId id);
void push_shape(lua_State* L, int world_index, WorldObject& world, physics::ShapeId id);
/// What a shape carries as the user data of the physics, which pieces take over: the handle of the one that
/// they were cut from, without its world.
std::uint64_t mark_of(physics::ShapeId id);
void push_joint(lua_State* L, int world_index, WorldObject& world, physics::JointId id);
void push_chain(lua_State* L, int world_index, WorldObject& world, physics::ChainId id);
/// Pushes the world of a body, shape or joint.
inline void push_world_of(lua_State* L, int object_index) {
    lua_getiuservalue(L, object_index, 1);
}

/// Forgets the Lua value of a body that was just destroyed.
void retire_body(lua_State* L, int world_index, WorldObject& world, physics::BodyId id);
/// Another step begins: after it, events can only name bodies that were destroyed from now on or since the
/// last step.
void age_retired(lua_State* L, int world_index, WorldObject& world);

/// The body at a stack index, or null when it is none or is stale: for the code behind described fields.
std::optional<physics::Body> living_body_at(lua_State* L, int index);
std::optional<physics::Joint> living_joint_at(lua_State* L, int index);

/// Pushes a static body without shapes at the origin, made when it is first asked for: what holds the other
/// end of joints to the world.
void push_ground(lua_State* L, WorldRef world);
/// Keeps the values of the joints that broke in the step just made, so that events can name them.
void keep_broken_joints(lua_State* L, WorldRef world);

/// Gives event cursors their metatable: the end of a loop, also by `break` or an error, hands its cursor
/// back.
void register_event_cursor(lua_State* L);
/// The iterator that world:events returns.
int push_events(lua_State* L, WorldRef world, std::optional<std::string_view> kind, bool with_shapes);
/// The iterator that world:joint_breaks returns.
int push_joint_breaks(lua_State* L, WorldRef world);
/// The iterator that world:sensor_events returns.
int push_sensor_events(lua_State* L, WorldRef world);
/// The iterator that world:breaks returns.
int push_body_breaks(lua_State* L, WorldRef world);

}  // namespace cairn::scripting
