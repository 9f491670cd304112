// A moment for each update, in a queue that is bounded in number and bytes.
#include "debug/rewind.h"

#include <algorithm>
#include <utility>

#include "bind/data_values.h"
#include "bind/physics_objects.h"
#include "bind/snapshot.h"

namespace cairn::scripting {
namespace {

/// A callback of `cairn`, on top of the stack; false when the game has none, with nothing pushed.
bool push_callback(lua_State* L, const char* name) {
    lua_getglobal(L, "cairn");
    if (lua_istable(L, -1)) {
        lua_pushstring(L, name);
        lua_rawget(L, -2);
        lua_remove(L, -2);
        if (lua_isfunction(L, -1)) return true;
    }
    lua_pop(L, 1);
    return false;
}

struct SaveCall {
    std::optional<Value>& saved;
};

int run_save(lua_State* L) {
    auto& call = *static_cast<SaveCall*>(lua_touserdata(L, 1));
    if (!push_callback(L, "save_state")) return 0;
    lua_call(L, 0, 1);
    auto value = to_value(L, -1);
    if (!value) raise(L, "cairn.save_state: " + value.error().message);
    call.saved = *std::move(value);
    return 0;
}

int run_load(lua_State* L) {
    const auto& saved = *static_cast<const Value*>(lua_touserdata(L, 1));
    if (!push_callback(L, "load_state")) return 0;
    push_value(L, saved);
    lua_call(L, 1, 0);
    return 0;
}

struct RestoreCall {
    const Context& context;
    const std::vector<physics::Snapshot>& worlds;
};

int run_restore(lua_State* L) {
    const auto& call = *static_cast<const RestoreCall*>(lua_touserdata(L, 1));
    for (std::size_t i = 0; i < call.worlds.size(); ++i) {
        WorldObject& world = *call.context.worlds[i];
        lua_rawgeti(L, LUA_REGISTRYINDEX, world.reference);
        const std::span<const std::byte> bytes = call.worlds[i].bytes();
        restore(L, {world, *world.world, lua_gettop(L)},
                {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    return 0;
}

std::optional<ScriptError> call(lua_State* L, lua_CFunction function, const void* argument) {
    lua_pushcfunction(L, function);
    lua_pushlightuserdata(L, const_cast<void*>(argument));
    return protected_call(L, 1, 0);
}

}  // namespace

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
    moment.worlds.resize(worlds_.size());
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
        if (const auto taken = worlds_[i]->world->snapshot(moment.worlds[i]); !taken)
            return ScriptError{taken.error().message, {}};
    }
    moment.random = context.random.state();
    moment.game.reset();
    SaveCall save{moment.game};
    if (auto error = call(game.lua(), run_save, &save)) return error;
    bytes_ += moment.bytes();
    moments_.push_back(std::move(moment));
    while (moments_.size() > 1 && (moments_.size() > kMostMoments || bytes_ > kMostBytes)) drop_oldest();
    return std::nullopt;
}

std::optional<ScriptError> Rewind::step_back(Game& game) {
    if (moments_.size() < 2 || !knows(game.context().worlds)) return std::nullopt;
    const Moment& before = moments_[moments_.size() - 2];
    const RestoreCall restoring{game.context(), before.worlds};
    if (auto error = call(game.lua(), run_restore, &restoring)) return error;
    game.set_random_state(before.random);
    bytes_ -= moments_.back().bytes();
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
    bytes_ -= moments_.front().bytes();
    recycle(std::move(moments_.front()));
    moments_.pop_front();
}

void Rewind::recycle(Moment moment) {
    constexpr std::size_t kMostSpare = 2;
    if (spare_.size() < kMostSpare) spare_.push_back(std::move(moment));
}

}  // namespace cairn::scripting
