// Goes back in time (F4): the worlds, the gameplay stream of random numbers, and what the game itself keeps,
// if it says so with cairn.save_state and cairn.load_state. Invariant: a moment is either restored whole or
// not at all.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <cairn/engine/random.h>
#include <cairn/physics/ids.h>
#include <cairn/physics/state.h>

#include "bridge/game.h"
#include "data/value.h"

namespace cairn::scripting {

/// Of one game, which must live longer, or be forgotten first.
class Rewind {
  public:
    /// How much of the past is kept, a moment for each update.
    static constexpr int kMost_s = 10;
    /// Whatever a game holds, its past takes no more; then there is less of it.
    static constexpr std::size_t kMostBytes = std::size_t{128} << 20;

    /// After an update. What went before is forgotten when worlds were made or destroyed since. The error is
    /// that of cairn.save_state.
    std::optional<ScriptError> note(Game& game);
    /// To the update before, if it is known. The error is that of cairn.load_state.
    std::optional<ScriptError> step_back(Game& game);
    void forget();

    /// How many are known.
    [[nodiscard]] std::size_t steps_back() const { return moments_.empty() ? 0 : moments_.size() - 1; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    /// The Lua values of a world's bodies, so that one that is destroyed and comes back is the same. Moments
    /// share them while no body comes or goes.
    struct Bodies {
        std::vector<physics::BodyId> ids;
        lua_State* lua = nullptr;
        int reference = LUA_NOREF;  ///< of the list
        Bodies() = default;
        ~Bodies();
        Bodies(const Bodies&) = delete;
        Bodies& operator=(const Bodies&) = delete;
    };
    struct Moment {
        std::vector<physics::Snapshot> worlds;
        std::vector<std::shared_ptr<const Bodies>> bodies;  ///< of each world
        engine::RandomState random;
        std::optional<Value> game;  ///< what cairn.save_state returned
        [[nodiscard]] std::size_t bytes_of_worlds() const {
            std::size_t sum = 0;
            for (const physics::Snapshot& world : worlds) sum += world.size();
            return sum;
        }
    };

    static int run_note(lua_State* L);
    static int run_restore(lua_State* L);
    void recycle(Moment moment);
    [[nodiscard]] bool knows(const std::vector<WorldObject*>& worlds) const;
    void drop_oldest();

    std::deque<Moment> moments_;
    std::vector<Moment> spare_;  ///< memory of moments that are gone
    std::vector<const WorldObject*> worlds_;
    std::size_t bytes_ = 0;
};

}  // namespace cairn::scripting
