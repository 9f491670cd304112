// A moment for each update, in a queue that is bounded in number and bytes.
#include "debug/rewind.h"

#include <algorithm>
#include <utility>

#include "bind/callbacks.h"
#include "bind/data_values.h"
#include "bind/physics_objects.h"
#include "bind/snapshot.h"

namespace cairn::scripting {
namespace {

int run_load(lua_State* L) {
    const auto& saved = *static_cast<const Value*>(lua_touserdata(L, 1));
    if (!push_callback(L, "load_state")) return 0;
    push_value(L, saved);
    lua_call(L, 1, 0);
    return 0;
}

std::optional<ScriptError> call(lua_State* L, lua_CFunction function, const void* argument) {
    lua_pushcfunction(L, function);
    lua_pushlightuserdata(L, const_cast<void*>(argument));
    return protected_call(L, 1, 0);
}

}  // namespace

Rewind::Bodies::~Bodies() {
    if (lua != nullptr) luaL_unref(lua, LUA_REGISTRYINDEX, reference);
}

namespace {

/// What the protected parts work on.
template <class Moment>
struct Call {
    Game& game;
    Moment& moment;
    const Moment* before;  ///< or null
};

}  // namespace

int Rewind::run_note(lua_State* L) {
    auto& [game, moment, before] = *static_cast<Call<Moment>*>(lua_touserdata(L, 1));
    const std::vector<WorldObject*>& worlds = game.context().worlds;
    moment.worlds.resize(worlds.size());
    moment.bodies.resize(worlds.size());
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        check_or_raise(L, worlds[i]->world->snapshot(moment.worlds[i]));
        std::vector<physics::BodyId> ids = worlds[i]->world->bodies();
        if (before != nullptr && before->bodies[i]->ids == ids) {
            moment.bodies[i] = before->bodies[i];
            continue;
        }
        auto bodies = std::make_shared<Bodies>();
        lua_rawgeti(L, LUA_REGISTRYINDEX, worlds[i]->reference);
        const int world = lua_gettop(L);
        lua_newtable(L);
        for (std::size_t k = 0; k < ids.size(); ++k) {
            push_body(L, world, ids[k]);
            lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
        }
        bodies->reference = luaL_ref(L, LUA_REGISTRYINDEX);
        bodies->lua = game.lua();
        bodies->ids = std::move(ids);
        moment.bodies[i] = std::move(bodies);
        lua_settop(L, 1);
    }
    moment.random = game.context().random.state();
    moment.game.reset();
    if (!push_callback(L, "save_state")) return 0;
    lua_call(L, 0, 1);
    auto value = to_value(L, -1);
    if (!value) raise(L, "cairn.save_state: " + value.error().message);
    moment.game = *std::move(value);
    return 0;
}

int Rewind::run_restore(lua_State* L) {
    auto& [game, moment, before] = *static_cast<Call<Moment>*>(lua_touserdata(L, 1));
    for (std::size_t i = 0; i < moment.worlds.size(); ++i) {
        WorldObject& world = *game.context().worlds[i];
        lua_settop(L, 1);
        lua_rawgeti(L, LUA_REGISTRYINDEX, world.reference);
        lua_createtable(L, 0, 2);
        const std::span<const std::byte> bytes = moment.worlds[i].bytes();
        lua_pushlstring(L, reinterpret_cast<const char*>(bytes.data()), bytes.size());
        lua_setfield(L, -2, "bytes");
        lua_rawgeti(L, LUA_REGISTRYINDEX, moment.bodies[i]->reference);
        lua_setfield(L, -2, "bodies");
        restore(L, {world, *world.world, 2}, AnyArgument{3});
    }
    return 0;
}

std::optional<ScriptError> Rewind::note(Game& game) {
    const Context& context = game.context();
    if (!knows(context.worlds)) {
        forget();
        worlds_.assign(context.worlds.begin(), context.worlds.end());
    }
    Moment moment;
    if (!spare_.empty()) {
        moment = std::move(spare_.back());
        spare_.pop_back();
    }
    Call<Moment> noting{game, moment, moments_.empty() ? nullptr : &moments_.back()};
    if (auto error = call(game.lua(), run_note, &noting)) return error;
    bytes_ += moment.bytes_of_worlds();
    moments_.push_back(std::move(moment));
    const auto most = static_cast<std::size_t>(kMost_s * context.services.updates_per_second);
    while (moments_.size() > 1 && (moments_.size() > most || bytes_ > kMostBytes)) drop_oldest();
    return std::nullopt;
}

std::optional<ScriptError> Rewind::step_back(Game& game) {
    if (moments_.size() < 2 || !knows(game.context().worlds)) return std::nullopt;
    Moment& before = moments_[moments_.size() - 2];
    Call<Moment> restoring{game, before, nullptr};
    if (auto error = call(game.lua(), run_restore, &restoring)) return error;
    game.set_random_state(before.random);
    bytes_ -= moments_.back().bytes_of_worlds();
    recycle(std::move(moments_.back()));
    moments_.pop_back();
    if (!before.game) return std::nullopt;
    return call(game.lua(), run_load, &*before.game);
}

void Rewind::forget() {
    while (!moments_.empty()) drop_oldest();
    worlds_.clear();
}

bool Rewind::knows(const std::vector<WorldObject*>& worlds) const {
    return std::equal(worlds.begin(), worlds.end(), worlds_.begin(), worlds_.end());
}

void Rewind::drop_oldest() {
    bytes_ -= moments_.front().bytes_of_worlds();
    recycle(std::move(moments_.front()));
    moments_.pop_front();
}

void Rewind::recycle(Moment moment) {
    constexpr std::size_t kMostSpare = 2;
    moment.bodies.clear();
    moment.game.reset();
    if (spare_.size() < kMostSpare) spare_.push_back(std::move(moment));
}

}  // namespace cairn::scripting
