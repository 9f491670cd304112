// The physics asks within a step, where a world is half of what it was and half of what it will be. So the
// script gets the values of the two bodies and shapes, may read them, and nothing else. An error in the
// filter cannot leave the step through the solver: it is kept, the other pairs are let collide without
// asking, and it is raised behind the step with the place where it happened.
#include "bind/pair_filter.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "bind/fields.h"

namespace cairn::scripting {

namespace {

/// What a filter may call: bindings that read through the views of bodies and shapes, and nothing of the
/// lists that the step is changing.
constexpr std::string_view kLooks[] = {
    "Body:angle",
    "Body:angular_damping",
    "Body:angular_velocity",
    "Body:gravity_scale",
    "Body:inertia",
    "Body:is_awake",
    "Body:is_valid",
    "Body:linear_damping",
    "Body:locks",
    "Body:linear_velocity",
    "Body:mass",
    "Body:position",
    "Body:to_local",
    "Body:to_world",
    "Body:transform",
    "Body:type",
    "Body:velocity_at",
    "Body:world",
    "Body:world_center",
    "Shape:body",
    "Shape:density",
    "Shape:filter",
    "Shape:friction",
    "Shape:is_sensor",
    "Shape:is_valid",
    "Shape:kind",
    "Shape:material",
    "Shape:one_way",
    "Shape:points",
    "Shape:radius",
    "Shape:restitution",
    "World:gravity",
    "World:is_valid",
    "World:step_count",
};

struct Question {
    WorldObject& world;
    physics::ShapeId a;
    physics::ShapeId b;
    bool answer = true;
};

/// "main.lua:12: the pair filter returned nil; expected true or false", with the place where it begins.
[[noreturn]] void raise_wrong_answer(lua_State* L) {
    lua_Debug filter;
    lua_getiuservalue(L, 2, kPairFilterValue);
    lua_getinfo(L, ">S", &filter);
    const std::string place = filter.linedefined > 0 ? std::string(filter.short_src) + ':' +
                                                           std::to_string(filter.linedefined) + ": "
                                                     : "";
    const std::string message =
        place + "the pair filter returned " + describe_value(L, -1) + "; expected true or false";
    lua_pushlstring(L, message.data(), message.size());
    lua_error(L);
    std::abort();  // lua_error never returns; its declaration does not say so
}

/// Runs protected, with the question as a light userdata and the world behind it.
int call_filter(lua_State* L) {
    auto& question = *static_cast<Question*>(lua_touserdata(L, 1));
    const physics::World& world = *question.world.filtered_step->looked_at();
    lua_getiuservalue(L, 2, kPairFilterValue);
    push_body(L, 2, world.shape(question.a)->body());
    push_body(L, 2, world.shape(question.b)->body());
    push_shape(L, 2, question.world, question.a);
    push_shape(L, 2, question.world, question.b);
    lua_call(L, 4, 1);
    if (!lua_isboolean(L, -1)) raise_wrong_answer(L);
    question.answer = lua_toboolean(L, -1) != 0;
    return 0;
}

bool may_collide(void* context, physics::ShapeId a, physics::ShapeId b) {
    FilteredStep* const step = static_cast<WorldObject*>(context)->filtered_step;
    return step == nullptr || step->ask(a, b);
}

}  // namespace

void set_pair_filter(lua_State* L, WorldRef self, std::optional<FunctionArgument> filter) {
    if (filter) {
        lua_pushvalue(L, filter->index);
        self.world.set_pair_filter({may_collide, &self.object});
    } else {
        lua_pushnil(L);
        self.world.set_pair_filter({});
    }
    lua_setiuservalue(L, self.index, kPairFilterValue);
}

bool FilteredStep::ask(physics::ShapeId a, physics::ShapeId b) {
    if (error_) return true;
    physics::World hidden = *std::move(world_.world);
    world_.world.reset();
    looked_at_ = &hidden;
    Question question{world_, a, b};
    luaL_checkstack(L_, LUA_MINSTACK, "the pair filter of a world");
    lua_pushcfunction(L_, call_filter);
    lua_pushlightuserdata(L_, &question);
    lua_pushvalue(L_, world_index_);
    error_ = protected_call(L_, 2, 0);
    looked_at_ = nullptr;
    world_.world.emplace(std::move(hidden));
    return question.answer;
}

void FilteredStep::raise_error() const {
    if (!error_) return;
    const std::string message = error_->message + " (in the pair filter of a world)";
    lua_pushlstring(L_, message.data(), message.size());
    lua_error(L_);
}

physics::World* world_to_look_at(lua_State* L, const WorldObject& object) {
    physics::World* const world =
        object.filtered_step != nullptr ? object.filtered_step->looked_at() : nullptr;
    if (world == nullptr) return nullptr;
    const std::string name = running_name(L);
    return std::find(std::begin(kLooks), std::end(kLooks), name) != std::end(kLooks) ? world : nullptr;
}

const physics::World* readable_world(const WorldObject& object) {
    if (object.world) return &*object.world;
    return object.filtered_step != nullptr ? object.filtered_step->looked_at() : nullptr;
}

}  // namespace cairn::scripting
