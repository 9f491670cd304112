// A character that walks: cairn.physics.new_mover and the methods of Mover.
#include "bind/mover.h"

#include <cairn/physics/mover.h>

#include "bind/modules.h"
#include "bind/world_queries.h"

namespace cairn::scripting {
namespace {

using physics::Position;
using physics::Vec2;
using Change = physics::Result<void>;

struct MoverObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Mover;
    physics::Mover mover;
};

constexpr Field kX = number_field("x", 0, "0", "m; of the feet");
constexpr Field kY = number_field("y", 0, "0", "m");
constexpr Field kHeight = above(number_field("height", 1.8, "1.8", "m, of the capsule, from its feet up"), 0);
constexpr Field kRadius = above(number_field("radius", 0.3, "0.3", "m; less than half the height"), 0);
constexpr Field kUpX = number_field("up_x", 0, "0", "a direction of any length");
constexpr Field kUpY = number_field("up_y", 1, "1", "");
constexpr double kQuarterTurn_rad = 1.57079632679489662;
constexpr Field kMaxSlope =
    within(number_field("max_slope", 0.87, "0.87", "rad; steeper ground is a wall"), 0, kQuarterTurn_rad);
constexpr Field kStepHeight =
    at_least(number_field("step_height", 0.25, "0.25", "m; steps up to this are walked over"), 0);
constexpr Field kPushForce =
    at_least(number_field("push_force", 300, "300", "N; at most, against dynamic bodies in the way"), 0);
constexpr const Field* kOwn[] = {&kX,   &kY,        &kHeight,     &kRadius,   &kUpX,
                                 &kUpY, &kMaxSlope, &kStepHeight, &kPushForce};

}  // namespace

const FieldSet kMoverFields{kOwn};

template <>
struct Argument<MoverObject*> {
    static constexpr std::string_view kType = "Mover";
    static MoverObject* get(lua_State* L, int index) {
        auto* mover = object_at<MoverObject>(L, index);
        if (mover == nullptr) argument_error(L, index, "a Mover");
        return mover;
    }
};

std::tuple<float, float> solve_planes(lua_State* L, float dx, float dy, TableArgument list, NotNegative gap) {
    constexpr lua_Integer kMostPlanes = 64;  // the time grows with the cube
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, list.index));
    if (count > kMostPlanes) {
        call_error(L, "planes has " + std::to_string(count) + " members, but must have at most " +
                          std::to_string(kMostPlanes));
    }
    std::vector<physics::CollisionPlane> planes;
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, list.index, i);
        const std::string place = "planes[" + std::to_string(i) + "]";
        if (!lua_istable(L, -1)) call_error(L, place + " is " + describe_value(L, -1) + "; expected a table");
        const int plane = lua_gettop(L);
        const auto number = [&](const char* name) {
            lua_getfield(L, plane, name);
            const auto value = static_cast<float>(lua_tonumber(L, -1));
            if (lua_type(L, -1) != LUA_TNUMBER || !physics::is_finite(value))
                call_error(
                    L, place + "." + name + " is " + describe_value(L, -1) + "; expected a finite number");
            lua_pop(L, 1);
            return value;
        };
        const Vec2 normal{number("nx"), number("ny")};
        const float separation_m = number("separation");
        lua_getfield(L, plane, "dynamic");
        planes.push_back(
            {.normal = normal, .separation_m = separation_m, .is_dynamic = lua_toboolean(L, -1) != 0});
        lua_settop(L, list.index + 1);
    }
    const Vec2 way = physics::solve_planes({dx, dy}, planes, gap);
    return {way.x, way.y};
}

Pushed new_mover(lua_State* L, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kMoverFields);
    const float height_m = reader.real(kHeight);
    const float radius_m = reader.real(kRadius);
    if (!(2 * radius_m < height_m)) {
        if (reader.has(kRadius)) reader.fail(kRadius, "must be less than half the height");
        reader.fail(kHeight, "must be more than twice the radius, which is 0.3 unless given");
    }
    const Vec2 up{reader.real(kUpX), reader.real(kUpY)};
    const float length = physics::length(up);
    if (!(length > 0)) call_error(L, "up_x, up_y = 0, 0: must be a direction");
    physics::MoverDef def;
    def.up = up * (1 / length);
    def.capsule = {.a_m = def.up * radius_m, .b_m = def.up * (height_m - radius_m), .radius_m = radius_m};
    def.max_slope_rad = reader.real(kMaxSlope);
    def.step_height_m = reader.real(kStepHeight);
    def.push_force_n = reader.real(kPushForce);
    new_object<MoverObject>(
        L, 0, value_or_raise(L, physics::Mover::create(def, {reader.number(kX), reader.number(kY)})));
    return {1};
}

namespace {

/// m. How far from where it stands a mover may come to look in a call of `move`: its own size, the way it
/// goes, what its ground carries it along, and the steps that it tries.
float reach_of(const physics::Mover& mover, const physics::World& world, Vec2 velocity, float dt_s) {
    const physics::MoverDef& def = mover.def();
    const float size =
        physics::length(def.capsule.a_m) + physics::length(def.capsule.b_m) + def.capsule.radius_m;
    float speed = physics::length(velocity);
    if (world.contains(mover.ground_body())) {
        const physics::Body ground = *world.body(mover.ground_body());
        speed += physics::length(ground.velocity_at(mover.position()));
    }
    return 2 * (size + def.step_height_m + speed * dt_s);
}

Change move(lua_State* L, MoverObject* self, WorldRef world, float vx, float vy, StepTime dt_s, Filter filter,
            Ignored ignored) {
    const Sight sight(L, world, filter, ignored);
    physics::QueryFilter seen = sight.filter();
    if (!sight.asks()) return self->mover.move(world.world, {vx, vy}, dt_s, seen);
    // It looks again and again on its way: all that is near is asked for first.
    const float reach = reach_of(self->mover, world.world, {vx, vy}, dt_s);
    const Position at = self->mover.position();
    const std::vector<physics::ShapeId> near = value_or_raise(
        L, world.world.shapes_in_box(at + Vec2{-reach, -reach}, at + Vec2{reach, reach}, seen));
    const std::vector<std::uint64_t> accepted = sight.accepted(near);
    const auto is_accepted = [&](physics::ShapeId shape, physics::BodyId) {
        return std::binary_search(accepted.begin(), accepted.end(), shape.bits());
    };
    seen.accepts = is_accepted;
    return self->mover.move(world.world, {vx, vy}, dt_s, seen);
}
Change teleport(MoverObject* self, double x, double y) {
    return self->mover.teleport({x, y});
}
std::tuple<double, double> position(MoverObject* self) {
    return {self->mover.position().x, self->mover.position().y};
}
std::tuple<float, float> velocity(MoverObject* self) {
    return {self->mover.velocity().x, self->mover.velocity().y};
}
bool is_grounded(MoverObject* self) {
    return self->mover.is_grounded();
}
std::tuple<float, float> ground_normal(MoverObject* self) {
    return {self->mover.ground_normal().x, self->mover.ground_normal().y};
}
Pushed ground_body(lua_State* L, MoverObject* self, WorldRef world) {
    push_body(L, world.index, self->mover.ground_body());
    return {1};
}

Pushed ground_shape(lua_State* L, MoverObject* self, WorldRef world) {
    const physics::ShapeId id = self->mover.ground_shape();
    if (!world.world.contains(id)) return lua_pushnil(L), Pushed{1};
    push_shape(L, world.index, world.object, id);
    return {1};
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body?"};
constexpr std::array<std::string_view, 1> kReturnsShape = {"Shape?"};

constexpr Function kFunctions[] = {
    function<&move>("move", "world, vx [m/s], vy [m/s], dt [s], filter = -1, ignored = nil", "",
                    "Goes on for a step at a velocity, slides along what it meets, walks over steps and down "
                    "slopes, and pushes dynamic bodies. What `filter` and `ignored` hide, as in queries of "
                    "worlds, is walked through."),
    function<&teleport>("teleport", "x [m], y [m]", "", "Somewhere else at once, standing on nothing."),
    function<&position>("position", "", "x [m], y [m]", "Of its feet."),
    function<&velocity>("velocity", "", "x [m/s], y [m/s]",
                        "What is left of the wanted velocity; on the ground relative to it."),
    function<&is_grounded>("is_grounded", "", "grounded",
                           "Whether it stands on something that is not too steep."),
    function<&ground_normal>("ground_normal", "", "x, y", "(0, 0) in the air."),
    function_pushing<&ground_body>("ground_body", "world", "body", kReturnsBody,
                                   "What it stands on; nil in the air."),
    function_pushing<&ground_shape>("ground_shape", "world", "shape", kReturnsShape,
                                    "Likewise, which shape of it."),
};

}  // namespace

int finalize_mover(lua_State* L) {
    object_at<MoverObject>(L, 1)->~MoverObject();
    return 0;
}

const Module kMoverMethods = {
    "Mover",
    "A character that walks: an upright capsule, moved by wishes and not by forces. The world does not know "
    "of "
    "it. Each update: add gravity to its velocity, set what the player wants, `move` it, step the world.",
    kFunctions, true};

}  // namespace cairn::scripting
