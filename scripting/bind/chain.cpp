// The methods of Chain.
#include "bind/chain.h"

#include "bind/modules.h"
#include "bind/physics_fields.h"

namespace cairn::scripting {
namespace {

using physics::Vec2;
using Change = physics::Result<void>;

struct ChainRef {
    ChainObject& object;
    physics::Chain chain;
    int index;
};

}  // namespace

template <>
struct Argument<ChainRef> {
    static constexpr std::string_view kType = "Chain";
    static ChainRef get(lua_State* L, int index) {
        auto* object = object_at<ChainObject>(L, index);
        if (object == nullptr) argument_error(L, index, "a Chain");
        if (!object->world->world) call_error(L, "the world of this chain was destroyed");
        auto chain = object->world->world->chain(object->id);
        if (!chain) call_error(L, "this chain was destroyed; is_valid() tells");
        return {*object, *chain, index};
    }
};

namespace {

/// An index of Lua, from 1, as one of the physics, from 0. What is beyond all numbers is beyond the chain
/// too.
int to_index(std::int64_t index) {
    return index < 1 || index > std::numeric_limits<int>::max() ? -1 : static_cast<int>(index) - 1;
}

Pushed body(lua_State* L, ChainRef self) {
    push_world_of(L, self.index);
    push_body(L, -1, self.chain.body());
    return {1};
}
bool is_closed(ChainRef self) {
    return self.chain.is_closed();
}
std::int64_t point_count(ChainRef self) {
    return static_cast<std::int64_t>(self.chain.points().size());
}

void require_point(lua_State* L, ChainRef self, std::int64_t index) {
    const auto count = static_cast<std::int64_t>(self.chain.points().size());
    if (index < 1 || index > count)
        call_error(L, "index is " + std::to_string(index) + "; expected 1 to " + std::to_string(count));
}
void require_segment(lua_State* L, ChainRef self, std::int64_t index) {
    if (index < 1 || index > self.chain.segment_count()) {
        call_error(L, "segment is " + std::to_string(index) + "; expected 1 to " +
                          std::to_string(self.chain.segment_count()));
    }
}

std::tuple<float, float> point(lua_State* L, ChainRef self, std::int64_t index) {
    require_point(L, self, index);
    const Vec2 p = self.chain.points()[static_cast<std::size_t>(index - 1)];
    return {p.x, p.y};
}
Change set_point(lua_State* L, ChainRef self, std::int64_t index, float x, float y) {
    require_point(L, self, index);
    return self.chain.set_point(to_index(index), {x, y});
}
Change insert_points(lua_State* L, ChainRef self, std::int64_t index, TableArgument points) {
    return self.chain.insert_points(to_index(index), read_point_list(L, points.index, "points"));
}
Change remove_points(lua_State* L, ChainRef self, std::int64_t first, std::int64_t count) {
    require_point(L, self, first);
    if (count < 1 || count > point_count(self))
        call_error(
            L, "count is " + std::to_string(count) + "; expected 1 to " + std::to_string(point_count(self)));
    return self.chain.remove_points(to_index(first), static_cast<int>(count));
}
std::optional<Vec2> end_of(lua_State* L, std::optional<float> x, std::optional<float> y) {
    if (x.has_value() != y.has_value())
        call_error(L, "x and y of a point belong together; both or neither are expected");
    if (!x) return std::nullopt;
    return Vec2{*x, *y};
}
Change set_ends(lua_State* L, ChainRef self, std::optional<float> before_x, std::optional<float> before_y,
                std::optional<float> after_x, std::optional<float> after_y) {
    return self.chain.set_ends(end_of(L, before_x, before_y), end_of(L, after_x, after_y));
}

Pushed segment(lua_State* L, ChainRef self, std::int64_t index) {
    require_segment(L, self, index);
    const auto shape = value_or_raise(L, self.chain.segment(to_index(index)));
    push_world_of(L, self.index);
    push_shape(L, -1, *self.object.world, shape);
    return {1};
}
Pushed index_of(lua_State* L, ChainRef self, ShapeRef shape) {
    const auto found = self.chain.index_of(shape.object.id);
    if (!found) return lua_pushnil(L), Pushed{1};
    lua_pushinteger(L, *found + 1);
    return {1};
}

std::tuple<float, float, float, float, std::int64_t> material(lua_State* L, ChainRef self,
                                                              std::int64_t segment) {
    require_segment(L, self, segment);
    const physics::Material m = self.chain.material(to_index(segment));
    return {m.friction, m.restitution, m.rolling_resistance, m.surface_speed_m_s, m.kind};
}
Change set_material(lua_State* L, ChainRef self, std::int64_t segment, TableArgument fields) {
    require_segment(L, self, segment);
    const FieldReader reader(L, fields.index, kMaterialFields);
    return self.chain.set_material(to_index(segment), read_material(reader));
}

Change destroy(ChainRef self) {
    return self.object.world->world->destroy_chain(self.object.id);
}
bool is_valid(Maybe<ChainObject> self) {
    const WorldObject& owner = *self.object.world;
    return owner.world && owner.world->contains(self.object.id);
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};
constexpr std::array<std::string_view, 1> kReturnsShape = {"Shape"};
constexpr std::array<std::string_view, 1> kReturnsIndex = {"integer?"};

constexpr Function kFunctions[] = {
    function_pushing<&body>("body", "", "body", kReturnsBody, ""),
    function<&is_closed>("is_closed", "", "closed", ""),
    function<&point_count>("point_count", "", "count", ""),
    function<&point>("point", "index", "x [m], y [m]", "In the body's frame; points count from 1."),
    function<&set_point>("set_point", "index, x [m], y [m]", "", "Moves a point; what lies on it wakes."),
    function<&insert_points>("insert_points", "index, points", "",
                             "Puts a list { {x, y}, ... } before a point, or after all when `index` is their "
                             "number + 1: endless ground."),
    function<&remove_points>("remove_points", "first, count", "", ""),
    function<&set_ends>("set_ends",
                        "before_x [m] = nil, before_y [m] = nil, after_x [m] = nil, after_y [m] = nil", "",
                        "With which points other chains go on: nothing then feels the join."),
    function_pushing<&segment>("segment", "index", "shape", kReturnsShape,
                               "The shape that leads from a point to the next one."),
    function_pushing<&index_of>("index_of", "shape", "index", kReturnsIndex,
                                "Which segment a shape is; nil for other shapes."),
    function<&material>("material", "segment",
                        "friction, restitution, rolling_resistance, surface_speed [m/s], material_kind", ""),
    function<&set_material>("set_material", "segment, fields", "", "What is not given is as by default.",
                            &kMaterialFields),
    function<&destroy>("destroy", "", "", "Removes the chain from its body."),
    function<&is_valid>("is_valid", "", "valid", "Whether the chain was not destroyed."),
};

}  // namespace

Pushed add_chain(lua_State* L, BodyRef self, TableArgument description) {
    const FieldReader reader(L, description.index, kBodyAddChainFields);
    OwnedChain owned;
    read_chain(L, reader, owned);
    WorldObject& world = *self.object.world;
    const auto id = value_or_raise(L, world.world->create_chain(self.object.id, owned.def));
    push_world_of(L, self.index);
    push_chain(L, -1, world, id);
    return {1};
}

Pushed add_chain_body(lua_State* L, WorldRef self, TableArgument description) {
    const FieldReader reader(L, description.index, kWorldAddChainFields);
    OwnedChain owned;
    read_chain(L, reader, owned);
    push_data_table(L, reader);
    physics::BodyDef def = read_body_def(reader);
    const physics::BodyId id = value_or_raise(L, self.world.create_body(def));
    const auto made = self.world.create_chain(id, owned.def);
    if (!made) {
        check_or_raise(L, self.world.destroy_body(id));
        call_error(L, made.error());
    }
    push_new_body(L, self.index, self.object, id);
    push_chain(L, self.index, self.object, *made);
    return {2};
}

const Module kChainMethods = {"Chain",
                              "A long outline of segments that are solid from one side, for the ground and "
                              "walls of a level. What slides "
                              "along it does not feel the joins. `chain.data` is a table of your own.",
                              kFunctions, true};

}  // namespace cairn::scripting
