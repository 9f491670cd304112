// Gamepads, fingers and actions from Lua.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using engine::InputEvent;
using engine::InputKind;
using engine::Key;

struct Player : LuaBench {
    void frame(const std::vector<InputEvent>& events = {}) {
        const auto error = game().update(events);
        if (error) FAIL(error->to_text());
    }
    void lines(const std::vector<const char*>& texts) {
        std::vector<InputEvent> events;
        for (const char* text : texts) events.push_back(*engine::input_event_from_text(text));
        frame(events);
    }
};

}  // namespace

TEST_CASE_METHOD(Player, "gamepads and fingers reach their callbacks and can be asked for") {
    REQUIRE(
        run("log = {} for _, name in ipairs{ 'gamepad_connected', 'gamepad_disconnected', 'gamepad_pressed', "
            "'gamepad_released', 'gamepad_moved', 'touch_pressed', 'touch_moved', 'touch_released' } do "
            "cairn[name] = "
            "function(...) log[#log + 1] = name .. ' ' .. table.concat({ ... }, ' ') end end") == "");
    lines({"gamepad_connected 2 Pad", "gamepad_pressed 2 x", "gamepad_moved 2 left_y 0.5",
           "touch_pressed 3 10 20", "touch_moved 3 12 20 2 0"});
    CHECK(value("table.concat(log, ', ')") ==
          "gamepad_connected 2 Pad, gamepad_pressed 2 x, gamepad_moved 2 left_y 0.5, touch_pressed 3 10.0 "
          "20.0, "
          "touch_moved 3 12.0 20.0 2.0 0.0");
    CHECK(value("table.concat(cairn.input.gamepads())") == "2");
    CHECK(value("cairn.input.gamepad_name(2)") == "Pad");
    CHECK(value("cairn.input.is_gamepad_down(2, 'x')") == "true");
    CHECK(value("cairn.input.gamepad_axis(2, 'left_y')") == "0.5");
    CHECK(value("table.concat(cairn.input.touches())") == "3");
    CHECK(value("table.concat({ cairn.input.touch_position(3) }, ' ')") == "12.0 20.0");
    REQUIRE(run("cairn.input.rumble(2, 1, 0.5) log = {}") == "");
    lines({"gamepad_released 2 x", "touch_released 3 12 20", "gamepad_disconnected 2"});
    CHECK(value("#log") == "3");
    CHECK(value("#cairn.input.gamepads() + #cairn.input.touches()") == "0");
    CHECK(value("cairn.input.touch_position(3)") == "nil");
}

TEST_CASE_METHOD(Player, "actions are pressed, held and released by any of their sources") {
    REQUIRE(run("cairn.input.bind('jump', { 'space', 'gamepad_a' }) log = '' "
                "function cairn.action_pressed(name) log = log .. '+' .. name end "
                "function cairn.action_released(name) log = log .. '-' .. name end") == "");
    lines({"key_pressed space"});
    CHECK(value("cairn.input.was_pressed('jump') and cairn.input.is_action_down('jump')") == "true");
    lines({"gamepad_pressed 1 a", "key_released space"});
    CHECK(value("cairn.input.was_pressed('jump')") == "false");
    CHECK(value("cairn.input.is_action_down('jump')") == "true");
    lines({"gamepad_released 1 a"});
    CHECK(value("cairn.input.was_released('jump')") == "true");
    lines({"key_pressed space", "key_released space"});  // within one update
    CHECK(value("cairn.input.was_pressed('jump') and cairn.input.was_released('jump')") == "true");
    CHECK(value("log") == "+jump-jump+jump-jump");
}

TEST_CASE_METHOD(Player, "two actions make an axis, with a stick in all its values") {
    REQUIRE(
        run("cairn.input.bind('left', { 'left', 'gamepad_left_x-' }) cairn.input.bind('right', { 'right', "
            "'gamepad_left_x+' })") == "");
    lines({"gamepad_moved 1 left_x 0.25"});
    CHECK(value("cairn.input.axis('left', 'right')") == "0.25");
    lines({"gamepad_moved 1 left_x -0.75"});
    CHECK(value("cairn.input.axis('left', 'right')") == "-0.75");
    lines({"gamepad_moved 1 left_x 0", "key_pressed left"});
    CHECK(value("cairn.input.axis('left', 'right')") == "-1.0");
}

TEST_CASE_METHOD(Player, "a player binds an action anew by pressing, and that press does nothing else") {
    REQUIRE(
        run("cairn.input.bind('jump', { 'space' }) cairn.input.bind('fire', { 'x' }) pressed = 0 fired = 0 "
            "function cairn.key_pressed() pressed = pressed + 1 end "
            "function cairn.action_pressed() fired = fired + 1 end "
            "cairn.input.listen(function(source) heard = source cairn.input.bind('jump', { source }) end)") ==
        "");
    lines({"mouse_moved 1 1 0 0", "key_pressed x", "key_released x"});
    CHECK(value("heard .. ' ' .. pressed .. ' ' .. fired") == "x 0 0");
    CHECK(value("table.concat(cairn.input.sources('jump'), ' ')") == "x");
    CHECK(value("table.concat(cairn.input.actions(), ' ')") == "fire jump");
    lines({"key_pressed x"});
    CHECK(value("pressed .. ' ' .. fired") == "1 2");
    REQUIRE(run("cairn.input.listen(print) cairn.input.stop_listening()") == "");
    lines({"key_pressed a"});
    CHECK(value("pressed") == "2");
}

TEST_CASE_METHOD(Player, "wrong names of sources, actions and buttons say what there is") {
    CHECK(run("cairn.input.bind('jump', { 'space', 'gamepad_q' })")
              .find("sources[2]: \"gamepad_q\" is no source") != std::string::npos);
    CHECK(run("cairn.input.bind('jump', { 3 })").find("sources[1] is 3; expected a string") !=
          std::string::npos);
    REQUIRE(run("cairn.input.bind('jump', {})") == "");
    CHECK(run("cairn.input.was_pressed('jmup')")
              .find("action is \"jmup\": no such action; did you mean \"jump\"?") != std::string::npos);
    CHECK(run("cairn.input.is_gamepad_down(1, 'strat')").find("did you mean \"start\"?") !=
          std::string::npos);
    CHECK(run("cairn.input.is_gamepad_down(9, 'a')") ==
          "test.lua:1: cairn.input.is_gamepad_down: gamepad is 9; expected an integer from 1 to 8");
    CHECK(run("cairn.input.gamepad_axis(1, 'x')").find("\"left_x\"") != std::string::npos);
}

}  // namespace cairn::scripting::test
