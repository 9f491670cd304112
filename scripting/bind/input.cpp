// cairn.input: what is held down, gamepads, fingers, actions.
#include <algorithm>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

const std::vector<std::string>& key_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (int i = 1; i < engine::kKeyCount; ++i)
            list.emplace_back(engine::key_name(static_cast<engine::Key>(i)));
        return list;
    }();
    return names;
}

bool is_down(lua_State* L, std::string_view name) {
    const auto key = engine::key_from_name(name);
    if (!key) call_error(L, "key is " + quote_text(name) + ": no such key" + suggestion(name, key_names()));
    return context_of(L).input.is_down(*key);
}

bool is_mouse_down(lua_State* L, std::string_view name) {
    const auto button = engine::mouse_button_from_name(name);
    if (!button) argument_error(L, 1, "\"left\", \"middle\", \"right\", \"x1\" or \"x2\"");
    return context_of(L).input.is_down(*button);
}

std::tuple<float, float> mouse_position(lua_State* L) {
    const engine::Vec2 p = context_of(L).input.mouse_position();
    return {p.x, p.y};
}

// ---- Gamepads

constexpr Range kGamepads{1, engine::kMaxGamepads};
using GamepadNumber = Ranged<kGamepads, std::int64_t>;

const engine::Gamepad& to_gamepad(lua_State* L, GamepadNumber number) {
    return context_of(L).input.gamepad(static_cast<int>(number.value));
}

Pushed gamepads(lua_State* L) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (int number = 1; number <= engine::kMaxGamepads; ++number) {
        if (!context_of(L).input.gamepad(number).is_connected()) continue;
        lua_pushinteger(L, number);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}
std::string gamepad_name(lua_State* L, GamepadNumber gamepad) {
    return to_gamepad(L, gamepad).name();
}
bool is_gamepad_down(lua_State* L, GamepadNumber gamepad, std::string_view name) {
    const auto button = engine::gamepad_button_from_name(name);
    if (!button) {
        std::vector<std::string> names;
        for (int i = 0; i < engine::kGamepadButtonCount; ++i)
            names.emplace_back(engine::gamepad_button_name(static_cast<engine::GamepadButton>(i)));
        call_error(L, "button is " + quote_text(name) + ": no such button" + suggestion(name, names));
    }
    return to_gamepad(L, gamepad).is_down(*button);
}
float gamepad_axis(lua_State* L, GamepadNumber gamepad, std::string_view name) {
    const auto axis = engine::gamepad_axis_from_name(name);
    if (!axis)
        argument_error(
            L, 2, "\"left_x\", \"left_y\", \"right_x\", \"right_y\", \"left_trigger\" or \"right_trigger\"");
    return to_gamepad(L, gamepad).axis(*axis);
}
constexpr Range kRumbleTimes{0, 60};

void rumble(lua_State* L, GamepadNumber gamepad, Share strength, Ranged<kRumbleTimes, double> seconds,
            std::optional<Share> low) {
    context_of(L).services.platform.rumble(static_cast<int>(gamepad.value), low.value_or(strength), strength,
                                           seconds);
}

// ---- Fingers

Pushed touches(lua_State* L) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (int number = 1; number <= engine::kMaxTouches; ++number) {
        if (!context_of(L).input.touch(number)) continue;
        lua_pushinteger(L, number);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}
constexpr Range kTouches{1, engine::kMaxTouches};

Pushed touch_position(lua_State* L, Ranged<kTouches, std::int64_t> touch) {
    const auto place = context_of(L).input.touch(static_cast<int>(touch.value));
    if (!place) {
        lua_pushnil(L);
        lua_pushnil(L);
    } else {
        lua_pushnumber(L, static_cast<double>(place->x));
        lua_pushnumber(L, static_cast<double>(place->y));
    }
    return {2};
}

// ---- Actions

void bind(lua_State* L, std::string_view action, TableArgument sources) {
    if (action.empty()) argument_error(L, 1, "a name that is not empty");
    std::vector<engine::InputSource> read;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, sources.index));
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(L, sources.index, i) != LUA_TSTRING)
            call_error(
                L, "sources[" + std::to_string(i) + "] is " + describe_value(L, -1) + "; expected a string");
        const auto source = engine::input_source_from_text(lua_tostring(L, -1));
        if (!source) call_error(L, "sources[" + std::to_string(i) + "]: " + source.error().message);
        read.push_back(*source);
        lua_pop(L, 1);
    }
    Context& context = context_of(L);
    context.actions.bind(action, std::move(read));
    context.actions.settle(context.input);
}

/// Raises for an action that is not bound, with the nearest that is.
std::string_view known_action(lua_State* L, std::string_view name) {
    const engine::Actions& actions = context_of(L).actions;
    if (actions.sources(name) == nullptr)
        call_error(L, "action is " + quote_text(name) + ": no such action" +
                          suggestion(name, actions.names()) + "; bind it first");
    return name;
}

void push_list(lua_State* L, const std::vector<std::string>& list) {
    lua_createtable(L, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        lua_pushlstring(L, list[i].data(), list[i].size());
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
}

Pushed sources(lua_State* L, std::string_view action) {
    std::vector<std::string> names;
    for (const engine::InputSource& source : *context_of(L).actions.sources(known_action(L, action)))
        names.push_back(engine::to_text(source));
    push_list(L, names);
    return {1};
}
Pushed actions(lua_State* L) {
    push_list(L, context_of(L).actions.names());
    return {1};
}
bool is_action_down(lua_State* L, std::string_view action) {
    return context_of(L).actions.is_down(known_action(L, action));
}
bool was_pressed(lua_State* L, std::string_view action) {
    return context_of(L).actions.was_pressed(known_action(L, action));
}
bool was_released(lua_State* L, std::string_view action) {
    return context_of(L).actions.was_released(known_action(L, action));
}
float action_value(lua_State* L, std::string_view action) {
    Context& context = context_of(L);
    return context.actions.value(known_action(L, action), context.input);
}
float action_axis(lua_State* L, std::string_view negative, std::string_view positive) {
    return action_value(L, positive) - action_value(L, negative);
}
void listen(lua_State* L, FunctionArgument listener) {
    Context& context = context_of(L);
    luaL_unref(L, LUA_REGISTRYINDEX, context.listener);
    lua_pushvalue(L, listener.index);
    context.listener = luaL_ref(L, LUA_REGISTRYINDEX);
}
void stop_listening(lua_State* L) {
    Context& context = context_of(L);
    luaL_unref(L, LUA_REGISTRYINDEX, context.listener);
    context.listener = LUA_NOREF;
}

constexpr std::array<std::string_view, 1> kReturnsNumbers = {"integer[]"};
constexpr std::array<std::string_view, 1> kReturnsNames = {"string[]"};
constexpr std::array<std::string_view, 2> kReturnsPlace = {"number?", "number?"};

constexpr Function kInputFunctions[] = {
    function<&is_down>(
        "is_down", "key", "down",
        "Keys: \"a\" to \"z\", \"0\" to \"9\", \"space\", \"return\", \"escape\", \"tab\", \"backspace\", "
        "\"delete\", \"insert\", \"home\", \"end\", \"page_up\", \"page_down\", \"left\", \"right\", \"up\", "
        "\"down\", \"f1\" to \"f12\", \"left_shift\", \"right_shift\", \"left_control\", "
        "\"right_control\", \"left_alt\", \"right_alt\", punctuation by its sign (\"-\"), \"keypad_0\", ..."),
    function<&is_mouse_down>(
        "is_mouse_down", "button", "down",
        "Buttons: \"left\", \"middle\", \"right\", \"x1\", \"x2\". The first finger is the left button "
        "too."),
    function<&mouse_position>("mouse_position", "", "x [px], y [px]", "Logical pixels."),
    function<&bind>("bind", "action, sources", "",
                    "Names what the player does, `cairn.input.bind(\"jump\", { \"space\", \"gamepad_a\", "
                    "\"mouse_left\" })`, instead "
                    "of what was bound before. Sources are keys, \"mouse_\" with a button, \"gamepad_\" with "
                    "a button or with a stick "
                    "and its direction (\"gamepad_left_x+\", \"gamepad_right_y-\", "
                    "\"gamepad_left_trigger\"); \"gamepad2_a\" is the "
                    "second gamepad's alone."),
    function_pushing<&sources>("sources", "action", "sources", kReturnsNames,
                               "A new list of what an action is bound to."),
    function_pushing<&actions>("actions", "", "actions", kReturnsNames, "A new list of all actions, sorted."),
    function<&is_action_down>("is_action_down", "action", "down", ""),
    function<&was_pressed>("was_pressed", "action", "pressed", "Whether it went down in this update."),
    function<&was_released>("was_released", "action", "released", "Whether it went up in this update."),
    function<&action_value>("action_value", "action", "value",
                            "0 to 1: how far its strongest source is pressed."),
    function<&action_axis>("axis", "negative, positive", "value",
                           "-1 to 1, from two actions: `cairn.input.axis(\"left\", \"right\")`."),
    function<&listen>(
        "listen", "listener", "",
        "Calls `listener(source)` with the next thing that is pressed, for rebinding; that event goes "
        "nowhere else."),
    function<&stop_listening>("stop_listening", "", "", ""),
    function_pushing<&gamepads>("gamepads", "", "numbers", kReturnsNumbers,
                                "A new list of the numbers of the gamepads that are connected, from 1."),
    function<&gamepad_name>("gamepad_name", "gamepad", "name", "Empty when it is not connected."),
    function<&is_gamepad_down>("is_gamepad_down", "gamepad, button", "down",
                               "Buttons by their place on most gamepads: \"a\" (below), \"b\" (right), \"x\" "
                               "(left), \"y\" (above), \"back\", "
                               "\"guide\", \"start\", \"left_stick\", \"right_stick\", \"left_shoulder\", "
                               "\"right_shoulder\", \"dpad_up\", "
                               "\"dpad_down\", \"dpad_left\", \"dpad_right\"."),
    function<&gamepad_axis>(
        "gamepad_axis", "gamepad, axis", "value",
        "\"left_x\", \"left_y\", \"right_x\", \"right_y\": -1 to 1, right and up positive; "
        "\"left_trigger\", \"right_trigger\": 0 to 1. Small tremors around the middle are 0."),
    function<&rumble>("rumble", "gamepad, strength, seconds [s], low = strength", "",
                      "Shakes it; `low` is the strength of its heavier weight."),
    function_pushing<&touches>("touches", "", "numbers", kReturnsNumbers,
                               "A new list of the fingers that touch, from 1."),
    function_pushing<&touch_position>("touch_position", "touch", "x [px], y [px]", kReturnsPlace,
                                      "Where a finger is, or nil."),
};

}  // namespace

const Module kInputModule = {
    "cairn.input",
    "What is held down. It follows the events of the callbacks, so it is the same in a replay.",
    kInputFunctions};

}  // namespace cairn::scripting
