// The methods of Body.
#include "bind/chain.h"
#include "bind/contacts.h"
#include "bind/context.h"
#include "bind/fracture.h"
#include "bind/modules.h"
#include "bind/object_data.h"
#include "bind/pair_filter.h"
#include "bind/physics_fields.h"
#include "bind/physics_names.h"
#include "bind/physics_objects.h"
#include "bind/world_queries.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using physics::Position;
using physics::Vec2;
using Change = physics::Result<void>;
using Pair = std::tuple<double, double>;
using FloatPair = std::tuple<float, float>;
using Place = std::tuple<double, double, float>;

std::string_view type(BodyRef self) {
    return name_of(self.body.type());
}

Pair position(OriginOf self) {
    return {self.position.x, self.position.y};
}
Change set_position(BodyRef self, double x, double y) {
    return self.body.set_transform({x, y}, static_cast<double>(self.body.angle()));
}
float angle(BodyRef self) {
    return self.body.angle();
}
Change set_angle(BodyRef self, double angle_rad) {
    return self.body.set_transform(self.body.position(), angle_rad);
}
Place transform(BodyRef self) {
    const physics::Transform xf = self.body.transform();
    return {xf.p.x, xf.p.y, xf.q.angle_rad()};
}
Change set_transform(BodyRef self, double x, double y, double angle_rad) {
    return self.body.set_transform({x, y}, angle_rad);
}
Place interpolated_transform(lua_State* L, BodyRef self, std::optional<double> alpha) {
    const double a = alpha.value_or(context_of(L).alpha);
    const physics::Transform xf = self.body.interpolated_transform(static_cast<float>(a));
    return {xf.p.x, xf.p.y, xf.q.angle_rad()};
}
Pair world_center(BodyRef self) {
    const Position p = self.body.world_center();
    return {p.x, p.y};
}
Pair to_world(BodyRef self, float x, float y) {
    const Position p = physics::transform_point(self.body.transform(), {x, y});
    return {p.x, p.y};
}
FloatPair to_local(BodyRef self, double x, double y) {
    const Vec2 p = physics::inverse_transform_point(self.body.transform(), {x, y});
    return {p.x, p.y};
}

FloatPair linear_velocity(BodyRef self) {
    const Vec2 v = self.body.linear_velocity();
    return {v.x, v.y};
}
Change set_linear_velocity(BodyRef self, float x, float y) {
    return self.body.set_linear_velocity({x, y});
}
float angular_velocity(BodyRef self) {
    return self.body.angular_velocity();
}
Change set_angular_velocity(BodyRef self, float w) {
    return self.body.set_angular_velocity(w);
}
FloatPair velocity_at(BodyRef self, double x, double y) {
    const Vec2 v = self.body.velocity_at({x, y});
    return {v.x, v.y};
}

Change apply_force(BodyRef self, float fx, float fy, double x, double y) {
    return self.body.apply_force({fx, fy}, {x, y});
}
Change apply_force_to_center(BodyRef self, float fx, float fy) {
    return self.body.apply_force_to_center({fx, fy});
}
Change apply_torque(BodyRef self, float torque) {
    return self.body.apply_torque(torque);
}
Change apply_impulse(BodyRef self, float ix, float iy, double x, double y) {
    return self.body.apply_impulse({ix, iy}, {x, y});
}
Change apply_impulse_to_center(BodyRef self, float ix, float iy) {
    return self.body.apply_impulse_to_center({ix, iy});
}
Change apply_angular_impulse(BodyRef self, float impulse) {
    return self.body.apply_angular_impulse(impulse);
}

float mass(BodyRef self) {
    return self.body.mass();
}
float inertia(BodyRef self) {
    return self.body.mass_data().inertia_kg_m2;
}
FloatPair local_center(BodyRef self) {
    const Vec2 p = self.body.mass_data().center_m;
    return {p.x, p.y};
}
float linear_damping(BodyRef self) {
    return self.body.linear_damping();
}
Change set_linear_damping(BodyRef self, NotNegative c) {
    return self.body.set_linear_damping(c);
}
float angular_damping(BodyRef self) {
    return self.body.angular_damping();
}
Change set_angular_damping(BodyRef self, NotNegative c) {
    return self.body.set_angular_damping(c);
}
float gravity_scale(BodyRef self) {
    return self.body.gravity_scale();
}
Change set_gravity_scale(BodyRef self, float scale) {
    return self.body.set_gravity_scale(scale);
}

bool is_awake(BodyRef self) {
    return self.body.is_awake();
}
void set_awake(BodyRef self, bool awake) {
    self.body.set_awake(awake);
}
bool allows_sleep(BodyRef self) {
    return self.body.allows_sleep();
}
void set_allow_sleep(BodyRef self, bool allow) {
    self.body.set_allow_sleep(allow);
}

std::tuple<bool, bool, bool> locks(BodyRef self) {
    const physics::AxisLocks locks = self.body.locks();
    return {locks.x, locks.y, locks.rotation};
}
void set_locks(BodyRef self, bool x, bool y, bool rotation) {
    self.body.set_locks({x, y, rotation});
}
float sleep_speed(BodyRef self) {
    return self.body.sleep_speed();
}
Change set_sleep_speed(BodyRef self, NotNegative speed) {
    return self.body.set_sleep_speed(speed);
}

template <GeometryKind kKind>
Pushed add_shape(lua_State* L, BodyRef self, TableArgument description) {
    const FieldReader reader(L, description.index, fields_of_body_add(kKind));
    OwnedGeometry geometry;
    read_geometry(L, reader, kKind, read_shape_place(reader), geometry);
    WorldObject& world = *self.object.world;
    const physics::ShapeDef def = read_shape_def(reader);
    std::vector<physics::ShapeId> made;
    for (const physics::Geometry& part : geometry.parts) {
        const auto id = world.world->create_shape(self.object.id, part, def);
        if (!id) {
            for (const physics::ShapeId other : made) check_or_raise(L, world.world->destroy_shape(other));
            call_error(L, id.error());
        }
        value_or_raise(L, world.world->shape(*id)).set_user_data(mark_of(*id));
        made.push_back(*id);
    }
    push_world_of(L, self.index);
    const int world_index = lua_gettop(L);
    push_data_table(L, reader);
    luaL_checkstack(L, static_cast<int>(made.size()) + 1, "shapes of a polygon");
    for (const physics::ShapeId id : made) {
        push_shape(L, world_index, world, id);
        lua_pushvalue(L, world_index + 1);
        set_data(L);
    }
    return {static_cast<int>(made.size())};
}

Pushed shapes(lua_State* L, BodyRef self) {
    push_world_of(L, self.index);
    const int world = lua_gettop(L);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::ShapeId id : self.body.shapes()) {
        push_shape(L, world, *self.object.world, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed joints(lua_State* L, BodyRef self) {
    push_world_of(L, self.index);
    const int world = lua_gettop(L);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::JointId id : self.body.joints()) {
        push_joint(L, world, *self.object.world, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed world(lua_State* L, BodyRef self) {
    push_world_of(L, self.index);
    return {1};
}

void destroy(lua_State* L, BodyRef self) {
    WorldObject& owner = *self.object.world;
    check_or_raise(L, owner.world->destroy_body(self.object.id));
    push_world_of(L, self.index);
    retire_body(L, -1, owner, self.object.id);
}

bool is_valid(Maybe<BodyObject> self) {
    const physics::World* world = readable_world(*self.object.world);
    return world != nullptr && world->contains(self.object.id);
}

constexpr std::array<std::string_view, 1> kReturnsShape = {"Shape"};
constexpr std::array<std::string_view, 1> kReturnsChain = {"Chain"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};
constexpr std::array<std::string_view, 1> kReturnsMaybeTable = {"table?"};
constexpr std::array<std::string_view, 1> kReturnsWorld = {"World"};

constexpr Function kFunctions[] = {
    function<&type>("type", "", "type", "\"static\", \"kinematic\" or \"dynamic\"."),
    function<&position>("position", "", "x [m], y [m]", "The place of the body's origin."),
    function<&set_position>("set_position", "x [m], y [m]", "", ""),
    function<&angle>("angle", "", "angle [rad]", "In (-pi, pi]."),
    function<&set_angle>("set_angle", "angle [rad]", "", ""),
    function<&transform>("transform", "", "x [m], y [m], angle [rad]", "Position and angle in one call."),
    function<&set_transform>("set_transform", "x [m], y [m], angle [rad]", "", ""),
    function<&interpolated_transform>(
        "interpolated_transform", "alpha = cairn.graphics.alpha()", "x [m], y [m], angle [rad]",
        "Where to draw the body: between the last two steps, alpha 0 is before the last "
        "step and 1 after it."),
    function<&world_center>("world_center", "", "x [m], y [m]", "The centre of mass."),
    function<&to_world>("to_world", "x [m], y [m]", "x [m], y [m]", "From the body's frame to the world."),
    function<&to_local>("to_local", "x [m], y [m]", "x [m], y [m]", "From the world to the body's frame."),
    function<&linear_velocity>("linear_velocity", "", "x [m/s], y [m/s]", "Of the centre of mass."),
    function<&set_linear_velocity>("set_linear_velocity", "x [m/s], y [m/s]", "", ""),
    function<&angular_velocity>("angular_velocity", "", "velocity [rad/s]", ""),
    function<&set_angular_velocity>("set_angular_velocity", "velocity [rad/s]", "", ""),
    function<&velocity_at>("velocity_at", "x [m], y [m]", "x [m/s], y [m/s]",
                           "Of the point of the body that is at a place in the world."),
    function<&apply_force>("apply_force", "fx [N], fy [N], x [m], y [m]", "",
                           "At a place in the world; acts during the next step."),
    function<&apply_force_to_center>("apply_force_to_center", "fx [N], fy [N]", "",
                                     "Acts during the next step."),
    function<&apply_torque>("apply_torque", "torque [N m]", "", "Acts during the next step."),
    function<&apply_impulse>("apply_impulse", "ix [N s], iy [N s], x [m], y [m]", "",
                             "At a place in the world; changes the velocity at once."),
    function<&apply_impulse_to_center>("apply_impulse_to_center", "ix [N s], iy [N s]", "",
                                       "Changes the velocity at once."),
    function<&apply_angular_impulse>("apply_angular_impulse", "impulse [N m s]", "",
                                     "Changes the angular velocity at once."),
    function<&apply_wind_to_body>(
        "apply_wind", "fields, dt [s]", "",
        "Of moving air, or water, during the next step, which takes dt; wakes the body.", &kWindFields),
    function<&mass>("mass", "", "mass [kg]", "0 unless dynamic."),
    function<&inertia>("inertia", "", "inertia [kg m^2]", "About the centre of mass; 0 unless dynamic."),
    function<&local_center>("local_center", "", "x [m], y [m]",
                            "The centre of mass in the body's frame; (0, 0) unless dynamic."),
    function<&linear_damping>("linear_damping", "", "damping [1/s]", ""),
    function<&set_linear_damping>("set_linear_damping", "damping [1/s]", "", "c in v e^(-c t)."),
    function<&angular_damping>("angular_damping", "", "damping [1/s]", ""),
    function<&set_angular_damping>("set_angular_damping", "damping [1/s]", "", ""),
    function<&gravity_scale>("gravity_scale", "", "scale", ""),
    function<&set_gravity_scale>("set_gravity_scale", "scale", "",
                                 "0 lets the body float, 1 is the world's gravity."),
    function<&is_awake>("is_awake", "", "awake", ""),
    function<&set_awake>(
        "set_awake", "awake", "",
        "Putting a body to sleep puts to sleep all that it touches or is jointed to. What a moving "
        "kinematic body holds or touches wakes again."),
    function<&allows_sleep>("allows_sleep", "", "allows", ""),
    function<&set_allow_sleep>("set_allow_sleep", "allow", "", ""),
    function<&locks>("locks", "", "x, y, rotation", "Which of its motions are locked."),
    function<&set_locks>("set_locks", "x, y, rotation", "",
                         "Its centre of mass stays at its x or y, or it does not turn, whatever acts on it."),
    function<&sleep_speed>("sleep_speed", "", "speed [m/s]", ""),
    function<&set_sleep_speed>("set_sleep_speed", "speed [m/s]", "",
                               "Slower than this it may sleep; at 0 never."),
    function_pushing<&add_shape<GeometryKind::Box>>("add_box", "fields", "shape", kReturnsShape,
                                                    "Adds a rectangle, placed in the body's frame.",
                                                    &fields_of_body_add(GeometryKind::Box)),
    function_pushing<&add_shape<GeometryKind::Circle>>("add_circle", "fields", "shape", kReturnsShape,
                                                       "Adds a disc.",
                                                       &fields_of_body_add(GeometryKind::Circle)),
    function_pushing<&add_shape<GeometryKind::Capsule>>("add_capsule", "fields", "shape", kReturnsShape,
                                                        "Adds a capsule.",
                                                        &fields_of_body_add(GeometryKind::Capsule)),
    function_pushing<&add_shape<GeometryKind::Polygon>>(
        "add_polygon", "fields", "shape", kReturnsShape,
        "Adds a polygon. One with dents, or with more than eight corners, "
        "becomes several convex shapes, which are all returned.",
        &fields_of_body_add(GeometryKind::Polygon)),
    function_pushing<&add_shape<GeometryKind::Segment>>(
        "add_segment", "fields", "shape", kReturnsShape,
        "Adds a line without thickness or mass, solid from both sides.",
        &fields_of_body_add(GeometryKind::Segment)),
    function_pushing<&add_chain>("add_chain", "fields", "chain", kReturnsChain,
                                 "Adds an outline of many segments, solid from one side, without mass.",
                                 &kBodyAddChainFields),
    function_pushing<&shapes>("shapes", "", "shapes", kReturnsTable, "A new list, in order of creation."),
    function_pushing<&joints>("joints", "", "joints", kReturnsTable, "A new list."),
    function_pushing<&contacts_of_body>("contacts", "", "contacts", kReturnsTable,
                                        "A new list of what touches it now, as `world:contacts()` tells it."),
    function_pushing<&world>("world", "", "world", kReturnsWorld, ""),
    function_pushing<&cut>("cut", "x1 [m], y1 [m], x2 [m], y2 [m]", "pieces", kReturnsTable,
                           "Cuts the body along a segment, from side to side: a list of the new bodies, at "
                           "least two, or an empty "
                           "one when it still hangs together; then nothing has changed. Pieces move on as "
                           "the material was moving, "
                           "and have copies of the body's data; the body itself is gone. A copy is a new "
                           "table with the same values: "
                           "tables within it are shared by all pieces."),
    function_pushing<&fracture>(
        "fracture", "fields", "pieces", kReturnsTable,
        "Breaks the body about an impact: a list of the new bodies, or an empty one when it is too small for "
        "two; then nothing has changed. What is not given is as `set_breakable` said, if it did.",
        &kFractureFields),
    function<&set_breakable>(
        "set_breakable", "fields", "",
        "From now on the body breaks when a contact presses harder on it in a step than it withstands; "
        "`world:breaks()` tells of it.",
        &kBreakableFields),
    function<&clear_breakable>("clear_breakable", "", "", "The body withstands everything again."),
    function<&is_breakable>("is_breakable", "", "breakable", ""),
    function_pushing<&breakable>("breakable", "", "fields", kReturnsMaybeTable,
                                 "A new table with the fields that `set_breakable` takes; nil unless it is."),
    function<&destroy>("destroy", "", "",
                       "Removes the body with its shapes and joints. What rested on it wakes."),
    function<&is_valid>("is_valid", "", "valid", "Whether the body was not destroyed."),
};

}  // namespace

const Module kBodyMethods = {
    "Body",
    "A rigid body. `==` compares bodies, and a body can be the key of a table: the same body is always the "
    "same value. "
    "`body.data` is a table of your own that is kept as long as the body and may be replaced. Using a "
    "destroyed body raises "
    "an error, except for `is_valid()` and `data`.",
    kFunctions,
    true,
};

}  // namespace cairn::scripting
