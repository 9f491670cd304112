// The methods of World.
#include <cstdio>

#include <cairn/engine/log.h>
#include <cairn/physics/features.h>

#include "bind/chain.h"
#include "bind/contacts.h"
#include "bind/context.h"
#include "bind/fracture.h"
#include "bind/joint_fields.h"
#include "bind/make_body.h"
#include "bind/materials.h"
#include "bind/modules.h"
#include "bind/mover.h"
#include "bind/pair_filter.h"
#include "bind/physics_fields.h"
#include "bind/physics_objects.h"
#include "bind/recording.h"
#include "bind/report.h"
#include "bind/snapshot.h"
#include "bind/transforms.h"
#include "bind/world_queries.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using physics::JointKind;
using physics::Position;
using physics::Vec2;

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};
constexpr std::array<std::string_view, 2> kReturnsBodyAndChain = {"Body", "Chain"};
constexpr std::array<std::string_view, 1> kReturnsJoint = {"Joint"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

/// Once for each body: one that is pushed to infinity again in each step would fill the log.
void warn_of_quarantined(WorldRef world) {
    for (const physics::BodyId id : world.world.quarantined()) {
        if (!world.object.warned.insert(id.bits()).second) continue;
        const auto body = world.world.body(id);
        if (!body) continue;
        char place[64];
        std::snprintf(place, sizeof place, "(%.3g, %.3g)", body->position().x, body->position().y);
        engine::log(
            engine::LogLevel::Warning,
            std::string("body at ") + place +
                " was halted: its motion became infinite, or led out of the world, which ends 1e12 m from "
                "its origin; world:quarantined() lists such bodies");
    }
}

physics::Result<void> step(lua_State* L, WorldRef self, StepTime dt_s) {
    age_retired(L, self.index, self.object);
    FilteredStep filtered(L, self);
    auto stepped = self.world.step(dt_s);
    if (!stepped) return stepped;
    warn_of_quarantined(self);
    keep_broken_joints(L, self);
    adopt_pieces(L, self);
    filtered.raise_error();
    return stepped;
}

template <class Ids>
Pushed push_list_of_bodies(lua_State* L, WorldRef world, const Ids& ids) {
    lua_createtable(L, static_cast<int>(ids.size()), 0);
    lua_Integer count = 0;
    for (const physics::BodyId id : ids) {
        push_body(L, world.index, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed quarantined(lua_State* L, WorldRef self) {
    return push_list_of_bodies(L, self, self.world.quarantined());
}

Pushed new_body(lua_State* L, WorldRef self, TableArgument description) {
    push_bare_body(L, self, FieldReader(L, description.index, kNewBodyFields));
    return {1};
}

template <GeometryKind kKind>
Pushed add_body(lua_State* L, WorldRef self, TableArgument description) {
    push_described_body(L, self, FieldReader(L, description.index, fields_of_world_add(kKind)), kKind);
    return {1};
}

template <JointKind kKind>
Pushed add_joint(lua_State* L, WorldRef self, TableArgument description) {
    push_made_joint(L, self, description.index, kKind);
    return {1};
}

template <JointKind kKind>
constexpr Function add_joint_function(const char* name, const char* doc) {
    return function_pushing<&add_joint<kKind>>(name, "fields", "joint", kReturnsJoint, doc,
                                               &fields_of(kKind).making);
}

Pushed ground(lua_State* L, WorldRef self) {
    push_ground(L, self);
    return {1};
}

Pushed joint_breaks(lua_State* L, WorldRef self) {
    return {push_joint_breaks(L, self)};
}

Pushed breaks(lua_State* L, WorldRef self) {
    return {push_body_breaks(L, self)};
}

Pushed sensor_events(lua_State* L, WorldRef self) {
    return {push_sensor_events(L, self)};
}

Pushed events(lua_State* L, WorldRef self, std::optional<std::string_view> kind,
              std::optional<bool> with_shapes) {
    return {push_events(L, self, kind, with_shapes.value_or(false))};
}

Pushed bodies(lua_State* L, WorldRef self) {
    return push_list_of_bodies(L, self, self.world.bodies());
}

std::tuple<float, float> gravity(WorldRef self) {
    const Vec2 g = self.world.gravity();
    return {g.x, g.y};
}
physics::Result<void> set_gravity(WorldRef self, float x, float y) {
    return self.world.set_gravity({x, y});
}

std::int64_t body_count(WorldRef self) {
    return self.world.counts().bodies;
}
std::int64_t awake_count(WorldRef self) {
    return self.world.counts().awake_bodies;
}
std::int64_t joint_count(WorldRef self) {
    return self.world.counts().joints;
}
std::int64_t contact_count(WorldRef self) {
    return self.world.counts().touching;
}
std::int64_t step_count(WorldRef self) {
    return static_cast<std::int64_t>(self.world.step_count());
}

std::string state_hash(WorldRef self) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(self.world.state_hash()));
    return text;
}

void destroy(lua_State* L, WorldRef self) {
    std::erase(context_of(L).worlds, &self.object);
    luaL_unref(L, LUA_REGISTRYINDEX, self.object.reference);
    self.object.world.reset();
}

bool is_valid(Maybe<WorldObject> self) {
    return readable_world(self.object) != nullptr;
}

constexpr std::array<std::string_view, 1> kReturnsIterator = {
    "fun(): string, Body, Body, number, number, number, number, number, number, Shape?, Shape?"};
constexpr std::array<std::string_view, 1> kReturnsBreakIterator = {
    "fun(): Joint, Body, Body, number, number, number, number, number, string"};
constexpr std::array<std::string_view, 1> kReturnsBodyBreakIterator = {
    "fun(): Body, Body, number, number, number, number, number, number, table"};
constexpr std::array<std::string_view, 1> kReturnsSensorIterator = {
    "fun(): string, Body, Body, Shape, Shape"};
constexpr std::array<std::string_view, 2> kReturnsBodyAndShape = {"Body?", "Shape?"};
constexpr std::array<std::string_view, 8> kReturnsShapeHit = {"Body?",  "number", "number", "number",
                                                              "number", "number", "number", "Shape"};
constexpr std::array<std::string_view, 7> kReturnsClosest = {"Body?",  "number", "number", "number",
                                                             "number", "number", "Shape"};
constexpr std::array<std::string_view, 7> kReturnsRayHit = {"Body?",  "number", "number", "number",
                                                            "number", "number", "Shape"};

constexpr Function kWorldFunctions[] = {
    function<&step>("step", "dt [s]", "",
                    "Moves the world on and replaces its events by those of this step."),
    function_pushing<&new_body>(
        "new_body", "fields", "body", kReturnsBody,
        "Adds a body without shapes; give it some with `body:add_box{...}` and the like.", &kNewBodyFields),
    function_pushing<&add_body<GeometryKind::Box>>("add_box", "fields", "body", kReturnsBody,
                                                   "Adds a body with one rectangle around its origin.",
                                                   &fields_of_world_add(GeometryKind::Box)),
    function_pushing<&add_body<GeometryKind::Circle>>("add_circle", "fields", "body", kReturnsBody,
                                                      "Adds a body with one disc around its origin.",
                                                      &fields_of_world_add(GeometryKind::Circle)),
    function_pushing<&add_body<GeometryKind::Capsule>>(
        "add_capsule", "fields", "body", kReturnsBody,
        "Adds a body with one capsule: all points within `radius` of a segment along its x axis.",
        &fields_of_world_add(GeometryKind::Capsule)),
    function_pushing<&add_body<GeometryKind::Polygon>>(
        "add_polygon", "fields", "body", kReturnsBody,
        "Adds a body with a polygon. One with dents, or with more than eight "
        "corners, becomes several convex shapes.",
        &fields_of_world_add(GeometryKind::Polygon)),
    function_pushing<&add_body<GeometryKind::Segment>>(
        "add_segment", "fields", "body", kReturnsBody,
        "Adds a body with one line without thickness, solid from both sides.",
        &fields_of_world_add(GeometryKind::Segment)),
    function_pushing<&add_chain_body>("add_chain", "fields", "body, chain", kReturnsBodyAndChain,
                                      "Adds a body with one chain, of any number of points.",
                                      &kWorldAddChainFields),
    add_joint_function<JointKind::Distance>("add_distance_joint",
                                            "Keeps two points at a distance: rigidly, as a spring or as a "
                                            "rope."),
    add_joint_function<JointKind::Revolute>(
        "add_revolute_joint",
        "Pins two bodies together at a point about which they turn. Angle 0 is how they stand now; it counts "
        "whole turns."),
    add_joint_function<JointKind::Prismatic>(
        "add_prismatic_joint",
        "Lets b slide along an axis of a, and not turn. Translation 0 is where they stand now; without an "
        "axis it is the world's x axis."),
    add_joint_function<JointKind::Weld>("add_weld_joint",
                                        "Holds b to a as they stand now: rigidly, or with springs."),
    add_joint_function<JointKind::Wheel>(
        "add_wheel_joint",
        "Hangs a wheel b from a chassis a: its centre slides along an axis of a on a spring, and it turns "
        "freely or by a motor. Without an axis it is the world's y axis. Units of the limit: m; of the "
        "motor: "
        "rad/s."),
    add_joint_function<JointKind::Motor>(
        "add_motor_joint",
        "Draws b to a target place and angle in the frame of a, or drives it at a velocity, with a force and "
        "a torque that have caps. The target 0 is how they stand now."),
    add_joint_function<JointKind::Mouse>(
        "add_mouse_joint",
        "Draws a point of a body to a target in the world, which `joint:set_target(x, y)` moves: the hand of "
        "a player."),
    add_joint_function<JointKind::Gear>(
        "add_gear_joint",
        "Ties the coordinates of two joints: angles (rad) of revolute ones, translations (m) of prismatic "
        "ones. It goes with either joint."),
    add_joint_function<JointKind::Pulley>(
        "add_pulley_joint", "A rope from a over two fixed wheels to b. It pulls and never pushes."),
    add_joint_function<JointKind::Friction>(
        "add_friction_joint", "Friction between b and a, as of things on a table seen from above."),
    add_joint_function<JointKind::Filter>("add_filter_joint", "Keeps two bodies from colliding."),
    function_pushing<&add_bodies>("add_bodies", "descriptions", "bodies", kReturnsTable,
                                  "Adds many bodies: a list of tables, each with `shape` (\"box\", "
                                  "\"circle\", \"capsule\", \"polygon\" or "
                                  "\"segment\"; absent: none) and the fields that `add_box` and its like "
                                  "take. Gives the list of the bodies; "
                                  "with an error, which names the place in the list, nothing is added."),
    function_pushing<&joints_of_world>("joints", "", "joints", kReturnsTable, "A new list of all joints."),
    function_pushing<&contacts_of_world>(
        "contacts", "", "contacts", kReturnsTable,
        "A new list of the pairs of shapes that touch now: tables with `body_a`, `body_b`, `shape_a`, "
        "`shape_b`, "
        "`nx, ny` (unit, from a to b), `friction_impulse` (N s) and `points`, a list of tables with `x, y` "
        "(m), "
        "`separation` (m, negative where they overlap) and `impulse` (N s). Made for tools; in each step, "
        "`events` costs less."),
    function_pushing<&islands_of_world>("islands", "", "islands", kReturnsTable,
                                        "A new list of the groups of bodies that move and fall asleep "
                                        "together: tables with `bodies` and `awake`."),
    function_pushing<&boxes_of_world>(
        "boxes", "", "boxes", kReturnsTable,
        "A new list of the boxes of the broad phase: tables with `shape`, and `x1, y1`, "
        "`x2, y2` (m)."),
    function<&destroy_bodies>(
        "destroy_bodies", "bodies", "",
        "Removes all bodies of a list; with an error, which names the place in the list, none."),
    function_pushing<&ground>("ground", "", "body", kReturnsBody,
                              "A static body without shapes at the origin, for joints to the world. Made "
                              "when it is first asked for."),
    function_pushing<&joint_breaks>(
        "joint_breaks", "", "iterator", kReturnsBreakIterator,
        "Iterates over the joints that the last step loaded beyond their strength: `for joint, a, b, x, y, "
        "fx, fy, torque, kind in world:joint_breaks() do`. The joint is gone, and its value is still the one "
        "that "
        "`add_..._joint` returned, with its `data`; `a` and `b` are its bodies, `x, y` the anchor on b (m), "
        "`fx, fy` (N) and "
        "`torque` (N m) what it did to b, as the mean over the step, `kind` what `joint:kind()` says."),
    function_pushing<&breaks>(
        "breaks", "", "iterator", kReturnsBodyBreakIterator,
        "Iterates over the breakable bodies on which something pressed harder in the last step than they "
        "withstand: `for body, other, impulse, x, y, nx, ny, speed, pieces in world:breaks() do`. `other` is "
        "what "
        "pressed, `impulse` (N s) how hard, `x, y` where, `nx, ny` the unit normal into the body, `speed` "
        "(m/s) "
        "how fast they met, `pieces` a list of the bodies into which the step broke it; it is empty when it "
        "was "
        "not automatic or too small to break."),
    function_pushing<&cuts_along>(
        "cuts_along", "x1 [m], y1 [m], x2 [m], y2 [m], filter = -1, ignored = nil", "hits", kReturnsTable,
        "What lies across a cut, in the order of the way: tables with `body`, `x1, y1` and `x2, y2` where "
        "the way "
        "enters and leaves it, and `pieces`, how many bodies `body:cut` would make of it. Changes nothing."),
    function_pushing<&events>(
        "events", "kind = nil, with_shapes = false", "iterator", kReturnsIterator,
        "Iterates over the events of the last step: `for kind, a, b, impulse, x, y, nx, ny, speed in "
        "world:events(\"hit\") do`. `kind` is \"begin\", \"end\" or \"hit\"; without an argument all come, "
        "begins first, "
        "then hits, then ends. `a` and `b` are the bodies, `x, y` the place, `nx, ny` the unit normal from a "
        "to b, "
        "`impulse` (N s) what the contact exchanged in the step and `speed` (m/s) how fast they met; what an "
        "event does "
        "not have is 0. A body destroyed since the step is still given: `is_valid()` tells, and its `data` "
        "can be read. With `with_shapes` the two shapes come last: `for kind, a, b, impulse, x, y, nx, ny, "
        "speed, "
        "shape_a, shape_b in world:events(\"hit\", true) do`. "
        "Anything may be done in the loop; stepping the world ends it."),
    function_pushing<&sensor_events>(
        "sensor_events", "", "iterator", kReturnsSensorIterator,
        "Iterates over what came to overlap sensors in the last step, and what ceased to: `for kind, sensor, "
        "visitor, sensor_shape, visitor_shape in world:sensor_events() do`. `kind` is \"begin\" or \"end\"; "
        "`sensor` and `visitor` are the bodies. What passes through a sensor within one step begins with it "
        "and ends "
        "with the next."),
    function_pushing<&bodies>("bodies", "", "bodies", kReturnsTable,
                              "A new list of all bodies, in a fixed order."),
    function<&read_transforms>("read_transforms", "transforms", "count",
                               "Writes the places of all bodies into a list in one pass, without garbage."),
    function_pushing<&quarantined>(
        "quarantined", "", "bodies", kReturnsTable,
        "A new list of the bodies whose motion became infinite in the last step, or "
        "led farther than 1e12 m from the origin: "
        "each was put back to where it was "
        "and stopped. Empty unless forces beyond all measure act."),
    function_pushing<&body_at>(
        "body_at", "x [m], y [m], filter = -1, ignored = nil", "body, shape", kReturnsBodyAndShape,
        "A body with a shape that contains the point, and that shape; of several the newest "
        "shape's; nil when there is none."),
    function_pushing<&cast_ray>(
        "cast_ray", "x1 [m], y1 [m], x2 [m], y2 [m], filter = -1, ignored = nil",
        "body, x [m], y [m], nx, ny, fraction, shape", kReturnsRayHit,
        "The first shape that the ray meets from outside: its body, the point, the normal out "
        "of the shape, the share of the ray's length, and the shape; nil when it meets none. A shape in "
        "which "
        "the ray begins is not met."),
    function_pushing<&cast_ray_all>(
        "cast_ray_all", "x1 [m], y1 [m], x2 [m], y2 [m], filter = -1, ignored = nil", "hits", kReturnsTable,
        "All shapes that the ray meets, in its order: tables with body, shape, x, y, nx, ny, fraction."),
    function_pushing<&cast_shape>("cast_shape", "shape, dx [m], dy [m], filter = -1, ignored = nil",
                                  "body, x [m], y [m], nx, ny, fraction, overlap [m], shape",
                                  kReturnsShapeHit,
                                  "The first shape met by one that moves without turning: `{ shape = "
                                  "\"circle\", radius = 1, x = 0, y = 2 "
                                  "}`, with the fields of `world:add_circle` and its like, and `x`, `y`, "
                                  "`angle` where it starts. What it "
                                  "overlaps there is met at fraction 0. nil when it meets none."),
    function_pushing<&cast_shape_all>(
        "cast_shape_all", "shape, dx [m], dy [m], filter = -1, ignored = nil", "hits", kReturnsTable,
        "All shapes met: tables with body, shape, x, y, nx, ny, fraction, overlap."),
    function_pushing<&shapes_overlapping>(
        "shapes_overlapping", "shape, filter = -1, ignored = nil", "shapes", kReturnsTable,
        "A new list of the shapes that a shape, described as for cast_shape, "
        "touches or overlaps."),
    function_pushing<&shapes_in_box>(
        "shapes_in_box", "x1 [m], y1 [m], x2 [m], y2 [m], filter = -1, ignored = nil", "shapes",
        kReturnsTable, "A new list of the shapes that touch or overlap a box between two corners."),
    function_pushing<&closest_point>("closest_point", "x [m], y [m], radius [m], filter = -1, ignored = nil",
                                     "body, x [m], y [m], nx, ny, distance [m], shape", kReturnsClosest,
                                     "The nearest surface within a radius; inside shapes the distance is "
                                     "negative. nil when there is none."),
    function_pushing<&closest_points>(
        "closest_points", "x [m], y [m], radius [m], filter = -1, ignored = nil", "points", kReturnsTable,
        "The nearest point of each shape within a radius: tables with body, shape, x, "
        "y, nx, ny, distance."),
    function_pushing<&collision_planes>(
        "collision_planes", "shape, reach [m], filter = -1, ignored = nil", "planes", kReturnsTable,
        "What limits a shape, described as for cast_shape: a line for each "
        "shape within reach, as tables with "
        "body, shape, x, y, nx, ny, separation, dynamic, and, where edges meet at a corner, nx_before, "
        "ny_before, nx_after, ny_after. For characters of "
        "your own; see cairn.physics.solve_planes and new_mover."),
    function<&explode>(
        "explode", "fields", "",
        "Pushes the dynamic bodies around a point, as a pressure on the outline that faces it.",
        &kExplosionFields),
    function<&apply_wind>(
        "apply_wind", "fields, dt [s]", "",
        "Of moving air on all dynamic bodies that are awake, during the next step, which takes "
        "dt.",
        &kWindFields),
    function<&set_material_rule>("set_material_rule", "kind_a, kind_b, fields", "",
                                 "How materials of two kinds (`material_kind` of shapes) mix.",
                                 &kMaterialRuleFields),
    function_pushing<&material_rule>("material_rule", "kind_a, kind_b", "rule", kReturnsTable,
                                     "A new table with the fields that `set_material_rule` takes."),
    function<&set_pair_filter>(
        "set_pair_filter", "filter = nil", "",
        "Asks a function which pairs of shapes collide, besides their categories, masks and groups: "
        "`world:set_pair_filter(function(a, b, shape_a, shape_b) return a.data.team ~= b.data.team end)`. It "
        "is called once for each pair whose boxes come together, in the step in which they do and in an "
        "order "
        "that depends on the game alone; its answer, true or false, holds until the two part. It may read "
        "bodies and shapes and their `data`, and must not change anything. nil ends the asking; pairs that "
        "are near each other keep their answers. An error in it is raised by `step`, which is done then; the "
        "rest of that step's pairs collide. Snapshots do not hold the filter."),
    function<&gravity>("gravity", "", "x [m/s^2], y [m/s^2]", ""),
    function<&set_gravity>("set_gravity", "x [m/s^2], y [m/s^2]", "", "Wakes every body."),
    function<&body_count>("body_count", "", "count", ""),
    function<&awake_count>("awake_count", "", "count", "How many dynamic and kinematic bodies are awake."),
    function<&joint_count>("joint_count", "", "count", ""),
    function<&contact_count>("contact_count", "", "count", "How many pairs of shapes touch."),
    function<&step_count>("step_count", "", "count", "Steps since the world was made."),
    function<&state_hash>(
        "state_hash", "", "hash",
        "16 hexadecimal digits over all that decides the future of the bodies: equal hashes, equal "
        "worlds."),
    function_pushing<&report>(
        "report", "", "report", kReturnsTable,
        "How the world is doing now: `max_penetration` and `max_joint_error` (m), `max_joint_angle_error` "
        "(rad), how fast such errors grow, `residual` (m/s) and `angular_residual` (rad/s), "
        "`kinetic_energy`, `potential_energy` and `elastic_energy` (J), `momentum_x`, `momentum_y` (kg m/s) "
        "and `angular_momentum` about the origin (kg m^2/s); counts: `bodies`, `awake_bodies`, `shapes`, "
        "`joints`, `awake_joints`, `contacts`, `touching`, `awake_touching`, `islands`; and `stages`, the "
        "milliseconds of the stages of the last step that was measured, which are to be shown and differ "
        "from run to run. Costs about as much as the contacts of a step, and nothing when it is not called."),
    function<&set_profiling>("set_profiling", "enabled", "",
                             "Whether steps measure their stages for `world:report()`; off at first."),
    function_pushing<&snapshot>(
        "snapshot", "", "snapshot", kReturnsTable,
        "All that decides the future of the world: a table with `bytes`, a string to save or to send, the "
        "same "
        "on every machine, and `bodies`, the list of the bodies that there are now. Data of bodies and other "
        "values of the script are not part of it."),
    function<&restore>("restore", "snapshot", "",
                       "Puts the world into the state of a snapshot, its own or another world's, as if all "
                       "since then had not "
                       "happened; from there it goes on exactly as it did. Takes what `world:snapshot()` "
                       "gave, or its `bytes` "
                       "alone. Bodies are the same values as before and keep their `data`. One that was "
                       "destroyed since comes "
                       "back; with the bytes alone it is a new value with an empty table. One that was made "
                       "since is destroyed. "
                       "Bytes that are damaged or of another version are an error, and nothing changes."),
    function<&destroy>("destroy", "", "", "Frees the world; its bodies become invalid."),
    function<&is_valid>("is_valid", "", "valid", "Whether the world was not destroyed."),
};

}  // namespace

int finalize_world(lua_State* L) {
    object_at<WorldObject>(L, 1)->~WorldObject();
    return 0;
}

const Module kWorldMethods = {
    "World",
    "A world of rigid bodies. **Which shapes a query sees** say its last two arguments. `ignored` is a body "
    "that is not seen. `filter` is one of three: a bit set of categories, `-1` being all; a function, "
    "`function(body, shape) return body.data.team ~= 1 end`, which may do anything; or a table with `mask`, "
    "the "
    "bit set of categories that are seen, `categories`, of which a shape's own mask must have one, for what "
    "the one who asks would collide with, `accepts`, the function, and `ignored`. The function is asked, "
    "once "
    "and in a fixed order, about each shape whose surroundings the query looks at, before it is known which "
    "of them are hit.",
    kWorldFunctions, true};

}  // namespace cairn::scripting
