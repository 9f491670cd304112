// Actions over keys, buttons and sticks.
#include <catch2/catch.hpp>

#include <cairn/engine/actions.h>

using namespace cairn::engine;

namespace {

InputSource source(const char* text) {
    const auto read = input_source_from_text(text);
    if (!read) FAIL(read.error().message);
    return *read;
}

/// Actions with the state that they follow; gives the changes of an event as "+jump -run".
struct Player {
    std::string apply(const InputEvent& event) {
        state.apply(event);
        std::string text;
        for (const Actions::Change& change : actions.follow(state))
            text += (text.empty() ? "" : " ") + std::string(change.is_pressed ? "+" : "-") + change.name;
        return text;
    }
    std::string press(Key key) { return apply({.kind = InputKind::KeyPressed, .key = key}); }
    std::string release(Key key) { return apply({.kind = InputKind::KeyReleased, .key = key}); }
    std::string stick(int pad, float x) {
        return apply(
            {.kind = InputKind::GamepadMoved, .number = pad, .gamepad_axis = GamepadAxis::LeftX, .value = x});
    }

    Actions actions;
    InputState state;
};

}  // namespace

TEST_CASE("a source written as text reads back as the same source") {
    for (const char* text :
         {"space", "a", "-", "keypad_7", "mouse_left", "mouse_x2", "gamepad_a", "gamepad1_start",
          "gamepad8_dpad_left", "gamepad_left_x+", "gamepad3_right_y-", "gamepad_left_trigger"}) {
        INFO(text);
        CHECK(to_text(source(text)) == text);
    }
    for (const char* text :
         {"", "spaec", "mouse_", "mouse_4", "gamepad", "gamepad_", "gamepad9_a", "gamepad0_a",
          "gamepad_left_x", "gamepad_left_trigger+", "gamepad_q", "gamepada", "unknown"}) {
        INFO(text);
        const auto read = input_source_from_text(text);
        REQUIRE_FALSE(read);
        CHECK_THAT(read.error().message, Catch::Contains(std::string("\"") + text + "\" is no source"));
    }
}

TEST_CASE("an action is down while any of its sources is") {
    Player player;
    player.actions.bind("jump", {source("space"), source("w")});
    CHECK(player.press(Key::Space) == "+jump");
    CHECK(player.press(Key::W) == "");
    CHECK(player.release(Key::Space) == "");
    CHECK(player.actions.is_down("jump"));
    CHECK(player.release(Key::W) == "-jump");
    CHECK(player.actions.was_pressed("jump"));
    CHECK(player.actions.was_released("jump"));
    player.actions.begin_update();
    CHECK_FALSE(player.actions.was_pressed("jump"));
    CHECK_FALSE(player.actions.was_released("jump"));
    CHECK_FALSE(player.actions.is_down("nothing"));
}

TEST_CASE("a stick presses beyond a half and releases below a third, and gives its value in between") {
    Player player;
    player.actions.bind("left", {source("gamepad_left_x-")});
    player.actions.bind("right", {source("gamepad_left_x+"), source("d")});
    CHECK(player.stick(1, 0.45f) == "");
    CHECK(player.actions.value("right", player.state) == 0.45f);
    CHECK(player.actions.value("left", player.state) == 0);
    CHECK(player.stick(1, 0.55f) == "+right");
    CHECK(player.stick(1, 0.4f) == "");
    CHECK(player.stick(1, 0.6f) == "");
    CHECK(player.stick(1, 0.3f) == "-right");
    CHECK(player.stick(1, -1) == "+left");
    CHECK(player.press(Key::D) == "+right");
    CHECK(player.actions.value("right", player.state) == 1);
}

TEST_CASE("a source of one gamepad does not hear the others") {
    Player player;
    player.actions.bind("any", {source("gamepad_left_x+")});
    player.actions.bind("second", {source("gamepad2_left_x+")});
    CHECK(player.stick(1, 1) == "+any");
    CHECK(player.stick(2, 1) == "+second");
    CHECK(player.apply({.kind = InputKind::GamepadDisconnected, .number = 2}) == "-second");
    CHECK(player.apply({.kind = InputKind::FocusLost}) == "-any");
}

TEST_CASE("binding anew replaces the sources, and what is held meanwhile is not a press") {
    Player player;
    player.actions.bind("jump", {source("space")});
    player.press(Key::W);
    player.actions.bind("jump", {source("w")});
    player.actions.settle(player.state);
    CHECK(player.press(Key::Space) == "");
    CHECK(player.actions.is_down("jump"));
    CHECK_FALSE(player.actions.was_pressed("jump"));
    CHECK(player.release(Key::W) == "-jump");
    CHECK(player.actions.names() == std::vector<std::string>{"jump"});
    CHECK(player.actions.sources("run") == nullptr);
}

TEST_CASE("what a player presses is told as a source") {
    CHECK(to_text(*pressed_source({.kind = InputKind::KeyPressed, .key = Key::F5})) == "f5");
    CHECK(to_text(*pressed_source({.kind = InputKind::MousePressed, .button = MouseButton::Right})) ==
          "mouse_right");
    CHECK(to_text(*pressed_source(
              {.kind = InputKind::GamepadPressed, .number = 2, .gamepad_button = GamepadButton::Y})) ==
          "gamepad_y");
    CHECK(to_text(*pressed_source({.kind = InputKind::GamepadMoved,
                                   .number = 1,
                                   .gamepad_axis = GamepadAxis::RightY,
                                   .value = -0.7f})) == "gamepad_right_y-");
    CHECK_FALSE(pressed_source({.kind = InputKind::GamepadMoved, .value = 0.3f}));
    CHECK_FALSE(pressed_source({.kind = InputKind::KeyPressed, .key = Key::A, .is_repeat = true}));
    CHECK_FALSE(pressed_source({.kind = InputKind::KeyReleased, .key = Key::A}));
}
