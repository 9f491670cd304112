// Input events as text, key names, and the state that events lead to.
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include <cairn/engine/input.h>

using namespace cairn::engine;

namespace {

InputEvent key(InputKind kind, Key which, bool repeat = false) {
    InputEvent event;
    event.kind = kind;
    event.key = which;
    event.is_repeat = repeat;
    return event;
}

InputEvent mouse(InputKind kind, Vec2 position, MouseButton button = MouseButton::Left, Vec2 delta = {}) {
    InputEvent event;
    event.kind = kind;
    event.position = position;
    event.button = button;
    event.delta = delta;
    return event;
}

InputEvent plain(InputKind kind) {
    InputEvent event;
    event.kind = kind;
    return event;
}

std::string error_of(std::string_view line) {
    const auto event = input_event_from_text(line);
    return event ? "" : event.error().message;
}

}  // namespace

TEST_CASE("every key has a name of its own that leads back to it") {
    std::set<std::string_view> names;
    for (int i = 0; i < kKeyCount; ++i) {
        const auto which = static_cast<Key>(i);
        CHECK(names.insert(key_name(which)).second);
        CHECK(key_from_name(key_name(which)) == which);
    }
    CHECK(key_name(Key::Space) == "space");
    CHECK(key_name(Key::Left) == "left");
    CHECK(key_name(Key::A) == "a");
    CHECK(key_name(Key::Digit0) == "0");
    CHECK(key_name(Key::Escape) == "escape");
    CHECK(key_name(Key::F5) == "f5");
    CHECK(key_name(Key::Slash) == "/");
    CHECK(key_name(Key::KeypadEnter) == "keypad_enter");
    CHECK_FALSE(key_from_name("Space"));
}

TEST_CASE("mouse buttons have names") {
    CHECK(mouse_button_from_name("right") == MouseButton::Right);
    CHECK(mouse_button_name(MouseButton::X2) == "x2");
    CHECK_FALSE(mouse_button_from_name("4"));
}

TEST_CASE("input state follows keys and buttons") {
    InputState state;
    CHECK_FALSE(state.is_down(Key::A));
    state.apply(key(InputKind::KeyPressed, Key::A));
    state.apply(key(InputKind::KeyPressed, Key::A, true));
    state.apply(mouse(InputKind::MousePressed, {3, 4}, MouseButton::Right));
    CHECK(state.is_down(Key::A));
    CHECK_FALSE(state.is_down(Key::B));
    CHECK(state.is_down(MouseButton::Right));
    CHECK(state.mouse_position() == Vec2{3, 4});
    state.apply(key(InputKind::KeyReleased, Key::A));
    state.apply(mouse(InputKind::MouseReleased, {5, 6}, MouseButton::Right));
    CHECK_FALSE(state.is_down(Key::A));
    CHECK_FALSE(state.is_down(MouseButton::Right));
    CHECK(state.mouse_position() == Vec2{5, 6});
    state.apply(mouse(InputKind::MouseMoved, {7, 8}));
    CHECK(state.mouse_position() == Vec2{7, 8});
}

TEST_CASE("losing the focus releases everything") {
    InputState state;
    state.apply(key(InputKind::KeyPressed, Key::LeftShift));
    state.apply(mouse(InputKind::MousePressed, {1, 2}));
    state.apply(plain(InputKind::FocusLost));
    CHECK_FALSE(state.is_down(Key::LeftShift));
    CHECK_FALSE(state.is_down(MouseButton::Left));
    CHECK_FALSE(state.has_focus());
    state.apply(plain(InputKind::FocusGained));
    CHECK(state.has_focus());
}

TEST_CASE("gamepads come, are pressed and moved, and leave nothing behind when they go") {
    InputState state;
    CHECK_FALSE(state.gamepad(2).is_connected());
    state.apply({.kind = InputKind::GamepadConnected, .text = "Pad", .number = 2});
    state.apply({.kind = InputKind::GamepadPressed, .number = 2, .gamepad_button = GamepadButton::X});
    state.apply(
        {.kind = InputKind::GamepadMoved, .number = 2, .gamepad_axis = GamepadAxis::LeftY, .value = -0.5f});
    CHECK(state.gamepad(2).is_connected());
    CHECK(state.gamepad(2).name() == "Pad");
    CHECK(state.gamepad(2).is_down(GamepadButton::X));
    CHECK(state.gamepad(2).axis(GamepadAxis::LeftY) == -0.5f);
    CHECK_FALSE(state.gamepad(1).is_down(GamepadButton::X));
    state.apply({.kind = InputKind::GamepadDisconnected, .number = 2});
    CHECK_FALSE(state.gamepad(2).is_down(GamepadButton::X));
    CHECK(state.gamepad(2).axis(GamepadAxis::LeftY) == 0);
    state.apply({.kind = InputKind::GamepadPressed, .number = 99});
    CHECK_FALSE(state.gamepad(99).is_down(GamepadButton::A));
}

TEST_CASE("fingers are followed while they touch") {
    InputState state;
    state.apply({.kind = InputKind::TouchPressed, .position = {5, 6}, .number = 3});
    CHECK(state.touch(3) == Vec2{5, 6});
    CHECK_FALSE(state.touch(1));
    state.apply({.kind = InputKind::TouchMoved, .position = {7, 6}, .number = 3});
    CHECK(state.touch(3) == Vec2{7, 6});
    state.apply({.kind = InputKind::TouchReleased, .position = {7, 6}, .number = 3});
    CHECK_FALSE(state.touch(3));
    state.apply({.kind = InputKind::TouchPressed, .position = {5, 6}, .number = 1});
    state.apply(plain(InputKind::FocusLost));
    CHECK_FALSE(state.touch(1));
}

TEST_CASE("the first finger is the mouse too, and no other one") {
    FingerMouse fingers;
    std::vector<InputEvent> events;
    const auto texts = [&] {
        std::vector<std::string> lines;
        for (const InputEvent& event : events) lines.push_back(to_text(event));
        events.clear();
        return lines;
    };
    using Lines = std::vector<std::string>;
    fingers.append({.kind = InputKind::MouseMoved, .position = {10, 10}, .delta = {10, 10}}, events);
    CHECK(texts() == Lines{"mouse_moved 10 10 10 10"});
    fingers.append({.kind = InputKind::TouchPressed, .position = {30, 15}, .number = 1}, events);
    CHECK(texts() == Lines{"mouse_moved 30 15 20 5", "mouse_pressed left 30 15", "touch_pressed 1 30 15"});
    fingers.append({.kind = InputKind::TouchPressed, .position = {90, 90}, .number = 2}, events);
    CHECK(texts() == Lines{"touch_pressed 2 90 90"});
    fingers.append({.kind = InputKind::TouchMoved, .position = {33, 15}, .delta = {3, 0}, .number = 1},
                   events);
    CHECK(texts() == Lines{"mouse_moved 33 15 3 0", "touch_moved 1 33 15 3 0"});
    fingers.append({.kind = InputKind::TouchReleased, .position = {33, 15}, .number = 1}, events);
    CHECK(texts() == Lines{"mouse_released left 33 15", "touch_released 1 33 15"});
    fingers.append({.kind = InputKind::TouchReleased, .position = {80, 90}, .number = 2}, events);
    CHECK(texts() == Lines{"touch_released 2 80 90"});
}

TEST_CASE("parts of gamepads have names of their own that lead back to them") {
    std::set<std::string_view> names;
    for (int i = 0; i < kGamepadButtonCount; ++i) {
        const auto button = static_cast<GamepadButton>(i);
        CHECK(names.insert(gamepad_button_name(button)).second);
        CHECK(gamepad_button_from_name(gamepad_button_name(button)) == button);
    }
    for (int i = 0; i < kGamepadAxisCount; ++i) {
        const auto axis = static_cast<GamepadAxis>(i);
        CHECK(names.insert(gamepad_axis_name(axis)).second);
        CHECK(gamepad_axis_from_name(gamepad_axis_name(axis)) == axis);
    }
    CHECK_FALSE(gamepad_button_from_name("A"));
}

TEST_CASE("an event written as text reads back as the same event") {
    InputEvent text = plain(InputKind::TextEntered);
    text.text = "\xc3\xa4 100%\n";
    InputEvent resized = plain(InputKind::WindowResized);
    resized.delta = {800, 600};
    // Numbers that decimal digits do not hit exactly.
    const float third = 1.0f / 3;
    const float tiny = std::numeric_limits<float>::denorm_min();
    for (const InputEvent& event : {
             key(InputKind::KeyPressed, Key::Space),
             key(InputKind::KeyPressed, Key::Semicolon, true),
             key(InputKind::KeyReleased, Key::Keypad7),
             mouse(InputKind::MousePressed, {third, -1e30f}, MouseButton::X1),
             mouse(InputKind::MouseReleased, {0.1f, tiny}, MouseButton::Middle),
             mouse(InputKind::MouseMoved, {320, 200.5f}, MouseButton::Left, {-third, 2}),
             mouse(InputKind::WheelMoved, {1, 2}, MouseButton::Left, {0, -1}),
             text,
             resized,
             InputEvent{.kind = InputKind::GamepadConnected, .text = "Pad 2 (blue)", .number = 2},
             InputEvent{.kind = InputKind::GamepadDisconnected, .number = 8},
             InputEvent{
                 .kind = InputKind::GamepadPressed, .number = 1, .gamepad_button = GamepadButton::DpadUp},
             InputEvent{
                 .kind = InputKind::GamepadReleased, .number = 1, .gamepad_button = GamepadButton::Start},
             InputEvent{.kind = InputKind::GamepadMoved,
             .number = 3,
             .gamepad_axis = GamepadAxis::RightTrigger,
             .value = third},
             InputEvent{.kind = InputKind::TouchPressed, .position = {third, 4}, .number = 10},
             InputEvent{.kind = InputKind::TouchMoved, .position = {1, 2}, .delta = {-1, third}, .number = 1},
             InputEvent{.kind = InputKind::TouchReleased, .position = {1, 2}, .number = 1},
             plain(InputKind::FocusGained),
             plain(InputKind::FocusLost),
             plain(InputKind::QuitRequested),
         }) {
        const std::string line = to_text(event);
        INFO(line);
        CHECK(line.find('\n') == std::string::npos);
        const auto read = input_event_from_text(line);
        REQUIRE(read);
        CHECK(*read == event);
    }
}

TEST_CASE("the text of an event is what a person would write") {
    CHECK(to_text(key(InputKind::KeyPressed, Key::Space)) == "key_pressed space");
    CHECK(to_text(mouse(InputKind::MousePressed, {320, 200.5f})) == "mouse_pressed left 320 200.5");
    CHECK(to_text(plain(InputKind::QuitRequested)) == "quit_requested");
}

TEST_CASE("a line that is no event gives an error that names the fault") {
    CHECK_THAT(error_of("key_presed space"), Catch::Contains("no kind of event 'key_presed'"));
    CHECK_THAT(error_of("key_pressed spaec"), Catch::Contains("no key 'spaec'"));
    CHECK_THAT(error_of("key_pressed a twice"), Catch::Contains("'twice'"));
    CHECK_THAT(error_of("mouse_pressed left 3"), Catch::Contains("ends before the position"));
    CHECK_THAT(error_of("mouse_pressed left 3 x"), Catch::Contains("'x' is not a finite number"));
    CHECK_THAT(error_of("mouse_moved 1 2 3 nan"), Catch::Contains("'nan' is not a finite number"));
    CHECK_THAT(error_of("text_entered a%2"), Catch::Contains("hexadecimal"));
    CHECK_THAT(error_of("gamepad_pressed 9 a"), Catch::Contains("'9' is not a whole number from 1 to 8"));
    CHECK_THAT(error_of("gamepad_pressed 1 z"), Catch::Contains("no gamepad button 'z'"));
    CHECK_THAT(error_of("gamepad_moved 1 left_z 0"), Catch::Contains("no gamepad axis 'left_z'"));
    CHECK_THAT(error_of("gamepad_moved 1 left_x inf"), Catch::Contains("not a finite number"));
    CHECK_THAT(error_of("touch_pressed 0 1 1"), Catch::Contains("from 1 to 10"));
    CHECK_THAT(error_of("focus_lost now"), Catch::Contains("unexpected 'now'"));
    CHECK_THAT(error_of(""), Catch::Contains("ends before the kind of event"));
}
