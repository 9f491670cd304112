// cairn.test: a small test API over a game that runs frame by frame.
#include <algorithm>
#include <cmath>

#include "bind/fields.h"
#include "bind/modules.h"
#include "bind/test_driver.h"
#include "data/table_writer.h"
#include "lua/errors.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using engine::InputEvent;
using engine::InputKind;

TestDriver& driver(lua_State* L) {
    return *context_of(L).test;
}

void test(lua_State* L, std::string_view name, FunctionArgument body) {
    if (driver(L).has_test(std::string(name)))
        call_error(L, "name is " + quote_text(name) + ": another test of this file is called so");
    lua_pushvalue(L, body.index);
    driver(L).add_test(L, std::string(name));
}

constexpr Field kSeed = integer_field("seed", 1, "1", "of the gameplay stream");
constexpr const Field* kStartOwn[] = {&kSeed};
constexpr FieldSet kStartFields{kStartOwn};

void start(lua_State* L, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kStartFields);
    driver(L).start(L, static_cast<std::uint64_t>(reader.integer(kSeed)));
}

void run(lua_State* L, Count frames) {
    for (std::int64_t i = 0; i < frames; ++i) driver(L).run_frame(L);
}

bool run_until(lua_State* L, FunctionArgument condition, Count max_frames) {
    for (std::int64_t i = 0; i < max_frames; ++i) {
        driver(L).run_frame(L);
        lua_pushvalue(L, condition.index);
        lua_call(L, 0, 1);
        const bool holds = lua_toboolean(L, -1) != 0;
        lua_pop(L, 1);
        if (holds) return true;
    }
    return false;
}

// ---- Input

engine::Key to_key(lua_State* L, std::string_view name) {
    const auto key = engine::key_from_name(name);
    if (!key) argument_error(L, 1, "the name of a key, as in cairn.input.is_down");
    return *key;
}
engine::MouseButton to_button(lua_State* L, std::optional<std::string_view> name) {
    const auto button = engine::mouse_button_from_name(name.value_or("left"));
    if (!button) argument_error(L, 3, "\"left\", \"middle\", \"right\", \"x1\" or \"x2\"");
    return *button;
}

void press(lua_State* L, std::string_view key) {
    driver(L).send(L, {.kind = InputKind::KeyPressed, .key = to_key(L, key)});
}
void release(lua_State* L, std::string_view key) {
    driver(L).send(L, {.kind = InputKind::KeyReleased, .key = to_key(L, key)});
}
void type_text(lua_State* L, std::string_view text) {
    // Refused before the first is sent.
    if (std::any_of(text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }))
        argument_error(L, 1, "text without control characters; press(\"return\") presses a key");
    while (!text.empty()) {
        std::size_t length = 1;  // of a character in UTF-8, with the bytes that go on with it
        while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0u) == 0x80u) ++length;
        driver(L).send(L, {.kind = InputKind::TextEntered, .text = std::string(text.substr(0, length))});
        text.remove_prefix(length);
    }
}
void mouse_move(lua_State* L, float x, float y) {
    const engine::Vec2 from = driver(L).sent_input().mouse_position();
    driver(L).send(L,
                   {.kind = InputKind::MouseMoved, .position = {x, y}, .delta = engine::Vec2{x, y} - from});
}
void mouse_press(lua_State* L, float x, float y, std::optional<std::string_view> button) {
    driver(L).send(L, {.kind = InputKind::MousePressed, .button = to_button(L, button), .position = {x, y}});
}
void mouse_release(lua_State* L, float x, float y, std::optional<std::string_view> button) {
    driver(L).send(L, {.kind = InputKind::MouseReleased, .button = to_button(L, button), .position = {x, y}});
}
void wheel(lua_State* L, float dx, float dy) {
    driver(L).send(L, {.kind = InputKind::WheelMoved,
                       .position = driver(L).sent_input().mouse_position(),
                       .delta = {dx, dy}});
}

engine::GamepadButton to_gamepad_button(lua_State* L, std::string_view name) {
    const auto button = engine::gamepad_button_from_name(name);
    if (!button) argument_error(L, 2, "the name of a button, as in cairn.input.is_gamepad_down");
    return *button;
}
constexpr Range kGamepads{1, engine::kMaxGamepads};
using GamepadNumber = Ranged<kGamepads, std::int64_t>;
constexpr Range kTouches{1, engine::kMaxTouches};
using TouchNumber = Ranged<kTouches, std::int64_t>;
constexpr Range kAxisValues{-1, 1};

void gamepad_connect(lua_State* L, GamepadNumber gamepad) {
    driver(L).send(
        L, {.kind = InputKind::GamepadConnected, .text = "test", .number = static_cast<int>(gamepad.value)});
}
void gamepad_disconnect(lua_State* L, GamepadNumber gamepad) {
    driver(L).send(L, {.kind = InputKind::GamepadDisconnected, .number = static_cast<int>(gamepad.value)});
}
void gamepad_press(lua_State* L, GamepadNumber gamepad, std::string_view button) {
    driver(L).send(L, {.kind = InputKind::GamepadPressed,
                       .number = static_cast<int>(gamepad.value),
                       .gamepad_button = to_gamepad_button(L, button)});
}
void gamepad_release(lua_State* L, GamepadNumber gamepad, std::string_view button) {
    driver(L).send(L, {.kind = InputKind::GamepadReleased,
                       .number = static_cast<int>(gamepad.value),
                       .gamepad_button = to_gamepad_button(L, button)});
}
void gamepad_move(lua_State* L, GamepadNumber gamepad, std::string_view name,
                  Ranged<kAxisValues, float> value) {
    const auto axis = engine::gamepad_axis_from_name(name);
    if (!axis) argument_error(L, 2, "the name of an axis, as in cairn.input.gamepad_axis");
    driver(L).send(L, {.kind = InputKind::GamepadMoved,
                       .number = static_cast<int>(gamepad.value),
                       .gamepad_axis = *axis,
                       .value = value});
}
void touch_press(lua_State* L, TouchNumber touch, float x, float y) {
    driver(L).send(
        L, {.kind = InputKind::TouchPressed, .position = {x, y}, .number = static_cast<int>(touch.value)});
}
void touch_move(lua_State* L, TouchNumber touch, float x, float y) {
    const int number = static_cast<int>(touch.value);
    const engine::Vec2 from = driver(L).sent_input().touch(number).value_or(engine::Vec2{x, y});
    driver(L).send(L, {.kind = InputKind::TouchMoved,
                       .position = {x, y},
                       .delta = engine::Vec2{x, y} - from,
                       .number = number});
}
void touch_release(lua_State* L, TouchNumber touch, float x, float y) {
    driver(L).send(
        L, {.kind = InputKind::TouchReleased, .position = {x, y}, .number = static_cast<int>(touch.value)});
}

// ---- Expectations

void expect(lua_State* L, AnyArgument condition, std::optional<std::string_view> message) {
    if (lua_toboolean(L, condition.index) != 0) return;
    raise(L, "expected a true value, got " + describe_value(L, condition.index) +
                 (message ? ": " + std::string(*message) : std::string()));
}

void expect_equal(lua_State* L, AnyArgument actual, AnyArgument expected) {
    if (lua_compare(L, actual.index, expected.index, LUA_OPEQ) != 0) return;
    raise(L, "expected " + describe_value(L, expected.index) + ", got " + describe_value(L, actual.index));
}

void expect_near(lua_State* L, double actual, double expected, Ranged<kNotNegative, double> tolerance) {
    if (std::abs(actual - expected) <= tolerance) return;
    raise(L, "expected " + describe_value(L, 2) + " within " + describe_value(L, 3) + ", got " +
                 describe_value(L, 1));
}

void expect_error(lua_State* L, FunctionArgument action, std::string_view text) {
    lua_pushvalue(L, action.index);
    if (lua_pcall(L, 0, 0, 0) == LUA_OK) {
        raise(L, "expected an error with " + quote_text(text) + ", but there was none");
    }
    const std::string message = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : describe_value(L, -1);
    if (message.find(text) == std::string::npos) {
        raise(L, "expected an error with " + quote_text(text) + ", got \"" + message + "\"");
    }
}

constexpr Field kTolerance =
    within(number_field("tolerance", PictureTolerance{}.color, "0.03", "how far a color may be off"), 0, 1);
constexpr Field kShare = within(
    number_field("share", PictureTolerance{}.share, "0", "of the pixels that may be farther off"), 0, 1);
constexpr const Field* kPictureOwn[] = {&kTolerance, &kShare};
constexpr FieldSet kPictureFields{kPictureOwn};

void expect_picture(lua_State* L, std::string_view path, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kPictureFields);
    const auto problem = driver(L).check_picture(
        L, std::string(path), {.color = reader.number(kTolerance), .share = reader.number(kShare)});
    if (problem) raise(L, *problem);
}

// ---- Outcomes

void push_result(lua_State* L, const std::optional<GameResult>& result) {
    if (!result) {
        lua_pushnil(L);
        return;
    }
    lua_newtable(L);
    lua_pushstring(L, result->outcome.c_str());
    lua_setfield(L, -2, "outcome");
    if (result->level) {
        lua_pushstring(L, result->level->c_str());
        lua_setfield(L, -2, "level");
    }
    if (result->score) {
        lua_pushnumber(L, *result->score);
        lua_setfield(L, -2, "score");
    }
    if (result->stars) {
        lua_pushinteger(L, *result->stars);
        lua_setfield(L, -2, "stars");
    }
}

Pushed result(lua_State* L) {
    push_result(L, context_of(L).result);
    return {1};
}
std::string state_hash(lua_State* L) {
    return driver(L).state_hash(L);
}
Pushed play_replay(lua_State* L, std::string_view path) {
    push_result(L, value_or_raise(L, driver(L).play_replay(std::string(path))));
    return {1};
}
std::string recording(lua_State* L) {
    return driver(L).recording(L);
}

constexpr std::array<std::string_view, 1> kReturnsResult = {"table?"};

constexpr Function kFunctions[] = {
    function<&test>("test", "name, body", "",
                    "Adds a test: `body()` runs in a fresh state and fails by raising an error. "
                    "No two tests of a file have the same name."),
    function<&start>("start", "fields = {}", "", "Runs main.lua and `cairn.load`.", &kStartFields),
    function<&run>(
        "run", "frames", "",
        "Runs that many updates. Now and then, and when the test is over, `cairn.draw` is called too: "
        "a test whose game cannot be drawn fails."),
    function<&run_until>("run_until", "condition, max_frames", "reached",
                         "Runs updates until `condition()` is true; false when it never was."),
    function<&press>("press", "key", "", "Input of the next frame."),
    function<&release>("release", "key", "", ""),
    function<&type_text>(
        "type_text", "text", "",
        "Enters text as a keyboard does, character by character (UTF-8): for `cairn.text_input` and "
        "text fields. A text field takes it once it has been opened, as a player does: with the focus on it, "
        "`press(\"return\")` and one frame, or a click. Keys such as \"backspace\" are pressed with "
        "`press`."),
    function<&mouse_move>("mouse_move", "x [px], y [px]", "", ""),
    function<&mouse_press>("mouse_press", "x [px], y [px], button = \"left\"", "", ""),
    function<&mouse_release>("mouse_release", "x [px], y [px], button = \"left\"", "", ""),
    function<&wheel>("wheel", "dx, dy", "", ""),
    function<&gamepad_connect>("gamepad_connect", "gamepad", "", ""),
    function<&gamepad_disconnect>("gamepad_disconnect", "gamepad", "", ""),
    function<&gamepad_press>("gamepad_press", "gamepad, button", "", ""),
    function<&gamepad_release>("gamepad_release", "gamepad, button", "", ""),
    function<&gamepad_move>("gamepad_move", "gamepad, axis, value", "", ""),
    function<&touch_press>(
        "touch_press", "touch, x [px], y [px]", "",
        "Fingers are numbered from 1; as on a device the first is the left mouse button too."),
    function<&touch_move>("touch_move", "touch, x [px], y [px]", "", ""),
    function<&touch_release>("touch_release", "touch, x [px], y [px]", "", ""),
    function<&expect>("expect", "condition, message = nil", "", "Fails unless the condition is true."),
    function<&expect_equal>("expect_equal", "actual, expected", "", "By `==`."),
    function<&expect_near>("expect_near", "actual, expected, tolerance", "", ""),
    function<&expect_error>("expect_error", "action, text", "",
                            "`action()` must raise an error whose message contains the text."),
    function<&expect_picture>(
        "expect_picture", "path, fields = {}", "",
        "What the game draws now must look like the picture, a PNG file of the game such as "
        "`tests/pictures/start.png`. `cairn test GAME --approve-pictures` writes it; where they differ, the "
        "new picture and one of the differences are kept, and the message tells where.",
        &kPictureFields),
    function_pushing<&result>("result", "", "result", kReturnsResult,
                              "What `cairn.result` reported last, or nil."),
    function<&state_hash>("state_hash", "", "hash", "That of `--hash`: all worlds and the gameplay stream."),
    function_pushing<&play_replay>(
        "play_replay", "path", "result", kReturnsResult,
        "Plays a recording of the game to its end, in a state of its own; a hash that differs is "
        "an error."),
    function<&recording>("recording", "", "text", "The run since `start` as the text of a replay."),
};

}  // namespace

const Module kTestModule = {"cairn.test",
                            "Only in `cairn test GAME`, which runs each `tests/*.lua` of the game. Every "
                            "test has a fresh state, in which `require` "
                            "finds the game's modules.",
                            kFunctions};

}  // namespace cairn::scripting
