// cairn.prefab and the methods of Prefab.
#include <variant>

#include "bind/modules.h"
#include "bind/physics_objects.h"
#include "bind/prefab_fields.h"
#include "data/nearest.h"

namespace cairn::scripting {
namespace {

using namespace physics;
using Change = Result<void>;

// In the order of kKindNames.
using AnyPrefab = std::variant<LinkChain, Rope, Bridge, Vehicle, Ragdoll, BrickWall, Blob, Pendulum, Windmill,
                               Elevator, GearTrain, PulleyLift>;
constexpr const char* kKindNames[] = {"chain",    "rope",       "bridge",     "vehicle",
                                      "ragdoll",  "brick_wall", "blob",       "pendulum",
                                      "windmill", "elevator",   "gear_train", "pulley_lift"};

/// User value 1 is the world.
struct PrefabObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Prefab;
    WorldObject* world;
    AnyPrefab prefab;
};

struct PrefabRef {
    PrefabObject& object;
    World& world;
    int index;

    [[nodiscard]] const Prefab& parts() const {
        return std::visit([](const auto& prefab) -> const Prefab& { return prefab; }, object.prefab);
    }
};

}  // namespace

template <>
struct Argument<PrefabRef> {
    static constexpr std::string_view kType = "Prefab";
    static PrefabRef get(lua_State* L, int index) {
        auto* object = object_at<PrefabObject>(L, index);
        if (object == nullptr) argument_error(L, index, "a Prefab");
        if (!object->world->world) call_error(L, "the world of this prefab was destroyed");
        return {*object, *object->world->world, index};
    }
};

namespace {

template <class Def, auto kCreate>
Pushed make(lua_State* L, WorldRef world, std::optional<TableArgument> description) {
    if (!description) lua_newtable(L);
    const FieldReader reader(L, description ? description->index : -1, PrefabReader<Def>::kFields);
    auto made = value_or_raise(L, kCreate(world.world, PrefabReader<Def>::read(L, reader)));
    push_prefab_data(L, reader);
    for (const BodyId body : made.bodies) {
        lua_pushvalue(L, -1);
        if (lua_isnil(L, -1)) {
            lua_pop(L, 1);
            lua_newtable(L);
        }
        push_new_body(L, world.index, world.object, body);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    new_object<PrefabObject>(L, 1, &world.object, AnyPrefab(std::move(made)));
    lua_pushvalue(L, world.index);
    lua_setiuservalue(L, -2, 1);
    return {1};
}

constexpr std::array<std::string_view, 1> kReturnsPrefab = {"Prefab"};

template <class Def, auto kCreate>
constexpr Function maker(const char* name, const char* doc) {
    return function_pushing<&make<Def, kCreate>>(name, "world, fields = {}", "prefab", kReturnsPrefab, doc,
                                                 &PrefabReader<Def>::kFields);
}

constexpr Function kMakers[] = {
    maker<LinkChainDef, &create_link_chain>("chain", "Rigid links, pinned end to end from x, y on."),
    maker<RopeDef, &create_rope>(
        "rope", "A rope from x, y to to_x, to_y. It bends freely; what hangs from it does not stretch it."),
    maker<BridgeDef, &create_bridge>("bridge", "Planks, pinned end to end from x, y to to_x, to_y."),
    maker<VehicleDef, &create_vehicle>(
        "vehicle", "A chassis on sprung wheels. See `prefab:drive`, `brake` and `coast`."),
    maker<RagdollDef, &create_ragdoll>(
        "ragdoll",
        "A limp human figure of eleven bones with its feet at x, y, facing right; its bodies are `hip`, "
        "`torso`, `head`, then `upper_leg`, `lower_leg` twice and `upper_arm`, `lower_arm` twice. Without a "
        "`group` it has one of its own, so that its bones do not collide."),
    maker<BrickWallDef, &create_brick_wall>("brick_wall",
                                            "Bricks in running bond, held by mortar that breaks. Its foot is "
                                            "at x, y."),
    maker<BlobDef, &create_blob>("blob", "A soft disc of round pieces, welded softly to their neighbours."),
    maker<PendulumDef, &create_pendulum>("pendulum", "Bobs on rods without mass, hung from x, y."),
    maker<WindmillDef, &create_windmill>("windmill", "A wheel of sails. See `prefab:blow`."),
    maker<ElevatorDef, &create_elevator>("elevator",
                                         "A platform that goes between floors. See `prefab:send` and "
                                         "`is_at`; floor 0 is the first one."),
    maker<GearTrainDef, &create_gear_train>("gear_train",
                                            "Wheels in a row that turn each other without slip."),
    maker<PulleyLiftDef, &create_pulley_lift>("pulley_lift", "Two platforms on one rope over two wheels."),
};

// ---- Prefab

std::string_view kind(PrefabRef self) {
    return kKindNames[self.object.prefab.index()];
}

/// Those that live.
Pushed bodies(lua_State* L, PrefabRef self) {
    push_world_of(L, self.index);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const BodyId id : self.parts().bodies) {
        if (!self.world.contains(id)) continue;
        push_body(L, -2, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed joints(lua_State* L, PrefabRef self) {
    push_world_of(L, self.index);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const JointId id : self.parts().joints) {
        if (!self.world.contains(id)) continue;
        push_joint(L, -2, *self.object.world, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

template <class T>
const T& expect_kind(lua_State* L, PrefabRef self, const char* name) {
    const T* found = std::get_if<T>(&self.object.prefab);
    if (found == nullptr) {
        call_error(L, std::string("belongs to a ") + name + ", and this is a " +
                          kKindNames[self.object.prefab.index()]);
    }
    return *found;
}

Change drive(lua_State* L, PrefabRef self, float speed_m_s) {
    return drive_vehicle(self.world, expect_kind<Vehicle>(L, self, "vehicle"), speed_m_s);
}
Change brake(lua_State* L, PrefabRef self) {
    return brake_vehicle(self.world, expect_kind<Vehicle>(L, self, "vehicle"));
}
Change coast(lua_State* L, PrefabRef self) {
    return coast_vehicle(self.world, expect_kind<Vehicle>(L, self, "vehicle"));
}

int floor_number(lua_State* L, const Elevator& elevator, std::int64_t floor) {
    const auto last = static_cast<std::int64_t>(elevator.floors_m.size()) - 1;
    if (floor < 0 || floor > last) {
        call_error(L, "floor is " + std::to_string(floor) + "; expected 0 to " + std::to_string(last));
    }
    return static_cast<int>(floor);
}
Change send(lua_State* L, PrefabRef self, std::int64_t floor) {
    const auto& elevator = expect_kind<Elevator>(L, self, "elevator");
    return send_elevator(self.world, elevator, floor_number(L, elevator, floor));
}
Result<bool> is_at(lua_State* L, PrefabRef self, std::int64_t floor) {
    const auto& elevator = expect_kind<Elevator>(L, self, "elevator");
    return is_elevator_at(self.world, elevator, floor_number(L, elevator, floor));
}

Change blow(lua_State* L, PrefabRef self, float wind_m_s, StepTime dt_s) {
    return blow_windmill(self.world, expect_kind<Windmill>(L, self, "windmill"),
                         {.velocity_m_s = {wind_m_s, 0}}, dt_s);
}

void destroy(lua_State* L, PrefabRef self) {
    push_world_of(L, self.index);
    const int world = lua_gettop(L);
    for (const JointId joint : self.parts().joints) {
        if (self.world.contains(joint)) check_or_raise(L, self.world.destroy_joint(joint));
    }
    for (const BodyId body : self.parts().bodies) {
        if (!self.world.contains(body)) continue;
        check_or_raise(L, self.world.destroy_body(body));
        retire_body(L, world, *self.object.world, body);
    }
}

constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kMethods[] = {
    function<&kind>("kind", "", "kind", "\"rope\", \"vehicle\" and so on: the name of its function."),
    function_pushing<&bodies>(
        "bodies", "", "bodies", kReturnsTable,
        "A new list of its bodies that live, in the order in which they were made: links, "
        "planks, bricks, pieces, bobs and wheels of gears from the first on; the chassis "
        "of a vehicle, then its wheels; the rotor of a windmill; the platform of an "
        "elevator; the static body that holds the others where it stands in the order."),
    function_pushing<&joints>("joints", "", "joints", kReturnsTable, "A new list of its joints that live."),
    function<&drive>("drive", "speed [m/s]", "",
                     "Of a vehicle: turns the driven wheels for that speed, to the right when positive."),
    function<&brake>("brake", "", "", "Of a vehicle: blocks the braked wheels."),
    function<&coast>("coast", "", "", "Of a vehicle: lets all wheels run."),
    function<&send>("send", "floor", "", "Of an elevator: sets it off to a floor, where it stops."),
    function<&is_at>("is_at", "floor", "there", "Of an elevator: whether it stands at the floor."),
    function<&blow>("blow", "wind [m/s], dt [s]", "",
                    "Of a windmill: what the wind does in the next step. Call it before each."),
    function<&destroy>("destroy", "", "", "Destroys what is left of it."),
};

}  // namespace

int finalize_prefab(lua_State* L) {
    object_at<PrefabObject>(L, 1)->~PrefabObject();
    return 0;
}

const Module kPrefabModule = {
    "cairn.prefab",
    "Things made of several bodies and joints. Each function adds one to a world; its parts are bodies and "
    "joints like any others.",
    kMakers,
};
const Module kPrefabMethods = {"Prefab", "What a function of cairn.prefab made.", kMethods, true};

}  // namespace cairn::scripting
