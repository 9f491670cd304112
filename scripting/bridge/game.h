// One game in one Lua state: its callbacks, frame by frame. Invariant: what a game does depends on its files,
// the seed and the events given to update(), and on nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cairn/engine/input.h>

#include "bind/context.h"
#include "lua/errors.h"
#include "lua/state.h"

namespace cairn::scripting {

struct GameOptions {
    std::uint64_t seed = 1;
    /// Of the visual stream, which decides nothing.
    std::uint64_t visual_seed = 1;
    /// Keep written files in memory instead of the save folder.
    bool plays_saves = false;
    TestDriver* test = nullptr;
};

class Game {
  public:
    Game(const Services& services, const GameOptions& options);
    ~Game();
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    /// Runs a script of the game's files.
    std::optional<ScriptError> run_file(const std::string& path,
                                        const std::vector<std::string>& arguments = {});
    /// Runs main.lua, then cairn.load.
    std::optional<ScriptError> load(const std::string& main_path, const std::vector<std::string>& arguments);
    /// Whether the game has cairn.before_reload, and so says how to go on with changed scripts, or has said
    /// it.
    [[nodiscard]] bool can_reload() const;
    /// Whether new scripts failed before they had taken what is kept for them: it waits for the next ones.
    [[nodiscard]] bool waits_for_scripts() const { return kept_ != LUA_NOREF; }
    struct Reloaded {
        std::optional<ScriptError> error;
        bool is_unchanged = false;  ///< after an error: of cairn.before_reload, so that nothing has changed
    };
    /// Runs the scripts anew, keeping what cairn.before_reload returns for cairn.after_reload. Where one of
    /// them raises an error, it is kept for the next reload.
    Reloaded reload(const std::string& main_path, const std::vector<std::string>& arguments);
    /// As if keys, buttons, sticks and fingers had been let go of, without calling anything: whoever saw the
    /// events meanwhile was not the game.
    void release_input();
    /// One frame: the events, the timers, cairn.update.
    std::optional<ScriptError> update(std::span<const engine::InputEvent> events);
    /// Between begin_frame and end_frame of the renderer.
    std::optional<ScriptError> draw(double alpha);

    /// Every world, in order of creation, and the gameplay random stream.
    [[nodiscard]] std::uint64_t state_hash() const;
    [[nodiscard]] const std::optional<GameResult>& result() const { return context_.result; }
    [[nodiscard]] bool wants_quit() const { return context_.wants_quit; }
    [[nodiscard]] std::uint64_t frame() const { return context_.frame; }
    [[nodiscard]] lua_State* lua() const { return state_.get(); }
    [[nodiscard]] const Context& context() const { return context_; }
    /// Of the gameplay stream, to one that it had before.
    void set_random_state(const engine::RandomState& state) { context_.random.set_state(state); }
    [[nodiscard]] const State& state() const { return state_; }

  private:
    /// A call of a callback, made inside a protected call because pushing its arguments needs memory.
    struct CallbackCall;
    static int run_callback(lua_State* L);
    static void run_scene_callbacks(lua_State* L, CallbackCall& callback);
    /// Logs functions of `cairn` that look like callbacks and are none.
    void hint_at_slips();
    /// What an update calls.
    std::optional<ScriptError> update_within(std::span<const engine::InputEvent> events);
    /// Calls cairn.load.
    std::optional<ScriptError> call_load(const std::vector<std::string>& arguments);
    std::optional<ScriptError> deliver(const engine::InputEvent& event);
    /// Without what it means for actions.
    std::optional<ScriptError> deliver_alone(const engine::InputEvent& event);
    std::optional<ScriptError> tell_listener(const engine::InputSource& source);
    /// The picture takes the window's size.
    std::optional<ScriptError> follow_window(engine::Size size);
    std::optional<ScriptError> run_timers();
    template <class... Arguments>
    std::optional<ScriptError> call(const char* name, bool* result, const Arguments&... arguments);

    Context context_;  // outlives the state, which uses it when it closes
    State state_;
    int cairn_ = 0;         ///< reference to the table of that name, whatever scripts do to the global
    int kept_ = LUA_NOREF;  ///< in the registry: for cairn.after_reload, until it has returned
};

}  // namespace cairn::scripting
