// What a running test can do to its game. Implemented by the test runner.
#pragma once

#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <string>

#include <cairn/engine/input.h>
#include <cairn/engine/result.h>

#include "bind/context.h"
#include "bridge/picture_check.h"

namespace cairn::scripting {

class TestDriver {
  public:
    virtual ~TestDriver() = default;

    /// Whether a test of the file at hand is called so.
    [[nodiscard]] virtual bool has_test(const std::string& name) const = 0;
    /// Registers the function on top of the stack, which is popped.
    virtual void add_test(lua_State* L, const std::string& name) = 0;
    /// Runs main.lua and cairn.load.
    virtual void start(lua_State* L, std::uint64_t seed) = 0;
    /// Input of the next frame.
    virtual void send(lua_State* L, engine::InputEvent event) = 0;
    /// What is held and where mouse and fingers are after all that was sent.
    [[nodiscard]] virtual const engine::InputState& sent_input() const = 0;
    /// One update with the input sent before.
    virtual void run_frame(lua_State* L) = 0;
    virtual std::string state_hash(lua_State* L) = 0;
    /// Plays a recording from its first frame to its last in a game of its own.
    virtual engine::Result<std::optional<GameResult>> play_replay(const std::string& path) = 0;
    /// Draws the game and compares it with an approved picture of the game's files. Gives what is wrong.
    virtual std::optional<std::string> check_picture(lua_State* L, const std::string& path,
                                                     const PictureTolerance& tolerance) = 0;
    /// The run so far, as the text of a replay.
    virtual std::string recording(lua_State* L) = 0;
};

}  // namespace cairn::scripting
